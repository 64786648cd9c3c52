// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/jump_trial.hpp>
#include <slamicp/evaluation/trial_world.hpp>

#include "support/random.hpp"

namespace slamicp::jump_trial_test {
namespace {

TEST(JumpTrialTest, NearlyAllJumpsAreNoticed) {
  const int maps = test::seeds(4);
  int jumps = 0, noticed = 0;
  for (const std::string_view world : trial_world_names())
    for (int seed = 0; seed < maps; ++seed) {
      JumpTrials trials(world, static_cast<std::uint64_t>(seed + 1));
      for (int k = 0; k < 3; ++k) {
        const JumpOutcome outcome = trials.draw(k == 2 ? 0.4 : 0.0);
        EXPECT_TRUE(outcome.shift >= 2.0 || outcome.turn >= 0.78);
        if (outcome.alike) continue;
        ++jumps;
        noticed += outcome.noticed;
      }
    }
  EXPECT_GE(noticed, jumps - 1) << "of " << jumps;
}

TEST(JumpTrialTest, TheSameSeedGivesTheSameOutcome) {
  JumpTrials once("office", 7), again("office", 7);
  for (int k = 0; k < 2; ++k) {
    const JumpOutcome a = once.draw(0.2), b = again.draw(0.2);
    EXPECT_EQ(a.shift, b.shift);
    EXPECT_EQ(a.scans_until, b.scans_until);
    EXPECT_EQ(a.longest_confident, b.longest_confident);
  }
}

}  // namespace
}  // namespace slamicp::jump_trial_test
