// SPDX-License-Identifier: Apache-2.0
#include <unordered_map>

#include <slamicp/error.hpp>
#include <slamicp/search/cell_index.hpp>

#include "search/cell_state.hpp"
#include "search/parallel.hpp"
#include "search/sample_lines.hpp"
#include "search/spacing.hpp"
#include "search/surface_fit.hpp"

namespace slamicp {
namespace {

constexpr std::size_t tiles_worth_a_thread = 8;

struct HashPlace {
  std::size_t operator()(const TilePlace& place) const noexcept {
    const auto x = static_cast<std::uint32_t>(place.x);
    const auto y = static_cast<std::uint32_t>(place.y);
    return static_cast<std::size_t>((std::uint64_t{y} << 32U | x) * 0x9E3779B97F4A7C15ULL >> 16U);
  }
};

struct Residents {
  TilePlace place;
  std::vector<int> numbers;
};

/// The points that can be found, by tile; numbers rising.
std::vector<Residents> by_tile(PointView<2> points, const TileGrid& grid) {
  constexpr std::uint32_t no_tile = ~0U;
  std::vector<Residents> tiles;
  std::vector<std::uint32_t> counts;
  std::vector<std::uint32_t> tile_of(points.size(), no_tile);
  std::unordered_map<TilePlace, std::uint32_t, HashPlace> known;
  TilePlace last;
  std::uint32_t last_tile = no_tile;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!can_be_found(points[k])) continue;
    const TilePlace place = grid.place_of(points[k]);
    if (last_tile == no_tile || place != last) {
      const auto [found, is_new] = known.try_emplace(place, static_cast<std::uint32_t>(tiles.size()));
      if (is_new) {
        tiles.push_back({place, {}});
        counts.push_back(0);
      }
      last = place;
      last_tile = found->second;
    }
    tile_of[k] = last_tile;
    ++counts[last_tile];
  }
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) tiles[tile].numbers.reserve(counts[tile]);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (tile_of[k] != no_tile) tiles[tile_of[k]].numbers.push_back(static_cast<int>(k));
  return tiles;
}

}  // namespace

