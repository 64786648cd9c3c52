// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/held_out.hpp>
#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/stretch_trials.hpp>
#include <slamicp/io/scan_log.hpp>

#include "support/data.hpp"

namespace slamicp::held_out_data_test {
namespace {

class RealRun : public test::DataTest {
 protected:
  void SetUp() override {
    DataTest::SetUp();
    const std::filesystem::path log = test::data_dir() / "hokuyo/birmingham_trace0.bag";
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "skipped: no " << log;
    placed_ = place_scans(open_scan_log(log).scans);
    parts_ = take_apart(placed_);
  }

  std::vector<PlacedRecord> placed_;
  HeldOutLog parts_;
};

// `scripts/measure real_calibration` has NEES / 3 of 0.4, 99 % in the ellipse, none lost.
TEST_F(RealRun, CovariancesAreNotTooSmall) {
  const HeldOutPairs pairs = compare(parts_);
  EXPECT_EQ(pairs.lost_tracks, 0);
  for (const std::vector<IndependentPair>* kind : {&pairs.matches, &pairs.fixes}) {
    std::size_t counted = 0, inside = 0;
    double nees = 0.0;
    for (const IndependentPair& pair : *kind) {
      if (!pair.usable || pair.blind) continue;
      EXPECT_LT(pair.difference.head<2>().norm(), 0.1);
      ++counted;
      inside += pair.nees() <= 7.814728;  // chi-squared with three degrees of freedom: 95 %
      nees += pair.nees() / 3.0;
    }
    ASSERT_GT(counted, 200U);
    EXPECT_GT(nees / static_cast<double>(counted), 0.1);
    EXPECT_LT(nees / static_cast<double>(counted), 1.25);
    EXPECT_GE(static_cast<double>(inside) / static_cast<double>(counted), 0.9);
  }
}

// ... and of robots put elsewhere 99 % noticed, no alarm at the right place.
TEST_F(RealRun, WrongPlacesAreNoticedAndRightOnesTrusted) {
  ReferenceRun run;
  run.map = parts_.map;
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    if (k % 4 == 0) continue;  // those are in the map
    run.scans.push_back(placed_[k].scan);
    run.reference.push_back(placed_[k].pose);
  }
  StretchTrials trials(run, 1);
  int right = 0, sure_and_right = 0, wrong = 0, sure_and_wrong = 0;
  trials.watch([&](const Fix& fix, const Pose2& truth) {
    const bool is = is_right(fix.pose, truth);
    const bool sure = fix.quality.probability > 0.9;
    (is ? right : wrong) += 1;
    if (sure) (is ? sure_and_right : sure_and_wrong) += 1;
  });
  constexpr int stretches = 20;
  int noticed = 0;
  for (int k = 0; k < stretches; ++k) {
    const StretchOutcome here = trials.draw(false);
    EXPECT_EQ(here.right_scans, 80);
    EXPECT_EQ(here.alarms, 0);
    noticed += trials.draw(true).noticed;
  }
  EXPECT_GE(noticed, stretches - 2);
  EXPECT_GT(sure_and_right, right * 9 / 10);
  EXPECT_LT(sure_and_wrong, wrong / 5);
}

}  // namespace
}  // namespace slamicp::held_out_data_test
