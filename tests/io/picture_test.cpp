// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include <slamicp/io/picture.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::picture_test {
namespace {

using io_test::expect_error;
using io_test::get;
using io_test::TemporaryFolder;

std::size_t occurrences(const std::string& text, std::string_view piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

PointCloud2 scattered(std::size_t count) {
  PointCloud2 points;
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525U + 1013904223U) / 4294967296.0; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 40.0 * next();
    points.emplace_back(x, 30.0 * next());
  }
  return points;
}

TEST(Picture, FiftyThousandPointsStayBelowAMegabyte) {
  Picture picture;
  picture.points(scattered(50'000), colours::map);
  EXPECT_LT(picture.svg().size(), 1'000'000U);
}

TEST(Picture, HoldsWhatWasAdded) {
  const PointCloud2 points = scattered(100);
  const Picture::Segment segment{{0, 0}, {1, 1}};
  Picture picture({.title = "a <title> & \"more\""});
  picture.points(points, colours::inlier, 2.0, "inliers")
      .polyline(points, colours::path)
      .segments({&segment, 1}, colours::truth)
      .circle({3, 4}, 0.5, colours::obstacle, 1.5, "obstacle")
      .robot({1, 2, 0.5}, 0.2)
      .label({5, 5}, "here");
  const std::string svg = picture.svg();
  EXPECT_EQ(picture.layers().size(), 6U);
  EXPECT_NE(svg.find("a &lt;title&gt; &amp; &quot;more&quot;"), std::string::npos);
  for (const char* word : {">inliers<", ">obstacle<", ">here<", ">x [m]<", ">y [m]<", "#22a054"})
    EXPECT_NE(svg.find(word), std::string::npos) << word;
  EXPECT_GE(occurrences(svg, "h0"), 100U);
  EXPECT_EQ(occurrences(svg, "<g"), occurrences(svg, "</g>"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

/// Of the first layer, which is lines.
const std::vector<std::vector<Point2>>& lines_of(const Picture& picture) {
  return std::get<Picture::Lines>(picture.layers().front().shape).lines;
}

TEST(Picture, EllipsesHold95Percent) {
  const Picture::Ellipse upright{{1.0, 2.0}, Eigen::Vector2d(0.01, 0.0004).asDiagonal()};
  const double s = std::sqrt(0.5);
  const Matrix<2, 2> turn = (Eigen::Matrix2d() << s, -s, s, s).finished();
  const Picture::Ellipse turned{{0.0, 0.0}, turn * upright.covariance * turn.transpose()};
  Picture picture;
  picture.ellipses(std::vector<Picture::Ellipse>{upright, turned}, 10.0, colours::ellipse, 1.0, "x 10");
  ASSERT_EQ(lines_of(picture).size(), 2U);
  const std::vector<Point2>& rim = lines_of(picture)[0];
  EXPECT_EQ(rim.front(), rim.back());
  double widest = 0.0, highest = 0.0;
  for (const Point2& point : rim) {
    widest = std::max(widest, point.x() - 1.0);
    highest = std::max(highest, point.y() - 2.0);
    // Each corner is where chi-squared with two degrees of freedom has 95 %.
    const Eigen::Vector2d off = (point - upright.centre) / 10.0;
    EXPECT_NEAR(off.dot(Eigen::Matrix2d(upright.covariance).inverse() * off), 5.991465, 1e-6);
  }
  EXPECT_NEAR(widest, 2.4477, 0.001);
  EXPECT_NEAR(highest, 0.48955, 0.001);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Point2 point = lines_of(picture)[1][k];
    EXPECT_NEAR(point.dot(Eigen::Matrix2d(turned.covariance).inverse() * point), 599.1465, 1e-4);
  }
}

TEST(Picture, WhatIsNoCovarianceIsNoEllipse) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Picture::Ellipse> none = {{{0.0, 0.0}, Eigen::Vector2d(-1.0, 1.0).asDiagonal()},
                                              {{0.0, 0.0}, Eigen::Vector2d(nan, 1.0).asDiagonal()},
                                              {{nan, 0.0}, Eigen::Vector2d(1.0, 1.0).asDiagonal()}};
  Picture picture;
  picture.ellipses(none, 1.0, colours::ellipse);
  EXPECT_TRUE(lines_of(picture).empty());
}

TEST(Picture, YPointsUp) {
  Picture picture({.bounds = Bounds<2>{{0, 0}, {10, 10}}});
  const PointCloud2 low{{5, 1}};
  const PointCloud2 high{{5, 9}};
  picture.points(low, {1, 2, 3}).points(high, {4, 5, 6});
  const std::string svg = picture.svg();
  const auto y_after = [&](const char* colour) {
    const std::size_t move = svg.find("d=\"M", svg.find(colour));
    return std::stod(svg.substr(svg.find(' ', move + 2)));
  };
  EXPECT_GT(y_after("#010203"), y_after("#040506"));
}

TEST(Picture, SurvivesWhatCannotBeDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const PointCloud2 odd{{nan, 1}, {1, inf}, {1e300, 1}, {2, 3}, {4, 5}, {nan, nan}, {6, 7}};
  Picture picture;
  picture.points(odd, colours::map).polyline(odd, colours::path).circle({nan, 0}, inf, colours::map);
  picture.robot({nan, 0, 0}, 1.0).label({inf, 0}, "x");
  const std::string svg = picture.svg();
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_FALSE(Picture().svg().empty());
}

TEST(Picture, OneMapPointAndFarAwayPointsHaveAGrid) {
  for (const double at : {0.0, 1e6, -5e8}) {
    const PointCloud2 one{{at, at}};
    Picture picture;
    picture.points(one, colours::map);
    EXPECT_LT(picture.svg().size(), 20'000U) << at;
  }
}

TEST(Picture, SavesByEnding) {
  const TemporaryFolder folder;
  Picture picture({.title = "saved"});
  picture.points(scattered(1000), {58, 110, 165, 0.5}).path(Trajectory{{0, {1, 1, 0}}, {1, {2, 5, 0}}}, colours::path);
  picture.save(folder / "a.svg");
  EXPECT_EQ(get(folder / "a.svg"), picture.svg());
  try {
    picture.save(folder / "a.png");
    EXPECT_EQ(get(folder / "a.png").substr(1, 3), "PNG");
  } catch (const Error& error) {
    EXPECT_NE(error.problem().find("built without Cairo"), std::string::npos);
  }
  expect_error([&] { picture.save(folder / "a.bmp"); }, (folder / "a.bmp").string(), "ending '.bmp'");
  expect_error([&] { picture.save(folder / "no/a.svg"); }, (folder / "no/a.svg").string(), "No such file");
}

TEST(Picture, ChecksItsOptions) {
  EXPECT_THROW(Picture({.width_px = 1}), Error);
  EXPECT_THROW(Picture({.bounds = Bounds<2>{}}), Error);
  EXPECT_NE((PictureOptions{.png_scale = 100}.problem()), "");
}

}  // namespace
}  // namespace slamicp::picture_test
