#include "guide/multiple_zero.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "field/boundary_values.hpp"
#include "guide/winding.hpp"

namespace quadrille {
namespace {

/// The disc about the open cells that hang together with the first one.
Disc cluster_of(const std::vector<OpenCell>& cells) {
  std::vector<bool> taken(cells.size(), false);
  std::vector<std::size_t> queue{0};
  taken[0] = true;
  Vec2 lower = cells[0].centre, upper = lower;
  double margin = 0;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const OpenCell& cell = cells[queue[next]];
    lower = {std::min(lower.x, cell.centre.x), std::min(lower.y, cell.centre.y)};
    upper = {std::max(upper.x, cell.centre.x), std::max(upper.y, cell.centre.y)};
    margin = std::max(margin, cell.radius);
    for (std::size_t other = 0; other < cells.size(); ++other) {
      if (taken[other] || distance(cell.centre, cells[other].centre) > 2 * (cell.radius + cells[other].radius))
        continue;
      taken[other] = true;
      queue.push_back(other);
    }
  }
  return {0.5 * (lower + upper), 0.5 * distance(lower, upper) + margin};
}

[[noreturn]] void refuse(const FieldEvaluator& evaluator, const Disc& cluster) {
  const CadFace& face = evaluator.field().mesh.face;
  std::string what = "its index is not known";
  double least = 0;
  for (double radius = 2 * cluster.radius; radius < face.diameter; radius *= 2) {
    const auto index = circle_index(evaluator, cluster.centre, radius, least);
    if (!index) break;
    if (least <= 1e3 * field_noise) continue;
    what = fmt::format("its index is {}", *index);
    break;
  }
  const Vec2 x = cluster.centre + face.origin;
  throw ComputeError(fmt::format("the guiding field vanishes to higher order near ({:.6g}, {:.6g}), within {:.2g}: {}",
                                 x.x, x.y, cluster.radius, what));
}

}  // namespace

void require_no_line_field(const CadFace& face) {
  Vec2 line;
  bool both_sides = false;
  for (int curve = 0; curve < face.num_curves(); ++curve) {
    const Nurbs& c = face.curves[curve];
    for (const double share : {0.0, 0.21, 0.5, 0.77, 1.0}) {
      const Vec2 value = boundary_value(face, curve, c.begin() + share * (c.end() - c.begin()));
      if (line == Vec2{}) line = value;
      if (std::abs(cross(line, value)) > 1e-6) return;
      both_sides = both_sides || dot(line, value) < 0;
    }
  }
  if (!both_sides) return;
  throw ComputeError(
      "all sides are straight and lie at multiples of 45 degrees to each other, odd ones included: the guiding field "
      "vanishes along whole curves, so that it has no critical points to build blocks from");
}

void require_simple_zeros(const FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                          const std::vector<OpenCell>& open_cells) {
  if (!open_cells.empty()) refuse(evaluator, cluster_of(open_cells));
  for (std::size_t a = 0; a < zeros.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Vec2 middle = 0.5 * (zeros[a].x + zeros[b].x);
      Vec2 value;
      if (evaluator.value_at(middle, value) && norm(value) < field_noise)
        refuse(evaluator, {middle, 0.5 * distance(zeros[a].x, zeros[b].x)});
    }
}

}  // namespace quadrille
