// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <slamicp/error.hpp>

namespace slamicp {
namespace {

std::string compose(const std::string& what, const std::string& where, const std::string& mend) {
  std::string message;
  if (!where.empty()) message += where + ": ";
  message += what;
  if (!mend.empty()) message += "; " + mend;
  return message;
}

}  // namespace

Error::Error(std::string what, std::string where, std::string mend)
    : std::runtime_error(compose(what, where, mend)),
      problem_(std::move(what)),
      where_(std::move(where)),
      mend_(std::move(mend)) {}

}  // namespace slamicp
