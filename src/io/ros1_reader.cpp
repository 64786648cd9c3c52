// SPDX-License-Identifier: Apache-2.0
#include "io/ros1_reader.hpp"

#include <bit>

#include <slamicp/error.hpp>

#include "io/binary.hpp"

namespace slamicp::ros {

std::string_view Ros1Reader::take(std::size_t size) {
  if (size > rest_.size())
    throw Error("a message is cut: it ends before its fields do", where_, "record it again, or leave the topic out");
  const std::string_view taken = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return taken;
}

std::uint64_t Ros1Reader::bits(std::size_t size) { return binary::read_bits(take(size), 0, size, false); }

float Ros1Reader::f32() { return std::bit_cast<float>(u32()); }

double Ros1Reader::f64() { return std::bit_cast<double>(bits(8)); }

void Ros1Reader::floats(std::vector<float>& numbers) {
  constexpr std::size_t size = 4;
  const std::string_view taken = take(std::size_t{u32()} * size);
  numbers.resize(taken.size() / size);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = std::bit_cast<float>(static_cast<std::uint32_t>(binary::read_bits(taken, i * size, size, false)));
}

double Ros1Reader::stamp() {
  const std::uint32_t seconds = u32();
  const std::uint32_t nanoseconds = u32();
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
}

Header Ros1Reader::header() {
  Header header;
  u32();  // the sequence number, which ROS 2 gave up
  header.stamp = stamp();
  header.frame = string();
  return header;
}

}  // namespace slamicp::ros
