#include "trace/merged_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::trace {
namespace {

constexpr int num_samples = 48;

// Both lines and their blend at one fraction of the lengths.
struct Blend {
  Vec2 position, derivative;  // of M, with respect to f
  Vec2 along_a, along_b;      // unit directions of both lines, each its own
};

Blend blend(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
            const MergeCandidate& candidate, double f) {
  const double c = std::cos(half_pi * f), w = c * c, slope = -half_pi * std::sin(pi * f);
  const double length_a = candidate.length_a, length_b = candidate.length_b;
  Blend m;
  const Vec2 xa = a.at(evaluator, f * length_a, m.along_a), xb = b.at(evaluator, (1 - f) * length_b, m.along_b);
  m.position = w * xa + (1 - w) * xb;
  m.derivative = w * length_a * m.along_a - (1 - w) * length_b * m.along_b + slope * (xa - xb);
  return m;
}

// The joined line at fraction f of its length: position, and derivative with respect to f.
Vec2 joined(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b, double length, double f,
            Vec2& derivative) {
  Vec2 along, along_end;
  const Vec2 x = a.at(evaluator, f * length, along), end = a.at(evaluator, length, along_end);
  const Vec2 shift = b.launch.origin - end, bend = -length * (unit(b.launch.angle) + along_end);
  derivative = length * along + 6 * f * (1 - f) * shift + f * (3 * f - 2) * bend;
  return x + f * f * ((3 - 2 * f) * shift - (1 - f) * bend);
}

// Consecutive samples lie far from each other: the first one that deviates too far ends the loop.
bool blend_deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                            double max_deviation, MergeCandidate& candidate) {
  constexpr int stride = 19;  // no divisor in common with num_samples
  for (int i = stride; i != 0; i = (i + stride) % num_samples) {
    const double f = static_cast<double>(i) / num_samples, w = std::pow(std::cos(half_pi * f), 2);
    const Blend m = blend(evaluator, a, b, candidate, f);
    const double angle = angle_between(m.derivative, w * m.along_a - (1 - w) * m.along_b);
    candidate.deviation = std::max(candidate.deviation, angle);
    if (candidate.deviation > max_deviation) return false;
  }
  return true;
}

bool join_deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                           double max_deviation, MergeCandidate& candidate) {
  double guide = a.launch.angle;
  for (int i = 1; i < num_samples; ++i) {
    Vec2 derivative, value;
    const double f = static_cast<double>(i) / num_samples;
    if (!evaluator.value_at(joined(evaluator, a, b, candidate.length_a, f, derivative), value)) return false;
    guide = guided_angle(value, guide);
    candidate.deviation = std::max(candidate.deviation, angle_between(derivative, unit(guide)));
    if (candidate.deviation > max_deviation) return false;
  }
  return true;
}

}  // namespace

curve::CurveFunction merged_curve(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                                  const MergeCandidate& candidate) {
  return [&evaluator, &a, &b, candidate, length = candidate.length()](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0);
    Vec2 x;
    if (candidate.is_join) {
      x = joined(evaluator, a, b, length, f, derivative);
    } else {
      const Blend m = blend(evaluator, a, b, candidate, f);
      x = m.position, derivative = m.derivative;
    }
    derivative = derivative / length;
    return f == 0 ? a.launch.origin : f == 1 ? b.launch.origin : x;
  };
}

bool deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                      double max_deviation, MergeCandidate& candidate) {
  candidate.deviation = 0;
  return candidate.is_join ? join_deviates_at_most(evaluator, a, b, max_deviation, candidate)
                           : blend_deviates_at_most(evaluator, a, b, max_deviation, candidate);
}

}  // namespace quadrille::trace
