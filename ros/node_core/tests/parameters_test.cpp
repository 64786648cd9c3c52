// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <slamicp_node/parameters.hpp>

#include <slamicp/error.hpp>

namespace slamicp::parameters_test {
namespace {

using node::NodeOptions;
using node::options_from;
using node::Values;

std::string problem_of(const Values& values) {
  std::vector<std::string> warnings;
  try {
    options_from(values, warnings);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Parameters, AreTakenByTheirNames) {
  std::vector<std::string> warnings;
  const NodeOptions options = options_from({{"odom_frame_id", std::string("wheels")},
                                            {"initial_pose_x", 2},
                                            {"initial_pose_a", 0.5},
                                            {"scan_topics", std::vector<std::string>{"front", "back"}},
                                            {"tf_broadcast", false}},
                                           warnings);
  EXPECT_EQ(options.odom_frame_id, "wheels");
  EXPECT_EQ(options.initial_pose_x, 2.0);
  EXPECT_EQ(options.initial_pose_a, 0.5);
  EXPECT_EQ(options.scan_topics.size(), 2U);
  EXPECT_FALSE(options.tf_broadcast);
  EXPECT_TRUE(warnings.empty());
}

TEST(Parameters, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_NE(problem_of({{"odom_frame", std::string("odom")}}).find("'odom_frame_id'"), std::string::npos);
  EXPECT_NE(problem_of({{"transform_tolerence", 0.1}}).find("'transform_tolerance'"), std::string::npos);
  EXPECT_NE(problem_of({{"gravity", 9.81}}).find("there is no parameter 'gravity'"), std::string::npos);
}

TEST(Parameters, WrongTypesAndRangesAreRefused) {
  EXPECT_NE(problem_of({{"deskew", 1}}).find("'deskew' is a bool"), std::string::npos);
  EXPECT_NE(problem_of({{"max_iterations", 2.5}}).find("'max_iterations' is a int"), std::string::npos);
  EXPECT_NE(problem_of({{"odometry_wait", -1.0}}).find("from 0 to 10"), std::string::npos);
  EXPECT_NE(problem_of({{"mode", std::string("flying")}}).find("mode must be"), std::string::npos);
  EXPECT_NE(problem_of({{"base_frame_id", std::string("odom")}}).find("must differ"), std::string::npos);
}

TEST(Parameters, ThoseOfAmclAreTaken) {
  std::vector<std::string> warnings;
  const NodeOptions options = options_from({{"min_particles", 500},
                                            {"odom_model_type", std::string("diff")},
                                            {"laser_max_range", 12.0},
                                            {"laser_min_range", -1.0},
                                            {"use_map_topic", false}},
                                           warnings);
  EXPECT_EQ(options.max_range, 12.0);
  EXPECT_EQ(options.min_range, 0.0);
  EXPECT_FALSE(options.use_map_topic);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].find("no particles"), std::string::npos);
}

TEST(Parameters, ThoseOfNav2sAmclAreUnderstood) {
  std::vector<std::string> warnings;
  const NodeOptions options = options_from({{"set_initial_pose", true},
                                            {"initial_pose.x", -2.0},
                                            {"initial_pose.y", 3},
                                            {"initial_pose.z", 0.0},
                                            {"initial_pose.yaw", 0.5},
                                            {"scan_topic", std::string("front/scan")},
                                            {"map_topic", std::string("building")},
                                            {"save_pose_rate", -1.0},
                                            {"first_map_only", true}},
                                           warnings);
  EXPECT_FALSE(options.wait_for_initial_pose);
  EXPECT_EQ(options.initial_pose_x, -2.0);
  EXPECT_EQ(options.initial_pose_y, 3.0);
  EXPECT_EQ(options.initial_pose_a, 0.5);
  EXPECT_EQ(options.scan_topics, std::vector<std::string>{"front/scan"});
  EXPECT_EQ(options.map_topic, "building");
  EXPECT_EQ(options.save_pose_rate, 0.0);
  EXPECT_TRUE(options.first_map_only);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("'initial_pose.z' has no use here: the robot drives in a plane"), std::string::npos);

  EXPECT_TRUE(options_from({{"set_initial_pose", false}}, warnings).wait_for_initial_pose);
  EXPECT_NE(problem_of({{"set_initial_pose", 1}}).find("'wait_for_initial_pose' is a bool"), std::string::npos);
  EXPECT_NE(problem_of({{"initial_pose.yaw", std::string("north")}}).find("'initial_pose_a' is a double"),
            std::string::npos);
  EXPECT_NE(problem_of({{"save_pose_rate", 1000.0}}).find("from 0 to 100"), std::string::npos);
  EXPECT_NE(problem_of({{"map_topic", std::string()}}).find("map_topic must not be empty"), std::string::npos);
}

TEST(Parameters, ANameThatEndsInAStarStandsForAllThatBeginSo) {
  std::vector<std::string> warnings;
  options_from({{"qos_overrides./tf.publisher.depth", 100}, {"qos_overrides./scan.subscription.depth", 5}}, warnings);
  EXPECT_EQ(warnings.size(), 2U);
  EXPECT_NE(problem_of({{"qos_override", 1}}).find("there is no parameter 'qos_override'"), std::string::npos);
}

TEST(Parameters, EachIsDescribedAndItsDefaultIsInRange) {
  const auto all = node::parameters();
  EXPECT_GT(all.size(), 25U);
  for (const auto& each : all) EXPECT_FALSE(each.meaning.empty()) << each.name;
  std::vector<std::string> warnings;
  for (const auto& [name, why] : node::parameters_without_use()) options_from({{name, 1}}, warnings);
  EXPECT_EQ(warnings.size(), node::parameters_without_use().size());
}

}  // namespace
}  // namespace slamicp::parameters_test
