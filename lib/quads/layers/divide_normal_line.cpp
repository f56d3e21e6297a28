#include "layers/divide_normal_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "layers/layer_law.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

[[noreturn]] void refuse(Vec2 position) {
  throw ComputeError(
      fmt::format("--wall: the layers do not fit into the block beside the wall at {}", position_text(position)));
}

void append(std::vector<double>& to, const std::vector<double>& more) { to.insert(to.end(), more.begin(), more.end()); }

/// The intervals times e^(tilt weight), with the tilt for which they sum to `total`.
std::vector<double> tilted(const std::vector<double>& intervals, const std::vector<double>& weights, double total) {
  const auto sum = [&](double tilt) {
    double result = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) result += intervals[i] * std::exp(tilt * weights[i]);
    return result;
  };
  double low = -5, high = 5;
  for (int step = 0; step < 60; ++step) {
    const double tilt = (low + high) / 2;
    (sum(tilt) < total ? low : high) = tilt;
  }
  const double tilt = (low + high) / 2, factor = total / sum(tilt);
  std::vector<double> result;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    result.push_back(intervals[i] * std::exp(tilt * weights[i]) * factor);
  return result;
}

double speed_at(const NormalLine& line, double u) {
  constexpr double step = 1e-4;
  const double low = std::max(0.0, u - step), high = std::min(1.0, u + step);
  return distance(line(low), line(high)) / (high - low);
}

/// Nodes of elements with these lengths, as fractions of their sum from 0 to 1.
std::vector<double> node_fractions(const std::vector<double>& lengths, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  double total = 0, low = 0;
  for (const double length : lengths) total += length;
  std::vector<double> fractions{0.0};
  for (const double length : lengths) {
    for (int i = 1; i <= order; ++i) fractions.push_back((low + length * (1 + gll[i]) / 2) / total);
    low += length;
  }
  fractions.back() = 1;
  return fractions;
}

std::vector<double> nodes_in_layers(const NormalLine& line, const SideLayers& side, const std::vector<double>& heights,
                                    std::size_t node, int order, Vec2 origin) {
  const WallPoint foot = side.feet[node];
  std::vector<double> u = parameters_at_heights(
      line, *side.wall, foot,
      side.own_intervals > 0
          ? node_heights(compressed_heights(side.heights, height_of_end(line, *side.wall, foot), side.own_intervals),
                         order)
          : heights);
  if (u.size() < heights.size()) refuse(line(0) + origin);
  return u;
}

/// Intervals between the layers, in u: u measures length on the arcs beside the line, and on the line up to a factor.
/// So a line that is one of the arcs has exactly its division.
std::vector<double> free_intervals(const LineFamily& family, const NormalLine& line, double low, double high,
                                   double blend) {
  const std::size_t first = family.low.heights.size(), last = family.left.size() - family.high.heights.size();
  const bool from_low = family.low.wall != nullptr, from_high = family.high.wall != nullptr;
  const double low_speed = speed_at(line, low), high_speed = speed_at(line, high);
  const double count = static_cast<double>(last - first + 1);
  std::vector<double> intervals, weights;
  for (std::size_t k = first; k < last; ++k) {
    const double i = static_cast<double>(k - first + 1);
    const double x = !from_high ? 0 : !from_low ? 1 : i / count;
    intervals.push_back(std::pow(family.left[k], 1 - blend) * std::pow(family.right[k], blend) /
                        (std::pow(low_speed, 1 - x) * std::pow(high_speed, x)));
    weights.push_back(!from_high ? i : !from_low ? count - i : 2 * i * (count - i) / count);
  }
  return tilted(intervals, weights, high - low);
}

/// The nodes of a line in the layers of both ends, the ends included.
struct LayerNodes {
  std::vector<double> low, high;
};

LayerNodes layer_nodes(const LineFamily& family, const NormalLine& line, std::size_t node, Vec2 origin) {
  LayerNodes nodes{{0.0}, {1.0}};
  if (family.low.wall)
    append(nodes.low, nodes_in_layers(line, family.low, family.low_heights, node, family.order, origin));
  if (family.high.wall) {
    const NormalLine reversed = [&line](double u) { return line(1 - u); };
    for (const double u : nodes_in_layers(reversed, family.high, family.high_heights, node, family.order, origin))
      nodes.high.push_back(1 - u);
    std::reverse(nodes.high.begin(), nodes.high.end());
  }
  if (nodes.low.back() >= nodes.high.front()) refuse(line(nodes.low.back()) + origin);
  return nodes;
}

