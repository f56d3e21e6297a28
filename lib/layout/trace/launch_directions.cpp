#include "trace/launch_directions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"

namespace quadrille::trace {
namespace {

// The solution of g = target on pieces [breaks[i], breaks[i+1]] on which g is monotone; of several the middle one.
double middle_root(const std::function<double(double)>& g, const std::vector<double>& breaks, double target) {
  const auto f = [&](double x) { return g(x) - target; };
  std::vector<double> roots;
  double low = f(breaks.front());
  for (size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double high = f(breaks[i + 1]);
    if ((low < 0) != (high < 0)) roots.push_back(bisect(f, breaks[i], breaks[i + 1]));
    low = high;
  }
  if (roots.empty()) {  // the target equals the value at an end up to round-off
    const auto nearer = [&](double a, double b) { return std::abs(f(a)) < std::abs(f(b)); };
    return *std::min_element(breaks.begin(), breaks.end(), nearer);
  }
  return roots[roots.size() / 2];
}

// J = R(left) diag(major, +-minor) R(-right), major >= minor >= 0.
struct SingularValues {
  double major, minor, left, right;
};

SingularValues singular_values(const Mat2& j) {
  const Vec2 sum{j.xx + j.yy, j.yx - j.xy}, difference{j.xx - j.yy, j.yx + j.xy};
  const double a = norm(sum) / 2, b = norm(difference) / 2;  // J z = sum z / 2 + difference conj(z) / 2
  const double angle_a = a > 0 ? angle_of(sum) : 0, angle_b = b > 0 ? angle_of(difference) : 0;
  return {a + b, std::abs(a - b), (angle_a + angle_b) / 2, (angle_b - angle_a) / 2};
}

// arg(major cos phi + i minor sin phi), continuous in phi.
double stretched_angle(double phi, double major, double minor) {
  const double turns = std::round(phi / (2 * pi));
  const double rest = phi - 2 * pi * turns;
  return 2 * pi * turns + std::atan2(minor * std::sin(rest), major * std::cos(rest));
}

/// G(alpha) = 4 alpha - arg v at distance `radius` from a point, unwrapped on a polygon of an arc; between its vertices
/// linear, then by bisection. Outside the mesh, beside the ends of the arc, v is that of a boundary along the arc's
/// end.
class RadialPhase {
 public:
  RadialPhase(const field::FieldEvaluator& evaluator, Vec2 centre, double radius, double from, double to)
      : evaluator_(evaluator), centre_(centre), radius_(radius), from_(from), to_(to) {
    samples_.push_back(at(from, 0));
    for (int i = 1; i <= num_samples; ++i) samples_.push_back(at(angle(i), samples_.back()));
  }

  double first() const { return samples_.front(); }

  /// The first alpha with G(alpha) = target.
  double solve(double target) const {
    int i = 0;
    while (i + 1 < num_samples && samples_[i + 1] < target) ++i;
    return bisect([&](double alpha) { return at(alpha, target) - target; }, angle(i), angle(i + 1));
  }

 private:
  static constexpr int num_samples = 256;

  double angle(int i) const { return from_ + (to_ - from_) * i / num_samples; }

  double at(double alpha, double near) const {
    Vec2 value;
    if (!evaluator_.value_at(centre_ + radius_ * unit(alpha), value))
      value = cross_value(2 * alpha < from_ + to_ ? from_ : to_);
    return near + wrap_pi(4 * alpha - angle_of(value) - near);
  }

  const field::FieldEvaluator& evaluator_;
  Vec2 centre_;
  double radius_, from_, to_;
  std::vector<double> samples_;
};

}  // namespace

std::vector<double> launch_directions(const Mat2& j) {
  const SingularValues s = singular_values(j);
  const int sign = det(j) > 0 ? 1 : -1, valence = 4 - sign;
  const auto g = [&](double phi) {
    return 4 * (phi + s.right) - s.left - sign * stretched_angle(phi, s.major, s.minor);
  };
  // phi = 0, the greatest stretch, is where G rises fastest; with index +1 it may decrease about phi = +-pi/2.
  std::vector<double> breaks{0};
  const double cos2 = s.minor * (s.major / 4 - s.minor) / ((s.major - s.minor) * (s.major + s.minor));
  if (sign > 0 && s.major > 4 * s.minor) {
    const double phi = std::acos(std::sqrt(cos2));
    for (const double at : {phi, pi - phi, pi + phi, 2 * pi - phi}) breaks.push_back(at);
  }
  breaks.push_back(2 * pi);
  const double first = std::ceil(g(0) / (2 * pi) - 1e-12);
  std::vector<double> directions;
  directions.reserve(valence);
  for (int k = 0; k < valence; ++k) directions.push_back(s.right + middle_root(g, breaks, 2 * pi * (first + k)));
  return directions;
}

std::vector<double> launch_directions_on_circle(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                int valence) {
  const RadialPhase g(evaluator, centre, radius, 0, 2 * pi);
  const double first = std::ceil(g.first() / (2 * pi) - 1e-9);
  std::vector<double> directions;
  for (int k = 0; k < valence; ++k) directions.push_back(g.solve(2 * pi * (first + k)));
  return directions;
}

std::vector<double> launch_directions_on_arc(const field::FieldEvaluator& evaluator, Vec2 apex, double tangent_out,
                                             double interior_angle, double radius, int valence) {
  const RadialPhase g(evaluator, apex, radius, tangent_out, tangent_out + interior_angle);
  const double side = std::round(g.first() / (2 * pi));  // the side's direction is one of the cross
  std::vector<double> directions;
  for (int k = 1; k < valence; ++k) directions.push_back(g.solve(2 * pi * (side + k)) - tangent_out);
  return directions;
}

std::vector<double> corner_launch_directions(double interior_angle, int valence) {
  // In the frame of the outgoing side v moves straight from (1, 0) to the value of the other side; the valence
  // determines on which side of 0 it passes (at a tie, 4 omega = pi mod 2 pi, through 0: the bisector is the limit of
  // either).
  const double omega = interior_angle, turn = 4 * omega - 2 * pi * valence;
  const bool has_chord = std::abs(turn) < pi + 1e-6;
  const double half_chord = std::tan(std::clamp(turn, -pi + 1e-9, pi - 1e-9) / 2);
  const auto phase = [&](double theta) {
    if (!has_chord || std::abs(turn) < 1e-12) return turn * theta / omega;
    return turn / 2 + std::atan(half_chord * (2 * theta / omega - 1));
  };
  std::vector<double> breaks{0};
  const double fan = half_chord / (2 * omega) - 1;  // square of the position on the chord where G' = 0
  if (has_chord && fan > 0) {
    const double offset = omega / 2 * std::sqrt(fan) / half_chord;
    breaks.push_back(omega / 2 - offset);
    breaks.push_back(omega / 2 + offset);
  }
  breaks.push_back(omega);
  std::vector<double> directions;
  for (int k = 1; k < valence; ++k)
    directions.push_back(middle_root([&](double a) { return 4 * a - phase(a); }, breaks, 2 * pi * k));
  return directions;
}

std::vector<double> phase_launch_directions(double phi_0, int valence) {
  std::vector<double> directions;
  directions.reserve(valence);
  for (int k = 0; k < valence; ++k) directions.push_back((phi_0 + 2 * pi * k) / valence);
  return directions;
}

std::vector<double> phase_corner_launch_directions(double interior_angle, int valence) {
  std::vector<double> directions;
  for (int k = 1; k < valence; ++k) directions.push_back(interior_angle * k / valence);
  return directions;
}

}  // namespace quadrille::trace
