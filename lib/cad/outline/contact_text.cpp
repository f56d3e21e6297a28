#include "outline/contact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/position_text.hpp"
#include "curve/arc_length.hpp"

namespace quadrille::outline {
namespace {

double distance_to_end(const Nurbs& curve, double t) {
  const curve::ArcLength length(curve);
  return std::min(length.at(t), length.total() - length.at(t));
}

std::string size_text(double size, double diameter) {
  return fmt::format("{:.3g} ({:.2g} diameters)", size, size / diameter);
}

}  // namespace

std::string loop_name(size_t loop) { return loop == 0 ? "the outline" : fmt::format("hole {}", loop); }

std::string contact_text(const std::vector<heal::Loop>& loops, const Contact& c, double diameter) {
  const heal::LoopCurve &a = loops[c.loop_a][c.curve_a], &b = loops[c.loop_b][c.curve_b];
  const std::string place = rounded_position_text(c.position);
  const std::string of_loop = c.loop_a == c.loop_b ? " of " + loop_name(c.loop_a) : "";
  if (&a == &b) {
    const double length = std::abs(curve::ArcLength(a.curve).between(c.t_a, c.t_b));
    return fmt::format("edge {}{} at {}, with {} of its length in between: draw it anew", a.cad_edge, of_loop, place,
                       size_text(length, diameter));
  }
  const double size = std::min(distance_to_end(a.curve, c.t_a), distance_to_end(b.curve, c.t_b));
  const std::string edges = a.cad_edge == b.cad_edge ? fmt::format("parts of edge {}", a.cad_edge)
                                                     : fmt::format("edges {} and {}", a.cad_edge, b.cad_edge);
  return fmt::format("{}{} at {}, {} from the nearest of their ends: trim them, or draw them apart", edges, of_loop,
                     place, size_text(size, diameter));
}

}  // namespace quadrille::outline
