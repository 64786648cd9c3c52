// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/error.hpp>
#include <slamicp/evaluation/agent_replay.hpp>

#include "sampled_site.hpp"

namespace slamicp::agent_replay_test {
namespace {

RecordedDrive short_drive(const ExperimentSite& site, const char* obstacle, double seconds) {
  DrivePlan plan;
  plan.obstacle = obstacle;
  plan.start = 6.0;
  plan.most_seconds = seconds;
  return record_drive(site, plan);
}

TEST(AgentReplay, TheImprovedAgentSeesInTheScansWhatItSawWhenItDrove) {
  const ExperimentSite site = sampled_site();
  const RecordedDrive drive = short_drive(site, "D1", 2.0);
  const AgentReplay replay = replay_agent(site, drive);
  ASSERT_EQ(replay.outliers.size() + 1, drive.samples.size());
  for (std::size_t k = 0; k < replay.outliers.size(); ++k) {
    EXPECT_EQ(replay.outliers[k], drive.samples[k + 1].outliers);
    EXPECT_EQ(replay.poses[k].x, drive.samples[k + 1].estimate.x);
    EXPECT_EQ(replay.seconds[k], 0.0);  // no clock
  }
}

TEST(AgentReplay, BothAgentsFindTheSameWithTheIndexRebuiltOrNot) {
  const ExperimentSite site = sampled_site();
  const RecordedDrive drive = short_drive(site, "D1", 1.0);
  const AgentReplay ours = replay_agent(site, drive, {AgentForm::improved, false, 10});
  ASSERT_EQ(ours.outliers.size(), 4U);
  EXPECT_GT(ours.mean_outliers(), 10.0);
  for (const ReplayOptions& options :
       {ReplayOptions{AgentForm::original, false, 10}, ReplayOptions{AgentForm::original, true, 10},
        ReplayOptions{AgentForm::improved, true, 10}}) {
    const AgentReplay other = replay_agent(site, drive, options);
    ASSERT_EQ(other.outliers.size(), ours.outliers.size());
    EXPECT_NEAR(other.mean_outliers(), ours.mean_outliers(), 2.0);
    for (std::size_t k = 0; k < other.poses.size(); ++k)
      EXPECT_LT(distance(other.poses[k], ours.poses[k]).translation, 0.02);
  }
}

TEST(AgentReplay, TimesComeFromTheClock) {
  const ExperimentSite site = sampled_site();
  const RecordedDrive drive = short_drive(site, "D1", 0.5);
  double time = 0.0;
  const AgentReplay replay = replay_agent(site, drive, {}, [&] { return time += 0.001; });
  EXPECT_NEAR(replay.mean_seconds(), 0.004, 1e-9);  // four subtasks
}

TEST(AgentReplay, ManyOutliersCostWhatTheClockSays) {
  const ExperimentSite site = sampled_site();
  double time = 0.0;
  const OutlierCost cost =
      outlier_cost(site, short_drive(site, "D1", 0.5), short_drive(site, "", 0.5), 2, [&] { return time += 0.001; });
  EXPECT_GT(cost.scans, 0U);
  EXPECT_GT(cost.outliers_with, 10.0);
  EXPECT_LT(cost.outliers_without, 3.0);
  EXPECT_NEAR(cost.seconds_with, 0.004, 1e-9);
  EXPECT_NEAR(cost.ratio(), 1.0, 1e-9);
}

TEST(AgentReplay, ImprovementIsThePapersEquation8) {
  EXPECT_NEAR(improvement_percent(71.06, 45.33), 36.21, 0.005);  // Table 1, A1
  EXPECT_EQ(improvement_percent(2.0, 1.0), 50.0);
  EXPECT_EQ(improvement_percent(0.0, 1.0), 0.0);
}

TEST(AgentReplay, RefusesADriveWithoutScans) {
  const ExperimentSite site = sampled_site();
  EXPECT_THROW(replay_agent(site, {}), Error);
  EXPECT_THROW(replay_agent(site, short_drive(site, "", 0.1), {AgentForm::improved, false, 0}), Error);
}

}  // namespace
}  // namespace slamicp::agent_replay_test
