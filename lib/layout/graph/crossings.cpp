#include "graph/crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <utility>

#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "surface/positions.hpp"

namespace quadrille::graph {
namespace {

struct Box {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void widen(double margin) { low -= {margin, margin}, high += {margin, margin}; }
};

bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

constexpr double side_by_side = 0.1;  // radians
constexpr std::size_t most_sought = 100;

// A cache is asked again and again for lines that are continued step by step: the time for all is bounded too.
constexpr long long searches_of_cache = 4;
constexpr std::size_t many_curves = 500;

// A piece of a curve as a cubic Bezier over [t0, t1].
struct Bezier {
  std::array<Vec2, 4> p;
  double t0, t1;

  Box box() const {
    Box b;
    for (const Vec2 q : p) b.add(q);
    return b;
  }
  Vec2 chord() const { return p[3] - p[0]; }
  // Bound of the angle between the curve's tangents and its chord.
  double cone() const {
    double widest = 0;
    for (int i = 0; i < 3; ++i) widest = std::max(widest, angle_between(chord(), p[i + 1] - p[i]));
    return widest;
  }
  // Whether `other` lies wholly on one side of the strip along the chord that contains this curve.
  bool is_beside(const Bezier& other, double margin) const {
    const Vec2 normal = left_of(chord()) / norm(chord());
    if (!std::isfinite(normal.x)) return false;
    const auto heights = [&](const Bezier& of) {
      const auto height = [&](int i) { return dot(normal, of.p[i] - p[0]); };
      return std::minmax({height(0), height(1), height(2), height(3)});
    };
    const auto [low, high] = heights(*this);
    const auto [other_low, other_high] = heights(other);
    return other_low > high + margin || other_high < low - margin;
  }
};

std::array<Bezier, 2> halves(const Bezier& b) {
  const Vec2 q0 = (b.p[0] + b.p[1]) / 2, q1 = (b.p[1] + b.p[2]) / 2, q2 = (b.p[2] + b.p[3]) / 2;
  const Vec2 r0 = (q0 + q1) / 2, r1 = (q1 + q2) / 2, m = (r0 + r1) / 2;
  const double t = (b.t0 + b.t1) / 2;
  return {Bezier{{b.p[0], q0, r0, m}, b.t0, t}, Bezier{{m, r1, q2, b.p[3]}, t, b.t1}};
}

std::vector<Bezier> spans(const Nurbs& c) {
  std::vector<Bezier> beziers;
  for (size_t k = 3; k + 4 < c.knots.size(); ++k) {
    const double u0 = c.knots[k], u1 = c.knots[k + 1];
    if (!(u0 < u1)) continue;
    // Blossoms of the span's four poles.
    const auto at = [&](double x, double y, double z) {
      std::array<Vec2, 4> d{c.poles[k - 3], c.poles[k - 2], c.poles[k - 1], c.poles[k]};
      const std::array<double, 3> u{x, y, z};
      for (int r = 1; r <= 3; ++r)
        for (int j = 3; j >= r; --j) {
          const double low = c.knots[k - 3 + j], high = c.knots[k + 1 + j - r], w = (u[r - 1] - low) / (high - low);
          d[j] = (1 - w) * d[j - 1] + w * d[j];
        }
      return d[3];
    };
    beziers.push_back({{at(u0, u0, u0), at(u0, u0, u1), at(u0, u1, u1), at(u1, u1, u1)}, u0, u1});
  }
  return beziers;
}

/// Span i of curve a and span j of curve b, whose boxes meet; a < b, or a == b and i + 1 < j: neighbouring spans of one
/// curve share a point, and change their direction too little to meet elsewhere.
struct Overlap {
  int a, b, i, j;
  auto operator<=>(const Overlap&) const = default;
};

struct Span {
  int curve, number;
  Box box;
};

// Horizontal bands, several boxes high: in a sweep through one, few pairs of boxes overlap in x only.
struct Bands {
  double low = 0, height = 1;
  int count = 1;

  explicit Bands(const std::vector<Span>& spans) {
    Box whole;
    double sum = 0;
    for (const Span& span : spans)
      whole.add(span.box.low), whole.add(span.box.high), sum += span.box.high.y - span.box.low.y;
    if (!(sum > 0)) return;
    const double extent = whole.high.y - whole.low.y, mean = sum / static_cast<double>(spans.size());
    low = whole.low.y;
    count = static_cast<int>(std::clamp(extent / (4 * mean), 1.0, 1000.0));
    height = extent / count;
  }
  int of(double y) const { return std::clamp(static_cast<int>((y - low) / height), 0, count - 1); }
};

/// Compares the numbers of pairs of pieces and of crossings with their bounds.
class Counter {
 public:
  explicit Counter(const CrossingBounds& bounds) : bounds_(bounds) {}

