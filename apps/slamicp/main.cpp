// SPDX-License-Identifier: Apache-2.0
// slamicp: one program, one verb each.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include <slamicp/error.hpp>
#include <slamicp/io/output_file.hpp>
#include <slamicp/version.hpp>

#include "arguments.hpp"
#include "verbs.hpp"

namespace {

enum ExitStatus { done = 0, could_not_do_it = 1, wrong_words = 2 };

extern "C" void leave_nothing_half_written(int signal) {
  slamicp::remove_unfinished_outputs();
  std::_Exit(128 + signal);
}

/// `slamicp help VERB` is `slamicp VERB --help`.
void add_help(CLI::App& program) {
  CLI::App* help = program.add_subcommand("help", "print every option of a verb, with unit, default and an example");
  help->add_option("VERB", "which verb; without it, the list of verbs");
  help->allow_extras(false);
  help->callback([&program, help] {
    const auto words = help->get_option("VERB")->results();
    if (words.empty()) {
      std::cout << program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
      return;
    }
    const auto named = [&](const CLI::App* verb) { return verb->get_name() == words.front(); };
    for (const CLI::App* verb : std::as_const(program).get_subcommands(named)) {
      std::cout << verb->help("slamicp");
      return;
    }
    throw CLI::ValidationError("VERB", "there is no verb '" + words.front() + "'; slamicp --help lists them");
  });
}

int run(int argc, char** argv) {
  CLI::App program{"slamicp: localize a 2D lidar in its map, and get what the map does not know", "slamicp"};
  program.set_version_flag("--version", std::string("slamicp ") + slamicp::version);
  program.require_subcommand(1);
  program.get_formatter()->column_width(42);
  slamicp::command::add_demo(program);
  slamicp::command::add_info(program);
  slamicp::command::add_convert(program);
  slamicp::command::add_simulate(program);
  slamicp::command::add_map(program);
  slamicp::command::add_localize(program);
  slamicp::command::add_align(program);
  slamicp::command::add_odometry(program);
  slamicp::command::add_evaluate(program);
  slamicp::command::add_experiment(program);
  add_help(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11 has its own numbers; ours are 0 for help and version, 2 for wrong words.
    return program.exit(error, std::cout, std::cerr) == 0 ? done : wrong_words;
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, leave_nothing_half_written);
  std::signal(SIGTERM, leave_nothing_half_written);
  try {
    slamicp::command::Arguments arguments(argc, argv);
    return run(arguments.count(), arguments.words());
  } catch (const slamicp::Error& error) {
    std::cerr << "slamicp: " << error.what() << '\n';
  } catch (const std::bad_alloc&) {
    std::cerr << "slamicp: out of memory; give a shorter log or a thinner cloud\n";
  } catch (const std::exception& error) {
    std::cerr << "slamicp: " << error.what() << '\n';
  }
  return could_not_do_it;
}
