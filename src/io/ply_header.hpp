// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/binary.hpp"

/// PLY, the Stanford polygon format: a header that names elements (vertex, face, ...) and their properties, then the
/// elements one after the other.
namespace slamicp::ply {

struct Property {
  binary::Kind kind;
  bool is_list = false;
  binary::Kind length_kind;  ///< of a list's length
  int axis = -1;             ///< 0, 1, 2 for a vertex's x, y, z
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  bool is_vertex() const noexcept { return name == "vertex"; }
};

struct Header {
  std::string format;  ///< "ascii", "binary_little_endian", "binary_big_endian"
  std::vector<Element> elements;
  bool has_z = false;
  std::size_t data_offset = 0;
  std::size_t lines = 0;
};

/// Throws Error with file and line.
Header read_header(std::string_view bytes, const std::string& name);

}  // namespace slamicp::ply
