#include "layers/layer_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "layers/layer_rules.hpp"
#include "layers/wall_spec.hpp"
#include "mesh/chords.hpp"
#include "mesh/transfinite.hpp"
#include "surface/positions.hpp"

namespace quadrille::layers {
namespace {

mesh::TransfiniteMap block_map(const sizing::MeasuredLayout& measured, int block) {
  std::array<const curve::Chain*, 4> sides{};
  std::array<bool, 4> backwards{};
  for (int k = 0; k < 4; ++k) {
    const HalfEdge half = mesh::half_edge(measured.blocks(), block, k);
    sides[k] = &measured.chain(half.arc);
    backwards[k] = half.is_backwards;
  }
  return mesh::TransfiniteMap(sides, backwards);
}

/// A point of the block in the frame of its side k: x along that side, y away from it.
Vec2 in_frame(const mesh::TransfiniteMap& map, int k, double x, double y) {
  switch (k) {
    case 0:
      return map.position(x, y);
    case 1:
      return map.position(1 - y, x);
    case 2:
      return map.position(1 - x, 1 - y);
    default:
      return map.position(y, 1 - x);
  }
}

/// The line at the fraction x of the side, at Chebyshev points.
std::vector<Vec2> line_points(const mesh::TransfiniteMap& map, int side, double x) {
  std::vector<Vec2> points;
  for (int i = 0; i <= layer_constants.samples_per_line; ++i)
    points.push_back(in_frame(map, side, x, (1 - std::cos(pi * i / layer_constants.samples_per_line)) / 2));
  return points;
}

std::vector<double> lengths_along(const std::vector<Vec2>& points) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(lengths.back() + distance(points[i - 1], points[i]));
  return lengths;
}

/// Heights of the points of a line that starts at the fraction x of the wall's side.
std::vector<double> heights_along(const sizing::MeasuredLayout& measured, const WallSide& wall,
                                  const std::vector<Vec2>& points, double x) {
  const HalfEdge half = mesh::half_edge(measured.blocks(), wall.block, wall.side);
  WallPoint foot = wall_point(wall, measured.chain(half.arc).at(half.is_backwards ? 1 - x : x), half.is_backwards);
  std::vector<double> heights;
  for (const Vec2 point : points) heights.push_back(wall.line.distance(point, foot));
  return heights;
}

double scale_range(const WallLine& wall, const std::vector<Vec2>& points) {
  double least = HUGE_VAL, greatest = 0;
  for (const Vec2 x : points) {
    const double scale = wall.scale_at(x);
    least = std::min(least, scale), greatest = std::max(greatest, scale);
  }
  return greatest / least;
}

/// Length at which the line first reaches the height, negative if it turns back before.
double length_at(const std::vector<double>& heights, const std::vector<double>& lengths, double height) {
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (heights[i] <= heights[i - 1]) return -1;
    if (heights[i] < height) continue;
    const double fraction = (height - heights[i - 1]) / (heights[i] - heights[i - 1]);
    return lengths[i - 1] + fraction * (lengths[i] - lengths[i - 1]);
  }
  return -1;
}

/// The lengths measured from the other end.
std::vector<double> from_end(const std::vector<double>& lengths) {
  std::vector<double> result;
  for (std::size_t i = lengths.size(); i-- > 0;) result.push_back(lengths.back() - lengths[i]);
  return result;
}

/// Subtracts the layers of one end from the free part.
void subtract_layers(const std::vector<double>& prescribed, int own_intervals, const std::vector<double>& heights,
                     const std::vector<double>& lengths, FreePart& part, double& last_layer) {
  if (prescribed.empty() || part.length < 0) return;
  const std::vector<double> layers =
      own_intervals > 0 ? compressed_heights(prescribed, heights.back(), own_intervals) : prescribed;
  const double top = length_at(heights, lengths, layers.back());
  const double below = layers.size() > 1 ? length_at(heights, lengths, layers[layers.size() - 2]) : 0;
  part.layers += static_cast<int>(layers.size());
  part.length = top < 0 ? -1 : part.length - top;
  last_layer = top - below;
}

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

double growth_between(const std::vector<WallSpec>& specs, const WallPair& walls, const NormalLineSample& line) {
  const auto growth = [&](int spec) { return growth_beyond(specs[spec]) * chart_growth_factor(specs[spec], line); };
  return walls.second < 0 ? growth(walls.first) : std::min(growth(walls.first), growth(walls.second));
}

bool is_crowded(const FreePart& part, int count, double growth) {
  if (part.ends.are_free()) return false;
  const std::vector<double> intervals = graded_intervals(part.ends, count - part.layers, part.length, part.size);
  return worst_growth(part.ends, intervals) > (1 + tolerance::tied) * std::max(growth, layer_constants.greatest_change);
}

/// The narrowest lines of a chord that become crowded by the count that its widest lines need.
void find_crowded(const std::vector<WallSpec>& specs, const std::map<WallPair, LineRange>& ranges,
                  std::vector<const NormalLineSample*>& misfits) {
  int count = 0;
  double growth = 2;
  for (const auto& [walls, range] : ranges) growth = std::min(growth, growth_between(specs, walls, *range.narrow));
  for (const auto& [walls, range] : ranges) {
    const FreePart& wide = range.widest;
    count = std::max(count, wide.layers + least_graded_count(wide.ends, wide.length, wide.size, growth,
                                                             layer_constants.max_intervals));
  }
  for (const auto& [walls, range] : ranges)
    if (is_crowded(range.narrowest, count, growth)) misfits.push_back(range.narrow);
}

