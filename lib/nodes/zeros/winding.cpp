#include "zeros/winding.hpp"

#include <algorithm>
#include <vector>

#include "base/angle.hpp"

namespace quadrille::zeros {
namespace {

struct FollowingRules {
  int steps = 128;          ///< of an arc
  double small_turn = 0.3;  ///< radians; a step that turns more is halved
  int max_halvings = 30;
};
constexpr FollowingRules rules;

class Follower {
 public:
  Follower(const field::FieldEvaluator& evaluator, Vec2 centre, double radius)
      : evaluator_(&evaluator), centre_(centre), radius_(radius) {}

  bool value(double angle, Vec2& v) {
    if (!evaluator_->value_at(centre_ + radius_ * unit(angle), v)) return false;
    least_ = std::min(least_, norm(v));
    return true;
  }
  /// Adds the turn from a to b, with the values va and vb; false if the phase cannot be followed.
  bool turn(double a, Vec2 va, double b, Vec2 vb, int halvings, double& sum) {
    const double step = std::atan2(cross(va, vb), dot(va, vb));
    if (std::abs(step) <= rules.small_turn || halvings == 0) {
      sum += step;
      return true;
    }
    Vec2 middle;
    const double m = 0.5 * (a + b);
    return value(m, middle) && turn(a, va, m, middle, halvings - 1, sum) && turn(m, middle, b, vb, halvings - 1, sum);
  }
  double least() const { return least_; }

 private:
  const field::FieldEvaluator* evaluator_;
  Vec2 centre_;
  double radius_, least_ = 1e300;
};

}  // namespace

std::optional<ArcTurn> phase_turn(const field::FieldEvaluator& evaluator, Vec2 centre, double radius, double angle0,
                                  double angle1) {
  constexpr int steps = rules.steps;
  Follower follower(evaluator, centre, radius);
  std::vector<Vec2> values(steps + 1);
  std::vector<int> inside;
  const auto angle = [&](int i) { return angle0 + (angle1 - angle0) * i / steps; };
  for (int i = 0; i <= steps; ++i)
    if (follower.value(angle(i), values[i])) inside.push_back(i);
  if (inside.size() < 2 || inside.back() - inside.front() != static_cast<int>(inside.size()) - 1) return {};
  ArcTurn result{0, 0, angle(inside.front()), angle(inside.back())};
  for (int i = inside.front(); i < inside.back(); ++i)
    if (!follower.turn(angle(i), values[i], angle(i + 1), values[i + 1], rules.max_halvings, result.turn)) return {};
  result.least_value = follower.least();
  return result;
}

std::optional<int> circle_index(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                double& least_value) {
  const std::optional<ArcTurn> turn = phase_turn(evaluator, centre, radius, 0, 2 * pi);
  if (!turn || turn->angle0 > 0 || turn->angle1 < 2 * pi) return {};
  least_value = turn->least_value;
  return static_cast<int>(std::lround(turn->turn / (2 * pi)));
}

}  // namespace quadrille::zeros
