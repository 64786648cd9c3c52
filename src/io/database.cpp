// SPDX-License-Identifier: Apache-2.0
#ifdef SLAMICP_WITH_SQLITE

#include "io/database.hpp"

#include <algorithm>
#include <fstream>
#include <sqlite3.h>
#include <system_error>
#include <utility>

#include <slamicp/error.hpp>

#include "io/binary.hpp"
#include "io/text.hpp"

namespace slamicp {
namespace {

/// The file as a URI that tells SQLite to write nothing beside it, no matter what its journals say.
std::string immutable_uri(const std::filesystem::path& path) {
  constexpr std::string_view plain = "-._~/:";
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = "file://";
  const std::u8string absolute = std::filesystem::absolute(path).generic_u8string();
  if (!absolute.starts_with(u8'/')) uri += '/';
  for (const char8_t unit : absolute) {
    const char c = static_cast<char>(unit);
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || plain.find(c) != std::string_view::npos)
      uri += c;
    else
      uri.append({'%', digits[unit >> 4], digits[unit & 0xF]});
  }
  return uri + "?immutable=1";
}

constexpr std::size_t database_header_size = 100;

/// As the file's header says; 1 where it is none.
std::size_t database_page_size(std::string_view file) {
  constexpr std::string_view magic("SQLite format 3\0", 16);
  if (file.size() < database_header_size || !file.starts_with(magic)) return 1;
  const std::uint64_t size = binary::read_bits(file, magic.size(), 2, true);
  constexpr std::size_t largest = 65536;  // which 16 bits do not hold
  return size <= 1 ? largest : static_cast<std::size_t>(size);
}

}  // namespace

Query::Query(sqlite3* database, const std::string& sql) : statement_(nullptr, &sqlite3_finalize) {
  sqlite3_stmt* statement = nullptr;
  const int result = sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr);
  statement_.reset(statement);
  if (result != SQLITE_OK) throw DatabaseFault{sqlite3_errmsg(database)};
}

void Query::start(std::int64_t number) {
  sqlite3_reset(statement_.get());
  sqlite3_bind_int64(statement_.get(), 1, number);
}

bool Query::next() {
  const int result = sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  if (result == SQLITE_DONE) return false;
  throw DatabaseFault{sqlite3_errmsg(sqlite3_db_handle(statement_.get()))};
}

std::int64_t Query::number(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::string_view Query::bytes(int column) const {
  // SQLite wants to be asked in this order.
  const void* const bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return bytes == nullptr ? std::string_view{}
                          : std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

Database::Database(const std::filesystem::path& path) : database_(nullptr, &sqlite3_close) {
  const std::string name = text::name_of(path);
  std::string header(database_header_size, '\0');
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!file || error) throw Error("cannot be read", name, "check the file's name and who may read it");
  file.read(header.data(), database_header_size);
  if (size % database_page_size(header) != 0) {
    bytes_ = text::read_file(path);
    open_bytes(name);
  } else {
    open(immutable_uri(path));
    protect(name);
  }
}

Database::Database(std::string bytes, const std::string& name)
    : bytes_(std::move(bytes)), database_(nullptr, &sqlite3_close) {
  open_bytes(name);
}

void Database::open_bytes(const std::string& name) {
  // Of a page that is not there as a whole SQLite would take the rest for zeros, and give messages that end in them.
  if (const std::size_t too_many = bytes_.size() % database_page_size(bytes_); too_many != 0) {
    bytes_.resize(bytes_.size() - too_many);
    damage_ = "it ends within a page";
  }
  // What lies in memory has no journal beside it, so what says so in the header is taken back.
  constexpr std::size_t versions = 18;
  if (bytes_.size() >= database_header_size) bytes_[versions] = bytes_[versions + 1] = 1;
  open("file::memory:");
  const auto size = static_cast<sqlite3_int64>(bytes_.size());
  if (sqlite3_deserialize(database_.get(), "main", reinterpret_cast<unsigned char*>(bytes_.data()), size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    throw Error("cannot be read as an SQLite database", name, "give a rosbag2 file");
  protect(name);
}

void Database::open(const std::string& uri) {
  sqlite3* database = nullptr;
  const int result =
      sqlite3_open_v2(uri.c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK)
    throw Error(std::string("cannot be opened: ") + sqlite3_errstr(result), uri, "check the file and the disk");
}

void Database::protect(const std::string& name) {
  sqlite3* const database = database_.get();
  for (const int what : {SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_TRUSTED_SCHEMA})
    sqlite3_db_config(database, what, 0, nullptr);
  const auto run = [&](const char* sql) { return sqlite3_exec(database, sql, nullptr, nullptr, nullptr); };
  run("PRAGMA cell_size_check=ON");
  const int result = run("SELECT count(*) FROM sqlite_master");
  if (result == SQLITE_NOTADB) throw Error("is no SQLite database", name, "give a rosbag2 file");
  if (result == SQLITE_OK) return;
  if (damage_.empty()) damage_ = sqlite3_errmsg(database);
  // So SQLite opens a file that is shorter than it says.
  run("PRAGMA writable_schema=ON");
}

}  // namespace slamicp

#endif
