// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <slamicp/error.hpp>
#include <slamicp/search/cell_index.hpp>

#include "search/cell_state.hpp"

namespace slamicp {

/// Makes the next version of an index: new tiles where something changed, all others shared.
class CellIndexEdit {
 public:
  CellIndexEdit(const CellIndex& before, PointBuffer points);

  void add(std::size_t first);
  void remove(std::span<const int> which);
  CellIndex finish();

 private:
  using State = CellIndex::State;

  /// What becomes of a tile.
  struct Change {
    const Tile* old = nullptr;  // null where nothing was within reach
    std::shared_ptr<Tile> tile;
    std::vector<CellPoint> added;
    std::vector<CellPoint> changed;
    std::vector<int> residents;
    bool is_rebuilt = false;
  };

  Change& change(TilePlace place);
  template <typename Use>
  void for_each_within_reach(const Point2& point, const Use& use);
  void find_touched(std::span<const int> moved);
  void make_tiles();
  void fit_lines();
  /// A point's line, if it was fitted anew; else null.
  const Line* fitted(int number) const noexcept;
  CellPoint as_seen(const Change& from, int number, const Line& line) const noexcept;
  void publish_lines(const Change& change) const;
  void make_table(Change& change);
  Point2 point(int number) const noexcept { return next_->points.view()[static_cast<std::size_t>(number)]; }

