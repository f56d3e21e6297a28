#include "outline/face_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "curve/nurbs.hpp"
#include "outline/extent.hpp"
#include "outline/outline_checks.hpp"
#include "outline/wire_loop.hpp"

namespace quadrille::outline {
namespace {

constexpr double same_area = 1e-6;

// A point of the loop at which no other loop touches it.
Vec2 inner_point(const Loop& loop) {
  const Nurbs& curve = loop.front().curve;
  return curve::point(curve, (curve.begin() + curve.end()) / 2);
}

// The number of the smallest piece whose outline contains x; the pieces are in order of falling size. 0 if none does.
size_t smallest_around(const std::vector<std::vector<Loop>>& pieces, Vec2 x) {
  for (size_t p = pieces.size(); p-- > 1;)
    if (winding_number(curves_of(pieces[p].front()), x) != 0) return p;
  return 0;
}

}  // namespace

std::vector<std::vector<Loop>> face_pieces(const std::vector<Loop>& loops) {
  std::vector<std::pair<double, size_t>> outlines;
  std::vector<size_t> holes;
  for (size_t l = 0; l < loops.size(); ++l) {
    const double area = signed_area(curves_of(loops[l]));
    if (area > 0)
      outlines.emplace_back(area, l);
    else
      holes.push_back(l);
  }
  if (outlines.empty()) return {loops};  // crossing curves without area, refused later
  // Rounded logarithms instead of comparisons within a tolerance, which are no order.
  const auto rank = [](double area) { return std::llround(std::log(area) / same_area); };
  std::stable_sort(outlines.begin(), outlines.end(),
                   [&](const auto& a, const auto& b) { return rank(a.first) > rank(b.first); });
  std::vector<std::vector<Loop>> pieces;
  for (const auto& [area, l] : outlines) pieces.push_back({loops[l]});
  for (const size_t l : holes) pieces[smallest_around(pieces, inner_point(loops[l]))].push_back(loops[l]);
  return pieces;
}

}  // namespace quadrille::outline
