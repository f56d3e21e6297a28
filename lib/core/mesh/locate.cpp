#include "mesh/locate.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/tri_bernstein.hpp"

namespace quadrille::mesh {
namespace {

// The value within [least, most], rounded down; `least` for NaN, which the boxes of damaged elements may give.
int bounded_int(double value, int least, int most) {
  return value > least ? static_cast<int>(std::min<double>(value, most)) : least;
}

constexpr double reference_tol = 1e-10;
constexpr double relative_round_off = 1e-14;  // of positions, relative to the diameter

/// The range of a coordinate over the element, from its Bernstein hull.
std::array<double, 2> hull(int order, const std::vector<double>& coefs) {
  const std::vector<double> b = spectral::bernstein_from_orthogonal(order, coefs);
  const auto [low, high] = std::minmax_element(b.begin(), b.end());
  return {*low, *high};
}

// Reference coordinates of x in the straight triangle of an element's vertices, used if the curved map has no inverse.
Vec2 straight_inverse(const spectral::TriMap& map, Vec2 x) {
  Vec2 xi;
  spectral::TriMap({map.position({-1, -1}), map.position({1, -1}), map.position({-1, 1})}).invert(x, xi);
  return xi;
}

// The local edge beyond which xi lies farthest and which has a neighbour; -1 if xi lies beyond no such edge.
int way_out(Vec2 xi, const std::array<int, 3>& neighbors) {
  const std::array<double, 3> beyond{-(1 + xi.y), xi.x + xi.y, -(1 + xi.x)};  // edges 0, 1, 2
  int best = -1;
  for (int k = 0; k < 3; ++k) {
    if (beyond[k] > 0 && neighbors[k] >= 0 && (best < 0 || beyond[k] > beyond[best])) best = k;
  }
  return best;
}

}  // namespace

Locator::Locator(const TriMesh& mesh, const std::vector<spectral::TriMap>& maps)
    : maps_(&maps), round_off_(relative_round_off * mesh.face.diameter) {
  boxes_.reserve(maps.size());
  lower_ = {HUGE_VAL, HUGE_VAL};
  Vec2 upper = -lower_;
  for (const spectral::TriMap& map : maps) {
    const auto [x0, x1] = hull(map.order(), map.coefs_x());
    const auto [y0, y1] = hull(map.order(), map.coefs_y());
    const double margin = 1e-8 * std::max(x1 - x0, y1 - y0) + round_off_;
    boxes_.push_back({{x0 - margin, y0 - margin}, {x1 + margin, y1 + margin}});
    lower_ = {std::min(lower_.x, x0 - margin), std::min(lower_.y, y0 - margin)};
    upper = {std::max(upper.x, x1 + margin), std::max(upper.y, y1 + margin)};
  }
  const Vec2 extent = maps.empty() ? Vec2{1, 1} : upper - lower_;
  const double spacing = std::sqrt(extent.x * extent.y / std::max<double>(1, static_cast<double>(maps.size())));
  nx_ = bounded_int(extent.x / spacing, 1, 4096);
  ny_ = bounded_int(extent.y / spacing, 1, 4096);
  cell_ = {extent.x / nx_, extent.y / ny_};
  fill_grid();
}

std::array<int, 2> Locator::cell_of(Vec2 x) const {
  const Vec2 at{(x.x - lower_.x) / cell_.x, (x.y - lower_.y) / cell_.y};
  return {bounded_int(at.x, 0, nx_ - 1), bounded_int(at.y, 0, ny_ - 1)};
}

void Locator::fill_grid() {
  const auto for_each_cell = [this](const auto& visit) {
    for (int e = 0; e < static_cast<int>(boxes_.size()); ++e) {
      const auto [i0, j0] = cell_of(boxes_[e].lower);
      const auto [i1, j1] = cell_of(boxes_[e].upper);
      for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i) visit(j * nx_ + i, e);
    }
  };
  offsets_.assign(nx_ * ny_ + 1, 0);
  for_each_cell([this](int cell, int) { ++offsets_[cell + 1]; });
  for (int c = 0; c < nx_ * ny_; ++c) offsets_[c + 1] += offsets_[c];
  values_.resize(offsets_.back());
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  for_each_cell([&](int cell, int elem) { values_[next[cell]++] = elem; });
}

bool Locator::is_in_box(int elem, Vec2 x) const {
  const Box& box = boxes_[elem];
  return x.x >= box.lower.x && x.x <= box.upper.x && x.y >= box.lower.y && x.y <= box.upper.y;
}

double Locator::distance_to_box(int elem, Vec2 x) const {
  const Box& box = boxes_[elem];
  return norm(Vec2{std::max({box.lower.x - x.x, 0.0, x.x - box.upper.x}),
                   std::max({box.lower.y - x.y, 0.0, x.y - box.upper.y})});
}

Location Locator::find(Vec2 x, double beside) const {
  if (boxes_.empty() || !std::isfinite(x.x) || !std::isfinite(x.y)) return {};
  const auto [i, j] = cell_of(x);
  const int cell = j * nx_ + i;
  Location nearest;
  double least = beside;
  for (int n = offsets_[cell]; n < offsets_[cell + 1]; ++n) {
    const int elem = values_[n];
    if (!is_in_box(elem, x)) continue;
    Vec2 xi{-1.0 / 3, -1.0 / 3};
    if (!(*maps_)[elem].invert(x, xi)) continue;
    const double outside = outside_reference(xi);
    if (outside <= reference_tol) return {elem, xi};
    const double size = distance(boxes_[elem].lower, boxes_[elem].upper);
    if (outside * size < least) least = outside * size, nearest = {elem, xi};
  }
  return nearest;
}

Location walk(const TriTopology& topology, const std::vector<spectral::TriMap>& maps, Vec2 x, Location from) {
  constexpr int most_steps = 64;
  constexpr Vec2 centroid{-1.0 / 3, -1.0 / 3};
  int elem = from.elem, previous = -1;
  Vec2 guess = from.xi;
  for (int step = 0; step < most_steps && elem >= 0; ++step) {
    Vec2 xi = guess;
    const bool is_inverse = maps[elem].invert(x, xi);
    if (is_inverse && outside_reference(xi) <= reference_tol) return {elem, xi};
    if (!is_inverse) xi = straight_inverse(maps[elem], x);
    const int edge = way_out(xi, topology.elem2neighbors[elem]);
    const int next = edge < 0 ? -1 : topology.elem2neighbors[elem][edge];
    if (next == previous) return {};
    previous = elem;
    elem = next;
    guess = centroid;
  }
  return {};
}

}  // namespace quadrille::mesh
