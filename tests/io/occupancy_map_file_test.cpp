// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/occupancy_map_file.hpp>

#include "io/io_test_support.hpp"
#include "io/png_test_support.hpp"
#include "support/random.hpp"

namespace slamicp::occupancy_map_file_test {
namespace {

using io_test::expect_error;
using io_test::get;
using io_test::put;

const std::string yaml_end =
    "resolution: 0.1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// The cells as letters, row by row from the top: '#' occupied, '.' free, '?' unknown, '/' between rows.
std::string letters(const OccupancyGrid& grid) {
  std::string out;
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width; ++column) {
      const CellState state = grid.at({column, row});
      out += state == CellState::occupied ? '#' : state == CellState::free ? '.' : '?';
    }
    if (row > 0) out += '/';
  }
  return out;
}

class OccupancyMapFileTest : public ::testing::Test {
 protected:
#ifndef SLAMICP_WITH_YAML
  void SetUp() override { GTEST_SKIP() << "skipped: this build reads no YAML"; }
#endif
  /// Writes map.yaml for an image and reads it.
  OccupancyMap load(const std::string& image, const std::string& bytes, const std::string& yaml = yaml_end) {
    put(folder_ / image, bytes);
    put(folder_ / "map.yaml", "image: " + image + "\n" + yaml);
    return load_occupancy_map(folder_ / "map.yaml");
  }
  std::string name(const std::string& file) { return (folder_ / file).string(); }

  io_test::TemporaryFolder folder_;
};

std::string with(std::string yaml, const std::string& line, const std::string& other) {
  return yaml.replace(yaml.find(line), line.size(), other);
}

TEST_F(OccupancyMapFileTest, ReadsGreysAsMapServerDoes) {
  const OccupancyMap map =
      load("map.pgm", "P2 # a comment\n# 4 x 4\n 4\n2 255\n0 254 205 88\n89# p = 0.651\n 90 204 206\n");
  // 205 is unknown: p = 0.19608; 206 is free: 0.19216; 89 is occupied: 0.65098; 90 is not: 0.64706.
  EXPECT_EQ(letters(map.grid), "#.?#/#??.");
  EXPECT_EQ(map.format, "PGM P2");
  EXPECT_EQ(map.grid.resolution, 0.1);
  EXPECT_EQ(map.grid.T_map_grid.x, 1.0);
  EXPECT_EQ(map.grid.T_map_grid.y, 2.0);
  EXPECT_TRUE(map.grid.probability.empty());
  EXPECT_TRUE(map.warnings.empty());
  // The first row of the image is the top.
  EXPECT_TRUE(map.grid.centre({0, 1}).isApprox(Point2(1.05, 2.15)));
  EXPECT_EQ(map.grid.at({1, 1}), CellState::free);
}

TEST_F(OccupancyMapFileTest, ThresholdsAreNotPartOfWhatTheyPart) {
  // 51 of 255 is p = 0.8, 204 is 0.2, as exact as numbers are.
  const std::string yaml = with(with(yaml_end, "0.65", "0.8"), "0.196", "0.2");
  EXPECT_EQ(letters(load("map.pgm", "P2 4 1 255 50 51 204 205", yaml).grid), "#??.");
}

TEST_F(OccupancyMapFileTest, NegateTurnsBlackAndWhite) {
  const std::string yaml = with(yaml_end, "negate: 0", "negate: true");
  EXPECT_EQ(letters(load("map.pgm", "P2 4 1 255 0 255 49 50", yaml).grid), ".#.?");
}

TEST_F(OccupancyMapFileTest, TakesBytesWordsAndLargerLevels) {
  EXPECT_EQ(letters(load("map.pgm", std::string("P5\n3 1\n255\n") + '\0' + '\xFE' + '\xCD').grid), "#.?");
  EXPECT_EQ(letters(load("map.pgm", std::string("P5 3 1 65535\n") + std::string("\0\1\xFE\0\xCD\xCD", 6)).grid), "#.?");
  EXPECT_EQ(letters(load("map.pgm", "P2 3 1 1000 0 1000 600").grid), "#.?");
  EXPECT_EQ(letters(load("map.pgm", "P2 3 1 1 0 1 1").grid), "#..");
  // The byte after the blank may look like a blank, or like a comment.
  EXPECT_EQ(letters(load("map.pgm", "P5\n2 1\n255\n\n#").grid), "##");
}

