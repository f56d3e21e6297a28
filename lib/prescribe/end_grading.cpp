#include "prescribe/end_grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "mesh/chords.hpp"
#include "prescribe/named_arcs.hpp"

namespace quadrille::prescribe {
namespace {

constexpr int uniform_samples = 96;
constexpr double least_sample = 1e-7;  ///< samples near both ends double from here
constexpr double steepest = 3;         ///< |s|, if the count is prescribed
constexpr double least_length = 1e-3;  ///< of the prescribed one, where elements shrink away from the end
constexpr double derivative_step = 1e-5;
constexpr double missed = 1.2;  ///< factor of an achieved length that is reported

using ArcChain = std::vector<HalfEdge>;

/// The prescribed length at the end of a chain of arcs, as one of its arcs sees it.
struct EndLength {
  int arc = 0;               ///< position in the chord
  bool is_from_end = false;  ///< the distance grows against the arc's own direction
  double offset = 0;         ///< distance of the arc from the end of the chain
  double length = 0;         ///< prescribed
};

/// l_0 of the header.
double start_length(double length, double s) { return std::abs(s) < 1e-9 ? length : length * s / std::expm1(s); }

class GradedChord {
 public:
  GradedChord(const sizing::MeasuredLayout& measured, int chord, const std::vector<EndLength>& ends,
              const sizing::ChordPlan& plan)
      : measured_(measured), chord_(measured.chords()[chord]), ends_(ends), plan_(plan) {
    std::set<double> samples(plan.grading.samples().begin(), plan.grading.samples().end());
    for (int k = 0; k <= uniform_samples; ++k) samples.insert(static_cast<double>(k) / uniform_samples);
    for (double u = least_sample; u < 0.5; u *= 2) samples.insert({u, 1 - u});
    u_.assign(samples.begin(), samples.end());
    u_.erase(std::unique(u_.begin(), u_.end(), [](double a, double b) { return b - a < least_sample / 2; }), u_.end());
    u_.back() = 1;
  }

  /// The plan with the ratio exp(s) that gives a whole number of elements.
  sizing::ChordPlan plan(double slope) const {
    sizing::ChordPlan result = plan_;
    double low = plan_.is_prescribed ? -steepest : 1e-6, high = plan_.is_prescribed ? steepest : slope;
    const double at_low = grading(low).count(), at_high = grading(high).count();
    const bool rises = at_low < at_high;  // with s: elements shrink away from the ends
    if (!plan_.is_prescribed) result.count = whole_count(at_low, at_high);
    if (!rises && at_low < result.count) low = high;
    for (int step = 0; step < 50 && low < high; ++step) {
      const double middle = (low + high) / 2;
      ((grading(middle).count() > result.count) != rises ? low : high) = middle;
    }
    result.grading = grading(high);
    result.slope = std::max(plan_.slope, std::abs(high));
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
    const double low = std::max(0.0, u - derivative_step), high = std::min(1.0, u + derivative_step);
    return length * (high - low) / std::abs(distance(end, high) - distance(end, low));
  }

  double element_length(double u, double s) const {
    const bool is_free = plan_.is_prescribed;  // of sizes: the count alone is prescribed
    double most = std::numeric_limits<double>::infinity(), least = 0;
    for (const EndLength& end : ends_) {
      const double x = distance(end, u);
      const double growing = std::max(start_length(end.length, s) + s * x, least_length * end.length);
      const double shrinking = start_length(end.length, -std::abs(s)) - std::abs(s) * x;
      most = std::min(most, in_parameter(end, u, growing));
      least = std::max(least, in_parameter(end, u, is_free ? growing : std::max(shrinking, 0.0)));
    }
    if (is_free) return s > 0 ? most : least;
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

/// The arcs of a boundary as chains from end to end.
std::vector<ArcChain> chains_of(const sizing::MeasuredLayout& measured, const std::string& name) {
  const std::vector<GraphArc>& all = measured.blocks().arcs;
  std::vector<HalfEdge> arcs = named_arcs(measured, name, "--grading");
  std::set<int> ends;
  for (const HalfEdge arc : arcs) ends.insert(end_of(all, arc));
  std::vector<ArcChain> chains;
  const auto take_from = [&](int node) {
    return std::find_if(arcs.begin(), arcs.end(), [&](HalfEdge arc) { return start_of(all, arc) == node; });
  };
  while (!arcs.empty()) {
    auto next = std::find_if(arcs.begin(), arcs.end(), [&](HalfEdge a) { return !ends.contains(start_of(all, a)); });
    if (next == arcs.end())
      throw UsageError(
          fmt::format("--grading {0}: the boundary '{0}' is closed, it has no ends: use --size-near", name));
    ArcChain& chain = chains.emplace_back();
    while (next != arcs.end()) {
      chain.push_back(*next);
      arcs.erase(next);
      next = take_from(end_of(all, chain.back()));
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
    const int chord = measured.chord_of(half.arc);
    const std::vector<int>& arcs = measured.chords()[chord].arcs;
    const int position = static_cast<int>(std::find(arcs.begin(), arcs.end(), half.arc) - arcs.begin());
    by_chord[chord].push_back({position, half.is_backwards, offset, length});
    offset += measured.length(half.arc);
  }
}

double first_length(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions, HalfEdge half) {
  const std::vector<double>& ends = divisions[half.arc].ends;
  const double fraction = half.is_backwards ? 1 - ends[ends.size() - 2] : ends[1];
  return fraction * measured.length(half.arc);
}

void warn_if_missed(const std::string& boundary, double prescribed, double achieved, Report& report) {
  if (std::max(achieved / prescribed, prescribed / achieved) > missed)
    report.warn(warning::end_length_missed,
                fmt::format("--grading {}: an element at its end is {:.3g} long, not {:.3g}: another boundary of its "
                            "chord, wall layers or the number of elements require it",
                            boundary, achieved, prescribed));
}

std::optional<double> length_of(const std::string& text) {
  if (text.empty()) return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_length = error == std::errc() && end == text.data() + text.size() && value >= 0 && std::isfinite(value);
  return is_length ? std::optional<double>(value) : std::nullopt;
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
    for (const ArcChain& chain : chains_of(measured, grading.boundary)) {
      if (grading.first > 0) add_end(measured, chain, grading.first, by_chord);
      if (grading.last > 0) add_end(measured, reversed(chain), grading.last, by_chord);
    }
  for (std::size_t c = 0; c < plans.size(); ++c)
    if (!by_chord[c].empty())
      plans[c] = GradedChord(measured, static_cast<int>(c), by_chord[c], plans[c]).plan(std::log(growth));
}

void report_end_gradings(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                         const std::vector<EndGrading>& gradings, Report& report) {
  for (std::size_t i = 0; i < gradings.size(); ++i) {
    const EndGrading& grading = gradings[i];
    report.set(fmt::format("gradings.{}.boundary", i), grading.boundary);
    for (const ArcChain& chain : chains_of(measured, grading.boundary)) {
      const double first = first_length(measured, divisions, chain.front());
      const double last = first_length(measured, divisions, chain.back().reversed());
      if (grading.first > 0) {
        report.set(fmt::format("gradings.{}.first", i), first);
        warn_if_missed(grading.boundary, grading.first, first, report);
      }
      if (grading.last > 0) {
        report.set(fmt::format("gradings.{}.last", i), last);
        warn_if_missed(grading.boundary, grading.last, last, report);
      }
    }
  }
}

}  // namespace quadrille::prescribe
