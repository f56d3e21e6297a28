#include "sizing/report_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "mesh/element_sizes.hpp"
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

/// The part of a mesh's E that the lengths of elements along a chord have.
struct ChordError {
  int chord = 0, count = 0;  ///< elements along it
  double part = 0;
  int num_elems = 0;  ///< all that it passes
};

constexpr double greatest_resolution = 5;    ///< above which there is a warning
constexpr double greatest_edge_ratio = 100;  ///< above which the warning names the place

/// Each element is counted with its two directions, whose parts of E are the same in squares.
std::vector<ChordError> chord_errors(const MeasuredLayout& measured, const ArcDivisions& divisions,
                                     const QuadMesh& mesh, const mesh::Resolution& of) {
  std::vector<ChordError> errors;
  for (const mesh::Chord& chord : measured.chords())
    errors.push_back({static_cast<int>(errors.size()), divisions[chord.arcs[0]].num_intervals()});
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto& arcs = measured.blocks().block2arcs[mesh.elem_block[elem]];
    for (int direction = 0; direction < 2; ++direction) {
      ChordError& error = errors[measured.chord_of(arcs[direction].arc)];
      error.part += of.parts[elem][direction];
      ++error.num_elems;
    }
  }
  return errors;
}

std::string place_of_thin_element(const QuadMesh& mesh) {
  const mesh::ElementSizes worst = mesh::worst_element_sizes(mesh);
  if (worst.edge_ratio <= greatest_edge_ratio) return {};
  return fmt::format(", and edges of one element, near {}, are of lengths 1 : {:.3g}",
                     surface::position_text(mesh.face, worst.edge_ratio_position), worst.edge_ratio);
}

/// With the number of elements along the worst chord by which their part would be that of equal squares.
std::string resolution_warning(double ratio, const std::vector<ChordError>& errors, const QuadMesh& mesh) {
  const ChordError& worst = *std::max_element(errors.begin(), errors.end(),
                                              [](const ChordError& a, const ChordError& b) { return a.part < b.part; });
  const double of_squares = worst.num_elems / (2.0 * mesh.num_elems() * ratio);
  return fmt::format(
      "elements are of so unequal sizes that the squared error of a smooth solution is about {:.3g} times that of as "
      "many equal squares, {:.0f} % of it along chord {} of {}{}: give --count {}={:.0f}",
      ratio, 100 * worst.part, worst.chord, counted(worst.count, "element"), place_of_thin_element(mesh), worst.chord,
      std::ceil(worst.count * std::pow(worst.part / of_squares, 1.0 / 8)));
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

void report_resolution(const MeasuredLayout& measured, const ArcDivisions& divisions, const QuadMesh& mesh,
                       bool is_relaxed_to_sizes, Report& report) {
  const mesh::Resolution measure = mesh::resolution(mesh);
  const std::vector<ChordError> errors = chord_errors(measured, divisions, mesh, measure);
  std::vector<double> parts;
  for (const ChordError& error : errors) parts.push_back(error.part);
  report.set("resolution.ratio", measure.ratio);
  report.set("resolution.chord.part", std::move(parts));
  if (is_relaxed_to_sizes && measure.ratio > greatest_resolution)
    report.warn(warning::unequal_sizes, resolution_warning(measure.ratio, errors, mesh));
}

}  // namespace quadrille::sizing
