// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/map_file.hpp>
#include <slamicp/io/spelling.hpp>
#include <slamicp/io/world_file.hpp>
#include <slamicp/navigation/spline_path.hpp>
#include <slamicp/simulation/corridor_world.hpp>
#include <slamicp/simulation/crowd.hpp>
#include <slamicp/simulation/lidar.hpp>

#include "io/io_test_support.hpp"

namespace slamicp::world_file_test {
namespace {

using io_test::expect_error;
using io_test::put;

const std::filesystem::path example_folder = std::filesystem::path(SLAMICP_TEST_DIR) / ".." / "examples" / "worlds";

class WorldFileTest : public ::testing::Test {
 protected:
#ifndef SLAMICP_WITH_YAML
  void SetUp() override { GTEST_SKIP() << "skipped: this build reads no YAML"; }
#endif
  World load(const std::string& yaml) {
    put(folder_ / "w.yaml", yaml);
    return load_world(folder_ / "w.yaml");
  }
  /// What stands wrong in a line of the file; counted from 1, 0 for none.
  void expect_wrong(const std::string& yaml, int line, std::string_view what) {
    const std::string where = (folder_ / "w.yaml").string() + (line > 0 ? ":" + std::to_string(line) : "");
    expect_error([&] { load(yaml); }, where, what);
  }
  /// The same, after a first line that is right.
  void expect_wrong_line(const std::string& yaml, std::string_view what) { expect_wrong("world: w\n" + yaml, 2, what); }
  /// How it is told to be mended.
  std::string mend_of(const std::string& yaml) {
    try {
      load(yaml);
    } catch (const Error& error) {
      return error.mend();
    }
    return "no Error";
  }

