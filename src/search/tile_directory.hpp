// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "search/tile.hpp"

namespace slamicp {

/// Tiles by place, for a plane of any size of which little is used. A copy shares everything; setting a tile in it
/// copies the three nodes of 8 x 8 children above that tile, where an older edit made them, and no more.
class TileDirectory {
 public:
  const Tile* find(TilePlace at) const noexcept {
    for (const Root& root : roots_) {
      if (root.x != (at.x >> root_bits) || root.y != (at.y >> root_bits)) continue;
      const auto& middle = root.node->children[child(at, 2 * node_bits)];
      if (!middle) return nullptr;
      const auto& inner = middle->children[child(at, node_bits)];
      return inner ? inner->children[child(at, 0)].get() : nullptr;
    }
    return nullptr;
  }

  /// @param edit  a number that no other directory's edit has: what it made itself is changed in place
  void set(TilePlace at, std::shared_ptr<const Tile> tile, std::uint64_t edit) {
    auto& middle = own(root_for(at).node, edit)->children[child(at, 2 * node_bits)];
    auto& inner = own(middle, edit)->children[child(at, node_bits)];
    auto& slot = own(inner, edit)->children[child(at, 0)];
    if (!slot) ++size_;
    slot = std::move(tile);
  }

  /// How many tiles.
  std::size_t size() const noexcept { return size_; }

  /// Calls use(tile) for the tiles between the two places, both included.
  template <typename Use>
  void for_each_in(TilePlace lower, TilePlace upper, const Use& use) const {
    for (const Root& root : roots_) for_each_child(*root.node, root.x, root.y, 2 * node_bits, lower, upper, use);
  }
  template <typename Use>
  void for_each(const Use& use) const {
    constexpr int most = std::numeric_limits<int>::max();
    for_each_in({-most, -most}, {most, most}, use);
  }

  std::size_t memory() const noexcept {
    std::size_t bytes = roots_.capacity() * sizeof(Root);
    for (const Root& root : roots_) {
      bytes += sizeof(Outer);
      for (const auto& middle : root.node->children) {
        if (!middle) continue;
        bytes += sizeof(Middle);
        for (const auto& inner : middle->children) bytes += inner ? sizeof(Inner) : 0;
      }
    }
    return bytes;
  }

 private:
  static constexpr int node_bits = 3;  // 8 x 8 children
  static constexpr int root_bits = 3 * node_bits;
  static constexpr int side = 1 << node_bits;

  template <typename Child>
  struct Node {
    std::array<std::shared_ptr<Child>, std::size_t{side} * side> children;
    std::uint64_t edit = 0;  // that made it
  };
  using Inner = Node<const Tile>;
  using Middle = Node<Inner>;
  using Outer = Node<Middle>;
  struct Root {
    int x, y;
    std::shared_ptr<Outer> node;
  };

  /// Which child leads to a place; `below` bits of it are decided further down.
  static std::size_t child(TilePlace at, int below) noexcept {
    const auto row = static_cast<std::size_t>((at.y >> below) & (side - 1));
    return row * side + static_cast<std::size_t>((at.x >> below) & (side - 1));
  }

  /// The node, for writing: nobody else sees it.
  template <typename Some>
  static Some* own(std::shared_ptr<Some>& node, std::uint64_t edit) {
    if (node && node->edit == edit) return node.get();
    node = node ? std::make_shared<Some>(*node) : std::make_shared<Some>();
    node->edit = edit;
    return node.get();
  }

  Root& root_for(TilePlace at) {
    const int x = at.x >> root_bits;
    const int y = at.y >> root_bits;
    const auto found = std::find_if(roots_.begin(), roots_.end(), [&](const Root& r) { return r.x == x && r.y == y; });
    if (found != roots_.end()) return *found;
    return roots_.emplace_back(Root{x, y, nullptr});
  }

  template <typename Use>
  static void for_each_child(const Tile& tile, int, int, int, TilePlace, TilePlace, const Use& use) {
    use(tile);
  }
  template <typename Child, typename Use>
  static void for_each_child(const Node<Child>& node, int node_x, int node_y, int below, TilePlace lower,
                             TilePlace upper, const Use& use) {
    // 64 bits: a node's first child can lie outside what int holds, beside clamped limits.
    const auto range = [&](int of_node, int from, int to) {
      const std::int64_t first = std::int64_t{of_node} * side;
      return std::pair(std::max<std::int64_t>(first, from >> below) - first,
                       std::min<std::int64_t>(first + side - 1, to >> below) - first);
    };
    const auto [x0, x1] = range(node_x, lower.x, upper.x);
    const auto [y0, y1] = range(node_y, lower.y, upper.y);
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x)
        if (const auto& one = node.children[static_cast<std::size_t>(y * side + x)])
          for_each_child(*one, static_cast<int>(std::int64_t{node_x} * side + x),
                         static_cast<int>(std::int64_t{node_y} * side + y), below - node_bits, lower, upper, use);
  }

  std::vector<Root> roots_;
  std::size_t size_ = 0;
};

}  // namespace slamicp
