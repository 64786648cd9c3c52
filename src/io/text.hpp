// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

/// Reading and writing text as every reader and writer of the io room needs it: by line, by number, whatever the
/// locale says, with the place of a mistake at hand.
namespace slamicp::text {

/// The whole file, byte by byte. Throws Error.
std::string read_file(const std::filesystem::path& path);

/// The path for messages, UTF-8.
std::string name_of(const std::filesystem::path& path);

/// The file name's ending in lower case with its dot: ".pcd"; empty where it has none.
std::string ending_of(const std::filesystem::path& path);

/// A piece of a file for a message: in quotes, short, printable.
std::string quoted(std::string_view piece);

/// "1 line", "3 lines"
std::string count_of(std::size_t count, std::string_view singular, std::string_view plural = {});

inline bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Walks through a text line by line. Takes LF and CRLF.
class Lines {
 public:
  /// @param first_offset  where to start, for a text that follows a header
  /// @param lines_before  number of lines before `first_offset`
  Lines(std::string_view text, std::string_view name, std::size_t first_offset = 0, std::size_t lines_before = 0);

  /// Goes to the next line; false when there is none.
  bool next();

  std::string_view line() const noexcept { return line_; }
  std::size_t number() const noexcept { return number_; }
  /// The first byte after the current line.
  std::size_t offset() const noexcept { return offset_; }
  /// True on a last line that no newline ends: it may be a half-written one.
  bool cut() const noexcept { return cut_; }
  /// "run.clf:203"
  std::string where() const;

 private:
  std::string_view text_;
  std::string_view name_;
  std::string_view line_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
  bool cut_ = false;
};

/// Splits a line at blanks and commas: "a b", "a,b", "a , b" are two tokens each, "a,,b" are three.
class Tokens {
 public:
  explicit Tokens(std::string_view line) noexcept : rest_(line) {}

  bool next(std::string_view& token) noexcept {
    skip_blanks();
    if (rest_.empty()) return false;
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != ',' && !is_blank(rest_[end])) ++end;
    token = rest_.substr(0, end);
    rest_.remove_prefix(end);
    skip_blanks();
    if (!rest_.empty() && rest_.front() == ',') rest_.remove_prefix(1);
    return true;
  }

 private:
  void skip_blanks() noexcept {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }
  std::string_view rest_;
};

/// The number that the token is, whole; nothing otherwise. Takes a leading '+', "nan" and "inf".
template <class Number>
std::optional<Number> to_number(std::string_view token) noexcept {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-') token.remove_prefix(1);
  Number number{};
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// Appends with so many decimals; "inf", "-inf", "nan" where it is no number; never "-0.00".
void append_fixed(std::string& text, double number, int decimals);

/// Appends with so many significant digits and no needless zeros.
void append_general(std::string& text, double number, int digits = 12);

/// Appends the shortest text that reads back as the same number.
template <class Number>
void append_exact(std::string& text, Number number) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, number);
  text.append(buffer, error == std::errc{} ? end : buffer);
}

}  // namespace slamicp::text
