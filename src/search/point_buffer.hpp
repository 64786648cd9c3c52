// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>

#include <slamicp/geometry/point_cloud.hpp>

namespace slamicp {

/// Points that only grow at their end. Versions share one piece of memory: each sees its own length, and the
/// first to append to a version goes on in place, behind what others see. Only when the room is used up, or for a
/// second branch from the same version, are the points copied.
class PointBuffer {
 public:
  PointBuffer() = default;
  explicit PointBuffer(PointCloud2 points) : size_(points.size()), room_(std::make_shared<Room>(std::move(points))) {}

  std::size_t size() const noexcept { return size_; }
  PointView<2> view() const noexcept { return room_ ? PointView<2>(room_->points.data(), size_) : PointView<2>(); }

  /// Room for points to come included.
  std::size_t memory() const noexcept { return room_ ? room_->points.capacity() * sizeof(Point2) : 0; }

  PointBuffer with_added(PointView<2> added) const {
    PointBuffer grown = *this;
    grown.size_ += added.size();
    std::size_t expected = size_;
    const bool fits = room_ && grown.size_ <= room_->points.size() &&
                      room_->used.compare_exchange_strong(expected, grown.size_, std::memory_order_relaxed);
    if (!fits) grown.room_ = std::make_shared<Room>(view(), grown.size_);
    std::copy(added.begin(), added.end(), grown.room_->points.begin() + static_cast<std::ptrdiff_t>(size_));
    return grown;
  }

  /// The same points, but for some that become no number.
  PointBuffer without(std::span<const int> which) const {
    PointBuffer left = *this;
    left.room_ = std::make_shared<Room>(view(), size_);
    for (const int k : which)
      left.room_->points[static_cast<std::size_t>(k)].setConstant(std::numeric_limits<double>::quiet_NaN());
    return left;
  }

 private:
  struct Room {
    explicit Room(PointCloud2 all) : points(std::move(all)), used(points.size()) { make_room(points.size()); }
    Room(PointView<2> all, std::size_t needed) : used(needed) {
      points.reserve(room_for(needed));
      points.assign(all.begin(), all.end());
      make_room(needed);
    }
    static std::size_t room_for(std::size_t needed) { return needed + needed / 8 + 1024; }
    void make_room(std::size_t needed) {
      points.reserve(room_for(needed));
      points.resize(points.capacity());
    }
    PointCloud2 points;
    std::atomic<std::size_t> used;
  };

  std::size_t size_ = 0;
  std::shared_ptr<Room> room_;
};

}  // namespace slamicp
