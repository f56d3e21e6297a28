#include "layers/layer_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "layers/layer_law.hpp"
#include "layers/layer_rules.hpp"

namespace quadrille::layers {
namespace {

/// The criterion for the count of a chord.
enum class FitRule {
  even,      ///< clearance, and no crowding at narrow positions
  clearance  ///< clearance alone
};

struct FittedLayers {
  std::vector<int> counts;                   ///< by spec
  std::vector<std::optional<Vec2>> misfits;  ///< by spec: a position where a greater number did not fit
};

/// Front and back wall of a line, by spec.
using WallPair = std::pair<int, int>;

/// The extremes of the lines of one chord between the same walls.
struct LineRange {
  FreePart widest, narrowest;
  const NormalLineSample* narrow = nullptr;
};
using ChordRanges = std::map<int, std::map<WallPair, LineRange>>;

/// The prescribed number; for layers=fit the number of layers lower than the lowest far side.
int first_count(const WallSpec& spec, int number, const std::vector<NormalLineSample>& lines) {
  if (!spec.as_many_as_fit) return requested_layers(spec);
  double lowest = 1e300;
  for (const NormalLineSample& line : lines) {
    if (line.front == number) lowest = std::min(lowest, line.front_heights.back());
    if (line.back == number) lowest = std::min(lowest, line.back_heights.back());
  }
  int count = 1;
  while (count < layer_constants.max_layers && layer_heights(spec, count + 1).back() < lowest) ++count;
  return count;
}

std::vector<std::vector<double>> heights_of(const std::vector<WallSpec>& specs, const std::vector<int>& counts) {
  std::vector<std::vector<double>> heights;
  for (std::size_t i = 0; i < specs.size(); ++i)
    heights.push_back(counts[i] > 0 ? layer_heights(specs[i], counts[i]) : std::vector<double>());
  return heights;
}

/// Whether intervals as long as the last layers fit above them.
bool has_clearance(const FreePart& part) {
  return layer_constants.greatest_change * part.length >= std::max(part.ends.before, part.ends.after);
}

double growth_between(const std::vector<WallSpec>& specs, const WallPair& walls) {
  const double front = growth_beyond(specs[walls.first]);
  return walls.second < 0 ? front : std::min(front, growth_beyond(specs[walls.second]));
}

bool is_crowded(const FreePart& part, int count, double growth) {
  if (part.ends.are_free()) return false;
  const std::vector<double> intervals =
      sizing::graded_intervals(part.ends, count - part.layers, part.length, part.size);
  return sizing::worst_growth(part.ends, intervals) >
         (1 + layer_constants.equal_tol) * std::max(growth, layer_constants.greatest_change);
}

/// The narrowest lines of a chord that become crowded by the count that its widest lines need.
void find_crowded(const std::vector<WallSpec>& specs, const std::map<WallPair, LineRange>& ranges,
                  std::vector<const NormalLineSample*>& misfits) {
  int count = 0;
  double growth = 2;
  for (const auto& [walls, range] : ranges) growth = std::min(growth, growth_between(specs, walls));
  for (const auto& [walls, range] : ranges) {
    const FreePart& wide = range.widest;
    count = std::max(count, wide.layers + sizing::least_graded_count(wide.ends, wide.length, wide.size, growth,
                                                                     layer_constants.max_intervals));
  }
  for (const auto& [walls, range] : ranges)
    if (is_crowded(range.narrowest, count, growth)) misfits.push_back(range.narrow);
}

/// Lines on which these numbers of layers do not fit.
std::vector<const NormalLineSample*> find_misfits(const std::vector<WallSpec>& specs, const std::vector<int>& counts,
                                                  const std::vector<NormalLineSample>& lines, FitRule rule) {
  const std::vector<std::vector<double>> heights = heights_of(specs, counts);
  std::vector<const NormalLineSample*> misfits;
  ChordRanges chords;
  for (const NormalLineSample& line : lines) {
    const FreePart part = part_between_layers(line, heights);
    if (!has_clearance(part)) {
      misfits.push_back(&line);
      continue;
    }
    LineRange& range = chords[line.chord][{line.front, line.back}];
    if (!range.narrow || part.length > range.widest.length) range.widest = part;
    if (!range.narrow || part.length < range.narrowest.length) range.narrowest = part, range.narrow = &line;
  }
  if (rule == FitRule::even)
    for (const auto& [chord, ranges] : chords) find_crowded(specs, ranges, misfits);
  return misfits;
}

/// Lowers the numbers of all walls of lines on which layers do not fit, by one each, until they fit everywhere.
FittedLayers fit_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines, FitRule rule) {
  FittedLayers fitted{{}, std::vector<std::optional<Vec2>>(specs.size())};
  for (std::size_t i = 0; i < specs.size(); ++i)
    fitted.counts.push_back(first_count(specs[i], static_cast<int>(i), lines));
  for (;;) {
    std::set<int> too_many;
    for (const NormalLineSample* line : find_misfits(specs, fitted.counts, lines, rule))
      for (const int spec : {line->front, line->back}) {
        if (spec < 0 || fitted.counts[spec] == 0) continue;
        too_many.insert(spec);
        if (!fitted.misfits[spec]) fitted.misfits[spec] = line->far_end;
      }
    if (too_many.empty()) return fitted;
    for (const int spec : too_many) --fitted.counts[spec];
  }
}

[[noreturn]] void refuse(const WallSpec& spec, int count, Vec2 position) {
  const std::string most =
      count == 0 ? "not even one fits: make the first one thinner"
                 : fmt::format("at most {} fit, with a thickness of {:.6g}: ask for as many as fit (layers=fit)", count,
                               layer_heights(spec, count).back());
  throw ComputeError(
      fmt::format("--wall {}: the layers do not fit between the wall and the far side of its blocks at {}; {}{}",
                  fmt::join(spec.names, ","), position_text(position), most,
                  spec.own_blocks ? "" : ", or give them blocks of their own (blocks=own)"));
}

}  // namespace

double growth_beyond(const WallSpec& spec) { return std::max(spec.growth, layer_constants.least_growth); }

std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                                Vec2 origin, bool may_crowd) {
  // As many as fit are as many as leave room for intervals that grow evenly.
  const bool any_fits = std::any_of(specs.begin(), specs.end(), [](const WallSpec& s) { return s.as_many_as_fit; });
  FittedLayers fitted = fit_layers(specs, lines, may_crowd && !any_fits ? FitRule::clearance : FitRule::even);
  // If the width of a chord varies strongly, no number of layers prevents crowding at narrow positions.
  if (std::count(fitted.counts.begin(), fitted.counts.end(), 0) > 0)
    fitted = fit_layers(specs, lines, FitRule::clearance);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const int count = fitted.counts[i];
    const bool fits = count > 0 && (specs[i].as_many_as_fit || count == requested_layers(specs[i]));
    if (!fits) refuse(specs[i], count, fitted.misfits[i].value_or(Vec2{}) + origin);
  }
  return fitted.counts;
}

}  // namespace quadrille::layers
