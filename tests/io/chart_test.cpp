// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <limits>

#include <slamicp/error.hpp>
#include <slamicp/io/chart.hpp>

namespace slamicp::chart_test {
namespace {

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

Chart two_speeds() {
  Chart chart({.title = "outliers & more", .x_label = "distance travelled [m]", .y_label = "outliers"});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point2> slow = {{0.0, 0.0}, {1.0, 40.0}, {2.0, nan}, {3.0, 5.0}, {4.0, 7.0}};
  chart.line(slow, colours::outlier, 1.0, "0.15 m/s").dots(slow, colours::map, 3.0, "0.25 m/s").mark(1.5, "b");
  return chart;
}

TEST(Chart, DrawsLinesDotsMarksAndWords) {
  const std::string svg = two_speeds().svg();
  for (const char* text : {"outliers &amp; more", "distance travelled [m]", "0.15 m/s", "0.25 m/s", ">b<", ">40<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(two_speeds().svg(), svg);
}

TEST(Chart, NamesStandWhereXCounts) {
  Chart chart({.x_names = {"A1", "A2", "D3"}, .logarithmic = true});
  chart.dots(std::vector<Point2>{{0.0, 0.05}, {1.0, 70.0}, {2.0, 0.0}}, colours::map);
  const std::string svg = chart.svg();
  for (const char* text : {">A1<", ">D3<", ">0.01<", ">100<"}) EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(count(svg, ">0<"), 0U);  // no zero on a scale of powers of ten
}

TEST(Chart, BandsLieBehindAndNeverVanish) {
  Chart chart = two_speeds();
  const Colour band{1, 2, 3, 0.5};
  chart.band(1.0, 2.0, band).band(3.0, 3.0, band).band(3.0, std::numeric_limits<double>::infinity(), band);
  EXPECT_EQ(chart.bands().size(), 3U);
  const std::string svg = chart.svg();
  EXPECT_EQ(count(svg, "#010203"), 2U);  // the endless one has no place
  EXPECT_LT(svg.find("#010203"), svg.find("#d62728"));
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Chart, AnEmptyOneIsStillAPicture) {
  EXPECT_NE(Chart().svg().find("<svg"), std::string::npos);
  EXPECT_NE(Chart({.logarithmic = true}).svg().find("<svg"), std::string::npos);
}

TEST(Chart, RefusesAbsurdSizesAndEndings) {
  EXPECT_THROW(Chart({.width_px = 10.0}), Error);
  EXPECT_THROW(Chart({.height_px = 1e6}), Error);
  EXPECT_THROW(Chart().save("chart.gif"), Error);
}

}  // namespace
}  // namespace slamicp::chart_test
