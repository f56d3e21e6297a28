#include "growth/recount.hpp"

#include <algorithm>
#include <cmath>

#include "growth/smooth_divisions.hpp"
#include "sizing/spacing.hpp"

namespace quadrille::growth {
namespace {

constexpr int max_tries = 4;

/// The ends of an arc's intervals that no other count moves, by their numbers: the first and the last one, those of the
/// layers, and breaks.
std::vector<int> kept_ends(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  const std::vector<double> fixed = fixed_fractions(input, arc);
  const int count = division.num_intervals(), low = input.num_layers(arc, 0), high = count - input.num_layers(arc, 1);
  std::vector<int> kept;
  for (int k = 0; k <= count; ++k) {
    const auto is_here = [&](double f) { return std::abs(f - division.ends[k]) < same_fraction; };
    if (k == 0 || k == count || k <= low || k >= high || std::any_of(fixed.begin(), fixed.end(), is_here))
      kept.push_back(k);
  }
  return kept;
}

/// The parts between kept ends, with the sum of the present intervals as measure of each: a part with n intervals is as
/// long as n units. Layers are parts of one interval that gets no more.
struct Parts {
  std::vector<int> kept;
  sizing::Segments segments;  ///< of those that may get more
  std::vector<bool> is_layer;
};

Parts parts_of(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  Parts parts{kept_ends(input, arc, division), {{0.0}, {}}, {}};
  const int count = division.num_intervals(), low = input.num_layers(arc, 0), high = count - input.num_layers(arc, 1);
  for (std::size_t i = 0; i + 1 < parts.kept.size(); ++i) {
    const int own = parts.kept[i + 1] - parts.kept[i];
    parts.is_layer.push_back(parts.kept[i] < low || parts.kept[i] >= high);
    if (parts.is_layer.back()) continue;
    parts.segments.ends.push_back(parts.segments.ends.back() + own);
    parts.segments.least_counts.push_back(1);
  }
  for (double& end : parts.segments.ends) end /= parts.segments.ends.back();
  return parts;
}

/// The end at a fraction of the present numbers of intervals between two kept ends.
double interpolated(const std::vector<double>& ends, int from, int to, double fraction) {
  const double position = from + fraction * (to - from);
  const int k = std::min(static_cast<int>(position), to - 1);
  return ends[k] + (position - k) * (ends[k + 1] - ends[k]);
}

sizing::ArcDivision divided_anew(const sizing::ArcDivision& division, const Parts& parts,
                                 const std::vector<int>& counts) {
  sizing::ArcDivision result{{division.ends.front()}};
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < parts.kept.size(); ++i) {
    const int from = parts.kept[i], to = parts.kept[i + 1], count = parts.is_layer[i] ? 1 : counts[next++];
    for (int k = 1; k < count; ++k)
      result.ends.push_back(interpolated(division.ends, from, to, static_cast<double>(k) / count));
    result.ends.push_back(division.ends[to]);
  }
  return result;
}

/// No value if parts of an arc compete.
std::vector<sizing::ArcDivision> divided_chord(const GrowthInput& input, const std::vector<int>& arcs, int count,
                                               bool break_ties, const sizing::ArcDivisions& divisions) {
  std::vector<sizing::ArcDivision> result;
  for (const int arc : arcs) {
    const Parts parts = parts_of(input, arc, divisions[arc]);
    const int layers = input.num_layers(arc, 0) + input.num_layers(arc, 1);
    const int least = std::max(count, layers + parts.segments.least_count());
    const std::vector<int> counts = sizing::segment_counts(parts.segments, least - layers, break_ties);
    if (counts.empty()) return {};
    result.push_back(divided_anew(divisions[arc], parts, counts));
  }
  return result;
}

}  // namespace

int recount_chord(const GrowthInput& input, int chord, int count, sizing::ArcDivisions& divisions) {
  const std::vector<int>& arcs = input.measured.chords()[chord].arcs;
  for (int i = 0;; ++i) {
    const bool is_last = i == max_tries;
    const std::vector<sizing::ArcDivision> divided =
        divided_chord(input, arcs, is_last ? count : count + i, is_last, divisions);
    if (divided.empty()) continue;
    for (std::size_t k = 0; k < arcs.size(); ++k) divisions[arcs[k]] = divided[k];
    return divisions[arcs.front()].num_intervals();
  }
}

}  // namespace quadrille::growth
