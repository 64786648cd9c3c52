// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <slamicp.h>
#include <stdexcept>
#include <string>

namespace slamicp::c {

/// What a call refuses, inside the library; guarded() turns it into a status.
class Refusal : public std::runtime_error {
 public:
  Refusal(slamicp_status status, const std::string& why) : std::runtime_error(why), status_(status) {}

  slamicp_status status() const noexcept { return status_; }

 private:
  slamicp_status status_;
};

/// Keeps the words for slamicp_last_error(), and hands the status on.
slamicp_status remember(slamicp_status status, const char* words) noexcept;

/// The status of the exception that is being handled, its words remembered.
/// @param of_library  what an Error of the library stands for here
slamicp_status remember_exception(slamicp_status of_library) noexcept;

/// Nothing that is thrown gets past this.
template <class Work>
slamicp_status guarded(slamicp_status of_library, Work&& work) noexcept {
  try {
    work();
    return SLAMICP_OK;
  } catch (...) {
    return remember_exception(of_library);
  }
}

template <class T>
void need(const T* argument, const char* name) {
  if (argument == nullptr) throw Refusal(SLAMICP_NULL_POINTER, std::string(name) + " is NULL");
}

}  // namespace slamicp::c
