// SPDX-License-Identifier: Apache-2.0
#include "refusal.hpp"

#include <cstdio>
#include <new>

#include <slamicp/error.hpp>
#include <slamicp/localization/quality.hpp>
#include <slamicp/obstacles/ray_class.hpp>
#include <slamicp/obstacles/shape.hpp>
#include <slamicp/registration/icp_result.hpp>
#include <slamicp/version.hpp>

namespace slamicp::c {
namespace {

// A place of its own for each thread: telling of too little memory must not need any.
thread_local char last_words[512] = "";

}  // namespace

slamicp_status remember(slamicp_status status, const char* words) noexcept {
  std::snprintf(last_words, sizeof last_words, "%s", words);
  return status;
}

slamicp_status remember_exception(slamicp_status of_library) noexcept {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return remember(refusal.status(), refusal.what());
  } catch (const Error& error) {
    return remember(of_library, error.what());
  } catch (const std::bad_alloc&) {
    return remember(SLAMICP_OUT_OF_MEMORY, "there is not enough memory; give fewer points");
  } catch (const std::length_error&) {
    return remember(SLAMICP_OUT_OF_MEMORY, "there is not enough memory; give fewer points");
  } catch (const std::exception& error) {
    return remember(SLAMICP_INTERNAL, error.what());
  } catch (...) {
    return remember(SLAMICP_INTERNAL, "something unknown was thrown");
  }
}

}  // namespace slamicp::c

const char* slamicp_last_error(void) { return slamicp::c::last_words; }

const char* slamicp_version(void) { return slamicp::version; }

const char* slamicp_stop_name(int32_t stop) {
  if (stop < SLAMICP_CONVERGED || stop > SLAMICP_NO_OVERLAP) return "unknown";
  return slamicp::to_string(static_cast<slamicp::Stop>(stop));
}

const char* slamicp_state_name(int32_t state) {
  if (state < SLAMICP_TRACKING || state > SLAMICP_LOST) return "unknown";
  return slamicp::to_string(static_cast<slamicp::TrackingState>(state));
}

const char* slamicp_ray_class_name(int32_t ray_class) {
  if (ray_class < SLAMICP_RAY_OBSTACLE || ray_class > SLAMICP_RAY_UNKNOWN) return "unknown";
  return slamicp::to_string(static_cast<slamicp::RayClass>(ray_class));
}

const char* slamicp_shape_name(int32_t shape) {
  if (shape < SLAMICP_SHAPE_UNKNOWN || shape > SLAMICP_SHAPE_BOX) return "unknown";
  return slamicp::to_string(static_cast<slamicp::ShapeKind>(shape));
}
