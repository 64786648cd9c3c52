// SPDX-License-Identifier: Apache-2.0
// Files that were written or edited on Windows: every text reader takes lines that end in CR LF.
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/scan_log.hpp>
#include <slamicp/io/trajectory_file.hpp>
#include <slamicp/io/world_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::line_ends_test {
namespace {

std::string with_cr(const std::string& text) {
  std::string other;
  for (const char c : text) {
    if (c == '\n') other += '\r';
    other += c;
  }
  return other;
}

class LineEndsTest : public ::testing::Test {
 protected:
  /// The text as it is, and the same with CR LF.
  std::pair<std::filesystem::path, std::filesystem::path> put_both(const std::string& name, const std::string& text) {
    std::filesystem::create_directory(folder_ / "windows");
    io_test::put(folder_ / name, text);
    io_test::put(folder_ / "windows" / name, with_cr(text));
    return {folder_ / name, folder_ / "windows" / name};
  }

  io_test::TemporaryFolder folder_;
};

TEST_F(LineEndsTest, Clouds) {
  const std::string pcd =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
  const std::string ply =
      "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n1 2 3\n4 5 6\n";
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.pcd", pcd},
                                   {"a.ply", ply},
                                   {"a.xyz", "1 2 3\n4 5 6\n"},
                                   {"a.csv", "x,y,z\n1,2,3\n4,5,6\n"}}) {
    const auto [unix_file, windows_file] = put_both(name, text);
    EXPECT_EQ(load_cloud3(windows_file), load_cloud3(unix_file)) << name;
    EXPECT_EQ(load_cloud3(windows_file).size(), 2U) << name;
    EXPECT_EQ(kind_of(windows_file), kind_of(unix_file)) << name;
  }
}

TEST_F(LineEndsTest, Logs) {
  const std::string carmen = "# log\nFLASER 3 1.5 2.5 3.5 1 2 0.5 1 2 0.5 10.25 host 0.5\n";
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"a.clf", carmen}, {"a.csv", "1.5,2.5,3.5,4.5\n1.5,2.5,3.5,4.5\n"}}) {
    const auto [unix_file, windows_file] = put_both(name, text);
    const ScanLog one = open_scan_log(unix_file), other = open_scan_log(windows_file);
    ASSERT_EQ(one.size(), other.size()) << name;
    ASSERT_GT(one.size(), 0U) << name;
    EXPECT_EQ((*one.begin()).ranges, (*other.begin()).ranges) << name;
    EXPECT_EQ((*one.begin()).stamp, (*other.begin()).stamp) << name;
  }
}

TEST_F(LineEndsTest, Trajectories) {
  const auto [unix_file, windows_file] = put_both("a.tum", "# stamp x y z\n1.5 2 3 0 0 0 0 1\n2.5 3 4 0 0 0 0 1\n");
  const Trajectory one = load_trajectory(unix_file), other = load_trajectory(windows_file);
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(other.size(), 2U);
  EXPECT_EQ(other[1].stamp, one[1].stamp);
  EXPECT_EQ(other[1].pose.x, one[1].pose.x);
  EXPECT_EQ(other[1].pose.y, one[1].pose.y);
}

#ifdef SLAMICP_WITH_YAML

TEST_F(LineEndsTest, MapsOfMapServer) {
  put_both("m.pgm", "P2\n# made by hand\n2 2\n255\n0 254\n205 0\n");
  const auto [unix_file, windows_file] = put_both(
      "m.yaml",
      "image: m.pgm\nresolution: 0.1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const OccupancyMap one = load_occupancy_map(unix_file), other = load_occupancy_map(windows_file);
  ASSERT_EQ(one.grid.width, 2);
  ASSERT_EQ(other.grid.width, 2);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) EXPECT_EQ(one.grid.at({column, row}), other.grid.at({column, row}));
}

TEST_F(LineEndsTest, Worlds) {
  const auto [unix_file, windows_file] =
      put_both("w.yaml", "# a room\nworld: w\nwalls:\n  - segment: [[0, 0], [4, 0]]\n  - segment: [[4, 0], [4, 3]]\n");
  EXPECT_EQ(kind_of(windows_file), FileKind::world);
  const World one = load_world(unix_file), other = load_world(windows_file);
  EXPECT_EQ(other.name, one.name);
  ASSERT_EQ(other.walls.size(), 2U);
  EXPECT_EQ(other.walls[1].b, one.walls[1].b);
}

#endif

}  // namespace
}  // namespace slamicp::line_ends_test
