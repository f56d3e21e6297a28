#include "curve/face_boundary.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {
namespace {

constexpr int newton_steps = 3;

/// The length of the ray at which it enters the box, widened by `margin`; infinite if it misses the box.
double entry(const PoleBox& box, Vec2 x, Vec2 direction, double margin) {
  double from = 0, to = HUGE_VAL;
  const auto cut = [&](double low, double high, double start, double speed) {
    if (speed == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const auto [a, b] = std::minmax({(low - start) / speed, (high - start) / speed});
    from = std::max(from, a), to = std::min(to, b);
  };
  cut(box.low.x - margin, box.high.x + margin, x.x, direction.x);
  cut(box.low.y - margin, box.high.y + margin, x.y, direction.y);
  return from <= to ? from : HUGE_VAL;
}

/// Crossings of a line with a piece of a curve. A point on the line counts as one to the right of it, so that both
/// curves at a joint on the line see it on one side.
class LineCrossings {
 public:
  /// Of poles nearer than `rounding` to the line only the ends count.
  LineCrossings(Vec2 x, Vec2 direction, double rounding)
      : x_(x), direction_(direction), negligible_(rounding * norm(direction)) {}

  /// Calls visit(t, to_left). A curve crosses a line at most as often as its poles do: it is halved until they do once.
  template <class Visit>
  void find(const Nurbs& piece, const Visit& visit) const {
    int changes = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < piece.poles.size(); ++i) {
      farthest = std::max(farthest, std::abs(offset(piece.poles[i])));
      changes += i > 0 && is_left(piece.poles[i]) != is_left(piece.poles[i - 1]);
    }
    if (changes == 0) return;
    if (changes > 1 && farthest > negligible_) {
      const double middle = (piece.begin() + piece.end()) / 2;
      const Nurbs first = trimmed(piece, piece.begin(), middle);
      Nurbs second = trimmed(piece, middle, piece.end());
      second.poles.front() = first.poles.back();
      find(first, visit);
      find(second, visit);
    } else if (is_left(piece.poles.back()) != is_left(piece.poles.front())) {
      visit(crossing(piece), is_left(piece.poles.back()));
    }
  }

 private:
  double offset(Vec2 y) const { return cross(direction_, y - x_); }
  bool is_left(Vec2 y) const { return offset(y) > 0; }

  double crossing(const Nurbs& piece) const {
    const bool before = is_left(piece.poles.front());
    double a = piece.begin(), b = piece.end();
    for (double middle = (a + b) / 2; a < middle && middle < b; middle = (a + b) / 2)
      (is_left(point(piece, middle)) == before ? a : b) = middle;
    return b;
  }

  Vec2 x_, direction_;
  double negligible_;
};

void sort_by_curve(std::vector<NearestPoint>& feet) {
  std::sort(feet.begin(), feet.end(), [](const NearestPoint& a, const NearestPoint& b) { return a.curve < b.curve; });
}

/// Decided by the side of the boundary at the nearest point; at a joint by its sector.
bool is_inside(const CadFace& face, const NearestPoint& foot, Vec2 x) {
  const Nurbs& curve = face.curves[foot.curve];
  const double end_tol = tolerance::round_off * (curve.end() - curve.begin());
  const bool at_begin = foot.t <= curve.begin() + end_tol, at_end = foot.t >= curve.end() - end_tol;
  if (!at_begin && !at_end) return cross(tangent(curve, foot.t), x - foot.position) > 0;
  const Joint& joint = face.joints[at_begin ? foot.curve : face.next_in_loop(foot.curve)];
  return wrap_two_pi(angle_of(x - joint.position) - joint.tangent_out) < joint.interior_angle;
}

}  // namespace

void CurveTree::build() {
  for (std::size_t c = 0; c < curves_.size(); ++c) add_spans(static_cast<int>(c));
  if (spans_.empty()) return;
  nodes_.reserve(2 * spans_.size() - 1);
  add_nodes(0, static_cast<int>(spans_.size()));
  const auto [low, high] = nodes_.front().box;
  rounding_ = 64 * std::numeric_limits<double>::epsilon() *
              std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
}

void CurveTree::add_spans(int curve) {
  const Nurbs& c = *curves_[curve];
  for (std::size_t k = c.degree; k < c.poles.size(); ++k) {
    if (!(c.knots[k] < c.knots[k + 1])) continue;
    Span span{curve, c.knots[k], c.knots[k + 1], {c.poles[k], c.poles[k]}};
    for (std::size_t i = k - c.degree; i < k; ++i) span.box.extend({c.poles[i], c.poles[i]});
    spans_.push_back(span);
  }
}

