#include "trace/streamline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/tolerance.hpp"

namespace quadrille::trace {
namespace {

// The coefficients of the stages, of the estimated error and of the continuous extension.
struct DormandPrince {
  double a21 = 1.0 / 5;
  double a31 = 3.0 / 40, a32 = 9.0 / 40;
  double a41 = 44.0 / 45, a42 = -56.0 / 15, a43 = 32.0 / 9;
  double a51 = 19372.0 / 6561, a52 = -25360.0 / 2187, a53 = 64448.0 / 6561, a54 = -212.0 / 729;
  double a61 = 9017.0 / 3168, a62 = -355.0 / 33, a63 = 46732.0 / 5247, a64 = 49.0 / 176, a65 = -5103.0 / 18656;
  double a71 = 35.0 / 384, a73 = 500.0 / 1113, a74 = 125.0 / 192, a75 = -2187.0 / 6784, a76 = 11.0 / 84;
  double e1 = 71.0 / 57600, e3 = -71.0 / 16695, e4 = 71.0 / 1920, e5 = -17253.0 / 339200, e6 = 22.0 / 525,
         e7 = -1.0 / 40;
  double d1 = -12715105075.0 / 11282082432.0, d3 = 87487479700.0 / 32700410799.0, d4 = -10690763975.0 / 1880347072.0,
         d5 = 701980252875.0 / 199316789632.0, d6 = -1453857185.0 / 822651844.0, d7 = 69997945.0 / 29380423.0;
};
constexpr DormandPrince dp{};

constexpr double max_turn = 0.6, cos_max_turn = 0.8253356149096783;  // within a step: far below the 45 degrees at which
                                                                     // the nearest direction is ambiguous

Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

// z^(1/2) of a unit z that is not near -1.
Vec2 root(Vec2 z) {
  const double x = std::sqrt((1 + z.x) / 2);
  return {x, z.y / (2 * x)};
}

// The directions about a step's first one, without an angle: e = d (v / (|v| d^4))^(1/4).
class Guide {
 public:
  Guide(double direction, bool is_straight) : d_(unit(direction)), is_straight_(is_straight) {
    const Vec2 square = product(d_, d_), fourth = product(square, square);
    conj_d4_ = {fourth.x, -fourth.y};
  }

  // d xi / d s at xi; false where the direction is in doubt.
  bool rate(const field::FieldEvaluator& evaluator, int elem, Vec2 xi, Vec2& rate) const {
    Vec2 x;
    Mat2 dx_dxi;
    const Vec2 value = evaluator.value(elem, xi, x, dx_dxi);
    const double size2 = norm2(value), area = det(dx_dxi);
    if (!(size2 > 0) || !(area > 0)) return false;
    const Vec2 turn = is_straight_ ? Vec2{1, 0} : root(root(product(value / std::sqrt(size2), conj_d4_)));
    rate = inverse(dx_dxi) * product(d_, turn);
    return turn.x >= cos_max_turn && std::isfinite(rate.x) && std::isfinite(rate.y);
  }

