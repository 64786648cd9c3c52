// SPDX-License-Identifier: Apache-2.0
// slamicp convert: between formats, by file name ending.
#include <filesystem>
#include <memory>
#include <variant>

#include <slamicp/error.hpp>
#include <slamicp/io/cloud_file.hpp>
#include <slamicp/io/file_kind.hpp>
#include <slamicp/io/occupancy_map_file.hpp>
#include <slamicp/io/scan_log.hpp>

#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

namespace slamicp::command {
namespace {

struct ConvertWords {
  std::string in, out, json;
  bool ascii = false;
  double resolution = GridOptions{}.resolution;
  ScanLogOptions reading;
};

bool is_log_ending(const std::string& ending) { return ending == ".clf" || ending == ".log"; }

void convert_log(const ConvertWords& words) {
  const ScanLog log = open_scan_log(file_named(words.in), words.reading);
  warn(log.warnings);
  save_scan_log(file_named(words.out), log.scans);
  write_json(words.json,
             {{"verb", "convert"}, {"in", words.in}, {"out", words.out}, {"kind", "log"}, {"scans", log.size()}});
  Talk{words.json}(format("%zu scans -> %s", log.size(), words.out.c_str()));
}

void convert_cloud(const ConvertWords& words) {
  const Cloud cloud = load_cloud(file_named(words.in));
  warn(cloud.warnings);
  const auto encoding = words.ascii ? CloudEncoding::ascii : CloudEncoding::binary;
  if (const auto* plane = std::get_if<PointCloud2>(&cloud.points); plane != nullptr && is_map_server(words.out))
    save_occupancy_map(file_named(words.out), to_occupancy_grid(*plane, {.resolution = words.resolution}));
  else
    std::visit([&](const auto& points) { save_cloud(file_named(words.out), points, encoding); }, cloud.points);
  write_json(words.json, {{"verb", "convert"},
                          {"in", words.in},
                          {"out", words.out},
                          {"kind", "cloud"},
                          {"dimension", cloud.dimension()},
                          {"points", cloud.size()}});
  Talk{words.json}(format("%zu points -> %s", cloud.size(), words.out.c_str()));
}

/// Cell by cell: what is free stays free.
void convert_map(const ConvertWords& words) {
  const OccupancyMap map = load_occupancy_map(file_named(words.in));
  warn(map.warnings);
  save_occupancy_map(file_named(words.out), map.grid);
  write_json(words.json, {{"verb", "convert"},
                          {"in", words.in},
                          {"out", words.out},
                          {"kind", "map"},
                          {"width", map.grid.width},
                          {"height", map.grid.height}});
  Talk{words.json}(format("%d x %d cells -> %s", map.grid.width, map.grid.height, words.out.c_str()));
}

void run(const ConvertWords& words) {
  const std::string out = file_named(words.out).extension().string();
  const FileKind kind = kind_of(file_named(words.in));
  const bool in_is_log = kind == FileKind::scan_log;
  const bool out_can_be_log = is_log_ending(out) || out == ".csv";
  if (in_is_log && out_can_be_log) return convert_log(words);
  if (kind == FileKind::occupancy_map && is_map_server(words.out)) return convert_map(words);
  if (!in_is_log && !is_log_ending(out)) return convert_cloud(words);
  throw Error(
      in_is_log ? "a log cannot become a cloud by itself" : "a cloud has no scans", words.in + " -> " + words.out,
      in_is_log ? "make a map of it: slamicp map LOG --out MAP" : std::string("give a cloud's ending: ") + map_words);
}

}  // namespace

void add_convert(CLI::App& program) {
  CLI::App* verb =
      program.add_subcommand("convert", "a log, a cloud or a map into another format, by file name ending");
  const auto words = std::make_shared<ConvertWords>();
  verb->add_option("IN", words->in, std::string("log: ") + log_words + "; cloud or map: " + map_words)->required();
  verb->add_option("OUT", words->out, std::string("log: .clf .log (CARMEN), .csv (ranges); cloud or map: ") + map_words)
      ->required();
  verb->add_flag("--ascii", words->ascii, "text PCD and PLY; default: binary");
  add_resolution(*verb, words->resolution);
  add_log_options(*verb, words->reading);
  add_json(*verb, words->json);
  add_example(*verb, "slamicp convert map.ply map.pcd");
  verb->callback([words] { run(*words); });
}

}  // namespace slamicp::command