  void count(const Box& at) {
    if (bounds_.num_pairs) ++*bounds_.num_pairs;
    if (++num_ <= bounds_.max_pairs) return;
    const Vec2 position = (at.low + at.high) / 2;
    throw ComputeError(
        fmt::format("separatrices run beside each other too often: more than {} pairs of their pieces could cross, the "
                    "last near {}",
                    bounds_.max_pairs, place(position)));
  }

  void require_few_crossings(const std::vector<Crossing>& found) const {
    if (found.size() <= bounds_.max_crossings) return;
    const Vec2 position = found.back().position;
    throw CrowdedLinesError(
        fmt::format("separatrices cross each other more than the {} times allowed, the last near {}",
                    bounds_.max_crossings, place(position)));
  }

 private:
  std::string place(Vec2 position) const {
    return bounds_.face ? surface::position_text(*bounds_.face, position) : position_text(position);
  }

  const CrossingBounds& bounds_;
  long long num_ = 0;
};

// By a sweep from left to right through each band; a pair counts in the first band that both touch. Sorted.
std::vector<Overlap> overlaps(std::vector<Span> spans, const std::vector<bool>& sought, Counter& counter) {
  const auto is_sought = [&](int a, int b) { return sought.empty() || sought[a] || sought[b]; };
  std::stable_sort(spans.begin(), spans.end(), [](const Span& p, const Span& q) { return p.box.low.x < q.box.low.x; });
  const Bands bands(spans);
  std::vector<std::vector<const Span*>> open(bands.count);
  std::vector<Overlap> all;
  for (const Span& span : spans) {
    const int first = bands.of(span.box.low.y), last = bands.of(span.box.high.y);
    for (int band = first; band <= last; ++band) {
      std::erase_if(open[band], [&](const Span* other) { return other->box.high.x < span.box.low.x; });
      for (const Span* other : open[band]) {
        if (!is_sought(other->curve, span.curve) || !meet(other->box, span.box) ||
            band != std::max(first, bands.of(other->box.low.y)))
          continue;
        const bool is_first = std::pair{span.curve, span.number} < std::pair{other->curve, other->number};
        const Span &p = is_first ? span : *other, &q = is_first ? *other : span;
        if (p.curve == q.curve && p.number + 1 >= q.number) continue;
        counter.count(span.box);
        all.push_back({p.curve, q.curve, p.number, q.number});
      }
      open[band].push_back(&span);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

Box box_of(const Nurbs& spline, double margin) {
  Box box;
  for (const Vec2 pole : spline.poles) box.add(pole);
  box.widen(margin);
  return box;
}

/// By curve: whether it is sought or may meet one that is.
std::vector<bool> concerned(const std::vector<Nurbs>& splines, double margin, const std::vector<bool>& sought) {
  std::vector<Box> boxes;
  for (std::size_t c = 0; c < sought.size(); ++c)
    if (sought[c]) boxes.push_back(box_of(splines[c], margin));
  // Tests of all pairs of boxes are worth their time only where few curves are sought.
  if (sought.empty() || boxes.size() > most_sought) return std::vector<bool>(splines.size(), true);
  std::vector<bool> result = sought;
  for (std::size_t c = 0; c < splines.size(); ++c) {
    if (result[c]) continue;
    const Box own = box_of(splines[c], margin);
    result[c] = std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return meet(own, box); });
  }
  return result;
}

class Finder {
 public:
  Finder(const std::vector<Nurbs>& splines, double same, const CrossingBounds& bounds)
      : splines_(splines), same_(same), counter_(bounds) {
    std::vector<Span> boxes;
    const std::vector<bool> is_concerned = concerned(splines, same, bounds.sought);
    for (int c = 0; c < static_cast<int>(splines.size()); ++c) {
      beziers_.push_back(is_concerned[c] ? spans(splines[c]) : std::vector<Bezier>());
      for (int i = 0; i < static_cast<int>(beziers_[c].size()); ++i) {
        boxes.push_back({c, i, beziers_[c][i].box()});
        boxes.back().box.widen(same);
      }
    }
    overlaps_ = overlaps(std::move(boxes), bounds.sought, counter_);
  }

  void run() {
    for (size_t k = 0; k < overlaps_.size(); ++k) {
      const auto [a, b, i, j] = overlaps_[k];
      if (k == 0 || a != overlaps_[k - 1].a || b != overlaps_[k - 1].b) first_ = found.size();
      search(a, b, beziers_[a][i], beziers_[b][j]);
    }
  }

  std::vector<Crossing> found;

 private:
  // Halves the longer piece until both together turn by less than the angle between them: then they cross once at most.
  void search(int a, int b, const Bezier& p, const Bezier& q) {
    if (p.is_beside(q, same_) || q.is_beside(p, same_)) return;
    counter_.count(p.box());
    const double along = angle_between(p.chord(), q.chord()), between = std::min(along, std::numbers::pi - along);
    const double turn = p.cone() + q.cone(), size_p = norm(p.chord()), size_q = norm(q.chord());
    // Curves side by side cannot be distinguished below some size; lines that pass very near a node turn within a
    // smaller length.
    const double size = std::max(size_p, size_q);
    const bool tiny = size < 10 * same_ || (size < 1e4 * same_ && between < side_by_side);
    const bool is_settled = (tiny || (turn < between && turn < 0.5)) && newton(a, b, p, q);
    if (is_settled || tiny) return;
    const bool split_p = size_p > size_q;
    Box whole = (split_p ? q : p).box();
    whole.widen(same_);
    for (const Bezier& half : halves(split_p ? p : q))
      if (meet(half.box(), whole)) split_p ? search(a, b, half, q) : search(a, b, p, half);
  }

  // False if an iterate is outside the pieces: from the middle of a long piece it may miss a short one.
  bool newton(int a, int b, const Bezier& p, const Bezier& q) {
    const Nurbs &ca = splines_[a], &cb = splines_[b];
    double s = (p.t0 + p.t1) / 2, t = (q.t0 + q.t1) / 2;
    const double ds = p.t1 - p.t0, dt = q.t1 - q.t0;
    Vec2 gap, da, db;
    for (int iteration = 0; iteration < 20; ++iteration) {
      const auto x = curve::derivatives(ca, s), y = curve::derivatives(cb, t);
      gap = y[0] - x[0], da = x[1], db = y[1];
      const double area = cross(da, db);
      if (std::abs(area) < 1e-9 * norm(da) * norm(db)) return true;  // side by side
      const double step_s = cross(gap, db) / area, step_t = cross(gap, da) / area;
      s = std::clamp(s + step_s, ca.begin(), ca.end()), t = std::clamp(t + step_t, cb.begin(), cb.end());
      if (s < p.t0 - ds || s > p.t1 + ds || t < q.t0 - dt || t > q.t1 + dt) return false;
      if (std::abs(step_s) < 1e-14 * ds && std::abs(step_t) < 1e-14 * dt) break;
    }
    const double slack_s = 1e-9 * ds + same_ / norm(da), slack_t = 1e-9 * dt + same_ / norm(db);
    if (s < p.t0 - slack_s || s > p.t1 + slack_s || t < q.t0 - slack_t || t > q.t1 + slack_t) return true;
    const Vec2 position = curve::point(ca, s);
    if (distance(position, curve::point(cb, t)) > 2 * same_) return true;
    for (size_t i = first_; i < found.size(); ++i)
      if (distance(found[i].position, position) <= same_) return true;
    const double angle = angle_between(da, db);
    found.push_back({a, b, s, t, position, std::min(angle, std::numbers::pi - angle)});
    counter_.require_few_crossings(found);
    return true;
  }

  const std::vector<Nurbs>& splines_;
  double same_;
  Counter counter_;
  std::vector<std::vector<Bezier>> beziers_;  // of the curves
  std::vector<Overlap> overlaps_;
  size_t first_ = 0;  // of the present pair in `found`
};

bool comes_before(const Crossing& x, const Crossing& y) {
  return x.a != y.a ? x.a < y.a : x.s != y.s ? x.s < y.s : x.b < y.b;
}

}  // namespace

std::vector<Crossing> find_crossings(const std::vector<Nurbs>& splines, double same, const CrossingBounds& bounds) {
  Finder finder(splines, same, bounds);
  finder.run();
  std::stable_sort(finder.found.begin(), finder.found.end(), comes_before);
  return std::move(finder.found);
}

const std::vector<Crossing>& CrossingCache::find(const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines,
                                                 double same, CrossingBounds bounds) {
  std::map<CurveKey, int> numbers;
  std::vector<int> new_number(numbers_.size(), -1);
  bounds.sought.clear();
  for (int i = 0; i < static_cast<int>(keys.size()); ++i) {
    numbers[keys[i]] = i;
    const auto known = numbers_.find(keys[i]);
    bounds.sought.push_back(known == numbers_.end());
    if (known != numbers_.end()) new_number[known->second] = i;
  }
  const auto times = static_cast<long long>(std::max(keys.size(), many_curves) / many_curves);
  bounds.max_pairs = std::min(bounds.max_pairs, searches_of_cache * times * bounds.max_pairs - num_pairs_);
  bounds.num_pairs = &num_pairs_;
  std::vector<Crossing> all = find_crossings(splines, same, bounds);
  for (Crossing c : crossings_) {
    c.a = new_number[c.a], c.b = new_number[c.b];
    if (c.a >= 0 && c.b >= 0) all.push_back(c);
  }
  std::stable_sort(all.begin(), all.end(), comes_before);
  numbers_ = std::move(numbers);
  crossings_ = std::move(all);
  return crossings_;
}

}  // namespace quadrille::graph
