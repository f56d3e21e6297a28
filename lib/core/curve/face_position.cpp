#include "curve/face_position.hpp"

#include <fmt/format.h>

#include <array>

#include "base/error.hpp"

namespace quadrille::curve {

Vec2 face_position(const CadFace& face, const std::vector<double>& coordinates, const std::string& where) {
  if (coordinates.size() == 2) return Vec2{coordinates[0], coordinates[1]} - face.origin;
  std::array<double, 3> rest{};
  Vec2 x;
  for (int k = 0; k < 3; ++k) {
    rest[k] = coordinates[k] - face.plane_origin[k];
    x += rest[k] * Vec2{face.plane_x[k], face.plane_y[k]};
  }
  double height2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double h = rest[k] - x.x * face.plane_x[k] - x.y * face.plane_y[k];
    height2 += h * h;
  }
  if (!(std::sqrt(height2) <= 1e-3 * face.diameter))
    throw FormatError(fmt::format("{}: ({:.6g}, {:.6g}, {:.6g}) lies {:.3g} off the plane of the face", where,
                                  coordinates[0], coordinates[1], coordinates[2], std::sqrt(height2)));
  return x - face.origin;
}

}  // namespace quadrille::curve
