// SPDX-License-Identifier: Apache-2.0
#include <slamicp/io/relations_file.hpp>

#include "io/number_table.hpp"

namespace slamicp {

std::vector<Relation> parse_relations(std::string_view text, const std::string& name) {
  std::vector<Relation> relations;
  read_number_table<8>(text, name, "t1 t2 x y z roll pitch yaw",
                       [&](const std::array<double, 8>& line, const text::Lines&) {
                         relations.push_back({line[0], line[1], {line[2], line[3], wrap_angle(line[7])}});
                       });
  return relations;
}

std::vector<Relation> load_relations(const std::filesystem::path& path) {
  return parse_relations(text::read_file(path), text::name_of(path));
}

}  // namespace slamicp
