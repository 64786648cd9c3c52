// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef SLAMICP_WITH_SQLITE

#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <string>
#include <string_view>

namespace slamicp::test {

/// Writes a rosbag2 database, with the tables that ros2 bag makes.
class Rosbag2Writer {
 public:
  explicit Rosbag2Writer(const std::filesystem::path& path) {
    EXPECT_EQ(sqlite3_open(path.string().c_str(), &database_), SQLITE_OK);
    run("PRAGMA synchronous=OFF");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
        "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL,"
        "data BLOB NOT NULL)");
    run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  }
  ~Rosbag2Writer() { sqlite3_close(database_); }
  Rosbag2Writer(const Rosbag2Writer&) = delete;
  Rosbag2Writer& operator=(const Rosbag2Writer&) = delete;

  Rosbag2Writer& topic(int id, const std::string& name, const std::string& type, const std::string& format = "cdr") {
    run("INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + name + "','" + type + "','" + format + "','')");
    return *this;
  }

  Rosbag2Writer& message(int topic, std::int64_t nanoseconds, std::string_view body) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database_, "INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)", -1, &statement,
                       nullptr);
    sqlite3_bind_int(statement, 1, topic);
    sqlite3_bind_int64(statement, 2, nanoseconds);
    sqlite3_bind_blob(statement, 3, body.data(), static_cast<int>(body.size()), SQLITE_STATIC);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_DONE);
    sqlite3_finalize(statement);
    return *this;
  }

  void run(const std::string& sql) {
    EXPECT_EQ(sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sql << ": " << sqlite3_errmsg(database_);
  }

 private:
  sqlite3* database_ = nullptr;
};

}  // namespace slamicp::test

#endif
