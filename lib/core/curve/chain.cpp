#include "curve/chain.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"
#include "curve/span.hpp"

namespace quadrille::curve {

namespace {

bool has_equal_weights(const Nurbs& curve) {
  return std::all_of(curve.weights.begin(), curve.weights.end(), [&](double w) { return w == curve.weights[0]; });
}

/// The Taylor coefficients at m of the derivative of a curve of equal weights, whose degree is at most 8.
std::array<Vec2, 8> taylor_of_derivative(const Nurbs& curve, double m) {
  const int k = find_span(curve, m);
  std::array<Vec2, 8> terms;
  with_degree(curve.degree, [&](auto p) {
    LocalPoles poles = local_poles(curve, k, p);
    double factor = curve.weights[0];  // times (n - 1)!
    for (int n = 1; n <= p; factor *= n++) {
      differentiate(curve, k, p - n + 1, poles);
      const Homogeneous h = de_boor(curve, k, p - n, poles, [m](int) { return m; });
      terms[n - 1] = Vec2{h.x, h.y} / factor;
    }
  });
  return terms;
}

/// Of a sum of speeds from coordinates.
double rounding_of_length(const Nurbs& curve) {
  double rounding = 0;
  for (const Vec2 pole : curve.poles)
    rounding = std::max(rounding, 16 * std::numeric_limits<double>::epsilon() * norm(pole));
  return rounding;
}

}  // namespace

ArcLength::Hodograph ArcLength::hodograph(const Nurbs& curve, bool is_polynomial, double a, double b) {
  const double m = (a + b) / 2;
  if (is_polynomial) return {m, taylor_of_derivative(curve, m)};
  // Bernstein coefficients by blossoms, relative to the point in the middle: A(u) / w(u) with A(0) = 0.
  const int k = find_span(curve, m);
  constexpr std::integral_constant<int, 2> degree;
  const LocalPoles poles = local_poles(curve, k, degree);
  const auto blossom = [&](double t1, double t2) {
    return de_boor(curve, k, degree, poles, [=](int r) { return r == 1 ? t1 : t2; });
  };
  std::array<Homogeneous, 3> c{blossom(a, a), blossom(a, b), blossom(b, b)};
  const Vec2 origin = point(curve, m);
  for (Homogeneous& h : c) h.x -= h.w * origin.x, h.y -= h.w * origin.y;
  const double h = b - a;
  const Vec2 a1 = Vec2{c[2].x - c[0].x, c[2].y - c[0].y} / h;
  const Vec2 a2 = Vec2{c[2].x - 2 * c[1].x + c[0].x, c[2].y - 2 * c[1].y + c[0].y} / (h * h);
  const double w0 = (c[0].w + 2 * c[1].w + c[2].w) / 4, w1 = (c[2].w - c[0].w) / h;
  const double w2 = (c[2].w - 2 * c[1].w + c[0].w) / (h * h);
  return {m, {{w0 * a1, 2 * w0 * a2, w1 * a2 - w2 * a1}}, {w0, w1, w2}};  // A' w - A w' over w^2
}

// The sums of gauss_integral() and speed() to the last digit, but of all points at once, in vector registers.
template <int n>
double ArcLength::gauss(size_t span, double a, double b) const {
  if (hodographs_.empty()) return gauss_integral<n>([&](double t) { return norm(derivative(*curve_, t)); }, a, b);
  using Points = Eigen::Array<double, n, 1>;
  const GaussRule<n>& rule = gauss_rule<n>();
  const Hodograph& q = hodographs_[span];
  const double middle = (a + b) / 2, half = (b - a) / 2;
  const Points u = middle + half * Eigen::Map<const Points>(rule.points.data()) - q.middle;
  Points x = Points::Constant(q.d[num_terms_ - 1].x), y = Points::Constant(q.d[num_terms_ - 1].y);
  for (int k = num_terms_ - 2; k >= 0; --k) x = q.d[k].x + u * x, y = q.d[k].y + u * y;
  Points speeds = x * x + y * y;
  for (double& speed : speeds) speed = std::sqrt(speed);  // that of Eigen is not rounded correctly
  if (is_rational_) speeds /= (q.w[0] + u * (q.w[1] + u * q.w[2])).square();
  speeds *= Eigen::Map<const Points>(rule.weights.data());
  double sum = speeds[0];
  for (int i = 1; i < n; ++i) sum += speeds[i];
  return half * sum;
}

ArcLength::ArcLength(const Nurbs& curve) : curve_(&curve) {
  const bool is_polynomial = has_equal_weights(curve);
  is_rational_ = !is_polynomial;
  is_polyline_ = curve.degree == 1 && is_polynomial;
  num_terms_ = std::max(3, curve.degree);
  add(curve.begin(), 0, 0);
  if (is_polyline_) {
    for (size_t i = 1; i < curve.poles.size(); ++i)
      add(curve.knots[i + 1], lengths_.back() + distance(curve.poles[i - 1], curve.poles[i]), i - 1);
    return;
  }
  const double scale = polygon_length(curve), rounding = rounding_of_length(curve);
  constexpr int deepest_slow = 8;
  struct Interval {
    double a, b, length;
    int depth;
    double error;  ///< error estimate of the interval of which this is one half
    size_t span;
  };
  std::vector<Interval> stack;
  for (size_t i = 1; i < curve.knots.size(); ++i) {
    const double a = curve.knots[i - 1], b = curve.knots[i];
    if (!(a < b)) continue;
    if (is_polynomial ? curve.degree <= most_terms : curve.degree == 2)
      hodographs_.push_back(hodograph(curve, is_polynomial, a, b));
    stack.push_back({a, b, gauss<16>(stack.size(), a, b), 0, scale, stack.size()});
  }
  speeds_.front() = speed(0, curve.begin());
  std::reverse(stack.begin(), stack.end());
  while (!stack.empty()) {
    const Interval whole = stack.back();
    stack.pop_back();
    const double m = (whole.a + whole.b) / 2;
    const double left = gauss<16>(whole.span, whole.a, m), right = gauss<16>(whole.span, m, whole.b);
    const double error = std::abs(left + right - whole.length);
    // The points of a curve that is tiny relative to its coordinates are known to rounding only: halving is then no
    // use. Nor is it a sign of rounding that the error of a long interval falls slowly: a thin ellipse begins so.
    const bool is_rounding =
        error > whole.error / 16 && (error <= rounding || (whole.depth >= deepest_slow && error <= 1e-6 * scale));
    if (error <= 1e-14 * scale || is_rounding || whole.depth == 40) {
      add(m, lengths_.back() + left, whole.span);
      add(whole.b, lengths_.back() + right, whole.span);
    } else {
      stack.push_back({m, whole.b, right, whole.depth + 1, error, whole.span});
      stack.push_back({whole.a, m, left, whole.depth + 1, error, whole.span});
    }
  }
}

void ArcLength::add(double parameter, double length, size_t span) {
  parameters_.push_back(parameter);
  lengths_.push_back(length);
  speeds_.push_back(speed(span, parameter));
  spans_.push_back(span);
}

double ArcLength::speed(size_t span, double t) const {
  if (hodographs_.empty()) return norm(derivative(*curve_, t));
  const Hodograph& q = hodographs_[span];
  const double u = t - q.middle;
  Vec2 d = q.d[num_terms_ - 1];
  for (int k = num_terms_ - 2; k >= 0; --k) d = q.d[k] + u * d;
  const double numerator = norm(d);
  if (!is_rational_) return numerator;
  const double w = q.w[0] + u * (q.w[1] + u * q.w[2]);
  return numerator / (w * w);
}

double ArcLength::at(double t) const {
  if (t <= parameters_.front()) return 0;
  if (t >= parameters_.back()) return lengths_.back();
  const size_t i = std::upper_bound(parameters_.begin(), parameters_.end(), t) - parameters_.begin() - 1;
  return lengths_[i] + inside(i, t);
}

double ArcLength::inside(size_t i, double t) const {
  const double a = parameters_[i], b = parameters_[i + 1], whole = lengths_[i + 1] - lengths_[i];
  if (is_polyline_) return whole * ((t - a) / (b - a));
  // Integrates from the nearer end: at most a quarter of an interval on which 16 points were enough, so 8 are. This
  // also makes the middle of a symmetric curve exact to the last digit.
  if (t - a <= b - t) return t == a ? 0 : gauss<8>(spans_[i + 1], a, t);
  return t == b ? whole : whole - gauss<8>(spans_[i + 1], t, b);
}

double ArcLength::guess(size_t i, double length) const {
  const double h = lengths_[i + 1] - lengths_[i], x = (length - lengths_[i]) / h;
  const double a = parameters_[i], b = parameters_[i + 1];
  if (is_polyline_ || !(speeds_[i] > 0) || !(speeds_[i + 1] > 0)) return a + (b - a) * x;
  // Hermite's cubic through both ends with slopes d t / d s = 1 / speed.
  const double u = h / speeds_[i], v = h / speeds_[i + 1], d = b - a;
  return std::clamp(a + x * (u + x * (3 * d - 2 * u - v + x * (u + v - 2 * d))), a, b);
}

double ArcLength::parameter(double length) const {
  if (length <= 0) return parameters_.front();
  if (length >= lengths_.back()) return parameters_.back();
  const size_t i = std::upper_bound(lengths_.begin(), lengths_.end(), length) - lengths_.begin() - 1;
  double low = parameters_[i], high = parameters_[i + 1];
  double t = guess(i, length);
  if (length == lengths_[i]) return low;
  if (is_polyline_) return t;
  const double span = high - low;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double missing = length - lengths_[i] - inside(i, t);
    (missing > 0 ? low : high) = t;
    double next = t + missing / speed(spans_[i + 1], t);
    if (!(next > low && next < high)) {
      if (next == low || next == high) return next;
      next = (low + high) / 2;
    }
    const double moved = std::abs(next - t);
    t = next;
    // Newton's method squares the error: after a step of 1e-8 of the interval, 1e-16 of it remains.
    if (moved <= 1e-8 * span) break;
  }
  return t;
}

