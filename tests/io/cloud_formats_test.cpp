// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <gtest/gtest.h>

#include <slamicp/io/cloud_file.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::cloud_formats_test {
namespace {

using io_test::expect_error;
using io_test::put;
using io_test::TemporaryFolder;

/// Loads a text as the file a<ending>; where an Error happens it stands at "a<ending>:line".
class CloudFormats : public ::testing::Test {
 protected:
  PointCloud3 load(const std::string& ending, const std::string& content) {
    put(folder_ / ("a" + ending), content);
    return load_cloud3(folder_ / ("a" + ending));
  }
  void fails(const std::string& ending, const std::string& content, int line, std::string_view what) {
    const std::string place = (folder_ / ("a" + ending)).string() + (line > 0 ? ":" + std::to_string(line) : "");
    expect_error([&] { load(ending, content); }, place, what);
  }
  TemporaryFolder folder_;
};

template <class Number>
std::string bytes_of(Number number, bool big_endian = false) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

const PointCloud3 wanted{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};

TEST_F(CloudFormats, XyzTakesAnySeparatorHeaderAndComment) {
  for (const char* text : {"1,2,3\n4,5,6\n", "1 2 3\n4 5 6", "  1 , 2 ,\t3\r\n\r\n4,5,6\r\n", "x,y,z\n1,2,3\n4,5,6\n",
                           "# a comment\n1e0 2.0e+00 +3\n4 5 6\n", "// CloudCompare\n\"X\",\"Y\",\"Z\"\n1,2,3\n4,5,6\n",
                           "scan,z,y,x\n0,3,2,1\n0,6,5,4\n", "1 2 3 77\n4 5 6 88\n", "some title\n1 2 3\n4 5 6\n"})
    EXPECT_EQ(load(".xyz", text), wanted) << text;
}

TEST_F(CloudFormats, XyzReadsPointsOfOurOwnTables) {
  put(folder_ / "a.csv", "scan,stamp,beam,x,y,distance,kind\n0,1.5,7,1,2,inf,unknown\n");
  const Cloud cloud = load_cloud(folder_ / "a.csv");
  EXPECT_EQ(cloud.dimension(), 2);
  EXPECT_EQ(cloud.size(), 1U);
  EXPECT_EQ(cloud.warnings.size(), 1U);
}

TEST_F(CloudFormats, XyzMistakes) {
  fails(".csv", "", 0, "holds no point");
  fails(".csv", "# only a comment\n", 0, "holds no point");
  fails(".csv", "only a title\n", 0, "holds no point");
  fails(".csv", "1,2\n1,b\n", 2, "not a number: 'b'");
  fails(".csv", "1,2\n1,\n", 2, "1 value, but 2");
  fails(".csv", "1,2\n1,2,3\n", 2, "3 values, but 2");
  fails(".csv", "1\n", 1, "only one value");
  fails(".csv", "x,y\n1,2\nnext,part\n", 3, "not a number: 'next'");
  std::string ranges = "1";
  for (int i = 0; i < 100; ++i) ranges += ",1";
  fails(".csv", ranges + "\n", 1, "a log of ranges");
  EXPECT_TRUE(load(".csv", "x,y\n").empty());
}

std::string pcd_header(const std::string& fields, const std::string& points, const std::string& data) {
  return "# .PCD v.7\nVERSION .7\n" + fields + "WIDTH " + points + "\nHEIGHT 1\nPOINTS " + points + "\nDATA " + data +
         "\n";
}
const std::string xyz_fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

TEST_F(CloudFormats, PcdAscii) {
  EXPECT_EQ(load(".pcd", pcd_header(xyz_fields, "2", "ascii") + "1 2 3\n4 5 6\n"), wanted);
  EXPECT_EQ(load(".pcd", pcd_header("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n", "2", "ascii") + "1 2 3\r\n4 5 6"),
            wanted);
  EXPECT_EQ(load(".pcd", pcd_header("FIELDS z n y x\nSIZE 4 4 8 4\nTYPE F F F I\nCOUNT 1 2 1 1\n", "2", "ascii") +
                             "3 9 9 2 1\n6 nan 9 5 4\n"),
            wanted);
}

TEST_F(CloudFormats, PcdBinaryWithFieldsOfAnyKindAndOrder) {
  const std::string fields = "FIELDS z _ y x\nSIZE 8 1 2 1\nTYPE F U I U\nCOUNT 1 3 1 1\n";
  std::string bytes = pcd_header(fields, "2", "binary");
  for (const Point3& point : wanted)
    bytes += bytes_of(point.z()) + "abc" + bytes_of(static_cast<std::int16_t>(-point.y())) +
             bytes_of(static_cast<std::uint8_t>(point.x() + 200));
  const PointCloud3 cloud = load(".pcd", bytes + "trailing bytes");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud[1], Point3(204, -5, 6));
  EXPECT_EQ(load(".pcd", pcd_header("FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\n", "1", "binary") + bytes_of(1.5F) +
                             bytes_of(-2.5F))[0],
            Point3(1.5, -2.5, 0.0));
}