double length_between(const NormalLine& line, double low, double high) {
  constexpr int samples = 32;
  double length = 0;
  for (int k = 0; k < samples; ++k)
    length += distance(line(low + (high - low) * k / samples), line(low + (high - low) * (k + 1) / samples));
  return length;
}

/// Steps of the parameter whose lengths are as prescribed, up to a common factor: they follow the speed of the line at
/// the middle of each.
std::vector<double> parameter_steps(const NormalLine& line, double low, double high,
                                    const std::vector<double>& lengths) {
  constexpr int rounds = 3;
  std::vector<double> steps = lengths;
  for (int round = 0; round < rounds; ++round) {
    double total = 0, at = low;
    for (const double step : steps) total += step;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const double step = steps[k] * (high - low) / total;
      steps[k] = lengths[k] / speed_at(line, at + step / 2);
      at += step;
    }
  }
  return steps;
}

/// The middles of intervals of these lengths, as fractions of their sum.
std::vector<double> middles(const std::vector<double>& lengths) {
  double total = 0, low = 0;
  for (const double length : lengths) total += length;
  std::vector<double> fractions;
  for (const double length : lengths) {
    fractions.push_back((low + length / 2) / total);
    low += length;
  }
  return fractions;
}

/// The intervals of the arcs beside a line, blended in proportion to its distances from both there. `blend`: at its
/// ends.
std::vector<double> blended_sizes(const LineFamily& family, const std::array<double, 2>& blend) {
  const std::vector<double> left = middles(family.left), right = middles(family.right);
  const double mean = (blend[0] + blend[1]) / 2;
  std::vector<double> sizes;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double u = (1 - mean) * left[k] + mean * right[k], own = blend[0] + u * (blend[1] - blend[0]);
    sizes.push_back(std::pow(family.left[k], 1 - own) * std::pow(family.right[k], own));
  }
  return sizes;
}

}  // namespace

LineFamily line_family(const SideLayers& low, const SideLayers& high, std::vector<double> left,
                       std::vector<double> right, int order) {
  LineFamily family{low, high, std::move(left), std::move(right), order};
  family.low_heights = node_heights(low.heights, order);
  family.high_heights = node_heights(high.heights, order);
  return family;
}

BlockLine measured_line(const LineFamily& family, const NormalLine& line, std::size_t node,
                        const std::array<double, 2>& blend, Vec2 origin) {
  const LayerNodes ends = layer_nodes(family, line, node, origin);
  const std::size_t first = family.low.heights.size(), last = family.left.size() - family.high.heights.size();
  const std::vector<double> sizes = blended_sizes(family, blend);
  const auto step = [&](const std::vector<double>& nodes, std::size_t k) {
    return distance(line(nodes[k]), line(nodes[k + family.order]));
  };
  BlockLine result;
  result.length = length_between(line, ends.low.back(), ends.high.front());
  for (std::size_t k = first; k < last; ++k) result.sizes.push_back(sizes[k]);
  if (first > 0) {
    result.before = step(ends.low, ends.low.size() - 1 - family.order);
    result.before_size = sizes[first - 1];
  }
  if (last < family.left.size()) {
    result.after = step(ends.high, 0);
    result.after_size = sizes[last];
  }
  return result;
}

std::vector<double> divide_normal_line(const LineFamily& family, const NormalLine& line, std::size_t node, double blend,
                                       Vec2 origin, const std::vector<double>* lengths) {
  auto [nodes, top] = layer_nodes(family, line, node, origin);
  const double low = nodes.back(), high = top.front();
  const std::vector<double> intervals =
      lengths ? parameter_steps(line, low, high, *lengths) : free_intervals(family, line, low, high, blend);
  const std::vector<double> fractions = node_fractions(intervals, family.order);
  for (std::size_t k = 1; k < fractions.size(); ++k) nodes.push_back(low + fractions[k] * (high - low));
  append(nodes, {top.begin() + 1, top.end()});
  return nodes;
}

}  // namespace quadrille::layers
