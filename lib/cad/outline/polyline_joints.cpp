#include "outline/polyline_joints.hpp"

#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "base/tolerance.hpp"

namespace quadrille::outline {
namespace {

struct PolylineLimits {
  double longest_curve = 0.02;  ///< diameters
  int fewest_curves = 8;
};
constexpr PolylineLimits limits;

bool is_short_and_straight(const CadFace& face, int curve) {
  const Nurbs& c = face.curves[curve];
  return c.poles.size() == 2 &&
         distance(c.poles[0], c.poles[1]) < limits.longest_curve * face.diameter * (1 - tolerance::tied);
}

/// By curve: whether it belongs to a polyline.
std::vector<bool> curves_of_polylines(const CadFace& face) {
  std::vector<bool> is_part(face.num_curves(), false);
  for (int c = 0; c < face.num_curves(); ++c) {
    if (is_part[c] || !is_short_and_straight(face, c)) continue;
    std::vector<int> chain{c};
    const auto extend = [&](auto&& next) {
      for (int i = next(c); i != c && is_short_and_straight(face, i); i = next(i)) chain.push_back(i);
    };
    extend([&](int i) { return face.next_in_loop(i); });
    const bool is_whole_loop = face.next_in_loop(chain.back()) == c;
    if (!is_whole_loop) extend([&](int i) { return face.previous_in_loop(i); });
    if (std::ssize(chain) >= limits.fewest_curves)
      for (const int i : chain) is_part[i] = true;
  }
  return is_part;
}

}  // namespace

int smooth_polylines(CadFace& face, double kink, int many) {
  if (face.num_regions() > 1) return 0;
  const std::vector<bool> is_part = curves_of_polylines(face);
  std::vector<int> kinks;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner && is_part[j] && is_part[face.previous_in_loop(j)] &&
        std::abs(joint.interior_angle - pi) <= kink * (1 + tolerance::tied))
      kinks.push_back(j);
  }
  if (std::ssize(kinks) < many) return 0;
  for (const int j : kinks) face.joints[j].is_corner = false;
  return static_cast<int>(kinks.size());
}

}  // namespace quadrille::outline