namespace {

constexpr double greatest_snap = 1e-3;  ///< of a chain's length
constexpr double same_fraction = 1e-12;

}  // namespace

CurveTable::CurveTable(const CadFace& face, const std::vector<Nurbs>& splines) : face_(&face), splines_(&splines) {}

const Nurbs& CurveTable::curve(int id) const {
  return id < face_->num_curves() ? face_->curves[id] : (*splines_)[id - face_->num_curves()];
}

const ArcLength& CurveTable::arc_length(int id) const {
  const auto known = tables_.find(id);
  return known != tables_.end() ? known->second : tables_.emplace(id, curve(id)).first->second;
}

const std::vector<double>& CurveTable::breaks(int id) const {
  const auto known = breaks_.find(id);
  return known != breaks_.end() ? known->second : breaks_.emplace(id, smoothness_breaks(curve(id))).first->second;
}

Chain::Chain(const CurveTable& table, std::vector<ArcPiece> pieces) : table_(&table), pieces_(std::move(pieces)) {
  double length = 0;
  for (const ArcPiece& piece : pieces_) {
    const ArcLength& arc = table_->arc_length(piece.curve);
    arc_lengths_.push_back(&arc);
    starts_.push_back(arc.at(piece.t0));
    length += std::abs(arc.at(piece.t1) - starts_.back());
    ends_.push_back(length);
  }
}

