#include "layers/normal_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "layers/wall_spec.hpp"
#include "spectral/quadrature.hpp"
#include "surface/positions.hpp"

namespace quadrille::layers {
namespace {

struct LineConstants {
  int max_steps = 60;         ///< of a search
  double height_tol = 1e-11;  ///< relative accuracy of the heights
  double speed_step = 1e-4;   ///< of the parameter, for derivatives
  int end_samples = 16;       ///< between the wall and the end of a line, for its height there
  int length_samples = 32;    ///< of the part between the layers
  int parameter_rounds = 3;   ///< in which steps of the parameter follow the speed of the line
};
constexpr LineConstants line_constants;

/// A parameter of the line and the height there.
struct LineSample {
  double u = 0, height = 0;
};

class HeightSearch {
 public:
  HeightSearch(const NormalLine& line, const WallLine& wall, WallPoint foot) : line_(line), wall_(wall), foot_(foot) {}

  /// The first parameter, beyond the parameter of the last height, at which this height is reached; -1 if there is
  /// none.
  double next(double height) {
    LineSample low = last_, high;
    double step = last_.u > 0 ? 1.1 * (height - last_.height) * rate_ : first_step(height);
    for (;; step *= 1.5) {
      high = sample(std::min(1.0, low.u + step));
      if (high.height >= height) break;
      if (high.u >= 1 || high.height < low.height) return -1;
      low = high;
    }
    const LineSample found = between(low, high, height);
    rate_ = (found.u - last_.u) / (found.height - last_.height);
    return (last_ = found).u;
  }

 private:
  LineSample sample(double u) { return {u, wall_.distance(line_(u), foot_)}; }

  double first_step(double height) const {
    const double probe = line_constants.speed_step;
    const double speed = wall_.scale_at(line_(0)) * distance(line_(probe), line_(0)) / probe;
    return speed > 0 ? std::min(1.0, 1.1 * height / speed) : probe;
  }

  /// The Illinois algorithm: regula falsi that halves the weight of an end that stays.
  LineSample between(LineSample low, LineSample high, double height) {
    double a = low.height - height, b = high.height - height;
    LineSample best = high;
    for (int step = 0;
         step < line_constants.max_steps && std::abs(best.height - height) > line_constants.height_tol * height;
         ++step) {
      const LineSample trial = sample(high.u - b * (high.u - low.u) / (b - a));
      const double miss = trial.height - height;
      if (miss < 0) {
        low = trial, a = miss;
        if (best.height < height) b /= 2;
      } else {
        high = trial, b = miss;
        if (best.height >= height && step > 0) a /= 2;
      }
      best = trial;
      if (high.u - low.u <= 1e-15) break;
    }
    return best;
  }

