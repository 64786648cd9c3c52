// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

/// Each binds what its file has; classes before those that name them.
namespace slamicp::python {

void bind_errors(nanobind::module_& m);
void bind_map(nanobind::module_& m);
void bind_scan(nanobind::module_& m);
void bind_icp(nanobind::module_& m);
void bind_localizer(nanobind::module_& m);
void bind_obstacles(nanobind::module_& m);
void bind_mapper(nanobind::module_& m);
void bind_files(nanobind::module_& m);
void bind_simulation(nanobind::module_& m);

}  // namespace slamicp::python
