// SPDX-License-Identifier: Apache-2.0
#include "io/compression.hpp"

#include <gtest/gtest.h>

#include "io/io_test_support.hpp"
#include "support/packing.hpp"

namespace slamicp::compression_test {
namespace {

using io_test::expect_error;

constexpr std::size_t no_limit = std::size_t{1} << 30U;

/// Text that packs well, but not to nothing.
std::string content_of(std::size_t size) {
  std::string content;
  for (std::size_t i = 0; content.size() < size; ++i) content += std::to_string(i * i % 1013) + ' ';
  content.resize(size);
  return content;
}

class Packed : public ::testing::TestWithParam<Compression> {
 protected:
  void SetUp() override {
    if (!test::can_pack(GetParam())) GTEST_SKIP() << "skipped: this build has no " << name_of(GetParam());
  }
  static std::string unpacked(std::string_view packed, std::size_t limit = no_limit) {
    return unpack(GetParam(), packed, limit, "run.bag");
  }
};

TEST_P(Packed, ComesBack) {
  for (const std::size_t size : {0U, 1U, 1000U, 65535U, 65536U, 65537U, 700'000U}) {
    const std::string content = content_of(size);
    EXPECT_EQ(unpacked(test::pack(GetParam(), content)), content) << size;
    EXPECT_EQ(unpacked(test::pack(GetParam(), content), size), content) << size;
  }
}

TEST_P(Packed, SeveralStreamsAreOneContentAndWhatFollowsIsLeftOut) {
  const std::string a = content_of(1000), b = content_of(70'000);
  EXPECT_EQ(unpacked(test::pack(GetParam(), a) + test::pack(GetParam(), b)), a + b);
  EXPECT_EQ(unpacked(test::pack(GetParam(), a) + std::string(100, '\0')), a);
}

TEST_P(Packed, IsToldByItsFirstBytes) {
  const std::string packed = test::pack(GetParam(), content_of(1000));
  EXPECT_TRUE(is_packed(GetParam(), packed));
  EXPECT_FALSE(is_packed(GetParam(), packed.substr(0, 1)));
  EXPECT_FALSE(is_packed(GetParam(), packed.substr(1)));
  EXPECT_FALSE(is_packed(Compression::none, packed));
}

TEST_P(Packed, NeverGivesMoreThanTheLimit) {
  const std::string bomb = test::pack(GetParam(), std::string(std::size_t{20} << 20U, '\0'));
  expect_error([&] { unpacked(bomb, 1'000'000); }, "run.bag", "unpacks to more than 1000000 bytes");
  expect_error([&] { unpacked(test::pack(GetParam(), "12345678"), 7); }, "run.bag", "more than 7 bytes");
}

TEST_P(Packed, CutAnywhereIsAnError) {
  const std::string packed = test::pack(GetParam(), content_of(3000));
  for (std::size_t size = 0; size < packed.size(); ++size)
    EXPECT_THROW(unpacked(std::string_view(packed).substr(0, size)), Error) << size;
  expect_error([&] { unpacked(std::string_view(packed).substr(0, packed.size() / 2)); }, "run.bag", "is cut");
}

TEST_P(Packed, OtherBytesAreAnError) {
  const std::string name(name_of(GetParam()));
  expect_error([&] { unpacked("FLASER 180 1.0 1.0 1.0 1.0 1.0"); }, "run.bag", "is no " + name + ", or broken");
  std::string packed = test::pack(GetParam(), content_of(3000));
  std::size_t passed = 0;
  for (std::size_t at = 0; at < packed.size(); at += 7) {
    std::string broken = packed;
    broken[at] = static_cast<char>(broken[at] ^ 0x55);
    try {
      passed += unpacked(broken) == content_of(3000) ? 0 : 1;
    } catch (const Error&) {
    }
  }
  // All have checksums, but for Zstandard, which our writer does not ask for them.
  if (GetParam() != Compression::zstd) {
    EXPECT_EQ(passed, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Packed,
                         ::testing::Values(Compression::lz4, Compression::bz2, Compression::gzip, Compression::xz,
                                           Compression::zstd),
                         [](const auto& param_info) { return std::string(name_of(param_info.param)); });

TEST(Compression, IsToldByTheEnding) {
  EXPECT_EQ(compression_of_ending(".gz"), Compression::gzip);
  EXPECT_EQ(compression_of_ending(".xz"), Compression::xz);
  EXPECT_EQ(compression_of_ending(".zst"), Compression::zstd);
  EXPECT_EQ(compression_of_ending(".bz2"), Compression::bz2);
  EXPECT_EQ(compression_of_ending(".lz4"), Compression::lz4);
  EXPECT_EQ(compression_of_ending(".clf"), Compression::none);
  EXPECT_EQ(compression_of_ending(""), Compression::none);
}

TEST(Compression, NoneGivesTheBytes) {
  EXPECT_EQ(unpack(Compression::none, "abc", 3, "run.bag"), "abc");
  expect_error([] { unpack(Compression::none, "abc", 2, "run.bag"); }, "run.bag", "more than 2 bytes");
}

}  // namespace
}  // namespace slamicp::compression_test
