#include "sizing/report_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/enum_names.hpp"
#include "base/warning_codes.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/verdict.hpp"
#include "sizing/advice.hpp"
#include "surface/positions.hpp"

namespace quadrille::sizing {
namespace {

/// The element edges on the arcs of one chord, or of all chords; lengths are arc lengths, means are over the length.
struct EdgeSizes {
  double length = 0, log_prescribed = 0, log_ratio = 0, log_ratio2 = 0;  ///< sums, over edges of their length
  double least = INFINITY, greatest = 0;                                 ///< achieved
  double least_log = INFINITY, greatest_log = -INFINITY;                 ///< of ln(achieved / prescribed)

  void add_edge(double achieved, double prescribed_length) {
    const double ratio = std::log(achieved / prescribed_length);
    add({achieved, achieved * std::log(prescribed_length), achieved * ratio, achieved * ratio * ratio, achieved,
         achieved, ratio, ratio});
  }
  void add(const EdgeSizes& other) {
    length += other.length, log_prescribed += other.log_prescribed;
    log_ratio += other.log_ratio, log_ratio2 += other.log_ratio2;
    least = std::min(least, other.least), greatest = std::max(greatest, other.greatest);
    least_log = std::min(least_log, other.least_log), greatest_log = std::max(greatest_log, other.greatest_log);
  }
  double prescribed() const { return std::exp(log_prescribed / length); }
  double mean_ratio() const { return std::exp(log_ratio / length); }
  double deviation() const { return std::sqrt(log_ratio2 / length); }  ///< of the logarithm, root mean square
};

EdgeSizes edge_sizes(const mesh::Chord& chord, const MeasuredLayout& measured, const ArcDivisions& divisions,
                     const SizeField& sizes) {
  EdgeSizes sums;
  for (const int arc : chord.arcs) {
    const curve::Chain& chain = measured.chain(arc);
    const auto prescribed = [&](double fraction) {
      if (sizes.is_uniform()) return sizes.greatest();
      const curve::ChainPoint at = chain.at(fraction);
      return sizes.along(at.tangent, at.position, measured.region_of(arc));
    };
    for (int k = 0; k < divisions[arc].num_intervals(); ++k)
      sums.add_edge(divisions[arc].width(k) * chain.length(), prescribed(divisions[arc].middle(k)));
  }
  return sums;
}

/// By chord: the part of a mesh's E that the lengths of elements along it have.
std::vector<double> chord_parts(const MeasuredLayout& measured, const QuadMesh& mesh, const mesh::Resolution& of) {
  std::vector<double> parts(measured.chords().size());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto& arcs = measured.blocks().block2arcs[mesh.elem_block[elem]];
    for (int direction = 0; direction < 2; ++direction)
      parts[measured.chord_of(arcs[direction].arc)] += of.parts[elem][direction];
  }
  return parts;
}

/// If the resolution ratio is a fault, its cause also names the chord that has the greatest part of E.
void name_chord(const MeasuredLayout& measured, const QuadMesh& mesh, mesh::Verdict& verdict) {
  const auto fault = std::ranges::find(verdict.faults, mesh::Limit::resolution, &mesh::Fault::limit);
  if (fault == verdict.faults.end()) return;
  const std::vector<double> parts = chord_parts(measured, mesh, mesh::resolution(mesh));
  const auto most = std::ranges::max_element(parts);
  fault->cause += fmt::format(", chord {} has {:.0f} % of the error", most - parts.begin(), 100 * *most);
}

}  // namespace

void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report) {
  EdgeSizes all;
  std::vector<double> id, count, prescribed_length, ratio, deviation, least, greatest;
  for (const mesh::Chord& chord : measured.chords()) {
    const EdgeSizes edges = edge_sizes(chord, measured, divisions, sizes);
    all.add(edges);
    id.push_back(static_cast<double>(id.size()));
    count.push_back(divisions[chord.arcs[0]].num_intervals());
    prescribed_length.push_back(edges.prescribed());
    ratio.push_back(edges.mean_ratio());
    deviation.push_back(edges.deviation());
    least.push_back(edges.least);
    greatest.push_back(edges.greatest);
  }
  report.set("sizes.prescribed", all.prescribed());
  report.set("sizes.mean_ratio", all.mean_ratio());
  report.set("sizes.deviation", all.deviation());
  report.set("sizes.least_edge", all.least);
  report.set("sizes.greatest_edge", all.greatest);
  report.set("sizes.least_ratio", std::exp(all.least_log));
  report.set("sizes.greatest_ratio", std::exp(all.greatest_log));
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

void report_resolution(const MeasuredLayout& measured, const QuadMesh& mesh, Report& report) {
  const mesh::Resolution measure = mesh::resolution(mesh);
  report.set("resolution.ratio", measure.ratio);
  report.set("resolution.chord.part", chord_parts(measured, mesh, measure));
}

std::string report_verdict(const MeasuredLayout& measured, const QuadMesh& mesh, const SizeOptions& prescribed,
                           const SizeOptions& applied, Report& report) {
  mesh::Verdict verdict = mesh::verdict_of(mesh);
  name_chord(measured, mesh, verdict);
  const std::optional<Advice> advice = advice_for(mesh, verdict, prescribed, applied);
  std::string text = mesh::describe(verdict, mesh.face) + (advice ? describe(*advice) : "");
  report.set("verdict.grade", enum_name(verdict.grade()));
  report.set("verdict.text", text);
  if (verdict.faults.empty()) return text;
  const mesh::Fault& worst = verdict.faults.front();
  report.set("verdict.limit", enum_name(worst.limit));
  report.set("verdict.value", worst.value);
  report.set("verdict.position", surface::position_in_file(mesh.face, worst.position));
  if (advice) report.set("verdict.option", advice->option);
  const auto is_of_sizes = [](const mesh::Fault& fault) {
    return fault.limit == mesh::Limit::resolution || fault.limit == mesh::Limit::area_jump;
  };
  if (std::ranges::any_of(verdict.faults, is_of_sizes)) report.warn(warning::unequal_sizes, "the mesh is " + text);
  return text;
}

}  // namespace quadrille::sizing