TEST_F(OccupancyMapFileTest, TellsOfBytesThatFollow) {
  const OccupancyMap map = load("map.pgm", std::string("P5 1 1 255\n\0more", 16));
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_NE(map.warnings[0].find("4 bytes"), std::string::npos);
}

TEST_F(OccupancyMapFileTest, ScaleKeepsWhatLiesBetween) {
  const OccupancyMap map = load("map.pgm", "P2 4 1 255 0 51 153 255", "mode: scale\n" + yaml_end);
  EXPECT_EQ(letters(map.grid), "##?.");
  EXPECT_EQ(map.grid.probability, (std::vector<float>{1.0F, 0.8F, 0.4F, 0.0F}));
}

TEST_F(OccupancyMapFileTest, RawIsPerCentWhateverNegateSays) {
  for (const std::string negate : {"0", "1"}) {
    const OccupancyMap map = load("map.pgm", "P2 6 1 255 0 19 20 66 100 255",
                                  "mode: raw\n" + with(yaml_end, "negate: 0", "negate: " + negate));
    EXPECT_EQ(letters(map.grid), "..?##?");
    EXPECT_EQ(map.grid.probability[3], 0.66F);
    EXPECT_TRUE(std::isnan(map.grid.probability[5]));
  }
}

TEST_F(OccupancyMapFileTest, TellsWhereUnknownIsTakenForFree) {
  const std::string image = "P2 3 1 255 0 205 205";
  EXPECT_TRUE(load("map.pgm", image).warnings.empty());
  const OccupancyMap map = load("map.pgm", image, with(yaml_end, "0.196", "0.25"));
  EXPECT_EQ(letters(map.grid), "#..") << "as nav2 has it";
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_NE(map.warnings[0].find("2 cells of grey 205"), std::string::npos);
}

TEST_F(OccupancyMapFileTest, TellsWhereAnImageWasSmoothed) {
  EXPECT_TRUE(load("map.pgm", "P2 6 1 255 0 0 205 205 205 204").warnings.empty());
  const OccupancyMap map = load("map.pgm", "P2 6 1 255 0 254 205 205 150 170");
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_NE(map.warnings[0].find("2 cells are neither"), std::string::npos);
}

TEST_F(OccupancyMapFileTest, AnOriginMayBeTurned) {
  const OccupancyMap map =
      load("map.pgm", "P2 2 1 255 0 254", with(yaml_end, "[1, 2, 0]", "[1, 2, 1.5707963267948966]"));
  EXPECT_TRUE(map.grid.centre({1, 0}).isApprox(Point2(0.95, 2.15)));
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_NE(map.warnings[0].find("turned by 90.00 deg"), std::string::npos);
}

TEST_F(OccupancyMapFileTest, WritesWhatItReads) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    OccupancyGrid grid;
    grid.width = random.integer(1, 40);
    grid.height = random.integer(1, 40);
    grid.resolution = random.uniform(0.001, 1.0);
    grid.T_map_grid = {random.uniform(-1e3, 1e3), random.uniform(-1e-3, 1e-3), random.uniform(-3, 3)};
    for (int k = 0; k < grid.width * grid.height; ++k)
      grid.cells.push_back(static_cast<CellState>(random.integer(0, 2)));
    save_occupancy_map(folder_ / "a map: b#.yaml", grid);
    const OccupancyMap map = load_occupancy_map(folder_ / "a map: b#.yaml");
    EXPECT_EQ(map.grid.cells, grid.cells);
    EXPECT_EQ(map.grid.width, grid.width);
    EXPECT_NEAR(map.grid.resolution, grid.resolution, 1e-12);
    EXPECT_NEAR(map.grid.T_map_grid.x, grid.T_map_grid.x, 1e-9);
    EXPECT_NEAR(map.grid.T_map_grid.y, grid.T_map_grid.y, 1e-12);
    EXPECT_NEAR(map.grid.T_map_grid.theta, grid.T_map_grid.theta, 1e-12);
    EXPECT_EQ(folder_.file_count(), 2U);
  }
}

