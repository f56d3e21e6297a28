#include "couple/interface_corner.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace quadrille::couple {
namespace {

constexpr double least_turn = radians(45.0), equal_turn = 1e-6;

/// Whether an embedded curve passes the joint: not its end, where it turns back along its other side.
bool is_inside_curve(const CadFace& face, int joint) {
  const int before = face.previous_in_loop(joint);
  return face.is_interface(joint) && face.is_interface(before) && face.partners[joint] != before;
}

}  // namespace

std::optional<InterfaceCorner> sharpest_interface_corner(const CadFace& face) {
  std::optional<InterfaceCorner> sharpest;
  double most = least_turn;
  for (int j = 0; j < face.num_curves(); ++j) {
    const double turn = std::abs(face.joints[j].interior_angle - pi);
    if (!is_inside_curve(face, j) || turn <= most + equal_turn) continue;
    most = turn;
    sharpest = {j, turn};
  }
  return sharpest;
}

}  // namespace quadrille::couple
