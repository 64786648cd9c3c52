// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

// Counts what is allocated. It replaces the program's operator new: for one source of a test program only.

namespace slamicp::test {

inline std::atomic<bool> counting{false};
inline std::atomic<int> allocations{0};

inline void* try_to_allocate(std::size_t size) noexcept {
  if (counting) ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}

inline void* allocate(std::size_t size) {
  if (void* memory = try_to_allocate(size)) return memory;
  throw std::bad_alloc();
}

/// How often `work` allocates.
template <typename Work>
int allocations_of(const Work& work) {
  allocations = 0;
  counting = true;
  work();
  counting = false;
  return allocations;
}

}  // namespace slamicp::test

// GCC, where it inlines one of a pair and not the other, takes them for strangers.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

// Eigen, too, comes here: what it allocates it takes from malloc only where alignment demands it, and no fixed-size
// matrix does.
void* operator new(std::size_t size) { return slamicp::test::allocate(size); }
void* operator new[](std::size_t size) { return slamicp::test::allocate(size); }
// std::stable_sort asks by these; a sanitizer's would not know our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return slamicp::test::try_to_allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return slamicp::test::try_to_allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