  io_test::TemporaryFolder folder_;
};

void expect_near(const Point2& point, const Point2& expected) { EXPECT_LT((point - expected).norm(), 1e-12); }

void expect_same(const World& one, const World& other) {
  EXPECT_EQ(one.name, other.name);
  ASSERT_EQ(one.walls.size(), other.walls.size());
  for (std::size_t k = 0; k < one.walls.size(); ++k) {
    EXPECT_EQ(one.walls[k].a, other.walls[k].a);
    EXPECT_EQ(one.walls[k].b, other.walls[k].b);
  }
  ASSERT_EQ(one.pillars.size(), other.pillars.size());
  for (std::size_t k = 0; k < one.pillars.size(); ++k) EXPECT_EQ(one.pillars[k].radius, other.pillars[k].radius);
  ASSERT_EQ(one.doors.size(), other.doors.size());
  for (std::size_t k = 0; k < one.doors.size(); ++k) {
    EXPECT_EQ(one.doors[k].name, other.doors[k].name);
    EXPECT_EQ(one.doors[k].latch, other.doors[k].latch);
    EXPECT_NEAR(one.doors[k].opening, other.doors[k].opening, 1e-12);
    EXPECT_NEAR(one.doors[k].mapped_opening, other.doors[k].mapped_opening, 1e-12);
  }
  ASSERT_EQ(one.obstacles.size(), other.obstacles.size());
  for (std::size_t k = 0; k < one.obstacles.size(); ++k) {
    EXPECT_EQ(one.obstacles[k].name, other.obstacles[k].name);
    ASSERT_EQ(one.obstacles[k].boxes.size(), other.obstacles[k].boxes.size());
    for (std::size_t i = 0; i < one.obstacles[k].boxes.size(); ++i)
      EXPECT_NEAR(one.obstacles[k].boxes[i].heading, other.obstacles[k].boxes[i].heading, 1e-12);
    EXPECT_EQ(one.obstacles[k].cylinders.size(), other.obstacles[k].cylinders.size());
  }
  ASSERT_EQ(one.people.size(), other.people.size());
  for (std::size_t k = 0; k < one.people.size(); ++k)
    for (const double stamp : {0.0, 7.3})
      expect_near(pose_at(one.people[k], stamp).translation(), pose_at(other.people[k], stamp).translation());
  ASSERT_EQ(one.routes.size(), other.routes.size());
  for (std::size_t k = 0; k < one.routes.size(); ++k) EXPECT_EQ(one.routes[k].waypoints, other.routes[k].waypoints);
}

TEST_F(WorldFileTest, ReadsAllThatAWorldMayHave) {
  const World world = load(R"(# a comment
world: flat
walls:
  - segment: [[0, 0], [4, 0]]
  - {polyline: [[0, 0], [0, 3], [4, 3]], closed: false}
  - {polyline: [[5, 5], [6, 5], [6, 6]], closed: true}
  - rectangle: {centre: [2, 2], width: 1, depth: 0.5, heading_deg: 90}
pillars: [{centre: [1, 1.5], radius: 0.2}]
doors:
  - {name: front, hinge: [1, 0], latch: [2, 0], open_deg: 90, mapped_open_deg: 0, thickness: 0.05}
obstacles:
  - name: things
    boxes: [{centre: [3, 1], width: 0.4, depth: 0.3, heading_deg: -45}]
    cylinders: [{centre: [3.5, 1], radius: 0.1}]
people:
  - {name: Ada, way: [[0.5, 1], [3, 1]], speed: 1.5, start: 2, pause: 1, loop: false}
  - {way: [[0.5, 2]], heading_deg: 180, seen_as: body, body_radius: 0.3}
  - {way: [[1, 1], [2, 1], [2, 2]], loop: true, leg_radius: 0.05, leg_distance: 0.2, step_length: 0.6}
routes:
  - {name: there, waypoints: [[0.5, 0.5], [3, 0.5]]}
)");
  EXPECT_EQ(world.name, "flat");
  ASSERT_EQ(world.walls.size(), 2U + 2U + 3U + 4U) << "the door cuts the first in two";
  expect_near(world.walls[0].b, {1.0, 0.0});
  expect_near(world.walls[1].a, {2.0, 0.0});
  expect_near(world.walls[6].b, {5.0, 5.0});
  EXPECT_LT(std::abs((world.walls[7].b - world.walls[7].a).x()), 1e-12) << "the rectangle is turned";
  ASSERT_EQ(world.pillars.size(), 1U);
  EXPECT_EQ(world.pillars[0].radius, 0.2);
  ASSERT_EQ(world.doors.size(), 1U);
  EXPECT_EQ(world.doors[0].name, "front");
  EXPECT_NEAR(world.doors[0].opening, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_EQ(world.doors[0].mapped_opening, 0.0);
  EXPECT_EQ(world.doors[0].thickness, 0.05);
  ASSERT_EQ(world.obstacles.size(), 1U);
  EXPECT_EQ(world.obstacles[0].name, "things");
  EXPECT_NEAR(world.obstacles[0].boxes[0].heading, -0.25 * std::numbers::pi, 1e-12);
  EXPECT_EQ(world.obstacles[0].cylinders[0].radius, 0.1);
  ASSERT_EQ(world.people.size(), 3U);
  EXPECT_EQ(world.people[0].speed, 1.5);
  EXPECT_EQ(world.people[0].start, 2.0);
  EXPECT_EQ(world.people[0].pause, 1.0);
  EXPECT_EQ(world.people[1].shape, PersonShape::body);
  EXPECT_EQ(world.people[1].body_radius, 0.3);
  EXPECT_NEAR(world.people[1].heading, std::numbers::pi, 1e-12);
  EXPECT_TRUE(world.people[2].is_loop);
  EXPECT_EQ(world.people[2].step_length, 0.6);
  EXPECT_EQ(route(world, "there").waypoints.size(), 2U);
}

TEST_F(WorldFileTest, ADoorIsAsTheMapHasItUnlessToldOtherwise) {
  const World world = load("world: w\ndoors:\n  - {hinge: [0, 0], latch: [1, 0], open_deg: 30}\n");
  EXPECT_EQ(world.doors[0].opening, world.doors[0].mapped_opening);
  EXPECT_GT(world.doors[0].opening, 0.5);
}

TEST_F(WorldFileTest, WhatIsWrittenIsReadBack) {
  World world = corridor_world();
  for (const PlacedObstacle& obstacle : corridor_obstacles()) world = with_obstacle(world, obstacle);
  world = with_crowd(world, route(world, "reference").waypoints, {.people = 6, .layout = CrowdLayout::random_walk});
  world.people[0].is_loop = true;
  world.people[1].shape = PersonShape::body;
  world.people[2].name = "\"Zo\\e\"\n#: '";
  world = with_door(world, {"back", {20.0, 2.5}, {21.0, 2.5}, -1.2, 0.0, 0.05});
  save_world(folder_ / "saved.yaml", world);
  const World read = load_world(folder_ / "saved.yaml");
  expect_same(read, world);
  EXPECT_EQ(read.people[2].name, world.people[2].name);
  save_world(folder_ / "again.yaml", read);
  expect_same(load_world(folder_ / "again.yaml"), read);
}

TEST_F(WorldFileTest, WhatWouldNotBeReadIsNotWritten) {
  World world = corridor_world();
  world.pillars.push_back({{1.0, std::nan("")}, 0.1});
  EXPECT_THROW(save_world(folder_ / "saved.yaml", world), Error);
  EXPECT_EQ(folder_.file_count(), 0U);
}

TEST_F(WorldFileTest, AFloorPlanBecomesWallsAndDoorsCutThem) {
  put(
      folder_ / "plan.pgm", "P2 10 7 255 " + [] {
        std::string cells;
        for (int row = 0; row < 7; ++row)
          for (int column = 0; column < 10; ++column)
            cells += row == 0 || row == 6 || column == 0 || column == 9 ? "0 " : "254 ";
        return cells;
      }());
  put(folder_ / "plan.yaml",
      "image: plan.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const World room = load("world: w\nfloor_plan: plan.yaml\n");
  EXPECT_EQ(room.walls.size(), 4U);
  LidarModel lidar = hokuyo_utm30lx();
  std::vector<double> ranges;
  true_ranges(room, {3.0, 3.0, 0.0}, lidar, ranges);
  EXPECT_NEAR(ranges[540], 1.0 + 4.75 - 3.0, 1e-9) << "the middle of the last column";
  const World with_gap =
      load("world: w\nfloor_plan: plan.yaml\ndoors: [{hinge: [5.75, 2.6], latch: [5.75, 3.6], open_deg: -90}]\n");
  true_ranges(with_gap, {3.0, 3.0, 0.0}, lidar, ranges);
  EXPECT_TRUE(std::isinf(ranges[540]));
  // One localizes in the plan where the simulator sees it.
  const PointMap2::Pointer map = load_map(folder_ / "plan.yaml");
  for (const Point2& point : map->points()) EXPECT_LT(distance_to_walls(room, point), 1e-9);
  // As a file of its own it has no plan any more.
  save_world(folder_ / "saved.yaml", with_gap);
  expect_same(load_world(folder_ / "saved.yaml"), with_gap);
}

TEST_F(WorldFileTest, TellsOfAFloorPlanThatIsNone) {
  expect_wrong_line("floor_plan: none.yaml\n", "none.yaml is not there");
  put(folder_ / "plan.pgm", "P2 2 1 255 254 254");
  put(folder_ / "plan.yaml",
      "image: plan.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  expect_wrong_line("floor_plan: plan.yaml\n", "has no walls");
  expect_wrong_line("floor_plan: ''\n", "empty");
}

TEST_F(WorldFileTest, TellsAnUnknownKeyAndTheOneThatWasMeant) {
  expect_wrong_line("wals: []\n", "'wals'");
  EXPECT_EQ(mend_of("world: w\nwals: []\n"), "did you mean 'walls'?");
  EXPECT_EQ(mend_of("world: w\npillars: [{center: [0, 0], radius: 1}]\n"), "did you mean 'centre'?");
  EXPECT_EQ(mend_of("world: w\npillars: [{centre: [0, 0], raduis: 1}]\n"), "did you mean 'radius'?");
  EXPECT_EQ(mend_of("world: w\npeople: [{way: [[0, 0]], seen_as: leg}]\n"), "did you mean 'legs'?");
  EXPECT_EQ(mend_of("world: w\npillars: [{centre: [0, 0], colour: red}]\n"), "it may have: centre, radius");
}

TEST_F(WorldFileTest, TellsNumbersThatCannotBe) {
  for (const std::string number : {"nan", ".nan", "inf", "-0.2", "0", "1e9", "abc", "''", "[1]", "{a: 1}", "~"})
    expect_wrong_line("pillars: [{centre: [0, 0], radius: " + number + "}]\n", "radius");
  for (const std::string point : {"[0]", "[0, 1, 2]", "7", "[0, nan]", "[0, x]", "[0, 1e12]", "~", "{x: 1, y: 2}"})
    expect_wrong_line("pillars: [{radius: 1, centre: " + point + "}]\n", "centre");
  expect_wrong_line("doors: [{hinge: [0, 0], latch: [1, 0], open_deg: 200}]\n", "open_deg");
  expect_wrong_line("people: [{way: [[0, 0], [1, 0]], speed: 0}]\n", "speed");
  expect_wrong_line("people: [{way: [[0, 0], [1, 0]], pause: -1}]\n", "pause");
  expect_wrong_line("people: [{way: [[0, 0], [1, 0]], loop: maybe}]\n", "loop");
}

TEST_F(WorldFileTest, TellsWhatIsMissingOrTooMuch) {
  expect_wrong_line("pillars: [{centre: [0, 0]}]\n", "no 'radius'");
  expect_wrong_line("doors: [{hinge: [0, 0]}]\n", "no 'latch'");
  expect_wrong_line("doors: [{hinge: [0, 0], latch: [0, 0]}]\n", "wide");
  expect_wrong_line("people: [{speed: 1}]\n", "no 'way'");
  expect_wrong_line("people: [{way: []}]\n", "1 point");
  expect_wrong_line("people: [{way: [[0, 0], [1, 0], [0, 0]], loop: true}]\n", "ends where it begins");
  expect_wrong_line("routes: [{name: a, waypoints: [[0, 0]]}]\n", "2 points");
  expect_wrong_line("routes: [{name: a, waypoints: [[0, 0], [0, 0]]}]\n", "twice in a row");
  expect_wrong_line("obstacles: [{name: a}]\n", "neither boxes nor cylinders");
  expect_wrong_line("walls: [{closed: true}]\n", "no shape");
  expect_wrong_line("walls: [{segment: [[0, 0], [1, 0]], polyline: [[0, 0], [1, 0]]}]\n", "more than one shape");
  expect_wrong_line("walls: [{segment: [[0, 0], [1, 0], [2, 0]]}]\n", "more than two ends");
  expect_wrong_line("walls: [{segment: [[0, 0], [1, 0]], closed: true}]\n", "only a polyline");
  expect_wrong_line("walls: [{polyline: [[0, 0], [1, 0]], closed: true}]\n", "three corners");
  expect_wrong_line("walls: 7\n", "no list");
  expect_wrong_line("walls: [7]\n", "no 'key: value' pairs");
  expect_wrong_line("world: again\n", "twice");
  expect_wrong(
      "world: w\nroutes:\n  - {name: a, waypoints: [[0, 0], [1, 0]]}\n  - {name: a, waypoints: [[0, 0], [1, 1]]}\n", 4,
      "two routes 'a'");
  expect_wrong("world: w\n", 1, "nothing stands");
  expect_wrong("world: ''\n", 1, "no name");
}

TEST_F(WorldFileTest, TellsWhatIsNoWorld) {
  expect_wrong("", 0, "is no world");
  expect_wrong("just words\n", 0, "is no world");
  expect_wrong("walls: []\n", 0, "is no world");
  expect_wrong("image: map.pgm\nresolution: 0.05\n", 0, "map_server map");
  expect_wrong("world: [1\n", 2, "no YAML");
  expect_error([&] { load_world(folder_ / "none.yaml"); }, (folder_ / "none.yaml").string(), "cannot be read");
  put(folder_ / "world.yaml", "world: w\npillars: [{centre: [0, 0], radius: 1}]\n");
  expect_error([&] { load_map(folder_ / "world.yaml"); }, (folder_ / "world.yaml").string(), "is a world");
}

TEST_F(WorldFileTest, AliasesDoNotGrowBeyondMeasure) {
  std::string yaml = "world: w\nwalls:\n  - polyline: &long [[0, 0]";
  for (int k = 1; k < 3000; ++k) yaml += ",[" + std::to_string(k) + ",0]";
  yaml += "]\n";
  for (int k = 0; k < 500; ++k) yaml += "  - polyline: *long\n";
  EXPECT_THROW(load(yaml), Error);
}

TEST_F(WorldFileTest, AFileIsAWorldByItsKey) {
  put(folder_ / "a.yaml", "# a comment\nworld: w\n");
  put(folder_ / "b.yaml", "image: world.pgm\n");
  EXPECT_EQ(kind_of(folder_ / "a.yaml"), FileKind::world);
  EXPECT_EQ(kind_of(folder_ / "b.yaml"), FileKind::occupancy_map);
  EXPECT_EQ(kind_of(folder_ / "none.yaml"), FileKind::occupancy_map);
}

TEST_F(WorldFileTest, TheExamplesAreWorldsWhoseRoutesAreClear) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(example_folder)) {
    if (entry.path().extension() != ".yaml" || kind_of(entry.path()) != FileKind::world) continue;
    ++count;
    const World world = load_world(entry.path());
    EXPECT_FALSE(world.routes.empty()) << entry.path();
    EXPECT_FALSE(world.people.empty()) << entry.path();
    for (const Route& way : world.routes) {
      for (const Pose2& pose : SplinePath(way.waypoints).sampled(0.05)) {
        ASSERT_GT(distance_to_walls(world, pose.translation()), 0.3) << way.name << ", " << to_string(pose);
        for (const PlacedObstacle& obstacle : world.obstacles)
          ASSERT_GT(distance(obstacle, pose.translation()), 0.3) << way.name << ", " << obstacle.name;
      }
    }
    for (const Person& person : world.people)
      for (double stamp = 0.0; stamp < 60.0; stamp += 0.1)
        ASSERT_GT(distance_to_walls(world, pose_at(person, stamp).translation()), 0.2) << person.name << stamp;
  }
  EXPECT_EQ(count, 2U);
}

TEST(Spelling, CountsLettersAddedTakenChangedAndSwapped) {
  EXPECT_EQ(text::spelling_distance("radius", "radius"), 0U);
  EXPECT_EQ(text::spelling_distance("raduis", "radius"), 1U);
  EXPECT_EQ(text::spelling_distance("radus", "radius"), 1U);
  EXPECT_EQ(text::spelling_distance("", "abc"), 3U);
  EXPECT_EQ(text::spelling_distance("kitten", "sitting"), 3U);
  constexpr std::string_view names[] = {"walls", "way"};
  EXPECT_EQ(text::nearest_name("wall", names), "walls");
  EXPECT_EQ(text::nearest_name("zebra", names), "");
}

}  // namespace
}  // namespace slamicp::world_file_test
