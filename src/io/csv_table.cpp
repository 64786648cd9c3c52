// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include <slamicp/io/csv_table.hpp>

#include "io/text.hpp"

namespace slamicp {
namespace {

/// Appends values to one line, commas between.
class Line {
 public:
  explicit Line(std::string& out) : out_(out) {}

  template <class Whole>
  Line& whole(Whole number) {
    separate();
    text::append_exact(out_, number);
    return *this;
  }
  Line& real(double number, int decimals = 6) {
    separate();
    text::append_fixed(out_, number, decimals);
    return *this;
  }
  /// Words of ours hold no comma; one from elsewhere must not move the columns.
  Line& word(std::string_view word) {
    separate();
    for (const char c : word) out_ += c == ',' || c == '\n' || c == '\r' || c == '"' ? ' ' : c;
    return *this;
  }

 private:
  void separate() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  std::string& out_;
  bool first_ = true;
};

constexpr std::string_view header_of(const OutlierRow&) { return "scan,stamp,beam,x,y,distance,kind\n"; }
constexpr std::string_view header_of(const MetricsRow&) {
  return "scan,stamp,x,y,theta,stop,iterations,points,inliers,outliers,mean_inlier_distance,time_us,"
         "state,probability,var_x,var_y,var_theta,blind_deg\n";
}
constexpr std::string_view header_of(const ObstacleRow&) {
  return "scan,stamp,id,kind,x,y,width,depth,heading,radius,points,speed,state\n";
}

void append(Line line, const OutlierRow& row) {
  line.whole(row.scan).real(row.stamp).whole(row.beam).real(row.x).real(row.y).real(row.distance).word(row.kind);
}

void append(Line line, const MetricsRow& row) {
  line.whole(row.scan).real(row.stamp).real(row.x).real(row.y).real(row.theta, 9).word(row.stop);
  line.whole(row.iterations).whole(row.points).whole(row.inliers).whole(row.outliers);
  line.real(row.mean_inlier_distance).real(row.time_us, 1).word(row.state).real(row.probability, 4);
  line.real(row.var_x, 12).real(row.var_y, 12).real(row.var_theta, 12).real(row.blind_deg, 2);
}

void append(Line line, const ObstacleRow& row) {
  line.whole(row.scan).real(row.stamp).whole(row.id).word(row.kind).real(row.x).real(row.y);
  line.real(row.width).real(row.depth).real(row.heading, 9).real(row.radius).whole(row.points).real(row.speed);
  line.word(row.state);
}

}  // namespace

template <class Row>
CsvTable<Row>::CsvTable(const std::filesystem::path& path) : file_(path) {
  file_.write(header_of(Row{}));
}

template <class Row>
void CsvTable<Row>::add(const Row& row) {
  line_.clear();
  append(Line(line_), row);
  line_ += '\n';
  file_.write(line_);
}

template class CsvTable<OutlierRow>;
template class CsvTable<MetricsRow>;
template class CsvTable<ObstacleRow>;

}  // namespace slamicp
