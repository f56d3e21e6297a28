#include "prescribe/end_grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"
#include "base/warning_codes.hpp"
#include "mesh/chords.hpp"
#include "prescribe/log_spacing.hpp"
#include "prescribe/named_arcs.hpp"

namespace quadrille::prescribe {
namespace {

struct GradingConstants {
  int uniform_samples = 96;
  double least_sample = 1e-7;  ///< samples near both ends double from here
  double derivative_step = 1e-5;
  double missed = 1.2, missed_growth = 1.1;  ///< factors of an achieved length and growth that are reported
};
constexpr GradingConstants grading_constants;

using ArcChain = std::vector<HalfEdge>;

/// The prescribed length at the end of a chain of arcs, as one of its arcs sees it.
struct EndLength {
  int arc = 0;               ///< position in the chord
  bool is_from_end = false;  ///< the distance grows against the arc's own direction
  double offset = 0;         ///< distance of the arc from the end of the chain
  double length = 0;         ///< prescribed
};

/// A boundary from end to end, with the lengths there.
struct GradedChain {
  ArcChain arcs;
  double first = 0, last = 0;
};

/// l_0 of the header.
double start_length(double length, double s) { return std::abs(s) < 1e-9 ? length : length * s / std::expm1(s); }

/// The chord's grading from sizes, from both ends on with growing elements.
class GradedChord {
 public:
  GradedChord(const sizing::MeasuredLayout& measured, int chord, const std::vector<EndLength>& ends,
              const sizing::ChordPlan& plan)
      : measured_(measured), chord_(measured.chords()[chord]), ends_(ends), plan_(plan) {
    std::set<double> samples(plan.grading.samples().begin(), plan.grading.samples().end());
    for (int k = 0; k <= grading_constants.uniform_samples; ++k)
      samples.insert(static_cast<double>(k) / grading_constants.uniform_samples);
    for (double u = grading_constants.least_sample; u < 0.5; u *= 2) samples.insert({u, 1 - u});
    u_.assign(samples.begin(), samples.end());
    u_.erase(std::unique(u_.begin(), u_.end(),
                         [](double a, double b) { return b - a < grading_constants.least_sample / 2; }),
             u_.end());
    u_.back() = 1;
  }

  /// The plan with the ratio exp(s) that gives a whole number of elements.
  sizing::ChordPlan plan(double slope) const {
    sizing::ChordPlan result = plan_;
    double low = 1e-6, high = slope;
    const double at_low = grading(low).count(), at_high = grading(high).count();
    const bool rises = at_low < at_high;  // with s: elements shrink away from the ends
    result.count = whole_count(at_low, at_high);
    if (!rises && at_low < result.count) low = high;
    for (int step = 0; step < 50 && low < high; ++step) {
      const double middle = (low + high) / 2;
      ((grading(middle).count() > result.count) != rises ? low : high) = middle;
    }
    result.grading = grading(high);
    result.slope = std::max(plan_.slope, high);
    return result;
  }

 private:
  /// A number of elements between those at the least and the greatest s, so that no s exceeds the greatest.
  static int whole_count(double at_low, double at_high) {
    const double count = at_low < at_high ? std::max(std::ceil(at_low), std::floor(at_high))
                                          : sizing::whole_count(at_high, sizing::SizeRule::at_most);
    return static_cast<int>(std::clamp(count, 1.0, 1e9));
  }

  double distance(const EndLength& end, double u) const {
    const double fraction = measured_.arc_fraction(chord_, end.arc, u);
    return end.offset + measured_.length(chord_.arcs[end.arc]) * (end.is_from_end ? 1 - fraction : fraction);
  }

  /// A length along the arc of an end, in u.
  double in_parameter(const EndLength& end, double u, double length) const {
    const double low = std::max(0.0, u - grading_constants.derivative_step),
                 high = std::min(1.0, u + grading_constants.derivative_step);
    return length * (high - low) / std::abs(distance(end, high) - distance(end, low));
  }

  double element_length(double u, double s) const {
    double most = std::numeric_limits<double>::infinity(), least = 0;
    for (const EndLength& end : ends_) {
      const double x = distance(end, u);
      most = std::min(most, in_parameter(end, u, start_length(end.length, s) + s * x));
      least = std::max(least, in_parameter(end, u, std::max(start_length(end.length, -s) - s * x, 0.0)));
    }
    return std::min(most, std::max(least, plan_.grading.element_length(u)));
  }

  sizing::Grading grading(double s) const {
    std::vector<double> lengths;
    for (const double u : u_) lengths.push_back(element_length(u, s));
    return {u_, lengths};
  }

