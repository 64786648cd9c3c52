// SPDX-License-Identifier: Apache-2.0
#include "io/cdr.hpp"

#include <slamicp/error.hpp>

#ifdef SLAMICP_WITH_CDR

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>
#include <fastcdr/exceptions/NotEnoughMemoryException.h>

namespace slamicp::ros {

namespace fastcdr = eprosima::fastcdr;

struct CdrReader::State {
  State(std::string_view body, const std::string& where)
      : place(where),
        buffer(const_cast<char*>(body.data()), body.size()),  // Fast-CDR has one buffer for both ways; we only read
        end(body.data() + body.size()),
        cdr(buffer, fastcdr::Cdr::DEFAULT_ENDIAN, fastcdr::Cdr::DDS_CDR) {
    if (body.size() < 4) fail("message is cut: its " + std::to_string(body.size()) + " bytes hold no header");
    if (body[0] != 0 || (body[1] != 0 && body[1] != 1)) fail("message is in no plain CDR");
    guard([&] { cdr.read_encapsulation(); });
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(problem, place, "leave this topic out, or record it anew");
  }

  template <class Read>
  void guard(Read read) {
    try {
      read();
    } catch (const fastcdr::exception::NotEnoughMemoryException&) {
      fail("message ends within a field");
    } catch (const fastcdr::exception::Exception& broken) {
      fail(std::string("message has a broken field: ") + broken.what());
    }
  }

  template <class Number>
  Number number() {
    Number value{};
    guard([&] { cdr.deserialize(value); });
    return value;
  }

  std::size_t remaining() { return static_cast<std::size_t>(end - cdr.getCurrentPosition()); }

  /// The number of elements that follow, each of so many bytes.
  std::uint32_t count(std::size_t element_size) {
    const auto count = number<std::uint32_t>();
    if (count > remaining() / element_size)
      fail("message is cut: " + std::to_string(count) + " elements of a sequence do not fit into " +
           std::to_string(remaining()) + " bytes");
    return count;
  }

  std::string_view bytes() {
    const std::uint32_t size = count(1);
    const std::string_view bytes(cdr.getCurrentPosition(), size);
    if (size > 0) {
      // jump() alone would let Fast-CDR think that it still is where numbers of 4 bytes stand.
      cdr.jump(size - 1);
      number<std::uint8_t>();
    }
    return bytes;
  }

  void floats(std::vector<float>& numbers) {
    numbers.resize(count(sizeof(float)));
    if (!numbers.empty()) guard([&] { cdr.deserializeArray(numbers.data(), numbers.size()); });
  }

  const std::string& place;
  fastcdr::FastBuffer buffer;
  const char* end;
  fastcdr::Cdr cdr;
};

}  // namespace slamicp::ros

#else

namespace slamicp::ros {

struct CdrReader::State {
  State(std::string_view, const std::string& where) {
    throw Error("this slamicp was built without Fast-CDR, which messages of ROS 2 need", where,
                "build it with Fast-CDR 1 (Debian: libfastcdr-dev)");
  }
  template <class Number>
  Number number() {
    return {};
  }
  std::string_view bytes() { return {}; }
  void floats(std::vector<float>&) {}
  std::size_t remaining() { return 0; }
};

}  // namespace slamicp::ros

#endif

namespace slamicp::ros {

CdrReader::CdrReader(std::string_view body, const std::string& where) : state_(std::make_unique<State>(body, where)) {}
CdrReader::CdrReader(CdrReader&&) noexcept = default;
CdrReader::~CdrReader() = default;

std::uint8_t CdrReader::u8() { return state_->number<std::uint8_t>(); }
std::uint32_t CdrReader::u32() { return state_->number<std::uint32_t>(); }
std::int32_t CdrReader::i32() { return state_->number<std::int32_t>(); }
float CdrReader::f32() { return state_->number<float>(); }
double CdrReader::f64() { return state_->number<double>(); }
bool CdrReader::boolean() { return state_->number<bool>(); }

std::string CdrReader::string() {
  std::string_view text = state_->bytes();
  if (text.ends_with('\0')) text.remove_suffix(1);
  return std::string(text);
}

void CdrReader::floats(std::vector<float>& numbers) { state_->floats(numbers); }

std::string_view CdrReader::bytes() { return state_->bytes(); }

double CdrReader::stamp() {
  const std::int32_t seconds = i32();
  return seconds + 1e-9 * u32();
}

Header CdrReader::header() {
  Header header;
  header.stamp = stamp();
  header.frame = string();
  return header;
}

std::size_t CdrReader::remaining() const noexcept { return state_->remaining(); }

}  // namespace slamicp::ros