 private:
  Vec2 d_, conj_d4_;
  bool is_straight_;
};

// d xi / d s at xi; false where the direction is in doubt.
bool rate_at(const field::FieldEvaluator& evaluator, int elem, Vec2 xi, double direction, bool is_straight, Vec2& rate,
             double& angle, Mat2& dx_dxi) {
  Vec2 x;
  const Vec2 value = evaluator.value(elem, xi, x, dx_dxi);
  if (!(norm2(value) > 0) || !(det(dx_dxi) > 0)) return false;
  angle = is_straight ? direction : guided_angle(value, direction);
  rate = inverse(dx_dxi) * unit(angle);
  return std::abs(angle - direction) <= max_turn && std::isfinite(rate.x) && std::isfinite(rate.y);
}

constexpr double edge_tol = 1e-12;  // barycentric
constexpr double overshoot = 0.05;  // barycentric: how far a step may extrapolate beyond the element

// Barycentric coordinate that vanishes on a local edge, and its linear part.
double above_edge(int edge, Vec2 xi) {
  return edge == 0 ? (1 + xi.y) / 2 : edge == 1 ? -(xi.x + xi.y) / 2 : (1 + xi.x) / 2;
}
double above_edge_rate(int edge, Vec2 rate) {
  return edge == 0 ? rate.y / 2 : edge == 1 ? -(rate.x + rate.y) / 2 : rate.x / 2;
}

constexpr size_t samples_per_box = 16;  // consecutive samples for which near nodes are searched together

}  // namespace

Vec2 StreamStep::xi(double theta) const {
  const double rest = 1 - theta;
  return dense[0] + theta * (dense[1] + rest * (dense[2] + theta * (dense[3] + rest * dense[4])));
}

Vec2 StreamStep::slope(double theta) const {
  const double r = 1 - theta;
  return dense[1] + (r - theta) * dense[2] + theta * (2 * r - theta) * dense[3] +
         2 * theta * r * (r - theta) * dense[4];
}

StreamState stream_state(const field::FieldEvaluator& evaluator, int elem, Vec2 xi, double direction,
                         bool is_straight) {
  StreamState state{elem, xi, direction, {}, is_straight};
  Mat2 dx_dxi;
  if (!rate_at(evaluator, elem, xi, direction, is_straight, state.rate, state.angle, dx_dxi))
    state.rate = inverse(dx_dxi) * unit(state.angle);
  return state;
}

void try_step(const field::FieldEvaluator& evaluator, const StreamState& state, double h, StreamStep& step,
              StreamState& end, double& error) {
  error = std::numeric_limits<double>::infinity();
  const Vec2 y = state.xi, k1 = state.rate;
  Vec2 k2, k3, k4, k5, k6, k7;
  const Guide guide(state.angle, state.is_straight);
  const auto stage = [&](Vec2 slope, Vec2& k) { return guide.rate(evaluator, state.elem, y + h * slope, k); };
  if (!stage(dp.a21 * k1, k2)) return;
  if (!stage(dp.a31 * k1 + dp.a32 * k2, k3)) return;
  if (!stage(dp.a41 * k1 + dp.a42 * k2 + dp.a43 * k3, k4)) return;
  if (!stage(dp.a51 * k1 + dp.a52 * k2 + dp.a53 * k3 + dp.a54 * k4, k5)) return;
  if (!stage(dp.a61 * k1 + dp.a62 * k2 + dp.a63 * k3 + dp.a64 * k4 + dp.a65 * k5, k6)) return;
  const Vec2 slope = dp.a71 * k1 + dp.a73 * k3 + dp.a74 * k4 + dp.a75 * k5 + dp.a76 * k6;
  double angle = 0;
  Mat2 dx_dxi;
  if (!rate_at(evaluator, state.elem, y + h * slope, state.angle, state.is_straight, k7, angle, dx_dxi)) return;
  error = h * norm(dx_dxi * (dp.e1 * k1 + dp.e3 * k3 + dp.e4 * k4 + dp.e5 * k5 + dp.e6 * k6 + dp.e7 * k7));
  end = {state.elem, y + h * slope, angle, k7, state.is_straight};
  const Vec2 rise = h * slope, bend = h * k1 - rise;
  step.elem = state.elem;
  step.h = step.length = h;
  step.dense = {y, rise, bend, rise - h * k7 - bend,
                h * (dp.d1 * k1 + dp.d3 * k3 + dp.d4 * k4 + dp.d5 * k5 + dp.d6 * k6 + dp.d7 * k7)};
}

ElementExit first_exit(const StreamStep& step) {
  ElementExit exit;
  const Vec2 last = step.xi(1);
  for (int edge = 0; edge < 3; ++edge) {
    if (above_edge(edge, last) >= -edge_tol) continue;
    const auto above = [&](double fraction) { return above_edge(edge, step.xi(fraction)); };
    const double fraction = falling_root_to_round_off(above);
    if (fraction < exit.fraction) exit = {edge, fraction};
  }
  return exit;
}

double fraction_along_edge(int edge, Vec2 xi) {
  const double f = edge == 0 ? (1 + xi.x) / 2 : edge == 1 ? (1 + xi.y) / 2 : (1 - xi.y) / 2;
  return std::clamp(f, 0.0, 1.0);
}

double length_to_exit(const StreamState& state, double limit) {
  double length = limit;
  for (int edge = 0; edge < 3; ++edge) {
    const double rate = above_edge_rate(edge, state.rate);
    if (rate < 0) length = std::min(length, (std::max(0.0, above_edge(edge, state.xi)) + overshoot) / -rate);
  }
  return length;
}

// The cubic from the node to the first point, with the directions at both.
Vec2 Streamline::lead_in(double s, Vec2& direction) const {
  const double r = launch.radius, f = r > 0 ? s / r : 0;
  const Vec2 d0 = r * unit(launch.angle), d1 = r * unit(launch.angle_there), rise = launch.x - launch.origin;
  const Vec2 c2 = 3 * rise - 2 * d0 - d1, c3 = d0 + d1 - 2 * rise;
  direction = r > 0 ? normalized(d0 + 2 * f * c2 + 3 * f * f * c3) : unit(launch.angle);
  return launch.origin + f * (d0 + f * (c2 + f * c3));
}

void Streamline::index_steps() {
  for (std::size_t i = step_starts_.size(); i < steps.size(); ++i) step_starts_.push_back(steps[i].s);
}

// The last step that begins at s or before, or the first one.
const StreamStep& Streamline::step_at(double s) const {
  if (step_starts_.size() == steps.size()) {
    const auto after = std::upper_bound(step_starts_.begin(), step_starts_.end(), s);
    return steps[std::max<std::ptrdiff_t>(after - step_starts_.begin(), 1) - 1];
  }
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), s, [](double v, const StreamStep& k) { return v < k.s; });
  return after == steps.begin() ? steps.front() : *(after - 1);
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const {
  if (s <= launch.radius || steps.empty()) return lead_in(std::max(s, 0.0), direction);
  if (s >= length()) {
    direction = unit(end_angle);
    return end_position;
  }
  const StreamStep& step = step_at(s);
  const double theta = std::clamp((s - step.s) / step.h, 0.0, 1.0);
  if (step.elem == in_the_plane) {
    direction = normalized(step.slope(theta));
    return step.xi(theta);
  }
  Vec2 x;
  Mat2 dx_dxi;
  evaluator.maps()[step.elem].evaluate(step.xi(theta), x, dx_dxi);
  direction = normalized(dx_dxi * step.slope(theta));
  return x;
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s) const {
  Vec2 direction;
  return at(evaluator, s, direction);
}

