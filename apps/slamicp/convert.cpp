// SPDX-License-Identifier: Apache-2.0
// slamicp convert: between formats, by file name ending.
#include <filesystem>
#include <memory>
#include <variant>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/scan_log.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct Words {
  std::string in, out, json;
  bool ascii = false;
  ScanLogOptions reading;
};

bool is_log_ending(const std::string& ending) { return ending == ".clf" || ending == ".log"; }

void convert_log(const Words& words) {
  const ScanLog log = open_scan_log(words.in, words.reading);
  warn(log.warnings);
  save_scan_log(words.out, log.scans);
  write_json(words.json,
             {{"verb", "convert"}, {"in", words.in}, {"out", words.out}, {"kind", "log"}, {"scans", log.size()}});
  Talk{words.json}(format("%zu scans -> %s", log.size(), words.out.c_str()));
}

void convert_cloud(const Words& words) {
  const Cloud cloud = load_cloud(words.in);
  warn(cloud.warnings);
  const auto encoding = words.ascii ? CloudEncoding::ascii : CloudEncoding::binary;
  std::visit([&](const auto& points) { save_cloud(words.out, points, encoding); }, cloud.points);
  write_json(words.json, {{"verb", "convert"},
                          {"in", words.in},
                          {"out", words.out},
                          {"kind", "cloud"},
                          {"dimension", cloud.dimension()},
                          {"points", cloud.size()}});
  Talk{words.json}(format("%zu points -> %s", cloud.size(), words.out.c_str()));
}

void run(const Words& words) {
  const std::string out = std::filesystem::path(words.out).extension().string();
  const bool in_is_log = kind_of(words.in) == FileKind::scan_log;
  const bool out_can_be_log = is_log_ending(out) || out == ".csv";
  if (in_is_log && out_can_be_log) return convert_log(words);
  if (!in_is_log && !is_log_ending(out)) return convert_cloud(words);
  throw Error(in_is_log ? "a log cannot become a cloud by itself" : "a cloud has no scans",
              words.in + " -> " + words.out,
              in_is_log ? "make a map of it: slamicp map LOG --out MAP" : "give a cloud's ending: .csv .xyz .pcd .ply");
}

}  // namespace

void add_convert(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("convert", "a log or a cloud into another format, by file name ending");
  const auto words = std::make_shared<Words>();
  verb->add_option("IN", words->in, "log: .clf .log .csv; cloud: .csv .xyz .pcd .ply")->required();
  verb->add_option("OUT", words->out, "log: .clf .log (CARMEN), .csv (ranges); cloud: .csv .xyz .pcd .ply")->required();
  verb->add_flag("--ascii", words->ascii, "text PCD and PLY; default: binary");
  add_log_options(*verb, words->reading);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp convert map.ply map.pcd");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