/// Lines on which these numbers of layers do not fit: for want of clearance, or as narrow positions are crowded.
std::vector<const NormalLineSample*> find_misfits(const std::vector<WallSpec>& specs, const std::vector<int>& counts,
                                                  const std::vector<NormalLineSample>& lines, bool may_crowd) {
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
  if (!may_crowd)
    for (const auto& [chord, ranges] : chords) find_crowded(specs, ranges, misfits);
  return misfits;
}

/// Lowers the numbers of all walls of lines on which layers do not fit, by one each, until they fit everywhere.
FittedLayers fit_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                        bool may_crowd) {
  FittedLayers fitted{{}, std::vector<std::optional<Vec2>>(specs.size())};
  for (std::size_t i = 0; i < specs.size(); ++i)
    fitted.counts.push_back(first_count(specs[i], static_cast<int>(i), lines));
  for (;;) {
    std::set<int> too_many;
    for (const NormalLineSample* line : find_misfits(specs, fitted.counts, lines, may_crowd))
      for (const int spec : {line->front, line->back}) {
        if (spec < 0 || fitted.counts[spec] == 0) continue;
        too_many.insert(spec);
        if (!fitted.misfits[spec]) fitted.misfits[spec] = line->far_end;
      }
    if (too_many.empty()) return fitted;
    for (const int spec : too_many) --fitted.counts[spec];
  }
}

[[noreturn]] void refuse(const WallSpec& spec, int count, const CadFace& face, Vec2 position) {
  const std::string most =
      count == 0 ? "not even one fits: make the first one thinner"
                 : fmt::format("at most {} fit, with a thickness of {:.6g}: ask for as many as fit (layers=fit)", count,
                               layer_heights(spec, count).back());
  throw ComputeError(
      fmt::format("--wall {}: the layers do not fit between the wall and the far side of its blocks at {}; {}{}",
                  fmt::join(spec.names, ","), surface::position_text(face, position), most,
                  spec.own_blocks ? "" : ", or give them blocks of their own (blocks=own)"));
}

}  // namespace

double chart_growth_factor(const WallSpec& spec, const NormalLineSample& line) {
  return spec.own_blocks ? line.scale_range : 1;
}

std::vector<NormalLineSample> sample_normal_lines(const sizing::MeasuredLayout& measured, const WallSides& walls,
                                                  const std::vector<double>& arc_sizes) {
  std::vector<NormalLineSample> lines;
  for (const WallSide& wall : walls.sides) {
    const int far = walls.of_block[wall.block][(wall.side + 2) % 4];
    if (far >= 0 && wall.side >= 2) continue;  // sampled from the other side
    const mesh::TransfiniteMap map = block_map(measured, wall.block);
    const int begin = mesh::half_edge(measured.blocks(), wall.block, wall.side - 1).arc;
    const int end = mesh::half_edge(measured.blocks(), wall.block, wall.side + 1).arc;
    for (int k = 0; k < layer_constants.lines_per_block; ++k) {
      const double x = static_cast<double>(k) / (layer_constants.lines_per_block - 1);
      std::vector<Vec2> points = line_points(map, wall.side, x);
      NormalLineSample line;
      line.chord = measured.chord_of(begin), line.front = wall.spec;
      line.size = (1 - x) * arc_sizes[begin] + x * arc_sizes[end];
      line.lengths = lengths_along(points);
      line.far_end = points.back();
      line.scale_range = scale_range(wall.line, points);
      line.front_heights = heights_along(measured, wall, points, x);
      std::reverse(points.begin(), points.end());
      line.own_intervals[0] = wall.own_intervals;
      if (far >= 0) {
        line.back = walls.sides[far].spec;
        line.back_heights = heights_along(measured, walls.sides[far], points, 1 - x);
        line.own_intervals[1] = walls.sides[far].own_intervals;
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

FreePart part_between_layers(const NormalLineSample& line, const std::vector<std::vector<double>>& spec_heights) {
  FreePart part{{}, line.lengths.back(), line.size, 0};
  if (line.front >= 0)
    subtract_layers(spec_heights[line.front], line.own_intervals[0], line.front_heights, line.lengths, part,
                    part.ends.before);
  if (line.back >= 0)
    subtract_layers(spec_heights[line.back], line.own_intervals[1], line.back_heights, from_end(line.lengths), part,
                    part.ends.after);
  return part;
}

std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                                const CadFace& face, bool may_crowd) {
  // As many as fit are as many as leave room for intervals that grow evenly.
  const bool any_fits = std::any_of(specs.begin(), specs.end(), [](const WallSpec& s) { return s.as_many_as_fit; });
  FittedLayers fitted = fit_layers(specs, lines, may_crowd && !any_fits);
  // If the width of a chord varies strongly, no number of layers prevents crowding at narrow positions.
  if (std::count(fitted.counts.begin(), fitted.counts.end(), 0) > 0) fitted = fit_layers(specs, lines, true);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const int count = fitted.counts[i];
    const bool fits = count > 0 && (specs[i].as_many_as_fit || count == requested_layers(specs[i]));
    if (!fits) refuse(specs[i], count, face, fitted.misfits[i].value_or(Vec2{}));
  }
  return fitted.counts;
}

}  // namespace quadrille::layers
