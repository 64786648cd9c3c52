// SPDX-License-Identifier: Apache-2.0
// The passes over a scan, once for every instruction set that includes this. No function here has a name that another
// file could link to: what is compiled for a newer machine must not be run on an older one.
//
// A pass goes through the scan in blocks that stay in the first cache. In a block all points are placed in the map,
// several at a time; then each finds its nearest candidate, several candidates at a time; then all pairs are summed,
// several at a time.
#pragma once

#include "registration/pass/columns-inl.hpp"
#include "registration/pass/line_pass-inl.hpp"
#include "registration/pass/match_pass-inl.hpp"
#include "registration/pass/outlier_pass-inl.hpp"
#include "registration/pass/point_pass-inl.hpp"

namespace slamicp::pass {
namespace HWY_NAMESPACE {
namespace {

constexpr Passes all_passes{to_columns, line_pass, point_pass, outlier_pass, match_pass};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace slamicp::pass
