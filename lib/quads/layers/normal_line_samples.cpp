#include "layers/normal_line_samples.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "layers/layer_law.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/block_sides.hpp"
#include "mesh/transfinite.hpp"

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

}  // namespace

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
      NormalLineSample line{measured.chord_of(begin),
                            wall.spec,
                            far < 0 ? -1 : walls.sides[far].spec,
                            0,
                            {},
                            {},
                            {},
                            {},
                            {wall.own_intervals, far >= 0 ? walls.sides[far].own_intervals : 0}};
      line.size = (1 - x) * arc_sizes[begin] + x * arc_sizes[end];
      line.lengths = lengths_along(points);
      line.far_end = points.back();
      line.front_heights = heights_along(measured, wall, points, x);
      std::reverse(points.begin(), points.end());
      if (far >= 0) line.back_heights = heights_along(measured, walls.sides[far], points, 1 - x);
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

}  // namespace quadrille::layers
