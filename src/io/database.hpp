// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// SQLite files, to read only: what a build with SQLite has (SLAMICP_WITH_SQLITE).
namespace slamicp {

/// What SQLite says where it cannot go on: a damaged page, a missing table.
struct DatabaseFault {
  std::string problem;
};

/// A query, row by row. Throws DatabaseFault.
class Query {
 public:
  Query(sqlite3* database, const std::string& sql);

  /// Starts anew with another number in place of the "?".
  void start(std::int64_t number);
  /// Goes to the next row; false when there is none.
  bool next();
  std::int64_t number(int column) const;
  /// Text or a blob; good until the next row.
  std::string_view bytes(int column) const;

 private:
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

/// An open file, or one in memory. Nothing is written to it or beside it, and nothing in it is run: neither its views
/// nor its triggers. Damaged or cut, it gives what can still be reached.
class Database {
 public:
  /// Throws Error.
  explicit Database(const std::filesystem::path& path);
  /// @param bytes  the file's content
  /// @param name  for messages
  Database(std::string bytes, const std::string& name);

  Query query(const std::string& sql) const { return {database_.get(), sql}; }
  /// What is wrong with it as a whole, in words; empty if nothing is.
  const std::string& damage() const noexcept { return damage_; }

 private:
  void open(const std::string& uri);
  void open_bytes(const std::string& name);
  void protect(const std::string& name);

  std::string bytes_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
  std::string damage_;
};

}  // namespace slamicp