/// The spans [first, last) in two halves, by the longer side of the box around their centres.
void CurveTree::add_nodes(int first, int last) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({spans_[first].box});
  if (last - first == 1) {
    nodes_[node].span = first;
    return;
  }
  PoleBox centres{spans_[first].box.centre(), spans_[first].box.centre()};
  for (int i = first; i < last; ++i) {
    nodes_[node].box.extend(spans_[i].box);
    centres.extend({spans_[i].box.centre(), spans_[i].box.centre()});
  }
  const bool by_x = centres.high.x - centres.low.x >= centres.high.y - centres.low.y;
  const auto before = [by_x](const Span& a, const Span& b) {
    return by_x ? a.box.centre().x < b.box.centre().x : a.box.centre().y < b.box.centre().y;
  };
  const int middle = (first + last) / 2;
  std::nth_element(spans_.begin() + first, spans_.begin() + middle, spans_.begin() + last, before);
  add_nodes(first, middle);
  nodes_[node].second = static_cast<int>(nodes_.size());
  add_nodes(middle, last);
}

/// Calls visit(span) for the spans whose bound(box) is at most `reach`, those with the least bounds first.
template <class Bound, class Visit>
void CurveTree::visit_spans(const Bound& bound, double& reach, const Visit& visit) const {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto add = [&](int node) {
    const double least = bound(nodes_[node].box);
    if (least <= reach + rounding_ && least < HUGE_VAL) queue.emplace(least, node);
  };
  if (!nodes_.empty()) add(0);
  while (!queue.empty() && queue.top().first <= reach + rounding_) {
    const int node = queue.top().second;
    queue.pop();
    if (nodes_[node].span >= 0) {
      visit(spans_[nodes_[node].span]);
    } else {
      add(node + 1);
      add(nodes_[node].second);
    }
  }
}

void CurveTree::visit_feet(Vec2 x, double reach, const std::function<void(const NearestPoint&, double&)>& visit,
                           const Filter& filter) const {
  std::vector<bool> is_known(curves_.size(), false);
  const auto bound = [x](const PoleBox& box) { return box.distance_from(x); };
  visit_spans(bound, reach, [&](const Span& span) {
    if (is_known[span.curve]) return;
    is_known[span.curve] = true;
    if (filter && !filter(span.curve)) return;
    const Projection p = project(*curves_[span.curve], x);
    visit({span.curve, p.t, p.position, p.distance}, reach);
  });
}

NearestPoint CurveTree::nearest(Vec2 x, const Filter& filter) const {
  NearestPoint best;
  const auto visit = [&best](const NearestPoint& foot, double& reach) {
    if (std::pair(foot.distance, foot.curve) < std::pair(best.distance, best.curve)) best = foot;
    reach = best.distance;
  };
  visit_feet(x, HUGE_VAL, visit, filter);
  return best;
}

std::vector<NearestPoint> CurveTree::nearest_feet(Vec2 x, double tol, const Filter& filter) const {
  std::vector<NearestPoint> feet;
  double limit = HUGE_VAL;
  const auto visit = [&](const NearestPoint& foot, double& reach) {
    feet.push_back(foot);
    reach = limit = std::min(limit, foot.distance + tol);
  };
  visit_feet(x, HUGE_VAL, visit, filter);
  std::erase_if(feet, [limit](const NearestPoint& foot) { return foot.distance > limit; });
  sort_by_curve(feet);
  return feet;
}

std::vector<NearestPoint> CurveTree::feet_within(Vec2 x, double reach, const Filter& filter) const {
  std::vector<NearestPoint> feet;
  const auto visit = [&feet](const NearestPoint& foot, double& limit) {
    if (foot.distance <= limit) feet.push_back(foot);
  };
  visit_feet(x, reach, visit, filter);
  sort_by_curve(feet);
  return feet;
}

/// `visit` may lower the reach.
void CurveTree::visit_hits(Vec2 x, Vec2 direction, double& reach,
                           const std::function<void(const RayHit&)>& visit) const {
  const LineCrossings line(x, direction, rounding_);
  const auto bound = [&](const PoleBox& box) { return entry(box, x, direction, rounding_); };
  visit_spans(bound, reach, [&](const Span& span) {
    const Nurbs& curve = *curves_[span.curve];
    Nurbs piece = trimmed(curve, span.t0, span.t1);
    piece.poles.front() = point(curve, span.t0), piece.poles.back() = point(curve, span.t1);
    line.find(piece, [&](double t, bool to_left) {
      const double length = dot(point(curve, t) - x, direction) / norm2(direction);
      if (0 < length && length <= reach) visit({span.curve, t, length, to_left});
    });
  });
}

