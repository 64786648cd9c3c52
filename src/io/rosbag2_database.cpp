// SPDX-License-Identifier: Apache-2.0
#include "io/rosbag2_database.hpp"

#include <slamicp/error.hpp>

#include "io/text.hpp"

#ifdef SLAMICP_WITH_SQLITE

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "io/database.hpp"
#include "io/message_type.hpp"

namespace slamicp {
namespace {

constexpr const char* rosbag2_mend = "give a rosbag2 file; a damaged one may be mended by 'sqlite3 FILE .recover'";

/// One message, not yet read.
struct MessageRow {
  std::int64_t stamp;  ///< [ns]
  std::int64_t row;
  int channel;  ///< as the visitor numbers it
};

/// First the wanted messages' stamps, by row; then, sorted, each by itself: so one that is damaged costs only itself,
/// and SQLite need neither sort messages nor trust an index.
class Rosbag2Reader {
 public:
  Rosbag2Reader(const Database& database, const std::string& name, RecordingVisitor& visitor)
      : database_(database), name_(name), visitor_(visitor), damage_(database.damage()) {}

  void read() {
    read_topics();
    read_messages(wanted_rows());
    if (damage_.empty()) return;
    if (taken_ == 0 && (!channels_.empty() || topics_ == 0))
      throw Error("nothing can be read: " + damage_, name_, rosbag2_mend);
    visitor_.warn("is damaged (" + damage_ + "): what can be read is used" +
                  (lost_ == 0 ? "" : ", " + text::count_of(lost_, "message is", "messages are") + " lost"));
  }

 private:
  /// Reads of the database; false where it is damaged.
  template <class Read>
  bool reach(Read read) {
    try {
      read();
      return true;
    } catch (const DatabaseFault& fault) {
      if (damage_.empty()) damage_ = fault.problem;
      return false;
    }
  }

  void read_topics() {
    reach([&] {
      Query query = database_.query("SELECT id, name, type, serialization_format FROM topics");
      while (query.next()) open(query);
    });
  }

  void open(const Query& topic) {
    if (topic.bytes(3) != "cdr")
      return visitor_.warn("topic " + text::quoted(topic.bytes(1)) + " is in " + text::quoted(topic.bytes(3)) +
                           ", not in cdr: left out");
    const int channel = visitor_.open({std::string(topic.bytes(1)), ros1_type(topic.bytes(2)), Serialization::cdr});
    ++topics_;
    if (channel >= 0) channels_[topic.number(0)] = channel;
  }

  std::vector<MessageRow> wanted_rows() {
    std::string wanted;
    for (const auto& [topic, channel] : channels_) wanted += (wanted.empty() ? "" : ",") + std::to_string(topic);
    std::vector<MessageRow> rows;
    if (wanted.empty()) return rows;
    reach([&] {
      Query query = database_.query("SELECT timestamp, rowid, topic_id FROM messages NOT INDEXED WHERE topic_id IN (" +
                                    wanted + ")");
      while (query.next()) {
        // A damaged tree of pages may lead back to where one has been.
        const std::int64_t row = query.number(1);
        if (!rows.empty() && row <= rows.back().row) throw DatabaseFault{"rows are not in order"};
        const auto channel = channels_.find(query.number(2));
        if (channel != channels_.end()) rows.push_back({query.number(0), row, channel->second});
      }
    });
    std::sort(rows.begin(), rows.end(), [](const MessageRow& a, const MessageRow& b) {
      return std::tie(a.stamp, a.row) < std::tie(b.stamp, b.row);
    });
    return rows;
  }

  void read_messages(const std::vector<MessageRow>& rows) {
    if (rows.empty()) return;
    reach([&] {
      Query query = database_.query("SELECT data FROM messages WHERE rowid = ?");
      for (const MessageRow& row : rows) ++(reach([&] { read_message(query, row); }) ? taken_ : lost_);
    });
  }

  void read_message(Query& query, const MessageRow& row) {
    query.start(row.row);
    if (!query.next()) throw DatabaseFault{"a row is gone"};
    visitor_.take(row.channel, 1e-9 * static_cast<double>(row.stamp), query.bytes(0));
  }

  const Database& database_;
  const std::string& name_;
  RecordingVisitor& visitor_;
  std::map<std::int64_t, int> channels_;  ///< those wanted, by the topic's id
  std::size_t topics_ = 0;
  std::size_t taken_ = 0;
  std::size_t lost_ = 0;
  std::string damage_;  ///< the first, in words
};

/// What a recorder that never closed has left beside its file; it holds the last messages.
void warn_of_journal(const std::filesystem::path& path, RecordingVisitor& visitor) {
  for (const char* const ending : {"-wal", "-journal"}) {
    std::filesystem::path journal = path;
    journal += ending;
    std::error_code error;
    if (std::filesystem::file_size(journal, error) > 0 && !error)
      visitor.warn(
          text::name_of(journal.filename()) +
          " beside it is not read: 'sqlite3 FILE \"SELECT count(*) FROM messages\"' on a copy of both joins them");
  }
}

}  // namespace

void read_rosbag2_database(const std::filesystem::path& path, RecordingVisitor& visitor) {
  const Database database(path);
  warn_of_journal(path, visitor);
  Rosbag2Reader(database, text::name_of(path), visitor).read();
}

void read_rosbag2_database(std::string bytes, const std::string& name, RecordingVisitor& visitor) {
  const Database database(std::move(bytes), name);
  Rosbag2Reader(database, name, visitor).read();
}

}  // namespace slamicp

#else

namespace slamicp {
namespace {

[[noreturn]] void fail_without_sqlite(const std::string& name) {
  throw Error("this slamicp was built without SQLite, which rosbag2 files need", name,
              "build it with SQLite (Debian: libsqlite3-dev)");
}

}  // namespace

void read_rosbag2_database(const std::filesystem::path& path, RecordingVisitor&) {
  fail_without_sqlite(text::name_of(path));
}
void read_rosbag2_database(std::string, const std::string& name, RecordingVisitor&) { fail_without_sqlite(name); }

}  // namespace slamicp

#endif
