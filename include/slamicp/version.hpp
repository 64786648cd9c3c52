// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The library's version; the build reads it from these three lines. While MAJOR is 0, a new MINOR may change
/// the interface, a new PATCH does not.
#define SLAMICP_VERSION_MAJOR 0
#define SLAMICP_VERSION_MINOR 1
#define SLAMICP_VERSION_PATCH 0

#define SLAMICP_VERSION_TEXT_OF(major, minor, patch) #major "." #minor "." #patch
#define SLAMICP_VERSION_TEXT(major, minor, patch) SLAMICP_VERSION_TEXT_OF(major, minor, patch)

namespace slamicp {

/// "major.minor.patch"
inline constexpr const char* version =
    SLAMICP_VERSION_TEXT(SLAMICP_VERSION_MAJOR, SLAMICP_VERSION_MINOR, SLAMICP_VERSION_PATCH);

}  // namespace slamicp
