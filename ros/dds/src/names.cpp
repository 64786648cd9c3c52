// SPDX-License-Identifier: Apache-2.0
#include "names.hpp"

namespace slamicp::node {

std::string Names::absolute(const std::string& name) const {
  if (!name.empty() && name.front() == '/') return name;
  if (name.rfind("~/", 0) == 0) return whole() + name.substr(1);
  return (space.back() == '/' ? space : space + '/') + name;
}

std::string Names::topic(const std::string& name) const {
  std::string wanted = absolute(name);
  for (const auto& [from, to] : remapped)
    if (absolute(from) == wanted) return absolute(to);
  return wanted;
}

}  // namespace slamicp::node