std::uint64_t next_index_id() noexcept {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

CellIndex::CellIndex() : CellIndex(PointCloud2{}, SurfaceOptions{}) {}

CellIndex::CellIndex(PointCloud2 points, const SurfaceOptions& surfaces, const CellOptions& cells) {
  check(surfaces);
  if (const std::string problem = cells.problem(); !problem.empty()) throw Error(problem, "CellOptions");
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Error("an index of " + std::to_string(points.size()) + " points", "CellIndex",
                "thin the cloud: at most 2^31 - 1 points can be numbered");
  const auto state = std::make_shared<State>(surfaces, cells);
  state->points = PointBuffer(std::move(points));
  state->id = next_index_id();
  state->progress = std::make_shared<BuildProgress>();
  const PointView<2> all = state->points.view();
  std::vector<Residents> residents = by_tile(all, state->grid);
  std::vector<TilePlace> around;
  for (const Residents& some : residents) {
    Bounds<2> bounds;
    for (const int number : some.numbers) bounds.include(all[static_cast<std::size_t>(number)]);
    state->for_each_place_within_reach(bounds, [&](TilePlace at) { around.push_back(at); });
  }
  for (auto& [place, some] : residents)
    state->tiles.set(place, std::make_shared<Tile>(place, std::move(some), all, state->grid), state->id);
  for (const TilePlace at : around)
    if (state->tiles.find(at) == nullptr)
      state->tiles.set(at, std::make_shared<Tile>(at, std::vector<int>(), all, state->grid), state->id);
  state->measure_spacing();
  state->progress->places.reserve(state->tiles.size());
  state->tiles.for_each([&](const Tile& tile) { state->progress->places.push_back(tile.place()); });
  if (cells.eager) state->build_all();
  state_ = state;
}

std::size_t CellIndex::State::nearest_k(const Point2& query, double reach, std::span<Neighbour> found) const noexcept {
  if (found.empty()) return 0;
  NearestKVisitor visitor{reach * reach, found, 0};
  search().visit(query, visitor);
  return visitor.count;
}

void CellIndex::State::measure_spacing() noexcept {
  const auto near = [&](const Point2& point, double reach, std::span<Neighbour> found) {
    return can_be_found(point) ? nearest_k(point, reach, found) : 0;
  };
  spacing = sample_spacing<2>(points.view(), near);
  line_noise = sample_line_noise(points.view(), surfaces, near);
  spacing_of = points.size();
}

Line CellIndex::State::fit_line(int number) const noexcept {
  const PointView<2> all = points.view();
  const Point2& point = all[static_cast<std::size_t>(number)];
  std::array<Neighbour, max_surface_neighbours> room;
  const std::size_t count =
      nearest_k(point, surfaces.radius, std::span(room.data(), static_cast<std::size_t>(surfaces.neighbours)));
  const std::span<const Neighbour> found(room.data(), count);
  const auto place = [&](int k) -> const Point2& { return all[static_cast<std::size_t>(k)]; };
  const auto [surface, scatter] = fit_surface<2>(point, found, surfaces, place);
  Line line;
  line.window = surface_window(found, surfaces);
  if (!surface.valid()) return line;
  line.normal_x = static_cast<float>(surface.normal.x());
  line.normal_y = static_cast<float>(surface.normal.y());
  line.offset = static_cast<float>(surface.normal.dot(surface.centroid - point));
  line.trust = static_cast<float>(trust_of(scatter, static_cast<double>(count)));
  return line;
}

double CellIndex::State::trust_of(double scatter, double count) const noexcept {
  constexpr double least = 0.2;       // where all lines are poor they hold the pose together
  constexpr double thickness = 0.01;  // 1 sigma [m]: what scatters less is a wall as lidars see them
  // Of n points on a line the sum of squares has n - 2 degrees of freedom.
  const double variance = scatter * count / (count - 2.0);
  const double typical = std::max(line_noise.across, thickness);
  const double usual = surfaces.scatter * typical * typical;
  const double share = usual / variance;
  return share < 1.0 ? std::max(least, share * share) : 1.0;
}

const std::vector<Line>* CellIndex::State::lines_of(const Tile& tile) const {
  if (surfaces.neighbours == 0) return nullptr;
  if (tile.lines() == nullptr) {
    auto lines = std::make_unique<std::vector<Line>>();
    lines->reserve(tile.numbers().size());
    for (const int number : tile.numbers()) lines->push_back(fit_line(number));
    tile.publish(std::move(lines));
  }
  return tile.lines();
}

void CellIndex::State::collect(const Tile& tile, std::vector<CellPoint>& found) const {
  found.clear();
  const Point2 corner = grid.corner(tile.place());
  const double reach = cells.reach + 1e-4;
  const auto is_near = [&](const Point2& place) {
    return (place.array() > -reach).all() && (place.array() < grid.tile + reach).all();
  };
  const PointView<2> all = points.view();
  tiles.for_each_in(grid.place_of(corner - Point2::Constant(reach)),
                    grid.place_of(corner + Point2::Constant(grid.tile + reach)), [&](const Tile& other) {
                      const std::vector<Line>* lines = lines_of(other);
                      for (std::size_t j = 0; j < other.numbers().size(); ++j) {
                        const int number = other.numbers()[j];
                        const Point2 place = all[static_cast<std::size_t>(number)] - corner;
                        if (is_near(place)) found.push_back(cell_point(place, number, lines ? (*lines)[j] : Line{}));
                      }
                    });
}

bool CellIndex::State::build_table(const Tile& tile, CellBuilder& builder, std::vector<CellPoint>& room) const {
  collect(tile, room);
  return tile.publish(builder.build(room));
}

void CellIndex::State::build_all() const {
  std::vector<const Tile*> all;
  all.reserve(tiles.size());
  tiles.for_each([&](const Tile& tile) { all.push_back(&tile); });
  const auto in_parallel = [&](const auto& work) {
    parallel_chunks(all.size(), surfaces.threads, work, tiles_worth_a_thread);
  };
  in_parallel([&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) lines_of(*all[k]);
  });
  in_parallel([&](std::size_t begin, std::size_t end) {
    CellBuilder builder(grid, cells.reach);
    std::vector<CellPoint> room;
    for (std::size_t k = begin; k < end; ++k) build_table(*all[k], builder, room);
  });
  progress->next = progress->places.size();
  ++progress->builds;
}

