#include "curve/select_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::curve {
namespace {

constexpr int points_per_curve = 64;
/// Of the radius, for splines of CAD programs that stand for circles, and of the face's diameter, for curves on the
/// border of a box.
constexpr double closeness = 1e-6;
constexpr double equal_diameters = 1e-3;  // of the diameter

/// In space; without the placement of a planar face if `in_plane`: (x, y, 0), with the face's origin.
std::vector<Vec3> points_of(const CadFace& face, int curve, bool in_plane) {
  std::vector<Vec3> points;
  const Nurbs& flat = face.curves[curve];
  for (int i = 0; i <= points_per_curve; ++i) {
    const double part = static_cast<double>(i) / points_per_curve;
    if (face.chart) {
      const SpaceCurve& curved = face.chart->space_curves[curve];
      points.push_back(surface::point(curved, std::lerp(curved.begin(), curved.end(), part)));
      continue;
    }
    const Vec2 x = point(flat, std::lerp(flat.begin(), flat.end(), part)) + face.origin;
    const auto axis = [](const std::array<double, 3>& a) { return Vec3{a[0], a[1], a[2]}; };
    points.push_back(in_plane ? Vec3{x.x, x.y, 0}
                              : axis(face.plane_origin) + x.x * axis(face.plane_x) + x.y * axis(face.plane_y));
  }
  return points;
}

/// The text between the brackets of NAME(...); nothing for other texts.
std::optional<std::string> arguments_of(const std::string& text, const std::string& name) {
  if (!text.starts_with(name + '(') || !text.ends_with(')')) return std::nullopt;
  return text.substr(name.size() + 1, text.size() - name.size() - 2);
}

double number_in(const std::string& text, const std::string& where, const std::string& expected) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && std::isfinite(value)) return value;
  throw UsageError(fmt::format("{}: '{}' is not a number: expected {}", where, text, expected));
}

std::vector<int> curves_in_box(const CadFace& face, const std::string& arguments, const std::string& where) {
  const std::string expected = "box(X0,Y0,X1,Y1), or box(X0,Y0,Z0,X1,Y1,Z1) in space";
  std::vector<double> x;
  for (const std::string& part : split_at_commas(arguments)) x.push_back(number_in(part, where, expected));
  if (x.size() != 4 && x.size() != 6) throw UsageError(fmt::format("{}: expected {}", where, expected));
  const bool in_plane = x.size() == 4;
  if (in_plane && face.chart) throw UsageError(where + ": the face is curved: give box(X0,Y0,Z0,X1,Y1,Z1) in space");
  const auto [low, high] = in_plane ? std::pair{Vec3{x[0], x[1], 0}, Vec3{x[2], x[3], 0}}
                                    : std::pair{Vec3{x[0], x[1], x[2]}, Vec3{x[3], x[4], x[5]}};
  const double border = closeness * (face.chart ? surface::diameter(*face.chart) : face.diameter);
  const auto is_between = [&](double value, double a, double b) {
    return value >= std::min(a, b) - border && value <= std::max(a, b) + border;
  };
  const auto is_inside = [&, low = low, high = high](Vec3 p) {
    return is_between(p.x, low.x, high.x) && is_between(p.y, low.y, high.y) && is_between(p.z, low.z, high.z);
  };
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (std::ranges::all_of(points_of(face, c, in_plane), is_inside)) curves.push_back(c);
  return curves;
}

/// Of the circle that the whole loop is; nothing for other loops.
std::optional<double> circle_diameter(const CadFace& face, int loop) {
  if (face.is_slit_loop(loop)) return std::nullopt;
  std::vector<Vec3> points;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    const std::vector<Vec3> more = points_of(face, c, true);
    points.insert(points.end(), more.begin(), more.end());
  }
  const Vec3 a = points[0], u = points[points.size() / 3] - a, v = points[points.size() * 2 / 3] - a, w = cross(u, v);
  if (!(norm2(w) > 0)) return std::nullopt;
  const Vec3 centre = a + (norm2(v) * cross(w, u) + norm2(u) * cross(v, w)) / (2 * norm2(w));
  const double radius = distance(a, centre), tolerance = closeness * radius;
  const auto is_on_circle = [&, normal = normalized(w)](Vec3 p) {
    return std::abs(distance(p, centre) - radius) <= tolerance && std::abs(dot(p - centre, normal)) <= tolerance;
  };
  if (!std::ranges::all_of(points, is_on_circle)) return std::nullopt;
  return 2 * radius;
}

std::vector<int> curves_of_circles(const CadFace& face, std::string arguments, const std::string& where) {
  const char kind = arguments.empty() ? '*' : arguments[0] == '<' || arguments[0] == '>' ? arguments[0] : '=';
  if (kind == '<' || kind == '>') arguments.erase(0, 1);
  const double limit =
      kind == '*' ? 0 : number_in(arguments, where, "circles(<D), circles(>D), circles(D) or circles()");
  const auto fits = [&](double d) {
    if (kind == '=') return std::abs(d - limit) <= equal_diameters * limit;
    return kind == '*' || (kind == '<' ? d < limit : d > limit);
  };
  std::vector<int> curves;
  for (int l = 0; l < face.num_loops(); ++l)
    if (const auto diameter = circle_diameter(face, l); diameter && fits(*diameter))
      for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c) curves.push_back(c);
  return curves;
}

template <class Fits>
std::vector<int> curves_whose_name(const CadFace& face, const Fits& fits) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (fits(face.curve_names[c])) curves.push_back(c);
  return curves;
}

}  // namespace

std::vector<int> selected_curves(const CadFace& face, const std::string& text, const std::string& where) {
  std::vector<int> curves = curves_whose_name(face, [&](const std::string& name) { return name == text; });
  if (!curves.empty()) return curves;
  if (const auto box = arguments_of(text, "box")) return curves_in_box(face, *box, where);
  if (const auto circles = arguments_of(text, "circles")) return curves_of_circles(face, *circles, where);
  return curves_whose_name(face, [&](const std::string& name) { return matches_wildcard(name, text); });
}

}  // namespace quadrille::curve
