#include "guide/multiple_zero.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "guide/winding.hpp"

namespace quadrille {
namespace {

/// Cells and zeros that cannot be told apart: |v| between them stays within the noise.
bool hang_together(const FieldEvaluator& evaluator, const Disc& a, const Disc& b) {
  if (distance(a.centre, b.centre) <= 2 * (a.radius + b.radius)) return true;
  for (const double share : {0.25, 0.5, 0.75}) {
    Vec2 value;
    if (!evaluator.value_at(a.centre + share * (b.centre - a.centre), value) || norm(value) > 10 * field_noise)
      return false;
  }
  return true;
}

/// The disc about all that hangs together with the first of `parts`.
Disc cluster_of(const FieldEvaluator& evaluator, const std::vector<Disc>& parts) {
  std::vector<bool> taken(parts.size(), false);
  std::vector<std::size_t> queue{0};
  taken[0] = true;
  Vec2 lower = parts[0].centre, upper = lower;
  double margin = 0;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Disc& part = parts[queue[next]];
    lower = {std::min(lower.x, part.centre.x), std::min(lower.y, part.centre.y)};
    upper = {std::max(upper.x, part.centre.x), std::max(upper.y, part.centre.y)};
    margin = std::max(margin, part.radius);
    for (std::size_t other = 0; other < parts.size(); ++other) {
      if (taken[other] || !hang_together(evaluator, part, parts[other])) continue;
      taken[other] = true;
      queue.push_back(other);
    }
  }
  return {0.5 * (lower + upper), 0.5 * distance(lower, upper) + margin};
}

/// The number with no more digits than an uncertainty of `radius` leaves.
double rounded(double number, double radius) {
  const double step = std::pow(10.0, std::floor(std::log10(radius)));
  return std::round(number / step) * step + 0.0;  // + 0.0 turns -0 into 0
}

struct Contour {
  double radius;
  int index;
};

/// The smallest circle about the cluster, by doubling, on which the field stands out of its errors.
std::optional<Contour> contour_of(const FieldEvaluator& evaluator, const Disc& cluster) {
  const double diameter = evaluator.field().mesh.face.diameter;
  double least = 0;
  for (double radius = std::max(2 * cluster.radius, 1e-9 * diameter); radius < diameter; radius *= 2) {
    const std::optional<int> index = circle_index(evaluator, cluster.centre, radius, least);
    if (!index) return {};
    if (least > 1e3 * field_noise) return Contour{radius, *index};
  }
  return {};
}

[[noreturn]] void refuse(const FieldEvaluator& evaluator, const std::vector<Disc>& parts) {
  const CadFace& face = evaluator.field().mesh.face;
  const Disc cluster = cluster_of(evaluator, parts);
  const std::optional<Contour> contour = contour_of(evaluator, cluster);
  const double radius = contour ? contour->radius : std::max(cluster.radius, 1e-9 * face.diameter);
  const std::string what = contour ? fmt::format("its index is {}", contour->index) : "its index is not known";
  const Vec2 x = cluster.centre + face.origin;
  throw ComputeError(fmt::format("the guiding field vanishes to higher order near ({:.6g}, {:.6g}), within {:.2g}: {}",
                                 rounded(x.x, radius), rounded(x.y, radius), radius, what));
}

}  // namespace

void require_simple_zeros(const FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                          const std::vector<OpenCell>& open_cells) {
  std::vector<Disc> parts;
  for (const OpenCell& cell : open_cells) parts.push_back({cell.centre, cell.radius});
  for (const FoundZero& zero : zeros) parts.push_back({zero.x, 0});
  if (!open_cells.empty()) refuse(evaluator, parts);
  for (std::size_t a = 0; a < zeros.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      Vec2 value;
      if (evaluator.value_at(0.5 * (zeros[a].x + zeros[b].x), value) && norm(value) < field_noise) {
        std::rotate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(b), parts.end());
        refuse(evaluator, parts);
      }
    }
}

}  // namespace quadrille
