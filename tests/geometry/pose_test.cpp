// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>

#include <slamicp/geometry/pose.hpp>

#include "support/random.hpp"

namespace slamicp::pose_test {
namespace {

using test::pi;

template <int D>
void expect_near(const Pose<D>& a, const Pose<D>& b, double tolerance) {
  EXPECT_LT(distance(a, b).translation, tolerance);
  EXPECT_LT(distance(a, b).rotation, tolerance);
}

/// What holds in every Lie group, asked of SE(2) and SE(3) alike.
template <typename P>
class PoseTest : public ::testing::Test {
 protected:
  static constexpr int D = std::is_same_v<P, Pose2> ? 2 : 3;
  static constexpr int n = P::degrees_of_freedom;
  using Tangent = typename P::Tangent;

  P any() { return random.pose<D>(5.0, D == 2 ? 3.1 : 1.7); }
  /// A tangent that turns by `angle` about some axis.
  Tangent turning(double angle) {
    Tangent tangent;
    tangent.template head<D>() = random.point<D>(3.0);
    Vector<n - D> axis = random.point<n - D>(1.0);
    tangent.template tail<n - D>() = angle * axis.normalized();
    return tangent;
  }
  test::Random random{1};
};

using Groups = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(PoseTest, Groups);

TYPED_TEST(PoseTest, LogUndoesExpUpToHalfATurn) {
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-9, 9.9e-5, 1.01e-4, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14159, pi - 1e-7}) {
    for (int k = 0; k < 20; ++k) {
      const auto tangent = this->turning(angle);
      EXPECT_LT((TypeParam::exp(tangent).log() - tangent).norm(), 1e-9) << "angle " << angle;
    }
  }
}

TYPED_TEST(PoseTest, ExpUndoesLog) {
  for (int k = 0; k < 1000; ++k) {
    const TypeParam pose = this->any();
    expect_near(TypeParam::exp(pose.log()), pose, 1e-10);
  }
  expect_near(TypeParam::exp(TypeParam{}.log()), TypeParam{}, 1e-15);
}

TYPED_TEST(PoseTest, ExpUndoesLogAtExactlyHalfATurn) {
  for (int k = 0; k < 100; ++k) {
    const TypeParam pose = TypeParam::exp(this->turning(pi));
    EXPECT_TRUE(pose.log().allFinite());
    expect_near(TypeParam::exp(pose.log()), pose, 1e-9);
  }
}

TYPED_TEST(PoseTest, ExpStartsAsTheTangentSays) {
  // d exp(t v) / dt at 0, by central differences, is v: the translation moves by its head, a point turns by its tail.
  constexpr double h = 1e-5;
  for (int k = 0; k < 100; ++k) {
    const auto v = this->turning(1.3);
    const Point<TestFixture::D> point = this->random.template point<TestFixture::D>(2.0);
    const auto slope = ((TypeParam::exp(h * v) * point - TypeParam::exp(-h * v) * point) / (2.0 * h)).eval();
    Point<TestFixture::D> expected = v.template head<TestFixture::D>();
    if constexpr (TestFixture::D == 2)
      expected += v[2] * Point2(-point.y(), point.x());
    else
      expected += Point3(v.template tail<3>().cross(point));
    EXPECT_LT((slope - expected).norm(), 1e-8);
  }
}

TYPED_TEST(PoseTest, ExpOfASumAlongOneLineIsAProduct) {
  for (int k = 0; k < 100; ++k) {
    const auto v = this->turning(1.0);
    expect_near(TypeParam::exp(0.4 * v) * TypeParam::exp(0.3 * v), TypeParam::exp(0.7 * v), 1e-12);
    expect_near(interpolate(TypeParam::exp(v), 0.25), TypeParam::exp(0.25 * v), 1e-12);
  }
}

TYPED_TEST(PoseTest, AdjointMovesATangentThroughThePose) {
  for (int k = 0; k < 200; ++k) {
    const TypeParam pose = this->any();
    const auto v = this->turning(0.8);
    expect_near(pose * TypeParam::exp(v), TypeParam::exp(pose.adjoint() * v) * pose, 1e-11);
  }
}

TYPED_TEST(PoseTest, ProductsChainLikeFractions) {
  for (int k = 0; k < 200; ++k) {
    const TypeParam T_a_b = this->any();
    const TypeParam T_b_c = this->any();
    const TypeParam T_c_d = this->any();
    const Point<TestFixture::D> in_c = this->random.template point<TestFixture::D>(4.0);
    EXPECT_LT(((T_a_b * T_b_c) * in_c - T_a_b * (T_b_c * in_c)).norm(), 1e-12);
    expect_near((T_a_b * T_b_c) * T_c_d, T_a_b * (T_b_c * T_c_d), 1e-12);
  }
}

