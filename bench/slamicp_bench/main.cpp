// SPDX-License-Identifier: Apache-2.0
// slamicp-bench: this library, the paper's agents and other libraries on the same scans, in one process, in turns.
#include <iostream>
#include <stdexcept>

#include "commands.hpp"

namespace {

enum ExitStatus { done = 0, could_not_do_it = 1, wrong_words = 2 };

int run(int argc, char** argv) {
  CLI::App program{"slamicp-bench: how exactly and how fast slamicp and its peers localize the same scans",
                   "slamicp-bench"};
  program.get_formatter()->column_width(36);
  slamicp::bench::add_localization(program);
  slamicp::bench::add_sweep(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error, std::cout, std::cerr) == 0 ? done : wrong_words;
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::invalid_argument& error) {
    std::cerr << "slamicp-bench: " << error.what() << '\n';
    return wrong_words;
  } catch (const std::exception& error) {
    std::cerr << "slamicp-bench: " << error.what() << '\n';
  }
  return could_not_do_it;
}
