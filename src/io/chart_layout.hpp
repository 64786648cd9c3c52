// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp/io/chart.hpp>

#include "io/drawing.hpp"

namespace slamicp::drawing {

Drawing lay_out(const Chart& chart);

}  // namespace slamicp::drawing