  const sizing::MeasuredLayout& measured_;
  const mesh::Chord& chord_;
  const std::vector<EndLength>& ends_;
  const sizing::ChordPlan& plan_;
  std::vector<double> u_;
};

/// The lengths in u at both ends of a chord with a prescribed count; 0: free. Of several the least. `slope`: ln of the
/// growth with which elements reach a chord that begins at a distance from the end of its chain.
std::array<double, 2> end_parameters(const sizing::MeasuredLayout& measured, int number,
                                     const std::vector<EndLength>& ends, const sizing::ChordPlan& plan, double slope) {
  const mesh::Chord& chord = measured.chords()[number];
  std::array<double, 2> lengths{};
  for (const EndLength& end : ends) {
    const int side = end.is_from_end == chord.backwards[end.arc] ? 0 : 1;
    const double length = end.offset > 0 ? start_length(end.length, slope) + slope * end.offset : end.length;
    const double fraction = std::min(1.0, length / measured.length(chord.arcs[end.arc]));
    const double u = measured.chord_parameter(chord, end.arc, end.is_from_end ? 1 - fraction : fraction);
    double own = side == 0 ? u : 1 - u;
    if (end.offset > 0) own = std::min(own, plan.grading.element_length(side));
    lengths[side] = lengths[side] > 0 ? std::min(lengths[side], own) : own;
  }
  return lengths;
}

/// Changes the grading, not the count.
void grade_counted(const std::array<double, 2>& ends, sizing::ChordPlan& plan) {
  const LogSpacing spacing(plan.count, 1, ends[0], ends[1]);
  const std::vector<double>& u = spacing.positions();
  std::vector<double> eta = spacing.element_lengths();
  const double factor = sizing::Grading(u, eta).count() / plan.count;
  for (double& length : eta) length *= factor;
  plan.grading = sizing::Grading(u, eta);
  for (std::size_t j = 1; j < u.size(); ++j)
    plan.slope = std::max(plan.slope, std::abs(eta[j] - eta[j - 1]) / (u[j] - u[j - 1]));
}

/// The arcs of a boundary as chains from end to end.
std::vector<ArcChain> chains_of(const sizing::MeasuredLayout& measured, const std::string& name) {
  const std::vector<GraphArc>& all = measured.blocks().arcs;
  std::vector<HalfEdge> arcs = named_arcs(measured, name, "--grading");
  std::set<int> ends;
  for (const HalfEdge arc : arcs) ends.insert(end_of(all, arc));
  std::vector<ArcChain> chains;
  while (!arcs.empty()) {
    auto next = std::ranges::find_if(arcs, [&](HalfEdge a) { return !ends.contains(start_of(all, a)); });
    if (next == arcs.end())
      throw UsageError(
          fmt::format("--grading {0}: the boundary '{0}' is closed, it has no ends: use --size-near", name));
    ArcChain& chain = chains.emplace_back();
    while (next != arcs.end()) {
      chain.push_back(*next);
      arcs.erase(next);
      next = std::ranges::find(arcs, end_of(all, chain.back()), [&](HalfEdge a) { return start_of(all, a); });
    }
  }
  return chains;
}

ArcChain reversed(const ArcChain& chain) {
  ArcChain result;
  for (auto arc = chain.rbegin(); arc != chain.rend(); ++arc) result.push_back(arc->reversed());
  return result;
}

/// The end length `length` at the start of the chain, for each of its arcs, by chord.
void add_end(const sizing::MeasuredLayout& measured, const ArcChain& chain, double length,
             std::vector<std::vector<EndLength>>& by_chord) {
  double offset = 0;
  for (const HalfEdge half : chain) {
    by_chord[measured.chord_of(half.arc)].push_back(
        {measured.position_in_chord(half.arc), half.is_backwards, offset, length});
    offset += measured.length(half.arc);
  }
}

/// The lengths at all nodes of a chain whose counts are all prescribed, as those of one spacing along it.
void add_counted_chain(const sizing::MeasuredLayout& measured, const GradedChain& chain,
                       const std::vector<sizing::ChordPlan>& plans, std::vector<std::vector<EndLength>>& by_chord) {
  int count = 0;
  double length = 0, x = 0;
  for (const HalfEdge half : chain.arcs) {
    count += plans[measured.chord_of(half.arc)].count;
    length += measured.length(half.arc);
  }
  const LogSpacing spacing(count, length, chain.first, chain.last);
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    const HalfEdge half = chain.arcs[i];
    const bool is_first = i == 0, is_last = i + 1 == chain.arcs.size();
    const double end = x + measured.length(half.arc);
    const double before = is_first ? chain.first : spacing.element_length(x);
    const double after = is_last ? chain.last : spacing.element_length(end);
    if (before > 0) add_end(measured, {half}, before, by_chord);
    if (after > 0) add_end(measured, {half.reversed()}, after, by_chord);
    x = end;
  }
}

void add_chain(const sizing::MeasuredLayout& measured, const GradedChain& chain,
               const std::vector<sizing::ChordPlan>& plans, std::vector<std::vector<EndLength>>& by_chord) {
  const auto is_counted = [&](HalfEdge half) { return plans[measured.chord_of(half.arc)].is_prescribed; };
  if (std::ranges::all_of(chain.arcs, is_counted)) return add_counted_chain(measured, chain, plans, by_chord);
  if (chain.first > 0) add_end(measured, chain.arcs, chain.first, by_chord);
  if (chain.last > 0) add_end(measured, reversed(chain.arcs), chain.last, by_chord);
}

/// The lengths of the elements along a chain.
std::vector<double> element_lengths(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                                    const ArcChain& chain) {
  std::vector<double> lengths;
  for (const HalfEdge half : chain) {
    const sizing::ArcDivision& division = divisions[half.arc];
    for (int k = 0; k < division.num_intervals(); ++k)
      lengths.push_back(division.width(half.is_backwards ? division.num_intervals() - 1 - k : k) *
                        measured.length(half.arc));
  }
  return lengths;
}

void warn_if_missed(const std::string& boundary, double prescribed, double achieved, Report& report) {
  if (std::max(achieved / prescribed, prescribed / achieved) > grading_constants.missed)
    report.warn(warning::end_length_missed,
                fmt::format("--grading {}: an element at its end is {:.3g} long, not {:.3g}: another boundary of its "
                            "chord, wall layers or the number of elements require it",
                            boundary, achieved, prescribed));
}

void warn_if_steep(const std::string& boundary, double ratio, double growth, Report& report) {
  if (ratio > grading_constants.missed_growth * growth)
    report.warn(warning::end_growth_missed,
                fmt::format("--grading {}: adjacent elements along it differ by a factor of {:.3g}, more than --growth "
                            "{:g}: its end lengths with the number of elements in --count require it",
                            boundary, ratio, growth));
}

std::optional<double> length_of(const std::string& text) {
  if (text.empty()) return 0;
  const std::optional<double> value = finite_number_of(text);
  return value && *value >= 0 ? value : std::nullopt;
}

}  // namespace

