#include "curve/named_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "curve/project.hpp"
#include "curve/select_curves.hpp"
#include "model/interfaces.hpp"
#include "surface/space_extent.hpp"

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
    throw FormatError(fmt::format("{}: {} lies {:.3g} off the plane of the face", where,
                                  position_text(Vec3{coordinates[0], coordinates[1], coordinates[2]}),
                                  std::sqrt(height2)));
  return x - face.origin;
}

Vec3 space_position(const std::vector<double>& coordinates, const std::string& where) {
  if (coordinates.size() != 3)
    throw FormatError(
        fmt::format("{}: ({:.6g}) has two coordinates, and this face is curved: positions on it are those in space, "
                    "with x, y and z in the coordinates of the CAD file",
                    where, fmt::join(coordinates, ", ")));
  return {coordinates[0], coordinates[1], coordinates[2]};
}

std::vector<double> curve_distances(const CadFace& face, const std::vector<double>& coordinates,
                                    const std::string& where) {
  std::vector<double> distances;
  if (face.chart) {
    const Vec3 x = space_position(coordinates, where);
    for (const SpaceCurve& curve : face.chart->space_curves) distances.push_back(surface::project(curve, x).distance);
  } else {
    const Vec2 x = face_position(face, coordinates, where);
    for (const Nurbs& curve : face.curves) distances.push_back(project(curve, x).distance);
  }
  return distances;
}

namespace {

/// The region of this name or else of this number; -1: none.
int region_of_name(const CadFace& face, const std::string& name) {
  for (int r = 0; r < face.num_regions(); ++r)
    if (face.region_names[r] == name) return r;
  for (int r = 0; r < face.num_regions(); ++r)
    if (std::to_string(r) == name) return r;
  return -1;
}

/// The part behind the last @ is the name of a region, or its number.
std::vector<int> curves_of_region(const CadFace& face, const std::string& name, std::size_t at,
                                  const std::string& option) {
  const std::string region = name.substr(at + 1);
  const std::vector<int> curve_region = curve_regions(face);
  const int number = region_of_name(face, region);
  const auto is_in_region = [&](int c) { return curve_region[c] == number; };
  std::vector<int> curves = named_curves(face, name.substr(0, at), option);
  std::erase_if(curves, [&](int c) { return !is_in_region(c); });
  if (!curves.empty()) return curves;
  throw UsageError(fmt::format("{}: the boundary \"{}\" does not belong to a region \"{}\"{}; the regions are {}",
                               option, name.substr(0, at), region, did_you_mean(region, face.region_names),
                               fmt::join(face.region_names, ", ")));
}

/// Without those inside the face, if any lie on its boundary.
void keep_boundary(const CadFace& face, std::vector<int>& curves) {
  const auto is_inside = [&](int c) { return face.is_interface(c); };
  if (!std::ranges::all_of(curves, is_inside)) std::erase_if(curves, is_inside);
}

}  // namespace

std::vector<int> named_curves(const CadFace& face, const std::string& name, const std::string& option) {
  std::vector<int> curves = selected_curves(face, name, option);
  if (std::ranges::find(face.curve_names, name) == face.curve_names.end()) keep_boundary(face, curves);
  if (const auto number = number_of<int>(name); number && curves.empty()) curves = curves_of_number(face, *number);
  if (!curves.empty()) return curves;
  if (const std::size_t at = name.rfind('@'); at != std::string::npos && face.num_regions() > 1)
    return curves_of_region(face, name, at, option);
  const std::set<std::string> known(face.curve_names.begin(), face.curve_names.end());
  throw UsageError(fmt::format("{}: there is no boundary \"{}\"{}; the names are {} (or use the numbers 0 to {})",
                               option, name, did_you_mean(name, face.curve_names), fmt::join(known, ", "),
                               face.num_curves() - 1));
}

int named_region(const CadFace& face, const std::string& name) {
  const std::size_t at = name.rfind('@');
  if (at == std::string::npos || face.num_regions() == 1) return -1;
  if (std::find(face.curve_names.begin(), face.curve_names.end(), name) != face.curve_names.end()) return -1;
  return region_of_name(face, name.substr(at + 1));
}

}  // namespace quadrille::curve
