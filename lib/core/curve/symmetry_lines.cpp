#include "curve/symmetry_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/name_text.hpp"
#include "base/position_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

/// The line through the ends of a curve.
SymmetryLine line_through(const CadFace& face, int c) {
  const Nurbs& nurbs = face.curves[c];
  const Vec2 start = point(nurbs, nurbs.begin()), chord = point(nurbs, nurbs.end()) - start;
  return {start, norm(chord) > 0 ? normalized(chord) : Vec2{1, 0}, {c}};  // a closed curve is not straight
}

/// The point of a curve with the greatest value of `rank`, of its ends and seven points in each knot span.
template <typename Rank>
Vec2 foremost_point(const Nurbs& nurbs, const Rank& rank) {
  constexpr int steps = 8;
  Vec2 best = point(nurbs, nurbs.begin());
  for_each_span(nurbs, [&](double a, double b) {
    for (int i = 1; i <= steps; ++i) {
      const Vec2 x = point(nurbs, i == steps ? b : a + (b - a) * i / steps);
      if (rank(x) > rank(best)) best = x;
    }
  });
  return best;
}

std::string curve_text(const CadFace& face, int c) { return fmt::format("curve {} \"{}\"", c, face.curve_names[c]); }

std::string place_text(const CadFace& face, Vec2 x) { return rounded_position_text(x + face.origin); }

/// Why a curve is not straight; empty if it is.
std::string bend_fault(const CadFace& face, const SymmetryLine& line) {
  const int c = line.curves.front();
  const Vec2 x = foremost_point(face.curves[c], [&](Vec2 p) { return std::abs(line.height(p)); });
  if (std::abs(line.height(x)) <= tolerance::same_point * face.diameter) return {};
  return fmt::format("{} is not straight: at {} it is {:.3g} off the line between its ends", curve_text(face, c),
                     place_text(face, x), std::abs(line.height(x)));
}

/// Why the face is not on one side of a line; empty if it is.
std::string side_fault(const CadFace& face, const SymmetryLine& line) {
  for (const Nurbs& curve : face.curves) {
    const Vec2 x = foremost_point(curve, [&](Vec2 p) { return -line.height(p); });
    if (line.height(x) < -tolerance::same_point * face.diameter)
      return fmt::format("the face lies on both sides of {}: at {} it is {:.3g} beyond its line",
                         curve_text(face, line.curves.front()), place_text(face, x), -line.height(x));
  }
  return {};
}

/// Whether a straight curve is a part of the line.
bool continues(const CadFace& face, const SymmetryLine& line, const SymmetryLine& other) {
  const Nurbs& nurbs = face.curves[other.curves.front()];
  const double tol = tolerance::same_point * face.diameter;
  return std::abs(line.height(point(nurbs, nurbs.begin()))) <= tol &&
         std::abs(line.height(point(nurbs, nurbs.end()))) <= tol;
}

}  // namespace

std::vector<int> curves_that_fit(const CadFace& face, const std::vector<std::string>& patterns) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c) {
    const auto fits = [&](const std::string& pattern) { return matches_wildcard(face.curve_names[c], pattern); };
    if (!face.is_interface(c) && std::any_of(patterns.begin(), patterns.end(), fits)) curves.push_back(c);
  }
  return curves;
}

SymmetryLines symmetry_lines(const CadFace& face, const std::vector<int>& curves) {
  std::vector<SymmetryLine> lines;
  for (const int c : curves) {
    const SymmetryLine own = line_through(face, c);
    if (std::string fault = bend_fault(face, own); !fault.empty()) return {{}, std::move(fault)};
    const auto known =
        std::find_if(lines.begin(), lines.end(), [&](const SymmetryLine& line) { return continues(face, line, own); });
    if (known == lines.end())
      lines.push_back(own);
    else
      known->curves.push_back(c);
  }
  for (const SymmetryLine& line : lines)
    if (std::string fault = side_fault(face, line); !fault.empty()) return {{}, std::move(fault)};
  return {std::move(lines), {}};
}

bool is_part_of_whole(const std::vector<SymmetryLine>& lines) {
  return lines.size() == 1 ||
         (lines.size() == 2 && std::abs(dot(lines[0].direction, lines[1].direction)) <= tolerance::same_angle);
}

}  // namespace quadrille::curve
