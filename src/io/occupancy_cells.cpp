// SPDX-License-Identifier: Apache-2.0
#include "io/occupancy_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "io/text.hpp"

namespace slamicp {
namespace {

constexpr double nothing_known = std::numeric_limits<double>::quiet_NaN();

class Greys {
 public:
  Greys(const OccupancyImage& image, const OccupancyMapHeader& header) : image_(image), header_(header) {}

  /// That the cell of a pixel is occupied; NaN where the image says that nothing is known.
  double probability(std::size_t pixel) const {
    if (header_.mode == OccupancyMode::raw) {
      const double per_cent = std::round(255.0 * image_.levels[pixel] / image_.white);
      return per_cent <= 100.0 ? per_cent / 100.0 : nothing_known;
    }
    if (header_.mode == OccupancyMode::scale && image_.opaque != 0 && image_.alphas[pixel] < image_.opaque)
      return nothing_known;
    const auto [level, white] = level_and_white(pixel);
    // In whole numbers as far as it goes: 51 of 255 is 0.8 exactly, and so not above an occupied_thresh of 0.8.
    return static_cast<double>(header_.negate ? level : white - level) / white;
  }

  CellState state(double probability) const {
    if (probability > header_.occupied_threshold) return CellState::occupied;
    if (probability < header_.free_threshold) return CellState::free;
    return CellState::unknown;
  }

  /// The grey as one of 256.
  std::size_t grey(std::size_t pixel) const {
    const auto [level, white] = level_and_white(pixel);
    return static_cast<std::size_t>(std::uint64_t{level} * 255 / white);
  }

  /// The grey in which ROS writes what is unknown.
  bool is_unknown_grey(std::size_t pixel) const {
    const auto [level, white] = level_and_white(pixel);
    return std::uint64_t{level} * 255 == std::uint64_t{white} * 205;
  }

 private:
  /// In trinary mode alpha counts as a fourth colour, in grey images too.
  std::pair<std::uint32_t, std::uint32_t> level_and_white(std::size_t pixel) const {
    if (header_.mode != OccupancyMode::trinary || image_.opaque == 0) return {image_.levels[pixel], image_.white};
    const std::uint32_t colours = 3 * image_.opaque / image_.white;
    return {colours * image_.levels[pixel] + image_.alphas[pixel], colours * image_.white + image_.opaque};
  }

  const OccupancyImage& image_;
  const OccupancyMapHeader& header_;
};

OccupancyGrid empty_grid(const OccupancyImage& image, const OccupancyMapHeader& header) {
  OccupancyGrid grid;
  grid.width = image.width;
  grid.height = image.height;
  grid.resolution = header.resolution;
  grid.T_map_grid = header.T_map_grid;
  grid.cells.resize(image.levels.size());
  if (header.mode != OccupancyMode::trinary) grid.probability.resize(image.levels.size());
  return grid;
}

/// What the user may not have meant.
class Doubts {
 public:
  void look_at(const Greys& greys, std::size_t pixel, CellState state, const OccupancyMapHeader& header) {
    if (header.mode == OccupancyMode::raw) return;
    if (state == CellState::unknown) ++unknown_[greys.grey(pixel)];
    taken_for_free_ += state == CellState::free && !header.negate && greys.is_unknown_grey(pixel);
  }

  void tell(const OccupancyImage& image, const OccupancyGrid& grid, const OccupancyMapHeader& header,
            std::vector<std::string>& warnings) const {
    if (taken_for_free_ > 0)
      warnings.push_back(text::count_of(taken_for_free_, "cell") +
                         " of grey 205, which ROS writes for unknown, are free by this free_thresh: older map savers "
                         "of nav2 write 0.25; make it 0.196");
    if (header.mode != OccupancyMode::trinary) return;
    if (image.opaque != 0)
      warnings.emplace_back(
          "the image has alpha, which map_server counts as one more colour: greys look lighter to it; save it without");
    const CellCounts counts = count_cells(grid);
    const std::size_t between = counts.unknown - *std::max_element(unknown_.begin(), unknown_.end());
    if (between > counts.occupied)
      warnings.push_back("of many greys, " + text::count_of(between, "cell") + " are neither occupied nor free, " +
                         std::to_string(counts.occupied) +
                         " are occupied: the image was scaled or smoothed, and walls are missing; save the map again, "
                         "or lower occupied_thresh");
  }

 private:
  std::array<std::size_t, 256> unknown_{};  ///< cells of each grey
  std::size_t taken_for_free_ = 0;
};

}  // namespace

OccupancyGrid cells_of(const OccupancyImage& image, const OccupancyMapHeader& header,
                       std::vector<std::string>& warnings) {
  OccupancyGrid grid = empty_grid(image, header);
  const Greys greys(image, header);
  Doubts doubts;
  std::size_t pixel = 0;
  for (int row = grid.height - 1; row >= 0; --row)  // an image's first row is the top
    for (int column = 0; column < grid.width; ++column, ++pixel) {
      const double probability = greys.probability(pixel);
      const std::size_t index = grid.index({column, row});
      grid.cells[index] = greys.state(probability);
      if (!grid.probability.empty()) grid.probability[index] = static_cast<float>(probability);
      doubts.look_at(greys, pixel, grid.cells[index], header);
    }
  doubts.tell(image, grid, header, warnings);
  return grid;
}

}  // namespace slamicp