std::optional<RayHit> CurveTree::first_hit(Vec2 x, Vec2 direction, double reach) const {
  std::optional<RayHit> first;
  visit_hits(x, direction, reach, [&](const RayHit& hit) {
    if (!first || std::pair(hit.length, hit.curve) < std::pair(first->length, first->curve)) first = hit;
    reach = first->length;
  });
  return first;
}

std::vector<RayHit> CurveTree::hits(Vec2 x, Vec2 direction, double reach) const {
  std::vector<RayHit> hits;
  visit_hits(x, direction, reach, [&](const RayHit& hit) { hits.push_back(hit); });
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return std::tuple(a.length, a.curve, a.t) < std::tuple(b.length, b.curve, b.t);
  });
  return hits;
}

int CurveTree::winding_number(Vec2 x) const {
  int winding = 0;
  double reach = HUGE_VAL;
  visit_hits(x, {1, 0}, reach, [&](const RayHit& hit) { winding += hit.to_left ? 1 : -1; });
  return winding;
}

/// Improves the guess within its curve by Newton's method until its distance is not larger than `known`; returns it.
double CurveTree::improve(Vec2 x, double known, Guess& guess) const {
  const Nurbs& c = *curves_[guess.curve];
  for (int step = 0; step < newton_steps; ++step) {
    const PointAndDerivative at = point_and_derivative(c, guess.t);
    const Vec2 missing = x - at.point;
    const double distance2 = norm2(missing), speed2 = norm2(at.derivative);
    if (distance2 <= known * known || !(speed2 > 0)) return std::sqrt(distance2);
    guess.t = std::clamp(guess.t + dot(missing, at.derivative) / speed2, c.begin(), c.end());
  }
  return distance(x, point(c, guess.t));
}

/// The distance of x, or any value up to `known` if it is not larger than that.
double CurveTree::distance_above(Vec2 x, double known, Guess& guess) const {
  double nearest = improve(x, known, guess);
  if (nearest <= known) return nearest;
  double reach = nearest;
  const auto bound = [x](const PoleBox& box) { return box.distance_from(x); };
  visit_spans(bound, reach, [&](const Span& span) {
    const Projection found = project(*curves_[span.curve], x, span.t0, span.t1);
    if (found.distance >= nearest) return;
    nearest = found.distance;
    guess = {span.curve, found.t};
    reach = nearest > known ? nearest : -HUGE_VAL;
  });
  return nearest;
}

FarthestPoint CurveTree::farthest(const std::vector<Vec2>& points) const {
  FarthestPoint result;
  if (spans_.empty()) return result;
  Guess guess{0, curves_.front()->begin()};
  for (const Vec2 x : points)
    if (const double d = distance_above(x, result.distance, guess); d > result.distance) result = {d, x};
  return result;
}

double FaceBoundary::signed_distance(Vec2 x) const {
  // The two sides of a slit are equally near: the point is inside if it is on the face's side of one of them.
  const std::vector<NearestPoint> feet = nearest_feet(x, tolerance::round_off * face_->diameter);
  double least = HUGE_VAL;
  for (const NearestPoint& foot : feet) least = std::min(least, foot.distance);
  const auto is_at_inner_side = [&](const NearestPoint& foot) { return is_inside(*face_, foot, x); };
  return std::any_of(feet.begin(), feet.end(), is_at_inner_side) ? least : -least;
}

// A boundary that touches or crosses the segment crosses one of the two lines beside it.
bool FaceBoundary::is_visible(Vec2 from, Vec2 to) const {
  const double length = distance(from, to);
  if (length == 0) return true;
  const Vec2 direction = (to - from) / length, beside = tolerance::round_off * face_->diameter * left_of(direction);
  return !first_hit(from + beside, direction, length) && !first_hit(from - beside, direction, length);
}

double FaceBoundary::length_inside(Vec2 x, Vec2 direction) const {
  double begin = 0;
  for (const RayHit& hit : hits(x, direction)) {
    if (contains(x + (begin + hit.length) / 2 * direction)) return hit.length - begin;
    begin = hit.length;
  }
  return 0;
}

}  // namespace quadrille::curve
