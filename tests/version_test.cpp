// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <string>

#include <slamicp/version.hpp>

namespace slamicp::version_test {
namespace {

TEST(Version, is_the_one_that_the_build_names) { EXPECT_EQ(std::string(version), SLAMICP_BUILD_VERSION); }

}  // namespace
}  // namespace slamicp::version_test
