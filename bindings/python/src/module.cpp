// SPDX-License-Identifier: Apache-2.0
#include "module.hpp"

#include <slamicp/version.hpp>

NB_MODULE(_core, m) {
  using namespace slamicp::python;
  m.doc() = "slamicp's C++ library; import slamicp, which names all of it";
  m.attr("__version__") = slamicp::version;
  bind_errors(m);
  bind_map(m);
  bind_scan(m);
  bind_icp(m);
  bind_localizer(m);
  bind_obstacles(m);
  bind_mapper(m);
  bind_files(m);
  bind_simulation(m);
}
