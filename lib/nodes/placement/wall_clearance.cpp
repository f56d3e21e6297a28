#include "placement/wall_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "curve/named_curves.hpp"

namespace quadrille::placement {
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

std::vector<double> clearance_of_curves(const CadFace& face, const std::vector<WallClearance>& walls) {
  std::vector<double> clearance(face.curves.size(), 0.0);
  for (const WallClearance& wall : walls)
    for (const int curve : wall.curves) clearance[curve] = std::max(clearance[curve], wall.clearance);
  return clearance;
}

}  // namespace quadrille::placement
