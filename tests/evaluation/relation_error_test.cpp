// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/relation_error.hpp>

namespace slamicp::relation_error_test {
namespace {

// Stamps out of order, and one of them twice: the first counts.
const Trajectory poses = {{10.0, {0.0, 0.0, 0.0}},
                          {12.0, {1.0, 0.0, std::numbers::pi / 2.0}},
                          {11.0, {3.0, 3.0, 0.0}},
                          {11.0, {9.0, 9.0, 9.0}},
                          {90.0, {1.0, 2.0, std::numbers::pi}}};

TEST(RelationError, IsZeroForTheTrueRelations) {
  const std::vector<Relation> relations = {{10.0, 12.0, {1.0, 0.0, std::numbers::pi / 2.0}},
                                           {10.0, 11.0, {3.0, 3.0, 0.0}},
                                           {12.0, 90.0, {2.0, 0.0, std::numbers::pi / 2.0}}};
  const RelationError error = relation_error(poses, relations);
  EXPECT_EQ(error.all.translation.count, 3U);
  EXPECT_EQ(error.long_spans.translation.count, 1U);
  EXPECT_NEAR(error.all.translation.max, 0.0, 1e-12);
  EXPECT_NEAR(error.all.rotation_deg.max, 0.0, 1e-9);
}

TEST(RelationError, MeanAndDeviationOfKnownErrors) {
  const std::vector<Relation> relations = {{10.0, 12.0, {1.0, 0.1, std::numbers::pi / 2.0}},
                                           {12.0, 90.0, {2.3, 0.0, std::numbers::pi / 2.0 + 0.1}},
                                           {10.0, 50.0, {}}};
  const RelationError error = relation_error(poses, relations);
  EXPECT_EQ(error.not_found, 1U);
  EXPECT_NEAR(error.all.translation.mean, 0.2, 1e-12);
  EXPECT_NEAR(error.all.translation.standard_deviation, 0.1, 1e-12);
  EXPECT_NEAR(error.long_spans.translation.mean, 0.3, 1e-12);
  EXPECT_NEAR(error.long_spans.rotation_deg.mean, 18.0 / std::numbers::pi, 1e-9);
  EXPECT_NE(error.brief().find("1 relations not found"), std::string::npos);
}

TEST(RelationError, DoesNotCareWhereTheMapLies) {
  const std::vector<Relation> relations = {{10.0, 12.0, {0.9, 0.1, 1.5}}, {12.0, 90.0, {2.3, 0.0, 1.6}}};
  Trajectory moved = poses;
  for (StampedPose& pose : moved) pose.pose = Pose2{40.0, -7.0, 2.5} * pose.pose;
  EXPECT_NEAR(relation_error(moved, relations).all.translation.mean,
              relation_error(poses, relations).all.translation.mean, 1e-9);
}

TEST(RelationError, RefusesWhatCannotBeScored) {
  const std::vector<Relation> relations = {{10.0, 12.0, {}}};
  const std::vector<Relation> of_another_log = {{1000.0, 1200.0, {}}};
  const std::vector<Relation> broken = {{10.0, 12.0, {std::nan(""), 0.0, 0.0}}};
  EXPECT_THROW(relation_error({}, relations), Error);
  EXPECT_THROW(relation_error(poses, {}), Error);
  EXPECT_THROW(relation_error(poses, of_another_log), Error);
  EXPECT_THROW(relation_error(poses, broken), Error);
}

}  // namespace
}  // namespace slamicp::relation_error_test