Chain::Place Chain::place(double s) const {
  const double target = std::clamp(s, 0.0, 1.0) * length();
  const size_t i =
      std::min<size_t>(std::lower_bound(ends_.begin(), ends_.end(), target) - ends_.begin(), pieces_.size() - 1);
  const ArcPiece& piece = pieces_[i];
  const double before = i == 0 ? 0 : ends_[i - 1];
  const bool backwards = piece.t0 > piece.t1;
  double t;
  if (target <= before)
    t = piece.t0;
  else if (target >= ends_[i])
    t = piece.t1;
  else
    t = arc_lengths_[i]->parameter(starts_[i] + (backwards ? before - target : target - before));
  const auto [low, high] = std::minmax(piece.t0, piece.t1);
  return {i, std::clamp(t, low, high)};
}

ChainPoint Chain::at(double s) const {
  const auto [i, t] = place(s);
  const ArcPiece& piece = pieces_[i];
  const Nurbs& curve = table_->curve(piece.curve);
  // At the far end of a piece the tangent is the limit from inside the piece, not of the curve beyond the piece.
  const Vec2 along = tangent(curve, t, t == std::max(piece.t0, piece.t1));
  return {point(curve, t), piece.t0 > piece.t1 ? -along : along, static_cast<int>(i), t};
}

