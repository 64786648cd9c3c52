// SPDX-License-Identifier: Apache-2.0
#include <slamicp/evaluation/leg_trial.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/mapping/scan_odometry.hpp>

#include "support/data.hpp"
#include "support/leg_labels.hpp"

namespace slamicp::leg_trial_data_test {
namespace {

class LegTrial : public test::DataTest {};

std::vector<LaserScan> scans_of(const char* bag, const char* topic, std::size_t most) {
  ScanLogOptions options;
  options.scan_topics = {topic};
  std::vector<LaserScan> scans = open_scan_log(test::data_dir() / "obstacles" / bag, options).scans;
  if (scans.size() > most) scans.resize(most);
  return scans;
}

TEST_F(LegTrial, FindsTheLabelledLegs) {
  const char* bag = "leg_positive_1_extracted.bag";
  const std::vector<LaserScan> scans = scans_of(bag, "/training_scan", 1000);
  const std::vector<PointCloud2> labels = test::read_leg_labels(test::data_dir() / "obstacles" / bag);
  ASSERT_EQ(scans.size(), labels.size());
  Trajectory standing;
  for (const LaserScan& scan : scans) standing.push_back({scan.stamp, {}});
  LegScore score;
  follow_log(scans, background_of(scans, standing), {}, setup_for_legs(),
             [&](const TrackedScan& tracked) { add_legs(tracked, labels[score.scans], 0.3, score); });
  EXPECT_EQ(score.labels, 324U);
  EXPECT_GE(score.recall(), 0.85) << "the labels of six are on a wall";
}

TEST_F(LegTrial, FindsFewWhereNobodyIs) {
  LegScore score;
  for (const char* topic : {"/left_scan", "/rear_scan", "/right_scan"}) {
    const std::vector<LaserScan> scans = scans_of("leg_negative_2.bag", topic, 1000);
    ASSERT_FALSE(scans.empty());
    ScanOdometry odometry;
    for (const LaserScan& scan : scans) odometry.add(scan);
    follow_log(scans, background_of(scans, odometry.trajectory()), odometry.trajectory().front().pose, setup_for_legs(),
               [&](const TrackedScan& tracked) { add_legs(tracked, {}, 0.3, score); });
  }
  EXPECT_LE(score.leg_tracks_a_scan(), 0.1);
}

}  // namespace
}  // namespace slamicp::leg_trial_data_test