  const State& before_;
  std::shared_ptr<State> next_;
  CellBuilder builder_;
  std::vector<CellPoint> room_;
  std::map<TilePlace, Change> changes_;
  std::vector<int> added_;
  std::vector<int> touched_;                 // points that were there, whose lines are other ones now
  std::vector<std::pair<int, Line>> lines_;  // of added and touched points, numbers rising
};

CellIndexEdit::CellIndexEdit(const CellIndex& before, PointBuffer points)
    : before_(*before.state_), builder_(before_.grid, before_.cells.reach) {
  next_ = std::make_shared<State>(before_.surfaces, before_.cells);
  // What is added may be noisier than what was there, and is all there is where it stands: its lines are trusted.
  next_->surfaces.scatter = std::numeric_limits<double>::infinity();
  next_->points = std::move(points);
  next_->tiles = before_.tiles;
  next_->progress = before_.progress;
  next_->spacing = before_.spacing;
  next_->line_noise = before_.line_noise;
  next_->spacing_of = before_.spacing_of;
  next_->id = next_index_id();
}

CellIndexEdit::Change& CellIndexEdit::change(TilePlace place) {
  const auto [found, is_new] = changes_.try_emplace(place);
  if (is_new) {
    found->second.old = before_.tiles.find(place);
    if (found->second.old) found->second.residents = found->second.old->numbers();
  }
  return found->second;
}

template <typename Use>
void CellIndexEdit::for_each_within_reach(const Point2& point, const Use& use) {
  before_.for_each_place_within_reach({point, point}, [&](TilePlace at) { use(change(at)); });
}

void CellIndexEdit::add(std::size_t first) {
  for (std::size_t k = first; k < next_->points.size(); ++k) {
    const int number = static_cast<int>(k);
    if (!can_be_found(point(number))) continue;
    added_.push_back(number);
    change(before_.grid.place_of(point(number))).residents.push_back(number);
  }
  find_touched(added_);
  make_tiles();
  fit_lines();
  for (const int number : added_) {
    const Line* line = fitted(number);
    for_each_within_reach(point(number),
                          [&](Change& at) { at.added.push_back(as_seen(at, number, line ? *line : Line{})); });
  }
}

void CellIndexEdit::remove(std::span<const int> which) {
  std::vector<int> gone;
  for (const int number : which)
    if (can_be_found(before_.points.view()[static_cast<std::size_t>(number)])) gone.push_back(number);
  for (const int number : gone) {
    const Point2& was = before_.points.view()[static_cast<std::size_t>(number)];
    std::erase(change(before_.grid.place_of(was)).residents, number);
    for_each_within_reach(was, [](Change& at) { at.is_rebuilt = true; });
  }
  find_touched(gone);
  make_tiles();
  fit_lines();
}

/// The points that stay whose lines took one of the `moved` points in, or would.
void CellIndexEdit::find_touched(std::span<const int> moved) {
  if (before_.surfaces.neighbours == 0) return;
  const auto place = [&](int number) {
    return static_cast<std::size_t>(number) < before_.points.size()
               ? before_.points.view()[static_cast<std::size_t>(number)]
               : point(number);
  };
  std::map<TilePlace, std::vector<int>> by_tile;
  for (const int number : moved) by_tile[before_.grid.place_of(place(number))].push_back(number);
  for (const auto& entry : by_tile) {
    const std::vector<int>& some = entry.second;
    Bounds<2> bounds;
    for (const int number : some) bounds.include(place(number));
    const Point2 radius = Point2::Constant(before_.surfaces.radius);
    before_.tiles.for_each_in(
        before_.grid.place_of(bounds.lower - radius), before_.grid.place_of(bounds.upper + radius),
        [&](const Tile& tile) {
          const std::vector<Line>* lines = before_.lines_of(tile);  // another thread may be building them
          for (std::size_t j = 0; j < lines->size(); ++j) {
            const Point2& resident = place(tile.numbers()[j]);
            const double window = std::min(static_cast<double>((*lines)[j].window), before_.surfaces.radius);
            const Point2 off = (bounds.lower - resident).cwiseMax(resident - bounds.upper).cwiseMax(0.0);
            if (off.squaredNorm() > window * window) continue;
            const auto is_near = [&](int number) { return (place(number) - resident).norm() <= window; };
            if (std::any_of(some.begin(), some.end(), is_near)) touched_.push_back(tile.numbers()[j]);
          }
        });
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  std::erase_if(touched_, [&](int number) { return !can_be_found(point(number)); });
}

void CellIndexEdit::make_tiles() {
  for (const int number : added_) for_each_within_reach(point(number), [](Change&) {});
  for (const int number : touched_) for_each_within_reach(point(number), [](Change&) {});
  for (auto& [place, at] : changes_) {
    at.tile = std::make_shared<Tile>(place, std::move(at.residents), next_->points.view(), next_->grid);
    next_->tiles.set(place, at.tile, next_->id);
  }
}

void CellIndexEdit::fit_lines() {
  if (before_.surfaces.neighbours == 0) return;
  lines_.reserve(added_.size() + touched_.size());
  for (const std::vector<int>* some : {&touched_, &added_})  // added numbers are the highest
    for (const int number : *some) lines_.emplace_back(number, next_->fit_line(number));
  for (const auto& [number, line] : std::span(lines_).first(touched_.size()))
    for_each_within_reach(point(number), [&, number = number, line = line](Change& at) {
      at.changed.push_back(as_seen(at, number, line));
    });
  for (const auto& [place, at] : changes_) publish_lines(at);
}

const Line* CellIndexEdit::fitted(int number) const noexcept {
  const auto found = std::lower_bound(lines_.begin(), lines_.end(), number,
                                      [](const auto& one, int wanted) { return one.first < wanted; });
  return found != lines_.end() && found->first == number ? &found->second : nullptr;
}

CellPoint CellIndexEdit::as_seen(const Change& from, int number, const Line& line) const noexcept {
  return cell_point(point(number) - before_.grid.corner(from.tile->place()), number, line);
}

void CellIndexEdit::publish_lines(const Change& change) const {
  const std::vector<Line>* old = change.old ? change.old->lines() : nullptr;
  if (change.old && !old) return;  // not built yet; nor is it now
  auto lines = std::make_unique<std::vector<Line>>();
  lines->reserve(change.tile->numbers().size());
  std::size_t j = 0;  // both tiles have their points in the same order
  for (const int number : change.tile->numbers()) {
    if (const Line* line = fitted(number)) {
      lines->push_back(*line);
      continue;
    }
    while (change.old->numbers()[j] != number) ++j;
    lines->push_back((*old)[j]);
  }
  change.tile->publish(std::move(lines));
}

void CellIndexEdit::make_table(Change& change) {
  const CellTable* old = change.old ? change.old->table() : &CellIndex::empty_table();
  if (old == nullptr) return;        // not built yet; nor is it now
  constexpr std::size_t many = 256;  // added points, where lists would grow long
  CellTablePointer table;
  if (!change.is_rebuilt && change.added.size() <= many)
    table = builder_.grow(*old, next_->grid.corner(change.tile->place()), next_->points.view(), change.added,
                          change.changed);
  if (table)
    change.tile->publish(std::move(table));
  else
    next_->build_table(*change.tile, builder_, room_);
}

CellIndex CellIndexEdit::finish() {
  for (auto& [place, at] : changes_) make_table(at);
  if (next_->points.size() > next_->spacing_of + next_->spacing_of / 8) next_->measure_spacing();
  return CellIndex(std::shared_ptr<const State>(std::move(next_)));
}

CellIndex CellIndex::with_added(PointView<2> added) const {
  if (added.empty()) return *this;
  if (added.size() > size()) {
    PointCloud2 all(points().begin(), points().end());
    all.insert(all.end(), added.begin(), added.end());
    return {std::move(all), state_->surfaces, state_->cells};
  }
  if (added.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) - size())
    throw Error("more points than can be numbered", "CellIndex::with_added", "thin the map: 2^31 - 1 is the limit");
  CellIndexEdit edit(*this, state_->points.with_added(added));
  edit.add(size());
  return edit.finish();
}

CellIndex CellIndex::with_removed(std::span<const int> which) const {
  for (const int number : which)
    if (number < 0 || static_cast<std::size_t>(number) >= size())
      throw Error("there is no point " + std::to_string(number) + " to remove", "CellIndex::with_removed",
                  "numbers go from 0 to " + std::to_string(size() - std::min<std::size_t>(size(), 1)));
  if (which.empty()) return *this;
  CellIndexEdit edit(*this, state_->points.without(which));
  edit.remove(which);
  return edit.finish();
}

}  // namespace slamicp
