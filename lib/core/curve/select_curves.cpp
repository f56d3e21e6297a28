#include "curve/select_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "base/number_list.hpp"
#include "base/point_grid.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::curve {
namespace {

constexpr int points_per_curve = 64;
constexpr double equal_diameters = 1e-3;  // of the diameter
constexpr double smooth_turn = radians(1);

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
  if (const std::optional<double> value = finite_number_of(text)) return *value;
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
  const double border = tolerance::same_point * (face.chart ? surface::diameter(*face.chart) : face.diameter);
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
  const double radius = distance(a, centre), slack = tolerance::same_point * radius;
  const auto is_on_circle = [&, normal = normalized(w)](Vec3 p) {
    return std::abs(distance(p, centre) - radius) <= slack && std::abs(dot(p - centre, normal)) <= slack;
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

/// Ends of curves by their places: end 2 c is the start of curve c, end 2 c + 1 its end.
class CurveEnds {
 public:
  explicit CurveEnds(const CadFace& face) : face_(face), ends_at_(face.num_curves()) {
    std::vector<Vec2> positions;
    for (const Joint& joint : face.joints) {
      positions.push_back(joint.position);
      if (!joint.is_corner) most_turn_ = std::max(most_turn_, turn(joint.tangent_in, joint.tangent_out));
    }
    places_ = places_of(positions, tolerance::same_point * face.diameter);
    for (int end = 0; end < 2 * face.num_curves(); ++end) ends_at_[places_[joint_of(end)]].push_back(end);
  }

  /// Curves that continue `curve` without a corner at one of its ends.
  std::vector<int> continuations(int curve) const {
    std::vector<int> curves;
    for (const int end : {2 * curve, 2 * curve + 1})
      for (const int other : ends_at_[places_[joint_of(end)]])
        if (turn(direction(end) + pi, direction(other)) <= most_turn_) curves.push_back(other / 2);
    return curves;
  }

 private:
  static double turn(double from, double to) { return std::abs(wrap_pi(to - from)); }
  int joint_of(int end) const { return end % 2 == 0 ? end / 2 : face_.next_in_loop(end / 2); }
  /// Of the curve at this end, away from it.
  double direction(int end) const {
    const Joint& joint = face_.joints[joint_of(end)];
    return end % 2 == 0 ? joint.tangent_out : joint.tangent_in + pi;
  }

  const CadFace& face_;
  double most_turn_ = smooth_turn;
  std::vector<int> places_;                // of each joint
  std::vector<std::vector<int>> ends_at_;  // each place
};

std::vector<int> curves_tangent_to(const CadFace& face, const std::string& start, const std::string& where) {
  if (start.empty()) throw UsageError(where + ": expected tangent(N) or tangent(NAME), of a curve");
  const bool is_number = start.find_first_not_of("0123456789") == std::string::npos;
  std::vector<int> curves =
      is_number ? curves_of_number(face, static_cast<int>(std::min(number_in(start, where, "a number"), 1e9)))
                : selected_curves(face, start, where);
  const CurveEnds ends(face);
  std::vector<char> is_selected(face.num_curves());
  const auto select = [&](int c) {
    if (!is_selected[c]) curves.push_back(c);
    is_selected[c] = 1;
  };
  for (const int c : std::exchange(curves, {})) select(c);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (face.is_interface(curves[i])) select(face.partners[curves[i]]);
    for (const int c : ends.continuations(curves[i])) select(c);
  }
  std::ranges::sort(curves);
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
  if (const auto start = arguments_of(text, "tangent")) return curves_tangent_to(face, *start, where);
  return curves_whose_name(face, [&](const std::string& name) { return matches_wildcard(name, text); });
}

std::vector<int> curves_of_number(const CadFace& face, int number) {
  std::vector<int> curves;
  for (const int c : face.unnamed_curves)
    if (face.curve_names[c] == fmt::format("curve_{}", number)) curves.push_back(c);
  if (curves.empty() && number >= 0 && number < face.num_curves()) curves.push_back(number);
  return curves;
}

}  // namespace quadrille::curve