TEST_F(OccupancyMapFileTest, WritesTheGreysAndThresholdsOfRos) {
  OccupancyGrid grid;
  grid.width = 3;
  grid.height = 1;
  grid.resolution = 0.05;
  grid.T_map_grid = {-1.0, 2.5, 0.0};
  grid.cells = {CellState::occupied, CellState::free, CellState::unknown};
  save_occupancy_map(folder_ / "map.yaml", grid);
  EXPECT_EQ(get(folder_ / "map.pgm"), std::string("P5\n3 1\n255\n") + '\0' + '\xFE' + '\xCD');
  EXPECT_EQ(get(folder_ / "map.yaml"),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.0, 2.5, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST_F(OccupancyMapFileTest, WritesBothFilesOrNone) {
  OccupancyGrid grid;
  EXPECT_THROW(save_occupancy_map(folder_ / "map.yaml", grid), Error);
  grid.width = grid.height = 1;
  grid.cells = {CellState::free};
  std::filesystem::create_directory(folder_ / "map.yaml");
  EXPECT_THROW(save_occupancy_map(folder_ / "map.yaml", grid), Error);
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(OccupancyMapFileTest, NamesFileAndKeyOfWhatIsWrong) {
  put(folder_ / "map.pgm", "P2 1 1 255 0");
  const std::string yaml = "image: map.pgm\n" + yaml_end;
  struct Case {
    const char* line;
    const char* other;
    const char* where;
    const char* what;
  };
  for (const auto& [line, other, where, what] :
       {Case{"image: map.pgm\n", "", "map.yaml", "no 'image'"},
        Case{"map.pgm", "[1]", "map.yaml:1", "image is not"},
        Case{"map.pgm", "''", "map.yaml:1", "image is empty"},
        Case{"map.pgm", "none.pgm", "map.yaml", "none.pgm is not there"},
        Case{"resolution: 0.1\n", "", "map.yaml", "no 'resolution'"},
        Case{"0.1\n", "0\n", "map.yaml:2", "resolution is 0 m"},
        Case{"0.1\n", "-1\n", "map.yaml:2", "resolution is -1"},
        Case{"0.1\n", "fine\n", "map.yaml:2", "not a number: 'fine'"},
        Case{"0.1\n", ".nan\n", "map.yaml:2", "not a number"},
        Case{"0.1\n", "inf\n", "map.yaml:2", "not a number"},
        Case{"origin: [1, 2, 0]\n", "", "map.yaml", "no 'origin'"},
        Case{"[1, 2, 0]", "[1, 2]", "map.yaml:3", "three numbers"},
        Case{"[1, 2, 0]", "[1, nan, 0]", "map.yaml:3", "not a number: 'nan'"},
        Case{"[1, 2, 0]", "[1, [2], 0]", "map.yaml:3", "three numbers"},
        Case{"[1, 2, 0]", "7", "map.yaml:3", "three numbers"},
        Case{"negate: 0\n", "", "map.yaml", "no 'negate'"},
        Case{"negate: 0", "negate: 2", "map.yaml:4", "negate is '2'"},
        Case{"occupied_thresh: 0.65\n", "", "map.yaml", "no 'occupied_thresh'"},
        Case{"0.65", "65", "map.yaml:5", "no probability"},
        Case{"0.65", "0.196", "map.yaml:5", "not above free_thresh"},
        Case{"free_thresh: 0.196\n", "", "map.yaml", "no 'free_thresh'"},
        Case{"0.196", "-0.1", "map.yaml:6", "no probability"},
        Case{"negate: 0\n", "negate: 0\nmode: blue\n", "map.yaml:5", "'blue'"},
        Case{"[1, 2, 0]", "[1, 2, 0", "map.yaml:4", "is no YAML"}}) {
    SCOPED_TRACE(what);
    put(folder_ / "map.yaml", with(yaml, line, other));
    expect_error([&] { load_occupancy_map(folder_ / "map.yaml"); }, name(where), what);
  }
  for (const std::string text : {"", "7", "[1, 2]"}) {
    put(folder_ / "map.yaml", text);
    expect_error([&] { load_occupancy_map(folder_ / "map.yaml"); }, name("map.yaml"), "no 'key: value'");
  }
}

TEST_F(OccupancyMapFileTest, NamesTheImageThatIsBroken) {
  const auto broken = [&](const std::string& bytes, const char* what) {
    SCOPED_TRACE(what);
    expect_error([&] { load("map.pgm", bytes); }, name("map.pgm"), what);
  };
  broken("", "empty");
  broken("P6 1 1 255\n...", "starts with 'P6'");
  broken("BM6", "neither PGM nor PNG");
  broken("P5", "before the width");
  broken("P5 3", "before the height");
  broken("P5 3 1 # 255", "before the largest level");
  broken("P5 x 1 255\n", "width is not a whole number: 'x'");
  broken("P5 -3 1 255\n", "width is not");
  broken("P5 0 1 255\n", "no pixel");
  broken("P5 1 1 0\n", "largest level is 0");
  broken("P5 1 1 65536\n", "at most 65535");
  broken("P5 100000 100000 255\n", "too large");
  broken("P5 99999999999 1 255\n", "at most");
  broken("P5 10000 10000 255\n.", "1 of 100000000 pixels");
  broken("P2 10000 10000 255\n1 1", "cut");
  broken("P2 2 1 255 1 x", "pixel 1 is not a whole number: 'x'");
  broken("P2 2 1 100 1 101", "pixel 1 is 101");
}

TEST_F(OccupancyMapFileTest, EveryCutIsFound) {
  std::string whole = "P5\n# made by hand\n20 10\n255\n";
  for (int k = 0; k < 200; ++k) whole += static_cast<char>(k);
  load("map.pgm", whole);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(load("map.pgm", whole.substr(0, size)), Error) << size;
}

TEST_F(OccupancyMapFileTest, AMapIsItsWalls) {
  put(folder_ / "map.yaml", "image: map.pgm\n" + yaml_end);
  put(folder_ / "map.pgm", "P2 4 3 255 0 0 0 0  0 0 0 0  254 254 254 205");
  EXPECT_EQ(kind_of(folder_ / "map.yaml"), FileKind::occupancy_map);
  const PointMap2::Pointer map = load_map(folder_ / "map.yaml");
  ASSERT_EQ(map->size(), 3U) << "nothing free beside the fourth, no ray to the upper row";
  EXPECT_TRUE(map->points()[0].isApprox(Point2(1.05, 2.2)));
  EXPECT_EQ(load_cloud(folder_ / "map.yaml").format, "map_server, PGM P2");
  expect_error([&] { load_map(folder_ / "map.pgm"); }, name("map.pgm"), "image of a map");
  put(folder_ / "map.pgm", "P2 1 1 255 254");
  expect_error([&] { load_map(folder_ / "map.yaml"); }, name("map.yaml"), "no point");
}

TEST_F(OccupancyMapFileTest, ACloudBecomesAMap) {
  const PointCloud2 points{{0.01, 0.01}, {0.26, 0.01}, {1.01, -0.51}};
  save_map(folder_ / "map.yaml", *PointMap2::create(points));
  const OccupancyMap map = load_occupancy_map(folder_ / "map.yaml");
  EXPECT_EQ(count_cells(map.grid).occupied, 3U);
  EXPECT_EQ(count_cells(map.grid).free, 0U);
  for (const Point2& point : points) EXPECT_EQ(map.grid.at(*map.grid.cell_at(point)), CellState::occupied);
  EXPECT_EQ(load_cloud2(folder_ / "map.yaml").size(), 3U);
  expect_error([&] { save_cloud(folder_ / "solid.yaml", PointCloud3{{0, 0, 0}}); }, name("solid.yaml"), "3D");
}

/// PNG, where this build reads it.
class OccupancyMapPngTest : public OccupancyMapFileTest {
 protected:
  void SetUp() override {
#ifndef SLAMICP_WITH_LIBPNG
    GTEST_SKIP() << "built without libpng";
#endif
  }
};

TEST_F(OccupancyMapPngTest, ColoursCountAsTheirMean) {
  using namespace io_test;
  const OccupancyMap grey = load("map.png", png(3, 2, 8, png_grey, std::string("\0\xFE\xCD\xFE\0\xCD", 6)));
  EXPECT_EQ(letters(grey.grid), "#.?/.#?");
  EXPECT_EQ(grey.format, "PNG grey, 8 bit");
  // The mean of 255, 255, 105 is 205, of 0, 0, 255 it is 85: p = 0.667.
  const OccupancyMap rgb = load("map.png", png(3, 1, 8, png_rgb, std::string("\xFF\xFF\x69\0\0\xFF\xFE\xFE\xFE", 9)));
  EXPECT_EQ(letters(rgb.grid), "?#.");
  EXPECT_EQ(rgb.format, "PNG RGB, 8 bit");
  const OccupancyMap deep = load("map.png", png(3, 1, 16, png_grey, std::string("\0\1\xFE\xFE\xCD\xCD", 6)));
  EXPECT_EQ(letters(deep.grid), "#.?");
  EXPECT_EQ(deep.format, "PNG grey, 16 bit");
  const OccupancyMap bits = load("map.png", png(3, 1, 1, png_grey, "\x40"));
  EXPECT_EQ(letters(bits.grid), "#.#");
  const std::string palette = png_chunk("PLTE", std::string("\0\0\0\xFE\xFE\xFE\xCD\xCD\xCD", 9));
  const OccupancyMap painted = load("map.png", png(4, 1, 2, png_palette, "\x1B", palette));  // 0 1 2 3
  EXPECT_EQ(letters(painted.grid).substr(0, 3), "#.?");
  EXPECT_EQ(painted.format, "PNG palette, 8 bit");
}

TEST_F(OccupancyMapPngTest, AlphaIsUnknownInScaleAndOneMoreColourInTrinary) {
  using namespace io_test;
  const std::string image =
      png(4, 1, 8, png_rgba,
          std::string("\0\0\0\xFF", 4) + "\xCD\xCD\xCD\xFF" + "\xFE\xFE\xFE\xFF" + std::string("\0\0\0\xFE", 4));
  const OccupancyMap scale = load("map.png", image, "mode: scale\n" + yaml_end);
  EXPECT_EQ(letters(scale.grid), "#?.?");
  EXPECT_TRUE(std::isnan(scale.grid.probability[3]));
  EXPECT_TRUE(scale.warnings.empty());
  // (3 x 205 + 255) / 4 is 217.5: free, p = 0.147; black is 63.75: p = 0.75.
  const OccupancyMap trinary = load("map.png", image);
  EXPECT_EQ(letters(trinary.grid), "#..#");
  ASSERT_EQ(trinary.warnings.size(), 1U);
  EXPECT_NE(trinary.warnings[0].find("alpha"), std::string::npos);
  const OccupancyMap grey = load("map.png", png(2, 1, 8, png_grey_alpha, std::string("\0\xFF\xCD\xFF", 4)));
  EXPECT_EQ(letters(grey.grid), "#.") << "as if it had three colours";
}

TEST_F(OccupancyMapPngTest, EveryCutIsFound) {
  std::string samples;
  for (int k = 0; k < 64; ++k) samples += static_cast<char>(k);
  const std::string whole = io_test::png(8, 8, 8, io_test::png_grey, samples);
  load("map.png", whole);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(load("map.png", whole.substr(0, size)), Error) << size;
}

TEST_F(OccupancyMapPngTest, NamesTheImageThatIsBroken) {
  using namespace io_test;
  std::string image = png(2, 2, 8, png_grey, "abcd");
  image[image.size() - 20] ^= 1;
  expect_error([&] { load("map.png", image); }, name("map.png"), "is no whole PNG image");
  expect_error([&] { load("map.png", png(9000, 9000, 8, png_grey, "a")); }, name("map.png"), "promises more");
  expect_error([&] { load("map.png", png(1000000, 1000000, 8, png_grey, "a")); }, name("map.png"), "too large");
}

}  // namespace
}  // namespace slamicp::occupancy_map_file_test
