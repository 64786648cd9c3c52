// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "search/tile.hpp"

namespace slamicp {

/// Tiles by place, for a plane of any size of which little is used. A copy shares everything; setting a tile in it
/// copies the two nodes of 16 x 16 children above that tile, where an older edit made them, and no more.
class TileDirectory {
 public:
  const Tile* find(TilePlace at) const noexcept {
    for (const Root& root : roots_) {
      if (root.x != (at.x >> 8) || root.y != (at.y >> 8)) continue;
      const auto& node = root.node->children[child(at.x >> 4, at.y >> 4)];
      return node ? node->children[child(at.x, at.y)].get() : nullptr;
    }
    return nullptr;
  }

  /// @param edit  a number that no other directory's edit has: what it made itself is changed in place
  void set(TilePlace at, std::shared_ptr<const Tile> tile, std::uint64_t edit) {
    auto& inner = own(root_for(at).node, edit)->children[child(at.x >> 4, at.y >> 4)];
    auto& slot = own(inner, edit)->children[child(at.x, at.y)];
    if (!slot) ++size_;
    slot = std::move(tile);
  }

  /// How many tiles.
  std::size_t size() const noexcept { return size_; }

  /// Calls use(tile) for the tiles between the two places, both included.
  template <typename Use>
  void for_each_in(TilePlace lower, TilePlace upper, const Use& use) const {
    for (const Root& root : roots_)
      for_each_child(*root.node, root.x, root.y, 8, lower, upper, [&](const auto& node, int x, int y) {
        for_each_child(*node, x, y, 4, lower, upper, [&](const auto& tile, int, int) { use(*tile); });
      });
  }
  template <typename Use>
  void for_each(const Use& use) const {
    constexpr int most = std::numeric_limits<int>::max();
    for_each_in({-most, -most}, {most, most}, use);
  }

  std::size_t memory() const noexcept;

 private:
  template <typename Child>
  struct Node {
    std::array<std::shared_ptr<Child>, 256> children;
    std::uint64_t edit = 0;  // that made it
  };
  using Inner = Node<const Tile>;
  using Outer = Node<Inner>;
  struct Root {
    int x, y;
    std::shared_ptr<Outer> node;
  };

  static std::size_t child(int x, int y) noexcept { return static_cast<std::size_t>((y & 15) * 16 + (x & 15)); }

  /// The node, for writing: nobody else sees it.
  template <typename Some>
  static Some* own(std::shared_ptr<Some>& node, std::uint64_t edit) {
    if (node && node->edit == edit) return node.get();
    node = node ? std::make_shared<Some>(*node) : std::make_shared<Some>();
    node->edit = edit;
    return node.get();
  }

  Root& root_for(TilePlace at) {
    const int x = at.x >> 8;
    const int y = at.y >> 8;
    const auto found = std::find_if(roots_.begin(), roots_.end(), [&](const Root& r) { return r.x == x && r.y == y; });
    if (found != roots_.end()) return *found;
    return roots_.emplace_back(Root{x, y, nullptr});
  }

  /// @param levels  bits of a place that lie below the children's parent: 8 or 4
  template <typename Child, typename Use>
  static void for_each_child(const Node<Child>& node, int parent_x, int parent_y, int levels, TilePlace lower,
                             TilePlace upper, const Use& use) {
    const int below = levels - 4;
    // 64 bits: a parent's first child can lie outside what int holds, beside clamped limits.
    const auto range = [&](int parent, int from, int to) {
      const std::int64_t first = std::int64_t{parent} * 16;
      return std::pair(std::max<std::int64_t>(first, from >> below) - first,
                       std::min<std::int64_t>(first + 15, to >> below) - first);
    };
    const auto [x0, x1] = range(parent_x, lower.x, upper.x);
    const auto [y0, y1] = range(parent_y, lower.y, upper.y);
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x)
        if (const auto& one = node.children[static_cast<std::size_t>(y * 16 + x)])
          use(one, static_cast<int>(parent_x * 16 + x), static_cast<int>(parent_y * 16 + y));
  }

  std::vector<Root> roots_;
  std::size_t size_ = 0;
};

inline std::size_t TileDirectory::memory() const noexcept {
  std::size_t bytes = roots_.capacity() * sizeof(Root);
  for (const Root& root : roots_) {
    bytes += sizeof(Outer);
    for (const auto& node : root.node->children) bytes += node ? sizeof(Inner) : 0;
  }
  return bytes;
}

}  // namespace slamicp
