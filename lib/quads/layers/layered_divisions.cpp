#include "layers/layered_divisions.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/chords.hpp"

namespace quadrille::layers {
namespace {

std::vector<OppositeArcs> find_opposite_arcs(const WallInput& input, int chord) {
  const sizing::MeasuredLayout& measured = input.measured;
  std::vector<OppositeArcs> pairs;
  for (int block = 0; block < input.blocks().num_blocks(); ++block)
    for (const int k : {0, 1}) {
      const auto arc = [&](int side) { return mesh::half_edge(input.blocks(), block, side).arc; };
      if (measured.chord_of(arc(k)) != chord || arc(k) == arc(k + 2)) continue;
      pairs.push_back({measured.position_in_chord(arc(k)), measured.position_in_chord(arc(k + 2)),
                       (measured.length(arc(k + 1)) + measured.length(arc(k + 3))) / 2});
    }
  return pairs;
}

/// The chord's parameters at which the layers of arc i end.
std::pair<double, double> free_range(const LayeredChord& chord, int i, const std::vector<double>& ends) {
  const int count = static_cast<int>(ends.size());
  const int low = chord.at_end(i, 0).layers(), high = chord.at_end(i, 1).layers();
  return {chord.parameter(i, ends[chord.own_step(i, low, count)]),
          chord.parameter(i, ends[chord.own_step(i, count - 1 - high, count)])};
}

/// 0 between arcs with different layers: their intervals of equal number lie at different heights.
double alignment_weight(const LayeredChord& chord, const OppositeArcs& pair) {
  const auto [a, b, distance] = pair;
  for (const int end : {0, 1})
    if (chord.at_end(a, end).layers() != chord.at_end(b, end).layers()) return 0;
  const bool is_layered = chord.at_end(a, 0).layers() + chord.at_end(a, 1).layers() > 0;
  const bool is_free = !is_layered || chord.is_aligned(a) || chord.is_aligned(b);
  const double factor = 4 * (is_free ? 1 : layer_constants.layered_distance_factor);
  const double slenderness = (chord.length(a) + chord.length(b)) / (factor * distance);
  return std::min(layer_constants.greatest_weight, std::pow(slenderness, layer_constants.alignment_power));
}

Eigen::SparseMatrix<double> alignment_matrix(const LayeredChord& chord) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(chord.num_arcs() + 4 * chord.opposite_arcs().size());
  for (int i = 0; i < chord.num_arcs(); ++i) entries.emplace_back(i, i, 1.0);
  for (const OppositeArcs& pair : chord.opposite_arcs()) {
    const double weight = alignment_weight(chord, pair);
    if (weight == 0) continue;
    for (const int i : {pair.a, pair.b}) {
      entries.emplace_back(i, i, weight);
      entries.emplace_back(i, pair.a + pair.b - i, -weight);
    }
  }
  Eigen::SparseMatrix<double> matrix(chord.num_arcs(), chord.num_arcs());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The arc nearest along the chord's blocks whose prescribed end an arc has to follow.
struct Source {
  double distance = INFINITY;
  int arc = -1;  ///< position in the chord; -1: none
};

/// The least count that no free part of an arc or line exceeds its size and growth with.
int least_suitable_count(const LayeredChord& chord, const std::vector<FreePart>& lines, int least_count) {
  int count = least_count;
  const auto suit = [&](const FreePart& part) {
    count = std::max(count, part.layers + least_graded_count(part.ends, part.length, part.size, chord.growth(),
                                                             layer_constants.max_intervals));
  };
  for (const FreePart& line : lines) suit(line);
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const double length = chord.length(i), size = chord.size(i);
    const FreePart part = free_part(chord.spacing(i), length, size);
    if (part.ends.are_free())
      count =
          std::max(count, static_cast<int>(std::ceil(length / (layer_constants.size_slack * size) - tolerance::tied)));
    else
      suit(part);
  }
  return std::min(count, layer_constants.max_intervals);
}

/// The layers at both ends of the arc that has the most of them.
int most_layers(const LayeredChord& chord) {
  int most = 0;
  for (int i = 0; i < chord.num_arcs(); ++i)
    most = std::max(most, chord.spacing(i)[0].layers() + chord.spacing(i)[1].layers());
  return most;
}

/// The interval that would lie before the first one of an arc which begins like arc i.
double start_size(const LayeredChord& chord, int i, int chord_end) {
  const EndSpacing& end = chord.at_end(i, chord_end);
  return end.layer_ends.empty() ? end.before : end.layer_ends.front() * chord.length(i) / end.growth;
}

/// Replaces a source by the source of an opposite arc if this is nearer, or as near and finer. Returns whether it did.
bool update_source(const LayeredChord& chord, int chord_end, const Source& from, double distance, Source& to) {
  if (from.arc < 0) return false;
  const double longer = from.distance + distance;
  if (longer > to.distance * (1 + tolerance::tied)) return false;
  const bool is_nearer = longer < to.distance * (1 - tolerance::tied);
  if (!is_nearer &&
      start_size(chord, from.arc, chord_end) >= (1 - tolerance::tied) * start_size(chord, to.arc, chord_end))
    return false;
  to = {longer, from.arc};
  return true;
}

/// By arc: the nearest one that has layers at this end of the chord; if none has, the nearest with a prescribed end.
std::vector<Source> nearest_sources(const LayeredChord& chord, int chord_end) {
  std::vector<Source> sources(chord.num_arcs());
  bool any_layers = false;
  for (int i = 0; i < chord.num_arcs(); ++i) any_layers |= chord.at_end(i, chord_end).layers() > 0;
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const EndSpacing& end = chord.at_end(i, chord_end);
    if (any_layers ? end.layers() > 0 : !end.is_free()) sources[i] = {0, i};
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const OppositeArcs& pair : chord.opposite_arcs()) {
      changed |= update_source(chord, chord_end, sources[pair.a], pair.distance, sources[pair.b]);
      changed |= update_source(chord, chord_end, sources[pair.b], pair.distance, sources[pair.a]);
    }
  }
  return sources;
}