  const NormalLine& line_;
  const WallLine& wall_;
  WallPoint foot_;
  LineSample last_;
  double rate_ = 0;  ///< of u by the height, at the last one
};

[[noreturn]] void refuse(const CadFace& face, Vec2 position) {
  throw ComputeError(fmt::format("--wall: the layers do not fit into the block beside the wall at {}",
                                 surface::position_text(face, position)));
}

void append(std::vector<double>& to, const std::vector<double>& more) { to.insert(to.end(), more.begin(), more.end()); }

double speed_at(const NormalLine& line, double u) {
  const double low = std::max(0.0, u - line_constants.speed_step), high = std::min(1.0, u + line_constants.speed_step);
  return distance(line(low), line(high)) / (high - low);
}

/// The ends of intervals of these lengths, as fractions of their sum.
std::vector<double> end_fractions(const std::vector<double>& lengths) {
  std::vector<double> ends{0.0};
  for (const double length : lengths) ends.push_back(ends.back() + length);
  for (double& end : ends) end /= ends.back();
  return ends;
}

/// The nodes of a line in the layers of both ends, the ends included.
struct LayerNodes {
  std::vector<double> low, high;
};

LayerNodes layer_nodes(const LineFamily& family, const NormalLine& line, std::size_t node, const CadFace& face) {
  const auto from_wall = [&](const NormalLine& from, const SideLayers& side) {
    std::vector<double> parameters{0.0};
    if (!side.wall) return parameters;
    append(parameters,
           parameters_in_layers(from, *side.wall, side.feet[node], side.heights, side.own_intervals, family.order));
    if (parameters.size() <= side.heights.size() * family.order) refuse(face, from(0));
    return parameters;
  };
  LayerNodes nodes{from_wall(line, family.low), from_wall([&line](double u) { return line(1 - u); }, family.high)};
  sizing::reverse_fractions(nodes.high);
  if (nodes.low.back() >= nodes.high.front()) refuse(face, line(nodes.low.back()));
  return nodes;
}

double length_between(const NormalLine& line, double low, double high) {
  const int samples = line_constants.length_samples;
  double length = 0;
  for (int k = 0; k < samples; ++k)
    length += distance(line(low + (high - low) * k / samples), line(low + (high - low) * (k + 1) / samples));
  return length;
}

/// Steps of the parameter whose lengths are as prescribed, up to a common factor: they follow the speed of the line at
/// the middle of each.
std::vector<double> parameter_steps(const NormalLine& line, double low, double high,
                                    const std::vector<double>& lengths) {
  std::vector<double> steps = lengths;
  for (int round = 0; round < line_constants.parameter_rounds; ++round) {
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

/// The intervals of the arcs beside a line, blended in proportion to its distances from both there. `blend`: at its
/// ends.
std::vector<double> blended_sizes(const LineFamily& family, const std::array<double, 2>& blend) {
  const sizing::ArcDivision left{end_fractions(family.left)}, right{end_fractions(family.right)};
  const double mean = (blend[0] + blend[1]) / 2;
  std::vector<double> sizes;
  for (int k = 0; k < left.num_intervals(); ++k) {
    const double u = (1 - mean) * left.middle(k) + mean * right.middle(k), own = blend[0] + u * (blend[1] - blend[0]);
    sizes.push_back(std::pow(family.left[k], 1 - own) * std::pow(family.right[k], own));
  }
  return sizes;
}

}  // namespace

std::vector<double> interval_nodes(const std::vector<double>& ends, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<double> nodes{ends.front()};
  for (std::size_t k = 1; k < ends.size(); ++k)
    for (int i = 1; i <= order; ++i)
      nodes.push_back(i == order ? ends[k] : ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
  return nodes;
}

std::vector<double> node_heights(const std::vector<double>& layer_heights, int order) {
  std::vector<double> ends{0.0};
  append(ends, layer_heights);
  const std::vector<double> nodes = interval_nodes(ends, order);
  return {nodes.begin() + 1, nodes.end()};
}

std::vector<double> parameters_at_heights(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                          const std::vector<double>& heights) {
  HeightSearch search(line, wall, foot);
  std::vector<double> parameters;
  for (const double height : heights) {
    const double u = search.next(height);
    if (u < 0) break;
    parameters.push_back(u);
  }
  return parameters;
}

std::vector<double> parameters_in_layers(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                         const std::vector<double>& heights, int own_intervals, int order) {
  if (own_intervals == 0) return parameters_at_heights(line, wall, foot, node_heights(heights, order));
  double room = 0;  // the height of the line's end, which its points from the wall on lead to
  WallPoint moved = foot;
  for (int k = 1; k <= line_constants.end_samples; ++k)
    room = wall.distance(line(static_cast<double>(k) / line_constants.end_samples), moved);
  return parameters_at_heights(line, wall, foot, node_heights(compressed_heights(heights, room, own_intervals), order));
}

BlockLine measured_line(const LineFamily& family, const NormalLine& line, std::size_t node,
                        const std::array<double, 2>& blend, const CadFace& face) {
  const LayerNodes ends = layer_nodes(family, line, node, face);
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

std::vector<double> divide_normal_line(const LineFamily& family, const NormalLine& line, std::size_t node,
                                       const CadFace& face, const std::vector<double>& lengths) {
  auto [nodes, top] = layer_nodes(family, line, node, face);
  const double low = nodes.back(), high = top.front();
  const std::vector<double> fractions =
      interval_nodes(end_fractions(parameter_steps(line, low, high, lengths)), family.order);
  for (std::size_t k = 1; k < fractions.size(); ++k) nodes.push_back(low + fractions[k] * (high - low));
  append(nodes, {top.begin() + 1, top.end()});
  return nodes;
}

}  // namespace quadrille::layers
