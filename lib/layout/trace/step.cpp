#include "trace/step.hpp"

#include <cmath>
#include <limits>

#include "base/angle.hpp"

namespace quadrille::trace {
namespace {

constexpr double a21 = 1.0 / 5;
constexpr double a31 = 3.0 / 40, a32 = 9.0 / 40;
constexpr double a41 = 44.0 / 45, a42 = -56.0 / 15, a43 = 32.0 / 9;
constexpr double a51 = 19372.0 / 6561, a52 = -25360.0 / 2187, a53 = 64448.0 / 6561, a54 = -212.0 / 729;
constexpr double a61 = 9017.0 / 3168, a62 = -355.0 / 33, a63 = 46732.0 / 5247, a64 = 49.0 / 176, a65 = -5103.0 / 18656;
constexpr double a71 = 35.0 / 384, a73 = 500.0 / 1113, a74 = 125.0 / 192, a75 = -2187.0 / 6784, a76 = 11.0 / 84;
constexpr double e1 = 71.0 / 57600, e3 = -71.0 / 16695, e4 = 71.0 / 1920, e5 = -17253.0 / 339200, e6 = 22.0 / 525,
                 e7 = -1.0 / 40;
constexpr double d1 = -12715105075.0 / 11282082432.0, d3 = 87487479700.0 / 32700410799.0,
                 d4 = -10690763975.0 / 1880347072.0, d5 = 701980252875.0 / 199316789632.0,
                 d6 = -1453857185.0 / 822651844.0, d7 = 69997945.0 / 29380423.0;

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
  if (!stage(a21 * k1, k2)) return;
  if (!stage(a31 * k1 + a32 * k2, k3)) return;
  if (!stage(a41 * k1 + a42 * k2 + a43 * k3, k4)) return;
  if (!stage(a51 * k1 + a52 * k2 + a53 * k3 + a54 * k4, k5)) return;
  if (!stage(a61 * k1 + a62 * k2 + a63 * k3 + a64 * k4 + a65 * k5, k6)) return;
  const Vec2 slope = a71 * k1 + a73 * k3 + a74 * k4 + a75 * k5 + a76 * k6;
  double angle = 0;
  Mat2 dx_dxi;
  if (!rate_at(evaluator, state.elem, y + h * slope, state.angle, state.is_straight, k7, angle, dx_dxi)) return;
  error = h * norm(dx_dxi * (e1 * k1 + e3 * k3 + e4 * k4 + e5 * k5 + e6 * k6 + e7 * k7));
  end = {state.elem, y + h * slope, angle, k7, state.is_straight};
  const Vec2 rise = h * slope, bend = h * k1 - rise;
  step.elem = state.elem;
  step.h = step.length = h;
  step.dense = {y, rise, bend, rise - h * k7 - bend, h * (d1 * k1 + d3 * k3 + d4 * k4 + d5 * k5 + d6 * k6 + d7 * k7)};
}

}  // namespace quadrille::trace
