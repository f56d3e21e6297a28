#include "graph/family_order.hpp"

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"

namespace quadrille::graph {
namespace {

constexpr double touching = 1e-3;  // radians: laps of a spiral coincide up to rounding

}  // namespace

bool is_of_one_family(const Crossing& crossing) { return crossing.angle < pi / 4; }

void require_family_order(const std::vector<Crossing>& crossings, const std::vector<bool>& is_exempt, Vec2 origin) {
  for (const Crossing& c : crossings) {
    if (!is_of_one_family(c) || c.angle < touching || is_exempt[c.a] || is_exempt[c.b]) continue;
    throw FamilyOrderError(
        fmt::format("two separatrices of one family cross at {}, at {:.3g} degrees: --tolerance is too "
                    "coarse for the field there",
                    position_text(c.position + origin), degrees(c.angle)));
  }
}

}  // namespace quadrille::graph
