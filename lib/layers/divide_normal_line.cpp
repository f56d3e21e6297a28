#include "layers/divide_normal_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/position_text.hpp"
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
                                    std::size_t node, Vec2 origin) {
  std::vector<double> u = parameters_at_heights(line, *side.wall, side.feet[node], heights);
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

}  // namespace

LineFamily line_family(const SideLayers& low, const SideLayers& high, std::vector<double> left,
                       std::vector<double> right, int order) {
  LineFamily family{low, high, std::move(left), std::move(right), order};
  family.low_heights = node_heights(low.heights, order);
  family.high_heights = node_heights(high.heights, order);
  return family;
}

std::vector<double> divide_normal_line(const LineFamily& family, const NormalLine& line, std::size_t node, double blend,
                                       Vec2 origin) {
  std::vector<double> nodes{0.0};
  if (family.low.wall) append(nodes, nodes_in_layers(line, family.low, family.low_heights, node, origin));
  std::vector<double> top{1.0};
  if (family.high.wall) {
    const NormalLine reversed = [&line](double u) { return line(1 - u); };
    for (const double u : nodes_in_layers(reversed, family.high, family.high_heights, node, origin))
      top.push_back(1 - u);
    std::reverse(top.begin(), top.end());
  }
  const double low = nodes.back(), high = top.front();
  if (low >= high) refuse(line(low) + origin);
  const std::vector<double> fractions = node_fractions(free_intervals(family, line, low, high, blend), family.order);
  for (std::size_t k = 1; k < fractions.size(); ++k) nodes.push_back(low + fractions[k] * (high - low));
  append(nodes, {top.begin() + 1, top.end()});
  return nodes;
}

}  // namespace quadrille::layers
