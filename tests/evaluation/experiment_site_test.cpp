// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <slamicp/evaluation/experiment_site.hpp>

namespace slamicp::experiment_site_test {
namespace {

TEST(ExperimentSite, IsExploredByOurMapperWithAsManyPointsAsThePapersMap) {
  const ExperimentSite site = explore_site(1);
  EXPECT_NEAR(static_cast<double>(site.map->size()), 10402.0, 1040.0);
  EXPECT_GT(site.survey_scans, 2000U);
  EXPECT_LT(site.survey_error.mean, 0.05);
  EXPECT_NEAR(site.path->length(), 15.9, 0.1);
  // Walls stand where they are, as far as the mapper's drift allows; nothing floats in the corridor.
  for (std::size_t i = 0; i < site.map->size(); ++i)
    EXPECT_LT(distance_to_walls(site.world, site.map->points()[i]), 0.2);
  const ExperimentSite again = explore_site(1);
  ASSERT_EQ(again.map->size(), site.map->size());
  for (std::size_t i = 0; i < site.map->size(); ++i) ASSERT_EQ(again.map->points()[i], site.map->points()[i]);
}

}  // namespace
}  // namespace slamicp::experiment_site_test
