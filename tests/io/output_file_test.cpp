// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <iostream>

#include <slamicp/io/csv_table.hpp>
#include <slamicp/io/output_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::output_file_test {
namespace {

using io_test::expect_error;
using io_test::get;
using io_test::put;
using io_test::TemporaryFolder;

TEST(OutputFile, AppearsWholeAtCommit) {
  const TemporaryFolder folder;
  put(folder / "a.txt", "before");
  OutputFile file(folder / "a.txt");
  const std::string much(1 << 20, 'x');
  file.write(much);
  file.write("end");
  EXPECT_EQ(get(folder / "a.txt"), "before");
  file.commit();
  EXPECT_EQ(get(folder / "a.txt"), much + "end");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { OutputFile(folder / "a.txt").write("half"); }
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(OutputFile, ASignalLeavesNothing) {
  const TemporaryFolder folder;
  put(folder / "old.txt", "before");
  OutputFile first(folder / "old.txt");
  OutputFile second(folder / "new.txt");
  first.write("half");
  EXPECT_EQ(folder.file_count(), 3U);
  remove_unfinished_outputs();
#ifndef _WIN32  // there a file stays until it is closed, as it is when the program ends
  EXPECT_EQ(folder.file_count(), 1U);
#endif
  EXPECT_EQ(get(folder / "old.txt"), "before");
  expect_error([&] { second.commit(); }, (folder / "new.txt").string(), "cannot be given its name");
  expect_error([&] { first.commit(); }, (folder / "old.txt").string(), "cannot be given its name");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, MoreOutputsThanTheRegistryHolds) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<OutputFile>> files;
  for (int i = 0; i < 80; ++i) files.push_back(std::make_unique<OutputFile>(folder / std::to_string(i)));
  for (const auto& file : files) file->commit();
  EXPECT_EQ(folder.file_count(), 80U);
}

TEST(OutputFile, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  expect_error([&] { OutputFile file(folder / "no/such/a.txt"); }, (folder / "no/such/a.txt").string(),
               "No such file or directory");
  expect_error([&] { OutputFile file(folder.path()); }, folder.path().string(), "is a folder");
  expect_error([] { OutputFile file(""); }, "", "no name");
}

TEST(OutputFile, ADeviceIsWrittenDirectly) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "skipped: no /dev/full";
  write_file("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  expect_error([] { write_file("/dev/full", "x"); }, "/dev/full", "No space left on device");
}

TEST(OutputFile, FollowsALink) {
  const TemporaryFolder folder;
  put(folder / "real.txt", "before");
  std::error_code error;
  std::filesystem::create_symlink(folder / "real.txt", folder / "link.txt", error);
  if (error) GTEST_SKIP() << "skipped: no links here";
  write_file(folder / "link.txt", "after");
  EXPECT_EQ(get(folder / "real.txt"), "after");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
}

TEST(OutputFile, ADashIsStandardOutput) {
  ::testing::internal::CaptureStdout();
  {
    OutputFile never("-");
    never.write("half");
  }
  write_file("-", "whole\n");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "whole\n");
}

TEST(CsvTable, WritesTheHeadersThatScriptsRelyOn) {
  const TemporaryFolder folder;
  CsvTable<OutlierRow> outliers(folder / "outliers.csv");
  outliers.add({3, 1.5, 17, 1.25, -2.0, 0.5, "obstacle"});
  outliers.add({4, 1.6, 18, 1.25, -2.0});
  EXPECT_FALSE(std::filesystem::exists(folder / "outliers.csv"));
  outliers.commit();
  EXPECT_EQ(get(folder / "outliers.csv"),
            "scan,stamp,beam,x,y,distance,kind\n"
            "3,1.500000,17,1.250000,-2.000000,0.500000,obstacle\n"
            "4,1.600000,18,1.250000,-2.000000,inf,unknown\n");

  CsvTable<MetricsRow> metrics(folder / "metrics.csv");
  MetricsRow row;
  row.stop = "max_iterations";
  row.iterations = 30;
  row.points = 1081;
  row.mean_inlier_distance = std::numeric_limits<double>::quiet_NaN();
  row.time_us = 812.25;
  row.state = "suspect";
  row.probability = 0.3125;
  row.var_x = 2.5e-7;
  row.blind_deg = 90.0;
  metrics.add(row);
  metrics.commit();
  EXPECT_EQ(get(folder / "metrics.csv"),
            "scan,stamp,x,y,theta,stop,iterations,points,inliers,outliers,mean_inlier_distance,time_us,"
            "state,probability,var_x,var_y,var_theta,blind_deg\n"
            "0,0.000000,0.000000,0.000000,0.000000000,max_iterations,30,1081,0,0,nan,812.2,suspect,0.3125,"
            "0.000000250000,0.000000000000,0.000000000000,90.00\n");

  CsvTable<ObstacleRow> obstacles(folder / "obstacles.csv");
  ObstacleRow obstacle;
  obstacle.kind = "a,b\nc";
  obstacles.add(obstacle);
  obstacles.commit();
  EXPECT_EQ(get(folder / "obstacles.csv"),
            "scan,stamp,id,kind,x,y,width,depth,heading,radius,points,speed,state\n"
            "0,0.000000,0,a b c,0.000000,0.000000,0.000000,0.000000,0.000000000,0.000000,0,0.000000,\n");
}

}  // namespace
}  // namespace slamicp::output_file_test
