// SPDX-License-Identifier: Apache-2.0
#include "io/text.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>

#include <slamicp/error.hpp>

namespace slamicp::text {

std::string name_of(const std::filesystem::path& path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = name_of(path.extension());
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

std::string quoted(std::string_view piece) {
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for (const char c : piece.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (piece.size() > longest ? "...'" : "'");
}

std::string count_of(std::size_t count, std::string_view singular, std::string_view plural) {
  std::string text = std::to_string(count) + ' ';
  if (count == 1) return text.append(singular);
  return plural.empty() ? text.append(singular).append("s") : text.append(plural);
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw Error("is a folder", name_of(path), "name a file in it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const std::string cause = errno != 0 ? std::generic_category().message(errno) : "cannot open";
    throw Error("cannot be read: " + cause, name_of(path), "check the file's name and who may read it");
  }
  std::string content;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error) content.reserve(static_cast<std::size_t>(size));
  // In pieces, not by size: a pipe has none.
  char buffer[1 << 16];
  while (file.read(buffer, sizeof buffer) || file.gcount() > 0)
    content.append(buffer, static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw Error("reading stopped half way", name_of(path), "check the disk");
  return content;
}

Lines::Lines(std::string_view text, std::string_view name, std::size_t first_offset, std::size_t lines_before)
    : text_(text), name_(name), offset_(first_offset), number_(lines_before) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (offset_ == 0 && text_.starts_with(byte_order_mark)) offset_ = byte_order_mark.size();
}

bool Lines::next() {
  if (offset_ >= text_.size()) return false;
  const std::size_t end = text_.find('\n', offset_);
  cut_ = end == std::string_view::npos;
  line_ = text_.substr(offset_, cut_ ? std::string_view::npos : end - offset_);
  offset_ = cut_ ? text_.size() : end + 1;
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string Lines::where() const { return std::string(name_) + ':' + std::to_string(number_); }

namespace {

bool append_if_no_number(std::string& text, double number) {
  if (std::isfinite(number)) return false;
  text += std::isnan(number) ? "nan" : number > 0.0 ? "inf" : "-inf";
  return true;
}

}  // namespace

void append_fixed(std::string& text, double number, int decimals) {
  if (append_if_no_number(text, number)) return;
  char buffer[384];  // the largest double has 309 digits before the point
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed, decimals);
  std::string_view digits(buffer, error == std::errc{} ? static_cast<std::size_t>(end - buffer) : 0);
  if (digits.starts_with('-') && digits.find_first_not_of("-0.") == std::string_view::npos) digits.remove_prefix(1);
  text += digits;
}

void append_general(std::string& text, double number, int digits) {
  if (append_if_no_number(text, number)) return;
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, digits);
  text.append(buffer, error == std::errc{} ? end : buffer);
}

}  // namespace slamicp::text
