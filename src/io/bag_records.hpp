// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slamicp {

/// What a record of a ROS 1 bag is; other values are skipped.
enum class BagOp : std::uint8_t {
  message = 0x02,
  bag_header = 0x03,
  index = 0x04,
  chunk = 0x05,
  chunk_info = 0x06,
  connection = 0x07,
};

/// The value of `name` among fields `length name=value`; nothing where it is not there or the fields are broken.
std::optional<std::string_view> bag_field(std::string_view fields, std::string_view name) noexcept;

/// One record of a ROS 1 bag: header fields, and data.
struct BagRecord {
  std::size_t at = 0;  ///< its first byte
  BagOp op = BagOp::bag_header;
  std::string_view header;
  std::string_view data;         ///< as much as there is, where it is cut
  bool cut = false;              ///< the data end half way
  bool length_is_wrong = false;  ///< of an index record: it is not that of its entries

  std::optional<std::string_view> field(std::string_view name) const noexcept { return bag_field(header, name); }
  /// A field of 4 or 8 bytes as a number.
  std::optional<std::uint64_t> natural(std::string_view name) const noexcept;
  /// A field of seconds and nanoseconds [s].
  std::optional<double> time(std::string_view name) const noexcept;
};

/// Walks through the records of a ROS 1 bag, or of a chunk of one. No length is believed beyond the bytes at hand.
class BagRecords {
 public:
  BagRecords(std::string_view bytes, std::size_t first) noexcept : bytes_(bytes), next_(first) {}

  /// Goes to the next record; false at the end, and where what follows is no record.
  bool next() noexcept;
  const BagRecord& record() const noexcept { return record_; }
  /// True where all bytes were whole records.
  bool at_end() const noexcept { return next_ == bytes_.size() && !record_.cut; }
  /// Where the walk stopped, or the record that is cut.
  std::size_t stopped_at() const noexcept { return record_.cut ? record_.at : next_; }

 private:
  std::string_view bytes_;
  std::size_t next_;
  BagRecord record_;
};

}  // namespace slamicp