std::vector<double> Streamline::step_ends() const {
  std::vector<double> ends{0};
  for (const StreamStep& step : steps) ends.push_back(step.s);
  ends.push_back(length());
  return ends;
}

LinePasses::LinePasses(const field::FieldEvaluator& evaluator, const Streamline& line)
    : evaluator_(evaluator), line_(line) {
  const std::vector<double> ends = line.step_ends();
  for (size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && ends[i] > ends[i - 1]) s_.push_back((ends[i - 1] + ends[i]) / 2);
    if (s_.empty() || ends[i] > s_.back()) s_.push_back(ends[i]);
  }
  for (const double s : s_) x_.push_back(line.at(evaluator, s));
}

std::vector<LinePass> LinePasses::passes_of(Vec2 node, double slope, double max_distance) const {
  std::vector<LinePass> found;
  const size_t last = s_.size() - 1;
  double before = norm2(x_[0] - node), here = 0;
  for (size_t i = 1; i <= last; ++i, before = here) {
    here = norm2(x_[i] - node);
    if (here > before || (i < last && here >= norm2(x_[i + 1] - node))) continue;
    const double most = reach(i, slope, max_distance);
    if (here > most * most) continue;
    if (i == last && !ends_beside(node)) continue;
    found.push_back({s_[i - 1], i < last ? s_[i + 1] : s_[i], -1});
  }
  return found;
}

double LinePasses::reach(size_t i, double slope, double max_distance) const {
  const double spacing = s_[i] - s_[i - 1] + (i + 1 < s_.size() ? s_[i + 1] - s_[i] : 0.0);
  return std::max(slope * s_[i], max_distance) + spacing;
}

std::vector<int> LinePasses::nodes_near(const PointGrid& nodes, double slope, double max_distance) const {
  std::vector<int> near;
  for (size_t first = 1; first < s_.size(); first += samples_per_box) {
    const size_t last = std::min(first + samples_per_box, s_.size()) - 1;
    Vec2 low = x_[first], high = x_[first];
    double margin = 0;
    for (size_t i = first; i <= last; ++i) {
      low = {std::min(low.x, x_[i].x), std::min(low.y, x_[i].y)};
      high = {std::max(high.x, x_[i].x), std::max(high.y, x_[i].y)};
      margin = std::max(margin, (1 + tolerance::round_off) * reach(i, slope, max_distance));
    }
    nodes.visit_box(low - Vec2{margin, margin}, high + Vec2{margin, margin}, [&](int n) { near.push_back(n); });
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

// The root of (node - x) . x', which decreases as the line passes the node.
double LinePasses::foot(Vec2 node, LinePass& pass) const {
  if (pass.foot >= 0) return pass.foot;
  const auto ahead = [&](double s) {
    Vec2 direction;
    const Vec2 x = line_.at(evaluator_, s, direction);
    return dot(node - x, direction);
  };
  return pass.foot = falling_root(ahead, pass.low, pass.high, 1e-13, 1e-14);
}

bool LinePasses::ends_beside(Vec2 node) const {
  const Vec2 gap = node - line_.end_position;
  if (line_.end == Streamline::End::node) return line_.end_position == node;
  return line_.end == Streamline::End::boundary && dot(gap, unit(line_.end_angle)) <= 0.5 * norm(gap);
}

}  // namespace quadrille::trace
