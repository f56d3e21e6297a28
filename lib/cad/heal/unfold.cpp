#include "heal/unfold.hpp"

#include <algorithm>

namespace quadrille::heal {
namespace {

// Whether the leg from pole i to the next one runs against the legs before and behind it. The ends of the curve stay.
bool is_fold(const std::vector<Vec2>& poles, size_t i, double most) {
  const Vec2 before = poles[i] - poles[i - 1], leg = poles[i + 1] - poles[i], behind = poles[i + 2] - poles[i + 1];
  return norm(leg) <= most && dot(before, leg) < 0 && dot(leg, behind) < 0;
}

// Exchanges the two poles of the first fold. Returns false if no leg is a fold.
bool exchange_one(std::vector<Vec2>& poles, double most) {
  for (size_t i = 1; i + 2 < poles.size(); ++i) {
    if (!is_fold(poles, i, most)) continue;
    std::swap(poles[i], poles[i + 1]);
    return true;
  }
  return false;
}

double greatest_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double greatest = 0;
  for (size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, distance(a[i], b[i]));
  return greatest;
}

}  // namespace

double unfold(Nurbs& curve, double most) {
  std::vector<Vec2> poles = curve.poles;
  // An exchange can make the leg before it a fold, which comes next: as when sorting by insertion, each pole passes
  // every other one at most once.
  for (size_t left = poles.size() * poles.size(); exchange_one(poles, most); --left)
    if (left == 0) return 0;
  const double moved = greatest_distance(poles, curve.poles);
  if (moved > most) return 0;
  curve.poles = std::move(poles);
  return moved;
}

}  // namespace quadrille::heal
