// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <slamicp/registration/icp_options.hpp>

namespace slamicp::python {

/// Options by name. Throw Refusal with the names there are.
Method method_named(const std::string& name);
RobustKernel kernel_named(const std::string& name);

}  // namespace slamicp::python
