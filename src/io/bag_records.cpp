// SPDX-License-Identifier: Apache-2.0
#include "io/bag_records.hpp"

#include <algorithm>

#include "io/binary.hpp"

namespace slamicp {
namespace {

constexpr std::size_t length_size = 4;  // of the number of bytes before each block

/// The bytes that a length at `at` stands before; nothing where there is no length.
struct Block {
  std::string_view bytes;
  bool cut = false;
};
std::optional<Block> block_at(std::string_view bytes, std::size_t at) noexcept {
  if (at > bytes.size() || bytes.size() - at < length_size) return std::nullopt;
  const std::uint64_t length = binary::read_bits(bytes, at, length_size, false);
  const std::string_view rest = bytes.substr(at + length_size);
  return Block{rest.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(length, rest.size()))),
               length > rest.size()};
}

/// Takes the first field off; nothing where it is broken.
struct BagField {
  std::string_view name, value;
};
std::optional<BagField> take_field(std::string_view& fields) noexcept {
  const std::optional<Block> block = block_at(fields, 0);
  if (!block || block->cut) return std::nullopt;
  const std::size_t equals = block->bytes.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  fields.remove_prefix(length_size + block->bytes.size());
  return BagField{block->bytes.substr(0, equals), block->bytes.substr(equals + 1)};
}

/// What the record is; nothing where the header is broken.
std::optional<BagOp> op_of(std::string_view header) noexcept {
  std::optional<BagOp> op;
  while (!header.empty()) {
    const std::optional<BagField> field = take_field(header);
    if (!field) return std::nullopt;
    if (field->name == "op" && field->value.size() == 1) op = static_cast<BagOp>(field->value[0]);
  }
  return op;
}

/// Some recorders wrote index records of 12 bytes an entry with the length of 20 bytes an entry.
void mend_index_length(BagRecord& record, std::string_view rest) noexcept {
  constexpr std::uint64_t entry_size = 12;
  const std::optional<std::uint64_t> count = record.natural("count");
  if (record.natural("ver") != 1 || !count || *count * entry_size == record.data.size()) return;
  record.length_is_wrong = true;
  if (*count * entry_size > rest.size()) return;
  record.data = rest.substr(0, static_cast<std::size_t>(*count * entry_size));
  record.cut = false;
}

}  // namespace

std::optional<std::string_view> bag_field(std::string_view fields, std::string_view name) noexcept {
  while (!fields.empty()) {
    const std::optional<BagField> field = take_field(fields);
    if (!field) return std::nullopt;
    if (field->name == name) return field->value;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> BagRecord::natural(std::string_view name) const noexcept {
  const std::optional<std::string_view> value = field(name);
  if (!value || (value->size() != 4 && value->size() != 8)) return std::nullopt;
  return binary::read_bits(*value, 0, value->size(), false);
}

std::optional<double> BagRecord::time(std::string_view name) const noexcept {
  const std::optional<std::string_view> value = field(name);
  if (!value || value->size() != 8) return std::nullopt;
  return static_cast<double>(binary::read_bits(*value, 0, 4, false)) +
         1e-9 * static_cast<double>(binary::read_bits(*value, 4, 4, false));
}

bool BagRecords::next() noexcept {
  if (record_.cut || next_ >= bytes_.size()) return false;
  const std::optional<Block> header = block_at(bytes_, next_);
  if (!header || header->cut) return false;
  const std::optional<BagOp> op = op_of(header->bytes);
  const std::size_t data_at = next_ + length_size + header->bytes.size();
  const std::optional<Block> data = block_at(bytes_, data_at);
  if (!op || !data) return false;
  record_ = {.at = next_, .op = *op, .header = header->bytes, .data = data->bytes, .cut = data->cut};
  const std::string_view rest = bytes_.substr(data_at + length_size);
  if (*op == BagOp::index) mend_index_length(record_, rest);
  next_ = data_at + length_size + record_.data.size();
  return true;
}

}  // namespace slamicp