std::size_t CellIndex::build(std::size_t tiles, const Point2& near) const {
  const State& state = *state_;
  CellBuilder builder(state.grid, state.cells.reach);
  std::vector<CellPoint> room;
  std::size_t built = 0;
  const auto build_at = [&](const Tile* tile) {
    if (tile != nullptr && tile->table() == nullptr && built < tiles && state.build_table(*tile, builder, room))
      ++built;
  };
  if (can_be_found(near)) {
    constexpr int rings = 24;
    const TilePlace middle = state.grid.place_of(near);
    for (int ring = 0; ring <= rings && built < tiles; ++ring)
      for (int y = -ring; y <= ring; ++y)
        for (int x = -ring; x <= ring; x += std::abs(y) == ring || ring == 0 ? 1 : 2 * ring)
          build_at(state.tiles.find({middle.x + x, middle.y + y}));
  }
  BuildProgress& progress = *state.progress;
  while (built < tiles) {
    const std::size_t k = progress.next.fetch_add(1, std::memory_order_relaxed);
    if (k >= progress.places.size()) break;
    build_at(state.tiles.find(progress.places[k]));
  }
  // Tiles that came later, or whose place another version of this index went past.
  if (built < tiles) state.tiles.for_each([&](const Tile& tile) { build_at(&tile); });
  if (built > 0) ++progress.builds;
  return built;
}

std::size_t CellIndex::size() const noexcept { return state_->points.size(); }
PointView<2> CellIndex::points() const noexcept { return state_->points.view(); }
bool CellIndex::has_surfaces() const noexcept { return state_->surfaces.neighbours > 0 && size() > 0; }
double CellIndex::spacing() const noexcept { return state_->spacing; }
const LineNoise& CellIndex::line_noise() const noexcept { return state_->line_noise; }
std::uint64_t CellIndex::builds() const noexcept { return state_->progress->builds.load(std::memory_order_acquire); }
std::uint64_t CellIndex::id() const noexcept { return state_->id; }
const CellOptions& CellIndex::cell_options() const noexcept { return state_->cells; }
double CellIndex::cell() const noexcept { return state_->grid.cell; }
double CellIndex::tile() const noexcept { return state_->grid.tile; }
double CellIndex::place_unit() const noexcept { return slamicp::place_unit(state_->grid, state_->cells.reach); }
double CellIndex::distance_unit() const noexcept { return slamicp::distance_unit(state_->grid, state_->cells.reach); }

std::size_t CellIndex::memory() const noexcept {
  std::size_t bytes = sizeof(State) + state_->points.memory() + state_->tiles.memory();
  state_->tiles.for_each([&](const Tile& tile) { bytes += tile.memory(); });
  return bytes;
}