TYPED_TEST(PoseTest, InverseUndoes) {
  for (int k = 0; k < 200; ++k) {
    const TypeParam pose = this->any();
    expect_near(pose * pose.inverse(), TypeParam{}, 1e-12);
    expect_near(pose.inverse() * pose, TypeParam{}, 1e-12);
    EXPECT_LT((pose.inverse() * (pose * pose.translation()) - pose.translation()).norm(), 1e-12);
  }
}

TYPED_TEST(PoseTest, IsItsRotationAndTranslation) {
  for (int k = 0; k < 200; ++k) {
    const TypeParam pose = this->any();
    const Point<TestFixture::D> point = this->random.template point<TestFixture::D>(4.0);
    EXPECT_LT((pose * point - (pose.rotation() * point + pose.translation())).norm(), 1e-12);
    EXPECT_NEAR(pose.rotation().determinant(), 1.0, 1e-12);
    expect_near(TypeParam::from(pose.rotation(), pose.translation()), pose, 1e-12);
  }
}

TYPED_TEST(PoseTest, DistanceIsTheLengthOfTheMotionBetween) {
  for (int k = 0; k < 200; ++k) {
    const TypeParam a = this->any();
    const TypeParam b = this->any();
    const auto motion = (a.inverse() * b).log();
    EXPECT_NEAR(distance(a, b).rotation, motion.template tail<TestFixture::n - TestFixture::D>().norm(), 1e-9);
    EXPECT_NEAR(distance(a, b).translation, (a.translation() - b.translation()).norm(), 1e-12);
    EXPECT_EQ(distance(a, a).translation, 0.0);
    EXPECT_LT(distance(a, a).rotation, 1e-12);
  }
}

TYPED_TEST(PoseTest, KnowsWhetherItIsFinite) {
  EXPECT_TRUE(TypeParam{}.is_finite());
  for (const double bad : {test::nan, test::infinity}) {
    for (int k = 0; k < TestFixture::D; ++k) {
      Point<TestFixture::D> translation = Point<TestFixture::D>::Zero();
      translation[k] = bad;
      EXPECT_FALSE(TypeParam::from(TypeParam{}.rotation(), translation).is_finite());
    }
  }
}

TEST(Pose2Test, HeadingsStayInTheHalfOpenTurn) {
  test::Random random(2);
  for (int k = 0; k < 10000; ++k) {
    const Pose2 a = random.pose<2>(1.0, 3.14159);
    const Pose2 b = random.pose<2>(1.0, 3.14159);
    for (const double theta : {(a * b).theta, a.inverse().theta, Pose2::exp(a.log() + b.log()).theta, b.log()[2]}) {
      EXPECT_GT(theta, -pi);
      EXPECT_LE(theta, pi);
    }
  }
  EXPECT_EQ((Pose2{0, 0, pi}).inverse().theta, pi);
}

TEST(WrapAngleTest, IsInTheHalfOpenTurnAndTheSameDirection) {
  EXPECT_EQ(wrap_angle(pi), pi);
  EXPECT_EQ(wrap_angle(-pi), pi);
  EXPECT_EQ(wrap_angle(0.0), 0.0);
  EXPECT_EQ(wrap_angle(3.0), 3.0);
  test::Random random(3);
  for (int k = 0; k < 10000; ++k) {
    const double angle = random.uniform(-100.0, 100.0);
    const double wrapped = wrap_angle(angle);
    ASSERT_GT(wrapped, -pi);
    ASSERT_LE(wrapped, pi);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
  }
  for (int turns = -50; turns <= 50; ++turns) {
    EXPECT_GT(wrap_angle((2 * turns + 1) * pi), -pi);
    EXPECT_LE(wrap_angle((2 * turns + 1) * pi), pi);
  }
}

TEST(PoseTextTest, SaysMetresAndDegrees) {
  EXPECT_EQ(to_string(Pose2{1.2, 0.4, pi / 12.0}), "1.200 m, 0.400 m, 15.00 deg");
  EXPECT_EQ(to_string(Pose3{}), "0.000 m, 0.000 m, 0.000 m, turned by (0.00, 0.00, 0.00) deg");
}

TEST(BoundsTest, HoldTheFinitePointsOnly) {
  const PointCloud2 cloud = {{1, 5}, {test::nan, 9}, {-2, 3}, {test::infinity, -9}};
  const Bounds<2> bounds = bounds_of<2>(cloud);
  EXPECT_EQ(bounds.lower, Point2(-2, 3));
  EXPECT_EQ(bounds.upper, Point2(1, 5));
  EXPECT_TRUE(bounds_of<2>({}).empty());
  EXPECT_FALSE(bounds.empty());
}

}  // namespace
}  // namespace slamicp::pose_test