TEST_F(CloudFormats, PcdMistakes) {
  fails(".pcd", "", 0, "the file is empty");
  fails(".pcd", "VERSION .7\nFIELDS x y z\n", 0, "no DATA line");
  fails(".pcd", "VERSION .7\nDATA ascii\n", 2, "no FIELDS");
  fails(".pcd", "x y z\n", 1, "unknown header line 'x'");
  fails(".pcd", "FIELDS x y z\nSIZE 4 4\n", 2, "SIZE has 2 values, FIELDS has 3");
  fails(".pcd", "FIELDS x\nTYPE Q\n", 2, "unknown TYPE 'Q'");
  fails(".pcd", "FIELDS x\nSIZE 9\n", 2, "SIZE is too large: '9'");
  fails(".pcd", "WIDTH many\n", 1, "WIDTH is not a whole number: 'many'");
  fails(".pcd", "WIDTH\n", 1, "WIDTH has no value");
  fails(".pcd", pcd_header("FIELDS x z\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\n", "1", "ascii"), 10, "no x and y");
  fails(".pcd", pcd_header("FIELDS x y\nSIZE 2 4\nTYPE F F\nCOUNT 1 1\n", "1", "ascii"), 10, "field x has no number");
  fails(".pcd", pcd_header(xyz_fields, "2", "binary_compressed"), 10, "compressed PCD is not read");
  fails(".pcd", pcd_header(xyz_fields, "2", "morse"), 10, "unknown DATA 'morse'");
  fails(".pcd", pcd_header(xyz_fields, "2", "ascii") + "1 2 3\n", 11, "promises 2 points, the file holds 1");
  fails(".pcd", pcd_header(xyz_fields, "2", "ascii") + "1 2 3\n4 5\n", 12, "2 values, FIELDS promise 3");
  fails(".pcd", pcd_header(xyz_fields, "2", "ascii") + "1 2 3\n4 five 6\n", 12, "not a number: 'five'");
  fails(".pcd", pcd_header(xyz_fields, "2", "binary") + std::string(23, '\0'), 10,
        "promises 2 points, the file holds 1");
  fails(".pcd", pcd_header(xyz_fields, "1000000000", "binary") + "x", 10, "the file holds 0");
}

std::string ply_header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\n" + elements + "end_header\n";
}
const std::string ply_vertex = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";

TEST_F(CloudFormats, PlyAscii) {
  EXPECT_EQ(load(".ply", ply_header("ascii", ply_vertex) + "1 2 3\n4 5 6\n"), wanted);
  EXPECT_EQ(load(".ply", ply_header("ascii", ply_vertex + "element face 1\nproperty list uchar int vertex_indices\n") +
                             "1 2 3\n4 5 6\n3 0 1 0\n"),
            wanted);
  const std::string mixed =
      "element face 2\nproperty list uchar int i\nelement vertex 2\nproperty uchar red\n"
      "property double z\nproperty list uchar float extra\nproperty double y\nproperty short x\n";
  EXPECT_EQ(load(".ply", ply_header("ascii", mixed) + "3 0 1 0\n0\n255 3 1 9 2 1\n255 6 0 5 4"), wanted);
}

TEST_F(CloudFormats, PlyBinaryOfBothByteOrders) {
  const std::string elements =
      "element face 1\nproperty list uchar int i\nelement vertex 2\nproperty double z\n"
      "property float y\nproperty uchar red\nproperty short x\n";
  for (const bool big : {false, true}) {
    std::string bytes = ply_header(big ? "binary_big_endian" : "binary_little_endian", elements);
    bytes += bytes_of(std::uint8_t{2}) + std::string(8, 'i');
    for (const Point3& point : wanted)
      bytes += bytes_of(point.z(), big) + bytes_of(static_cast<float>(point.y()), big) + "r" +
               bytes_of(static_cast<std::int16_t>(point.x()), big);
    EXPECT_EQ(load(".ply", bytes), wanted);
  }
}

TEST_F(CloudFormats, PlyMistakes) {
  const std::string path = (folder_ / "a.ply").string();
  fails(".ply", "", 0, "the file is empty");
  fails(".ply", "plx\n", 1, "does not start with 'ply'");
  fails(".ply", "ply\nformat ascii 1.0\n", 2, "no end_header");
  fails(".ply", "ply\nend_header\n", 2, "no format");
  fails(".ply", "ply\nformat morse 1.0\n", 2, "unknown format 'morse'");
  fails(".ply", "ply\nproperty float x\n", 2, "a property before any element");
  fails(".ply", "ply\nelement vertex many\n", 2, "element count is not a whole number: 'many'");
  fails(".ply", "ply\nelement vertex 1\nproperty string x\n", 3, "unknown property type 'string'");
  fails(".ply", "ply\nelement vertex 1\nproperty float\n", 3, "the line ends before its property name");
  fails(".ply", "ply\nvertices 1\n", 2, "unknown header line 'vertices'");
  fails(".ply", ply_header("ascii", "element vertex 1\nproperty float x\n"), 6,
        "no element vertex with properties x and y");
  fails(".ply", ply_header("ascii", ply_vertex) + "1 2 3\n4 5\n", 10, "the data end too early");
  fails(".ply", ply_header("ascii", ply_vertex) + "1 2 3\n4 x 6\n", 10, "not a number: 'x'");
  fails(".ply", ply_header("binary_little_endian", ply_vertex) + std::string(23, '\0'), 0, "the data end too early");
  fails(".ply",
        ply_header("binary_little_endian", "element vertex 999999999999\nproperty float x\nproperty float y\n") + "x",
        0, "promises 999999999999 of element vertex");
  fails(".ply", ply_header("ascii", "element face 1\nproperty list int int i\n" + ply_vertex) + "-1 2 3\n", 11,
        "a list has a length that cannot be");
}

}  // namespace
}  // namespace slamicp::cloud_formats_test
