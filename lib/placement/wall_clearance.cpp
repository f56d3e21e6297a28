#include "placement/wall_clearance.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "curve/named_curves.hpp"
#include "curve/project.hpp"

namespace quadrille::placement {
namespace {

constexpr double equal_tol = 1e-6;
constexpr double reach_factor = 1.5;  ///< reach of the term over the clearance

}  // namespace

NamedClearance parse_clearance(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  NamedClearance result;
  if (equals != std::string::npos) {
    result.name = text.substr(0, equals);
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + equals + 1, end, result.clearance);
    if (read.ec != std::errc() || read.ptr != end) result.clearance = 0;
  }
  if (result.name.empty() || !(result.clearance > 0) || !std::isfinite(result.clearance))
    throw UsageError(fmt::format("--clearance: '{}' is not NAME=L with a length L > 0", text));
  return result;
}

std::vector<WallClearance> wall_clearances(const CadFace& face, const std::vector<NamedClearance>& named) {
  std::vector<WallClearance> walls;
  walls.reserve(named.size());
  for (const NamedClearance& one : named)
    walls.push_back({curve::named_curves(face, one.name, "--clearance"), one.clearance});
  return walls;
}

double distance_to_wall(const CadFace& face, const WallClearance& wall, Vec2 x, Vec2& gradient) {
  curve::Projection nearest;
  nearest.distance = HUGE_VAL;
  for (const int c : wall.curves)
    if (const curve::Projection foot = curve::project(face.curves[c], x); foot.distance < nearest.distance)
      nearest = foot;
  gradient = (x - nearest.position) / nearest.distance;
  return nearest.distance;
}

std::vector<bool> nodes_near_walls(const CadFace& face, const std::vector<WallClearance>& walls,
                                   const CriticalPoints& points) {
  std::vector<bool> is_near;
  for (const CriticalPoint& node : points.critical_points) {
    is_near.push_back(false);
    Vec2 gradient;
    for (const WallClearance& wall : walls)
      if (distance_to_wall(face, wall, node.position, gradient) < wall.clearance * (1 - equal_tol))
        is_near.back() = true;
  }
  return is_near;
}

double clearance_energy(const CadFace& face, const WallClearance& wall, double strength, Vec2 x, Vec2& gradient) {
  Vec2 away;
  const double r = distance_to_wall(face, wall, x, away), reach = reach_factor * wall.clearance;
  if (r >= reach) return 0;
  const double excess = reach / r - 1;
  gradient += -3 * strength * excess * excess * reach / (r * r) * away;
  return strength * excess * excess * excess;
}

}  // namespace quadrille::placement
