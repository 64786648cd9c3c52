// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace slamicp {

/// Wrong use or broken input at an edge: an option, a file, a map.
///
/// The message says what is wrong, where (a file and line, an option's name), and how to mend it.
/// What may happen on a good day (no overlap, a degenerate corridor, NaN ranges) is never an Error:
/// it is a value in the result.
class Error : public std::runtime_error {
 public:
  /// @param what   what is wrong, e.g. "range 17 is not a number: 'abc'"
  /// @param where  where, e.g. "run.clf:203" or "IcpOptions"; may be empty
  /// @param mend   how to mend it, e.g. "give metres, or 0 for no return"; may be empty
  explicit Error(std::string what, std::string where = {}, std::string mend = {});

  const std::string& problem() const noexcept { return problem_; }
  const std::string& where() const noexcept { return where_; }
  const std::string& mend() const noexcept { return mend_; }

 private:
  std::string problem_;
  std::string where_;
  std::string mend_;
};

}  // namespace slamicp