/// Rule 16: the arc's own division, moved towards the one that starts like the layers by the amount that the slope
/// requires.
std::vector<double> ends_of_arc(const LayeredChord& chord, const std::array<std::vector<Source>, 2>& sources, int i,
                                int count, bool is_prescribed) {
  ArcSpacing like_source = chord.spacing(i);
  double distance = INFINITY;
  for (const int chord_end : {0, 1}) {
    const Source& source = sources[chord_end][i];
    if (source.arc < 0 || source.arc == i) continue;
    EndSpacing& own = like_source[chord.own_end(i, chord_end)];
    const double start = start_size(chord, source.arc, chord_end);
    own.before = own.is_free() ? start : std::min(own.before, start);
    own.growth = chord.growth();
    distance = std::min(distance, source.distance);
  }
  const double length = chord.length(i);
  const auto spaced = [&](const ArcSpacing& spacing) {
    const double size = chord.size(i);
    return spaced_ends(spacing, length, is_prescribed ? even_size(spacing, length, size, chord.growth(), count) : size,
                       count);
  };
  std::vector<double> ends = spaced(chord.spacing(i));
  if (!std::isfinite(distance)) return ends;
  const std::vector<double> kept = spaced(like_source);
  double shift = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) shift = std::max(shift, std::abs(ends[k] - kept[k]) * length);
  const double weight = shift > 0 ? std::min(1.0, layer_constants.greatest_slope * distance / shift) : 1;
  for (std::size_t k = 1; k + 1 < ends.size(); ++k) ends[k] = weight * ends[k] + (1 - weight) * kept[k];
  return ends;
}

}  // namespace

LayeredChord::LayeredChord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings,
                           const ArcSizes& sizes)
    : input_(input),
      chord_(input.measured.chords()[chord]),
      spacings_(spacings),
      growth_(least_growth(chord_, spacings)),
      opposite_arcs_(find_opposite_arcs(input, chord)) {
  for (const int a : chord_.arcs) sizes_.push_back(sizes.at(a));
}

void align_divisions(const LayeredChord& chord, std::vector<sizing::ArcDivision>& divisions) {
  const int count = static_cast<int>(divisions.front().ends.size());
  Eigen::MatrixXd own(chord.num_arcs(), count);
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const auto [low, high] = free_range(chord, i, divisions[i].ends);
    for (int k = 0; k < count; ++k)
      own(i, k) = (chord.parameter(i, divisions[i].ends[chord.own_step(i, k, count)]) - low) / (high - low);
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(alignment_matrix(chord));
  const Eigen::MatrixXd aligned = solver.solve(own);
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const auto [low, high] = free_range(chord, i, divisions[i].ends);
    for (int k = chord.at_end(i, 0).layers() + 1; k + 1 < count - chord.at_end(i, 1).layers(); ++k)
      divisions[i].ends[chord.own_step(i, k, count)] = chord.fraction(i, low + aligned(i, k) * (high - low));
  }
}

std::vector<sizing::ArcDivision> layered_divisions(const LayeredChord& chord, const std::vector<FreePart>& lines,
                                                   int least_count, int prescribed_count) {
  const std::array<std::vector<Source>, 2> sources{nearest_sources(chord, 0), nearest_sources(chord, 1)};
  const int count = prescribed_count > 0 ? std::max(prescribed_count, most_layers(chord) + 1)
                                         : least_suitable_count(chord, lines, least_count);
  std::vector<sizing::ArcDivision> divisions;
  divisions.reserve(chord.num_arcs());
  for (int i = 0; i < chord.num_arcs(); ++i)
    divisions.push_back({ends_of_arc(chord, sources, i, count, prescribed_count > 0)});
  align_divisions(chord, divisions);
  return divisions;
}

}  // namespace quadrille::layers