Surface2 CellIndex::surface(std::size_t number) const noexcept {
  const Point2& point = points()[number];
  if (!has_surfaces() || !can_be_found(point)) return {};
  const Tile* tile = state_->tiles.find(state_->grid.place_of(point));
  const std::vector<Line>* lines = tile ? tile->lines() : nullptr;
  Line line;
  if (lines) {
    const int column = TileGrid::within_tile(state_->grid.cell_of(point.x()));
    const Tile::Piece piece = tile->row_piece(TileGrid::within_tile(state_->grid.cell_of(point.y())), column, column);
    std::uint32_t j = piece.begin;
    while (j < piece.end && tile->numbers()[j] != static_cast<int>(number)) ++j;
    if (j < piece.end) line = (*lines)[j];
  } else {
    line = state_->fit_line(static_cast<int>(number));
  }
  if (!line.valid()) return {};
  const Vector<2> normal = Vector<2>(line.normal_x, line.normal_y).normalized();
  return {point + static_cast<double>(line.offset) * normal, normal, static_cast<double>(line.trust)};
}

Neighbour CellIndex::nearest(const Point2& query, double reach) const noexcept {
  if (!is_finite<2>(query)) return {};
  const State& state = *state_;
  const int column = state.grid.cell_of(query.x());
  const int row = state.grid.cell_of(query.y());
  const Tile* tile = state.tiles.find({TileGrid::tile_of(column), TileGrid::tile_of(row)});
  const CellTable* table = tile ? tile->table() : &empty_table();
  if (table == nullptr) return state.search().nearest(query, reach);

  const std::uint32_t word = table->cells[TileGrid::within_tile(row) * tile_cells + TileGrid::within_tile(column)];
  const std::uint32_t count = CellTable::count_of(word);
  if (count == CellTable::no_answer) return state.search().nearest(query, reach);
  const double listed = std::min(reach, state.cells.reach);
  NearestVisitor visitor{listed * listed};
  const std::uint32_t first = CellTable::first_of(word);
  for (std::uint32_t j = first; j < first + count; ++j) {
    const int number = table->line(j).number;
    visitor.see(number, (points()[static_cast<std::size_t>(number)] - query).squaredNorm());
  }
  if (visitor.best.found() || reach <= state.cells.reach) return visitor.best;
  return state.search().nearest(query, reach);
}

NearestTwo CellIndex::nearest_two(const Point2& query, double reach) const noexcept {
  NearestTwoVisitor visitor{reach * reach};
  state_->search().visit(query, visitor);
  return {visitor.best, visitor.bound()};
}

std::size_t CellIndex::nearest_k(const Point2& query, double reach, std::span<Neighbour> found) const noexcept {
  return state_->nearest_k(query, reach, found);
}

void CellIndex::within(const Point2& query, double radius, std::vector<int>& indices) const {
  WithinVisitor visitor{radius * radius, indices};
  state_->search().visit(query, visitor);
}

void CellIndex::tables(int x, int y, int width, std::span<const CellTable*> tables) const noexcept {
  std::fill(tables.begin(), tables.end(), &empty_table());
  state_->tiles.for_each_in({x, y}, {x + width - 1, y + width - 1}, [&](const Tile& tile) {
    const CellTable* table = tile.table();
    tables[static_cast<std::size_t>((tile.place().y - y) * width + tile.place().x - x)] =
        table ? table : &unbuilt_table();
  });
}

namespace {

/// A table without points whose cells all say the same.
struct PlainTable {
  CellLine lines[CellTable::spare]{};
  CellTable table{};
  CellPlace places[CellTable::spare];

  explicit PlainTable(std::uint32_t word) noexcept {
    std::fill(std::begin(table.cells), std::end(table.cells), word);
    std::fill(std::begin(places), std::end(places), CellPlace{32767, 32767});
  }
};

}  // namespace

const CellTable& CellIndex::empty_table() noexcept {
  static const PlainTable plain(CellTable::word(0, 0, CellTable::farthest, CellTable::farthest));
  return plain.table;
}

const CellTable& CellIndex::unbuilt_table() noexcept {
  static const PlainTable plain(CellTable::word(CellTable::no_answer, 0, CellTable::farthest, 0));
  return plain.table;
}

}  // namespace slamicp
