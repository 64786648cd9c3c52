// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slamicp::command {

/// The command line in UTF-8, on Windows too, where main() gets it in whatever code page the machine has, with letters
/// lost. What the program prints is taken for UTF-8 from then on.
class Arguments {
 public:
  Arguments(int argc, char** argv);

  int count() const noexcept { return static_cast<int>(words_.size()) - 1; }
  /// As many as count(), and a null pointer; good as long as this is.
  char** words() noexcept { return words_.data(); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> words_;
};

}  // namespace slamicp::command
