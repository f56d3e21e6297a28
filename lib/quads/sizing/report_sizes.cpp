#include "sizing/report_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/warning_codes.hpp"

namespace quadrille::sizing {
namespace {

/// Sums over edges, from which means are computed.
struct Sums {
  double length = 0, log_prescribed = 0, log_ratio = 0, log_ratio2 = 0;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  double least_log = std::numeric_limits<double>::infinity(), greatest_log = -least_log;

  void add_edge(double achieved, double prescribed_length) {
    const double ratio = std::log(achieved / prescribed_length);
    length += achieved;
    log_prescribed += achieved * std::log(prescribed_length);
    log_ratio += achieved * ratio;
    log_ratio2 += achieved * ratio * ratio;
    least = std::min(least, achieved), greatest = std::max(greatest, achieved);
    least_log = std::min(least_log, ratio), greatest_log = std::max(greatest_log, ratio);
  }
  void add(const Sums& other) {
    length += other.length, log_prescribed += other.log_prescribed;
    log_ratio += other.log_ratio, log_ratio2 += other.log_ratio2;
    least = std::min(least, other.least), greatest = std::max(greatest, other.greatest);
    least_log = std::min(least_log, other.least_log), greatest_log = std::max(greatest_log, other.greatest_log);
  }
  EdgeSizes means() const {
    return {length,
            std::exp(log_prescribed / length),
            least,
            greatest,
            log_ratio / length,
            std::sqrt(log_ratio2 / length),
            std::exp(least_log),
            std::exp(greatest_log)};
  }
};

Sums sums_of(const mesh::Chord& chord, const MeasuredLayout& measured, const ArcDivisions& divisions,
             const SizeField& sizes) {
  Sums sums;
  for (const int arc : chord.arcs) {
    const ArcDivision& division = divisions[arc];
    const curve::Chain& chain = measured.chain(arc);
    for (int k = 0; k < division.num_intervals(); ++k) {
      const double achieved = (division.high(k) - division.low(k)) * chain.length();
      const double prescribed_length =
          sizes.is_uniform() ? sizes.greatest() : sizes.at(chain.position(division.middle(k)), measured.region_of(arc));
      sums.add_edge(achieved, prescribed_length);
    }
  }
  return sums;
}

}  // namespace

std::vector<EdgeSizes> edge_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions,
                                  const SizeField& sizes) {
  std::vector<EdgeSizes> result;
  Sums all;
  for (const mesh::Chord& chord : measured.chords()) {
    const Sums sums = sums_of(chord, measured, divisions, sizes);
    result.push_back(sums.means());
    all.add(sums);
  }
  result.push_back(all.means());
  return result;
}

void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report) {
  const std::vector<mesh::Chord>& chords = measured.chords();
  const std::vector<EdgeSizes> edges = edge_sizes(measured, divisions, sizes);
  const EdgeSizes& all = edges.back();
  report.set("sizes.prescribed", all.prescribed);
  report.set("sizes.mean_ratio", std::exp(all.mean_log));
  report.set("sizes.deviation", all.deviation);
  report.set("sizes.least_edge", all.least);
  report.set("sizes.greatest_edge", all.greatest);
  report.set("sizes.least_ratio", all.least_ratio);
  report.set("sizes.greatest_ratio", all.greatest_ratio);

  std::vector<double> id, count, prescribed_length, ratio, deviation, least, greatest;
  for (std::size_t c = 0; c < chords.size(); ++c) {
    id.push_back(static_cast<double>(c));
    count.push_back(divisions[chords[c].arcs[0]].num_intervals());
    prescribed_length.push_back(edges[c].prescribed);
    ratio.push_back(std::exp(edges[c].mean_log));
    deviation.push_back(edges[c].deviation);
    least.push_back(edges[c].least);
    greatest.push_back(edges[c].greatest);
  }
  for (const ChordCount& p : prescribed)
    if (count[p.chord] != p.count)
      report.warn(warning::chord_count_missed,
                  fmt::format("chord {} has {} elements, not the prescribed {}: wall layers, the geometric "
                              "tolerance or two elements that would share two edges require more",
                              p.chord, count[p.chord], p.count));
  report.set("sizes.chord.id", std::move(id));
  report.set("sizes.chord.count", std::move(count));
  report.set("sizes.chord.prescribed", std::move(prescribed_length));
  report.set("sizes.chord.mean_ratio", std::move(ratio));
  report.set("sizes.chord.deviation", std::move(deviation));
  report.set("sizes.chord.least_edge", std::move(least));
  report.set("sizes.chord.greatest_edge", std::move(greatest));
}

}  // namespace quadrille::sizing
