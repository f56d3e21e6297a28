#include "prescribe/boundary_counts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"
#include "prescribe/named_arcs.hpp"

namespace quadrille::prescribe {
namespace {

constexpr std::string_view even = ",even";

/// A chord with a free count along a boundary.
struct FreeChord {
  int chord = 0;
  int num_arcs = 1;   ///< m
  double target = 1;  ///< t
  int layers = 0;     ///< besides
};

/// A boundary that is to have `count` elements, `fixed` of them on chords with prescribed counts.
struct Demand {
  int count = 0, fixed = 0;
  int least = 0;  ///< that the layers of all chords leave; 0 without layers
  std::vector<FreeChord> free;
  std::vector<std::string> prescribed;  ///< "chord 3 (12 elements)", for messages
};

using Sums = std::map<int, std::pair<double, int>>;  ///< by sum: least cost, and the last count that gives it

/// The arcs of a boundary in a chord.
struct ArcsInChord {
  int num = 0;
  double length = 0;  ///< of all
};

using ArcsByChord = std::map<int, ArcsInChord>;

/// The arcs of a boundary; of an interface whose sides have arcs of their own one entry for each side.
std::vector<ArcsByChord> arcs_by_side(const sizing::MeasuredLayout& measured, const BoundaryCount& boundary) {
  const std::vector<HalfEdge> arcs = named_arcs(measured, boundary.boundary, "--count");
  const CadFace& face = measured.blocks().face;
  const auto curve_of = [&](HalfEdge arc) { return measured.blocks().arcs[arc.arc].pieces.front().curve; };
  std::set<int> curves;
  for (const HalfEdge arc : arcs) curves.insert(curve_of(arc));
  const auto is_second_side = [&](HalfEdge arc) {
    if (!measured.blocks().arcs[arc.arc].is_boundary || !face.is_interface(curve_of(arc))) return false;
    const int partner = face.partners[curve_of(arc)];
    return partner < curve_of(arc) && curves.contains(partner);
  };
  std::vector<ArcsByChord> sides(std::ranges::any_of(arcs, is_second_side) ? 2 : 1);
  for (const HalfEdge arc : arcs) {
    ArcsInChord& in_chord = sides[is_second_side(arc) ? 1 : 0][measured.chord_of(arc.arc)];
    ++in_chord.num;
    in_chord.length += measured.length(arc.arc);
  }
  return sides;
}

/// 0 unless a chord along the boundary has layers.
int least_with_layers(const ArcsByChord& arcs, const std::vector<LayeredCount>& layered) {
  int least = 0;
  bool any = false;
  for (const auto& [chord, in_chord] : arcs) {
    const int layers = layered.empty() ? 0 : layered[chord].layers;
    any = any || layers > 0;
    least += in_chord.num * (layers + 1);
  }
  return any ? least : 0;
}

/// A boundary that is to have its number, or one side of an interface.
struct CountedSide {
  const BoundaryCount* boundary;
  ArcsByChord arcs;
};

Demand demand_of(const CountedSide& side, const std::vector<sizing::ChordPlan>& plans,
                 const std::vector<LayeredCount>& layered) {
  Demand demand{side.boundary->count, 0, least_with_layers(side.arcs, layered), {}, {}};
  for (const auto& [chord, arcs] : side.arcs) {
    const int num = arcs.num;
    const sizing::ChordPlan& plan = plans[chord];
    if (!plan.is_prescribed) {
      const int layers = layered.empty() ? 0 : layered[chord].layers;
      const double by_sizes = layered.empty() ? plan.grading.count() : layered[chord].count - layers;
      const double target = side.boundary->is_even ? arcs.length / num : by_sizes;
      demand.free.push_back({chord, num, target, layers});
      continue;
    }
    demand.fixed += num * plan.count;
    demand.prescribed.push_back(fmt::format("chord {} ({} elements)", chord, plan.count));
  }
  return demand;
}

/// The targets, times one factor so that they have the sum.
void scale_targets(Demand& demand) {
  double sum = 0;
  int layers = 0;
  for (const FreeChord& f : demand.free) {
    sum += f.num_arcs * f.target;
    layers += f.num_arcs * f.layers;
  }
  for (FreeChord& f : demand.free) f.target *= std::max(1, demand.count - demand.fixed - layers) / sum;
}

/// By number of chords: the sums that counts near the targets can have. A window as wide as the greatest number of arcs
/// reaches every sum that their common divisor permits.
std::vector<Sums> reachable_sums(const Demand& demand) {
  int window = 2;
  for (const FreeChord& f : demand.free) window = std::max(window, f.num_arcs + 1);
  std::vector<Sums> sums{{{demand.fixed, {0.0, 0}}}};
  for (const FreeChord& f : demand.free) {
    Sums next;
    const int middle = static_cast<int>(std::lround(f.target));
    for (const auto& [sum, before] : sums.back())
      for (int n = std::max(1, middle - window); n <= middle + window; ++n) {
        const double cost = before.first + f.num_arcs * std::pow(std::log(n / f.target), 2);
        const int count = f.layers + n;
        const auto [known, is_new] = next.try_emplace(sum + f.num_arcs * count, cost, count);
        // Of tied counts, as of chords that are images of each other, those with the least number on the first chords.
        if (!is_new && cost < known->second.first - tolerance::tied) known->second = {cost, count};
      }
    sums.push_back(std::move(next));
  }
  return sums;
}

[[noreturn]] void refuse(const BoundaryCount& boundary, const Demand& demand, const Sums& possible) {
  std::vector<std::string> reasons = demand.prescribed;
  for (const FreeChord& f : demand.free)
    if (f.num_arcs > 1) reasons.push_back(fmt::format("chord {} (along it {} times)", f.chord, f.num_arcs));
  const auto above = possible.upper_bound(demand.count);
  std::vector<int> nearest;
  if (above != possible.begin()) nearest.push_back(std::prev(above)->first);
  if (above != possible.end()) nearest.push_back(above->first);
  throw UsageError(fmt::format(
      "--count {0}={1}: the boundary '{0}' cannot have {1} elements, because of {2}: possible {3} {4}",
      boundary.boundary, boundary.count,
      reasons.empty() ? std::string("the number of its chords") : fmt::format("{}", fmt::join(reasons, ", ")),
      nearest.size() == 1 ? "is" : "are", fmt::join(nearest, " and ")));
}

/// Of the free chords.
std::vector<sizing::ChordCount> counts_that_meet(const BoundaryCount& boundary, Demand demand) {
  if (demand.count < demand.least) {
    std::vector<sizing::ChordCount> least;
    for (const FreeChord& f : demand.free) least.push_back({f.chord, f.layers + 1});
    return least;
  }
  scale_targets(demand);
  const std::vector<Sums> sums = reachable_sums(demand);
  int sum = demand.count;
  if (!sums.back().contains(sum)) refuse(boundary, demand, sums.back());
  std::vector<sizing::ChordCount> counts;
  for (std::size_t i = demand.free.size(); i > 0; --i) {
    const int n = sums[i].at(sum).second;
    counts.push_back({demand.free[i - 1].chord, n});
    sum -= demand.free[i - 1].num_arcs * n;
  }
  return counts;
}

/// `least`: least_with_layers.
void warn_if_count_missed(const BoundaryCount& boundary, int achieved, int least, Report& report) {
  if (achieved == boundary.count) return;
  const std::string why =
      boundary.count < least
          ? fmt::format("its wall layers and one element between or above them need at least {}", least)
          : "the geometric tolerance or two elements that would share two edges require more";
  report.warn(warning::chord_count_missed,
              fmt::format("--count {0}={1}: the boundary '{0}' has {2} elements, not {1}: {3}", boundary.boundary,
                          boundary.count, achieved, why));
}

}  // namespace

void parse_count(const std::string& text, std::vector<sizing::ChordCount>& chords,
                 std::vector<BoundaryCount>& boundaries) {
  const std::size_t equals = text.rfind('=');
  const std::string name = text.substr(0, equals);
  std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  const bool is_even = value.ends_with(even);
  if (is_even) value.resize(value.size() - even.size());
  const std::optional<int> chord = number_of<int>(name), count = number_of<int>(value);
  if (name.empty() || !count || *count < 1 || (chord && is_even))
    throw UsageError(fmt::format("--count: '{}' is not CHORD=N or NAME=N[,even] with a whole number N >= 1", text));
  if (chord)
    chords.push_back({*chord, *count});
  else
    boundaries.push_back({name, *count, is_even});
}

std::vector<bool> even_curves(const CadFace& face, const std::vector<BoundaryCount>& boundaries) {
  std::vector<bool> is_even;
  for (const BoundaryCount& boundary : boundaries) {
    if (!boundary.is_even) continue;
    is_even.resize(face.num_curves(), false);
    for (const int c : curve::named_curves(face, boundary.boundary, "--count")) {
      is_even[c] = true;
      if (face.is_interface(c)) is_even[face.partners[c]] = true;
    }
  }
  return is_even;
}

std::vector<sizing::ChordCount> with_boundary_counts(const sizing::MeasuredLayout& measured,
                                                     const sizing::SizeField& sizes,
                                                     std::vector<sizing::ChordCount> counts,
                                                     const std::vector<BoundaryCount>& boundaries,
                                                     const std::vector<LayeredCount>& layered,
                                                     const std::vector<EndGrading>& gradings, double growth) {
  if (boundaries.empty()) return counts;
  std::vector<CountedSide> open;
  for (const BoundaryCount& boundary : boundaries)
    for (ArcsByChord& arcs : arcs_by_side(measured, boundary)) open.push_back({&boundary, std::move(arcs)});
  std::vector<sizing::ChordPlan> plans = sizing::grade_chords(measured, sizes, sizing::SizeRule::nearest, counts);
  apply_end_gradings(measured, gradings, growth, plans);
  for (std::size_t c = 0; c < layered.size(); ++c)
    if (plans[c].is_prescribed) plans[c].count = std::max(plans[c].count, layered[c].layers + 1);
  while (!open.empty()) {
    std::vector<Demand> demands;
    for (const CountedSide& side : open) demands.push_back(demand_of(side, plans, layered));
    const auto next = std::min_element(demands.begin(), demands.end(),
                                       [](const Demand& a, const Demand& b) { return a.free.size() < b.free.size(); });
    const auto at = next - demands.begin();
    for (const sizing::ChordCount& found : counts_that_meet(*open[at].boundary, *next)) {
      counts.push_back(found);
      plans[found.chord].count = found.count;
      plans[found.chord].is_prescribed = true;
    }
    open.erase(open.begin() + at);
  }
  return counts;
}

void report_boundary_counts(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                            const std::vector<BoundaryCount>& boundaries, const std::vector<LayeredCount>& layered,
                            Report& report) {
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    int achieved = 0;
    for (const ArcsByChord& side : arcs_by_side(measured, boundaries[i])) {
      achieved = 0;
      for (const auto& [chord, arcs] : side)
        achieved += arcs.num * divisions[measured.chords()[chord].arcs.front()].num_intervals();
      warn_if_count_missed(boundaries[i], achieved, least_with_layers(side, layered), report);
    }
    const std::string key = fmt::format("counts.{}.", i);
    report.set(key + "boundary", boundaries[i].boundary);
    report.set(key + "prescribed", boundaries[i].count);
    report.set(key + "achieved", achieved);
  }
}

}  // namespace quadrille::prescribe