Vec2 Chain::position(double s) const {
  const auto [i, t] = place(s);
  return point(table_->curve(pieces_[i].curve), t);
}

std::vector<double> Chain::joint_fractions() const {
  std::vector<double> fractions;
  for (size_t i = 0; i + 1 < ends_.size(); ++i) fractions.push_back(ends_[i] / length());
  return fractions;
}

bool Chain::is_smooth_seam(size_t i) const {
  const ArcPiece &a = pieces_[i], &b = pieces_[i + 1];
  if (a.curve != b.curve || !table_->is_cad_curve(a.curve)) return false;
  const Nurbs& curve = table_->curve(a.curve);
  const bool meets = (a.t1 == curve.end() && b.t0 == curve.begin()) || (a.t1 == curve.begin() && b.t0 == curve.end());
  return meets && has_smooth_seam(curve);
}

bool Chain::is_whole_curve(size_t i) const {
  const double length = ends_[i] - (i == 0 ? 0 : ends_[i - 1]);
  return length >= arc_lengths_[i]->total() * (1 - 1e-9);
}

bool Chain::is_at_end(double fraction) const {
  const double reach = std::clamp(tolerance::same_point * table_->diameter() / length(), same_fraction, greatest_snap);
  const bool is_at_start = fraction < 0.5;
  const double from_end = is_at_start ? fraction : 1 - fraction;
  if (from_end < same_fraction) return true;
  if (from_end > reach) return false;
  const size_t last = pieces_.size() - 1;
  const double joint = (is_at_start ? ends_[0] : (last > 0 ? ends_[last - 1] : 0)) / length();
  return std::abs(fraction - joint) >= same_fraction || !is_whole_curve(is_at_start ? 0 : last);
}

const std::vector<double>& Chain::break_fractions() const {
  if (!break_fractions_) break_fractions_ = find_break_fractions();
  return *break_fractions_;
}

std::vector<double> Chain::find_break_fractions() const {
  std::vector<double> fractions;
  for (size_t i = 0; i + 1 < ends_.size(); ++i)
    if (!is_smooth_seam(i)) fractions.push_back(ends_[i] / length());
  for (size_t i = 0; i < pieces_.size(); ++i) {
    const ArcPiece& piece = pieces_[i];
    if (!table_->is_cad_curve(piece.curve)) continue;
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    for (const double t : table_->breaks(piece.curve))
      if (low < t && t < high) {
        const double inside = std::abs(arc_lengths_[i]->between(piece.t0, t));
        fractions.push_back(((i == 0 ? 0 : ends_[i - 1]) + inside) / length());
      }
  }
  std::sort(fractions.begin(), fractions.end());
  const auto same = [](double a, double b) { return b - a < same_fraction; };
  fractions.erase(std::unique(fractions.begin(), fractions.end(), same), fractions.end());
  std::erase_if(fractions, [&](double f) { return is_at_end(f); });
  return fractions;
}

}  // namespace quadrille::curve
