// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/registration/icp.hpp>

#include "support/random.hpp"

namespace slamicp::icp_options_test {
namespace {

using test::infinity;
using test::nan;

void expect_refused(const IcpOptions& options, const char* option) {
  EXPECT_EQ(options.problem().rfind(option, 0), 0U) << "'" << options.problem() << "' should begin with " << option;
  EXPECT_THROW(Icp<2>{options}, Error);
  EXPECT_THROW(Icp<3>{options}, Error);
}

TEST(IcpOptionsTest, TheDefaultsAreThePapersAndGood) {
  EXPECT_EQ(IcpOptions{}.problem(), "");
  EXPECT_EQ(IcpOptions{}.max_correspondence_distance, 0.3);
  EXPECT_EQ(IcpOptions{}.outlier_threshold(), 0.3);
  EXPECT_EQ(IcpOptions{.outlier_distance = 0.1}.outlier_threshold(), 0.1);
}

TEST(IcpOptionsTest, EachRuleNamesItsOption) {
  for (const double bad : {0.0, -0.3, nan, infinity}) {
    expect_refused({.max_correspondence_distance = bad}, "max_correspondence_distance");
    expect_refused({.outlier_distance = bad}, "outlier_distance");
    expect_refused({.kernel_scale = bad}, "kernel_scale");
    expect_refused({.translation_tolerance = bad}, "translation_tolerance");
    expect_refused({.rotation_tolerance = bad}, "rotation_tolerance");
  }
  for (const double bad : {-0.1, 0.31, nan, infinity}) expect_refused({.final_gate = bad}, "final_gate");
  for (const int bad : {0, -1}) expect_refused({.max_iterations = bad}, "max_iterations");
}

TEST(IcpOptionsTest, LimitsThatMeetAreAllowed) {
  EXPECT_EQ(IcpOptions{.final_gate = 0.3}.problem(), "");
  EXPECT_EQ(IcpOptions{.outlier_distance = 5.0}.problem(), "");
  EXPECT_EQ(IcpOptions{.max_iterations = 1}.problem(), "");
}

}  // namespace
}  // namespace slamicp::icp_options_test
