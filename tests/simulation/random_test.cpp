// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/simulation/random.hpp>

namespace slamicp::random_test {
namespace {

TEST(Random, GivesThePublishedNumbersOfXoshiro256StarStar) {
  Random random(Random::State{1, 2, 3, 4});
  EXPECT_EQ(random.bits(), 11520U);
  EXPECT_EQ(random.bits(), 0U);
  EXPECT_EQ(random.bits(), 1509978240U);
  EXPECT_EQ(random.bits(), 1215971899390074240U);
}

TEST(Random, FillsItsStateByThePublishedNumbersOfSplitMix64) {
  const Random expected(
      Random::State{6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U});
  EXPECT_EQ(Random(1234567), expected);
}

TEST(Random, NormalIsTheSameNumberWithEveryCompiler) { EXPECT_EQ(Random(1).normal(), 0.11801966310721994); }

TEST(Random, ACopyGoesOnWithTheSameNumbers) {
  Random one(5);
  one.normal();
  Random other = one;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one.normal(), other.normal());
}

TEST(Random, StreamsDiffer) {
  const Random random(5);
  EXPECT_EQ(random.stream(1), random.stream(1));
  EXPECT_NE(random.stream(1), random.stream(2));
  EXPECT_NE(random.stream(1), Random(6).stream(1));
}

TEST(Random, UniformFillsItsInterval) {
  Random random(1);
  double sum = 0.0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double number = random.uniform(2.0, 4.0);
    ASSERT_GE(number, 2.0);
    ASSERT_LT(number, 4.0);
    sum += number;
  }
  EXPECT_NEAR(sum / count, 3.0, 0.01);
}

TEST(Random, NormalHasTheMomentsAndTheTailsOfANormal) {
  Random random(1);
  constexpr int count = 400000;
  double mean = 0.0;
  double square = 0.0;
  double cube = 0.0;
  double fourth = 0.0;
  int beyond_two = 0;
  int beyond_three = 0;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    mean += x / count;
    square += x * x / count;
    cube += x * x * x / count;
    fourth += x * x * x * x / count;
    beyond_two += std::abs(x) > 2.0 ? 1 : 0;
    beyond_three += std::abs(x) > 3.0 ? 1 : 0;
  }
  // Bounds: about four standard errors each.
  EXPECT_NEAR(mean, 0.0, 0.0065);
  EXPECT_NEAR(square, 1.0, 0.009);
  EXPECT_NEAR(cube, 0.0, 0.025);
  EXPECT_NEAR(fourth, 3.0, 0.065);
  EXPECT_NEAR(static_cast<double>(beyond_two) / count, 0.0455, 0.0014);
  EXPECT_NEAR(static_cast<double>(beyond_three) / count, 0.0027, 0.00035);
}

}  // namespace
}  // namespace slamicp::random_test