EndGrading parse_end_grading(const std::string& text) {
  const std::size_t equals = text.rfind('='), colon = text.rfind(':');
  if (equals != std::string::npos && equals > 0 && colon != std::string::npos && colon > equals) {
    const std::optional<double> first = length_of(text.substr(equals + 1, colon - equals - 1));
    const std::optional<double> last = length_of(text.substr(colon + 1));
    if (first && last && *first + *last > 0) return {text.substr(0, equals), *first, *last};
  }
  throw UsageError(
      fmt::format("--grading: '{}' is not NAME=FIRST:LAST with lengths of the elements at the two ends, of "
                  "which one may be left out",
                  text));
}

void apply_end_gradings(const sizing::MeasuredLayout& measured, const std::vector<EndGrading>& gradings, double growth,
                        std::vector<sizing::ChordPlan>& plans) {
  std::vector<std::vector<EndLength>> by_chord(plans.size());
  for (const EndGrading& grading : gradings)
    for (const ArcChain& chain : chains_of(measured, grading.boundary))
      add_chain(measured, {chain, grading.first, grading.last}, plans, by_chord);
  const double slope = std::log(growth);
  for (std::size_t c = 0; c < plans.size(); ++c) {
    const int chord = static_cast<int>(c);
    if (by_chord[c].empty()) continue;
    if (plans[c].is_prescribed)
      grade_counted(end_parameters(measured, chord, by_chord[c], plans[c], slope), plans[c]);
    else
      plans[c] = GradedChord(measured, chord, by_chord[c], plans[c]).plan(slope);
  }
}

void report_end_gradings(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                         const std::vector<EndGrading>& gradings, double growth,
                         const std::vector<sizing::ChordCount>& counts, Report& report) {
  std::set<int> counted;
  for (const sizing::ChordCount& count : counts) counted.insert(count.chord);
  const auto is_counted = [&](HalfEdge half) { return counted.contains(measured.chord_of(half.arc)); };
  for (std::size_t i = 0; i < gradings.size(); ++i) {
    const EndGrading& grading = gradings[i];
    report.set(fmt::format("gradings.{}.boundary", i), grading.boundary);
    for (const ArcChain& chain : chains_of(measured, grading.boundary)) {
      const std::vector<double> lengths = element_lengths(measured, divisions, chain);
      const double first = lengths.front(), last = lengths.back();
      if (grading.first > 0) {
        report.set(fmt::format("gradings.{}.first", i), first);
        warn_if_missed(grading.boundary, grading.first, first, report);
      }
      if (grading.last > 0) {
        report.set(fmt::format("gradings.{}.last", i), last);
        warn_if_missed(grading.boundary, grading.last, last, report);
      }
      double ratio = 1;
      for (std::size_t k = 1; k < lengths.size(); ++k)
        ratio = std::max({ratio, lengths[k] / lengths[k - 1], lengths[k - 1] / lengths[k]});
      report.set(fmt::format("gradings.{}.growth", i), ratio);
      if (std::ranges::any_of(chain, is_counted)) warn_if_steep(grading.boundary, ratio, growth, report);
    }
  }
}

}  // namespace quadrille::prescribe
