#include "sizing/measured_layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/bracketed_root.hpp"
#include "base/tolerance.hpp"

namespace quadrille::sizing {
namespace {

/// By arc: whether another one has the same two ends.
std::vector<bool> parallel_arcs(const std::vector<GraphArc>& arcs) {
  std::map<std::pair<int, int>, int> count;
  for (const GraphArc& arc : arcs) ++count[std::minmax(arc.from, arc.to)];
  std::vector<bool> are_parallel;
  for (const GraphArc& arc : arcs) are_parallel.push_back(count[std::minmax(arc.from, arc.to)] > 1);
  return are_parallel;
}

/// By arc: the region of the blocks beside it; -1 where they differ, or are not known.
std::vector<int> regions_of_arcs(const BlockLayout& layout) {
  constexpr int unmet = -2;
  std::vector<int> regions(layout.arcs.size(), layout.block_region.empty() ? -1 : unmet);
  for (std::size_t b = 0; b < layout.block_region.size(); ++b)
    for (const HalfEdge side : layout.block2arcs[b]) {
      int& region = regions[side.arc];
      region = region == unmet || region == layout.block_region[b] ? layout.block_region[b] : -1;
    }
  return regions;
}

}  // namespace

void reverse_fractions(std::vector<double>& fractions) {
  std::ranges::reverse(fractions);
  for (double& f : fractions) f = 1 - f;
}

bool has_fraction(const std::vector<double>& fractions, double fraction) {
  return std::ranges::any_of(fractions, [&](double f) { return std::abs(f - fraction) < tolerance::round_off; });
}

ArcParameter::ArcParameter(std::vector<double> fractions) : fractions_(std::move(fractions)) {
  const std::size_t last = fractions_.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    // Slopes at most three times the lesser neighbouring difference keep every piece monotone (Fritsch and Carlson).
    const double before = k > 0 ? fractions_[k] - fractions_[k - 1] : fractions_[1] - fractions_[0];
    const double after = k < last ? fractions_[k + 1] - fractions_[k] : before;
    slopes_.push_back(std::min((before + after) / 2, 3 * std::min(before, after)));
  }
}

double ArcParameter::fraction(double u) const {
  if (is_identity() || u <= 0 || u >= 1) return std::clamp(u, 0.0, 1.0);
  const double x = u * static_cast<double>(fractions_.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(x), fractions_.size() - 2);
  const double t = x - static_cast<double>(k), r = 1 - t;
  return r * r * (1 + 2 * t) * fractions_[k] + t * t * (1 + 2 * r) * fractions_[k + 1] +
         r * t * (r * slopes_[k] - t * slopes_[k + 1]);
}

double ArcParameter::parameter(double f) const {
  if (is_identity() || f <= 0 || f >= 1) return std::clamp(f, 0.0, 1.0);
  return bisect([&](double u) { return fraction(u) - f; }, 0, 1);
}

MeasuredLayout::Geometry::Geometry(const BlockLayout& layout)
    : blocks(&layout),
      curves(layout.face, layout.splines),
      periodic(matched_arcs(layout)),
      arc_chord(mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()), periodic)),
      arc_region(regions_of_arcs(layout)),
      chords(mesh::directed_chords(layout.block2arcs, arc_chord, periodic)),
      is_parallel(parallel_arcs(layout.arcs)) {
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(curves, arc.pieces);
  arc_position.resize(layout.arcs.size());
  for (const mesh::Chord& chord : chords)
    for (std::size_t i = 0; i < chord.arcs.size(); ++i) arc_position[chord.arcs[i]] = static_cast<int>(i);
}

MeasuredLayout::MeasuredLayout(const BlockLayout& layout)
    : geometry_(std::make_shared<Geometry>(layout)), parameters_(layout.arcs.size()) {}

MeasuredLayout MeasuredLayout::with_parameters(std::vector<ArcParameter> parameters, HalvedSides halved) const {
  MeasuredLayout other = *this;
  other.parameters_ = std::move(parameters);
  other.halved_ = std::move(halved);
  return other;
}

bool MeasuredLayout::has_equal_parameters() const {
  return std::ranges::all_of(parameters_, &ArcParameter::is_identity);
}

double MeasuredLayout::arc_fraction(const mesh::Chord& chord, int i, double u) const {
  return parameters_[chord.arcs[i]].fraction(chord.backwards[i] ? 1 - u : u);
}

double MeasuredLayout::chord_parameter(const mesh::Chord& chord, int i, double fraction) const {
  const double own = parameters_[chord.arcs[i]].parameter(fraction);
  return chord.backwards[i] ? 1 - own : own;
}

std::vector<double> name_joints(const curve::Chain& chain, const CadFace& face) {
  const std::vector<double> joints = chain.joint_fractions();
  std::vector<double> found;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int before = chain.pieces()[i].curve, after = chain.pieces()[i + 1].curve;
    if (face.curve_names[before] != face.curve_names[after] &&
        (face.has_given_name(before) || face.has_given_name(after)))
      found.push_back(joints[i]);
  }
  return found;
}

}  // namespace quadrille::sizing
