// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/registration/robust_kernel.hpp>

namespace slamicp::robust_kernel_test {
namespace {

constexpr RobustKernel kernels[] = {RobustKernel::none, RobustKernel::huber, RobustKernel::cauchy,
                                    RobustKernel::geman_mcclure, RobustKernel::tukey};

TEST(RobustKernelTest, WeightsAreZhangsFormulas) {
  // At the scale, at twice the scale, and at half of it; the scale is in metres.
  EXPECT_EQ(kernel_weight(RobustKernel::none, 7.0, 0.05), 1.0);

  EXPECT_EQ(kernel_weight(RobustKernel::huber, 0.025, 0.05), 1.0);
  EXPECT_EQ(kernel_weight(RobustKernel::huber, 0.05, 0.05), 1.0);
  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::huber, 0.10, 0.05), 0.5);

  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::cauchy, 0.05, 0.05), 0.5);
  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::cauchy, 0.10, 0.05), 0.2);

  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::geman_mcclure, 0.05, 0.05), 0.25);
  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::geman_mcclure, 0.10, 0.05), 0.04);

  EXPECT_DOUBLE_EQ(kernel_weight(RobustKernel::tukey, 0.025, 0.05), 0.5625);
  EXPECT_EQ(kernel_weight(RobustKernel::tukey, 0.05, 0.05), 0.0);
  EXPECT_EQ(kernel_weight(RobustKernel::tukey, 5.0, 0.05), 0.0);
}

TEST(RobustKernelTest, WeightsFallFromOneToZeroAndDoNotCareForTheSign) {
  for (const RobustKernel kernel : kernels) {
    EXPECT_EQ(kernel_weight(kernel, 0.0, 0.1), 1.0);
    double last = 1.0;
    for (int k = 1; k <= 2000; ++k) {
      const double residual = 0.001 * k;
      const double weight = kernel_weight(kernel, residual, 0.1);
      EXPECT_EQ(weight, kernel_weight(kernel, -residual, 0.1));
      EXPECT_LE(weight, last);
      EXPECT_GE(weight, 0.0);
      last = weight;
    }
  }
}

TEST(RobustKernelTest, OnlyTheRatioToTheScaleCounts) {
  for (const RobustKernel kernel : kernels)
    for (const double ratio : {0.3, 0.99, 1.01, 4.0})
      EXPECT_NEAR(kernel_weight(kernel, ratio * 0.02, 0.02), kernel_weight(kernel, ratio * 3.0, 3.0), 1e-12);
}

}  // namespace
}  // namespace slamicp::robust_kernel_test
