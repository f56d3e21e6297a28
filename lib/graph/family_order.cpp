#include "graph/family_order.hpp"

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::graph {
namespace {

constexpr double touching = 1e-3;  // radians: laps of a spiral coincide up to rounding

}  // namespace

bool is_of_one_family(const Crossing& crossing) { return crossing.angle < pi / 4; }

void require_family_order(const std::vector<Crossing>& crossings, const std::vector<bool>& is_exempt, Vec2 origin) {
  for (const Crossing& c : crossings) {
    if (!is_of_one_family(c) || c.angle < touching || is_exempt[c.a] || is_exempt[c.b]) continue;
    const Vec2 place = c.position + origin;
    throw ComputeError(
        fmt::format("two separatrices of one family cross at ({:.6g}, {:.6g}), at {:.3g} degrees: --tolerance is too "
                    "coarse for the field there",
                    place.x, place.y, degrees(c.angle)));
  }
}

}  // namespace quadrille::graph
