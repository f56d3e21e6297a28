#include "field/explicit_value.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

#include "base/angle_sum.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {
namespace {

// A point nearer to an apex than this, relative to |c - p_c|, is treated as the apex: the direction to it is noise.
constexpr double apex_tol = 1e-13;

Lifting lifting(const CornerAngle& corner) { return {-1, corner.apex, corner.pole, {}}; }

bool is_apex(const CornerAngle& corner, Vec2 x) {
  return norm2(x - corner.apex) <= apex_tol * apex_tol * norm2(corner.pole - corner.apex);
}

// The sum of turns * arg(x - position), each principal value: products of complex numbers in place of arc tangents.
class PhaseSum {
 public:
  explicit PhaseSum(Vec2 x) : x_(x) {}

  void add(const PhaseTurn& turn) {
    const Vec2 r = x_ - turn.position;
    if (turn.turns == 0 || r == Vec2{}) return;
    if (r.y == 0 || std::abs(turn.turns) > most_batched) {  // AngleSums adds angles of less than half a turn
      rest_ += turn.turns * angle_of(r);
      return;
    }
    Batch& batch = batches_[turn.turns + most_batched];
    batch.x[batch.size] = r.x, batch.y[batch.size] = r.y;
    if (++batch.size == AngleSums::width) flush(batch, turn.turns);
  }

  double value() {
    for (int turns = -most_batched; turns <= most_batched; ++turns)
      if (turns != 0) flush(batches_[turns + most_batched], turns);
    double sum = rest_;
    for (int i = 0; i < AngleSums::width; ++i) sum += sums_.value(i);
    return sum;
  }

 private:
  static constexpr int most_batched = 4;
  /// Vectors of equally many turns, which are added at once.
  struct Batch {
    AngleSums::Values x{}, y{};
    int size = 0;
  };

  void flush(Batch& batch, int turns) {
    for (int i = batch.size; i < AngleSums::width; ++i) batch.x[i] = 1, batch.y[i] = 0;
    if (batch.size > 0) sums_.add(batch.x, batch.y, turns);
    batch.size = 0;
  }

  Vec2 x_;
  std::array<Batch, 2 * most_batched + 1> batches_;
  AngleSums sums_;
  double rest_ = 0;
};

double sum_of_turns(const std::vector<PhaseTurn>& turns, Vec2 x) {
  PhaseSum sum(x);
  for (const PhaseTurn& turn : turns) sum.add(turn);
  return sum.value();
}

// z times (x - a)^d for each turn, (towards - x)^d where x is a. The
// result is not normalised; it is rescaled only to avoid overflow and underflow.
Vec2 turned(Vec2 z, const std::vector<PhaseTurn>& turns, Vec2 x, Vec2 towards) {
  for (const PhaseTurn& turn : turns) {
    const Vec2 r = x == turn.position ? towards - x : x - turn.position;
    if (r == Vec2{}) continue;
    const Vec2 factor = turn.turns > 0 ? r : Vec2{r.x, -r.y};
    for (int i = std::abs(turn.turns); i > 0; --i) {
      z = product(z, factor);
      const double size = std::abs(z.x) + std::abs(z.y);
      if (size < 1e-50 || size > 1e50) z = z / size;
    }
  }
  return z;
}

Vec2 gradient_of_turns(const std::vector<PhaseTurn>& turns, Vec2 x) {
  Vec2 sum;
  for (const PhaseTurn& turn : turns) {
    const Vec2 r = x - turn.position;
    if (turn.turns != 0) sum += turn.turns * left_of(r) / norm2(r);
  }
  return sum;
}

}  // namespace

double lifting_angle(const Lifting& lifting, Vec2 x) {
  const Vec2 a = x - lifting.apex, b = x - lifting.pole;
  return std::atan2(cross(b, a), dot(b, a));
}

Vec2 lifting_sum(const std::vector<Lifting>& liftings, Vec2 x) {
  Vec2 sum;
  for (const Lifting& lifting : liftings) sum += lifting_angle(lifting, x) * lifting.jump;
  return sum;
}

Vec2 lifting_gradient(const Lifting& lifting, Vec2 x) {
  const Vec2 a = x - lifting.apex, b = x - lifting.pole;
  return left_of(a) / norm2(a) - left_of(b) / norm2(b);
}

double lifting_angle_at_apex(const Lifting& lifting, Vec2 d) {
  const Vec2 b = lifting.apex - lifting.pole;
  return std::atan2(cross(b, d), dot(b, d));
}

double corner_angle(const CornerAngle& corner, Vec2 x, Vec2 inward) {
  return is_apex(corner, x) ? lifting_angle_at_apex(lifting(corner), inward) : lifting_angle(lifting(corner), x);
}

double explicit_phase(const PhaseTerms& terms, Vec2 x, Vec2 inward) {
  double phase = sum_of_turns(terms.nodes, x) + sum_of_turns(terms.holes, x) + sum_of_turns(terms.images, x);
  for (const CornerAngle& corner : terms.corner_angles) phase += corner.beta * corner_angle(corner, x, inward);
  return phase;
}

Vec2 explicit_direction(const PhaseTerms& terms, Vec2 x, Vec2 towards, double remainder) {
  double angle = remainder;
  for (const CornerAngle& corner : terms.corner_angles) {
    const Vec2 inward = is_apex(corner, x) ? normalized(towards - x) : Vec2{};
    angle += corner.beta * corner_angle(corner, x, inward);
  }
  const Vec2 z = turned(turned(turned(unit(angle), terms.nodes, x, x), terms.holes, x, towards), terms.images, x, x);
  return normalized(z);
}

Vec2 explicit_phase_gradient(const PhaseTerms& terms, Vec2 x) {
  Vec2 gradient =
      gradient_of_turns(terms.nodes, x) + gradient_of_turns(terms.holes, x) + gradient_of_turns(terms.images, x);
  for (const CornerAngle& corner : terms.corner_angles) gradient += corner.beta * lifting_gradient(lifting(corner), x);
  return gradient;
}

RemainderSample remainder_sample(const spectral::TriMap& map, int order, const double* coefs, Vec2 xi) {
  RemainderSample sample;
  map.evaluate(xi, sample.x, sample.dx_dxi);
  Mat2 ds_dxi;
  sample.value = spectral::orthogonal_sum(order, coefs, coefs, xi, ds_dxi).x;
  const Mat2 ds_dx = ds_dxi * inverse(sample.dx_dxi);
  sample.slope = {ds_dx.xx, ds_dx.xy};
  return sample;
}

}  // namespace quadrille::field
