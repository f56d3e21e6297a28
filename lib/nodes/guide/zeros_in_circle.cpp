#include "guide/zeros_in_circle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <optional>
#include <vector>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"

namespace quadrille::guide {
namespace {

using Complex = std::complex<double>;

constexpr int num_samples = 128;

/// w at equidistant points of the circle, counter-clockwise from the direction of x; conjugated for a negative index,
/// which exchanges A and B. std::nullopt if one of the points is outside the mesh.
std::optional<std::vector<Complex>> circle_samples(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                   int index) {
  std::vector<Complex> result;
  for (int i = 0; i < num_samples; ++i) {
    Vec2 v;
    if (!evaluator.value_at(centre + radius * unit(2 * pi * i / num_samples), v)) return {};
    result.emplace_back(v.x, index < 0 ? -v.y : v.y);
  }
  return result;
}

/// The coefficient c_k of the samples, |k| < half their number.
Complex fourier_coefficient(const std::vector<Complex>& w, int k) {
  const int n = static_cast<int>(w.size());
  Complex sum = 0;
  for (int i = 0; i < n; ++i) sum += w[i] * std::polar(1.0, -2 * pi * ((i * k) % n) / n);
  return sum / static_cast<double>(n);
}

/// A with the constant at the sampled points, from the samples w of a positive index; for a negative one B.
std::vector<Complex> analytic_part(const std::vector<Complex>& w) {
  const int n = static_cast<int>(w.size());
  std::vector<Complex> coefficients, part;
  for (int k = 0; k < n / 2; ++k) coefficients.push_back(fourier_coefficient(w, k));
  for (int i = 0; i < n; ++i) {
    const Complex zeta = std::polar(1.0, 2 * pi * i / n);
    Complex sum = 0;
    for (int k = n / 2; k-- > 0;) sum = sum * zeta + coefficients[k];
    part.push_back(sum);
  }
  return part;
}

double power(const std::vector<Complex>& w) {
  double sum = 0;
  for (const Complex value : w) sum += std::norm(value);
  return sum / static_cast<double>(w.size());
}

/// One step to the centroid from samples about z0; std::nullopt if the index's own term does not outweigh the others.
std::optional<Vec2> step(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double radius) {
  const auto w = circle_samples(evaluator, centre, radius, index);
  if (!w) return {};
  const int n = std::abs(index);
  const Complex leading = fourier_coefficient(*w, n);
  if (!(std::norm(leading) > 0.9 * power(*w))) return {};
  const Complex shift = -fourier_coefficient(*w, n - 1) * radius / (static_cast<double>(n) * leading);
  return Vec2{shift.real(), shift.imag()};
}

/// Repeats the step, because terms of higher order shift the result away from the centroid.
std::optional<Vec2> centroid(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double radius) {
  for (int round = 0; round < 8; ++round) {
    const auto shift = step(evaluator, centre, index, radius);
    if (!shift) return {};
    centre += *shift;
    if (norm(*shift) < 1e-14 * radius) break;
  }
  return centre;
}

struct OppositeRules {
  double nearest = 0.4, near = 0.6;               ///< of the distance to the boundary from a zero
  double first_circle = 1.05, next_circle = 1.1;  ///< radii, over the zeros' extent and over the one before
};
constexpr OppositeRules opposite_rules;

using Zeros = std::vector<zeros::FoundZero>;
using Group = std::vector<int>;

/// The zeros that are linked to zero i through its distance to the boundary.
Group linked_zeros(const curve::FaceBoundary& boundary, const Zeros& zeros, int i) {
  const auto gap = [&](int j) { return distance(zeros[i].x, zeros[j].x); };
  Group opposite;
  for (int j = 0; j < static_cast<int>(zeros.size()); ++j)
    if (zeros[j].index * zeros[i].index < 0) opposite.push_back(j);
  if (opposite.empty()) return {};
  const double reach = (1 + tolerance::tied) * boundary.signed_distance(zeros[i].x);
  const auto is_nearest = [&](int j) { return gap(j) <= opposite_rules.nearest * reach; };
  if (std::none_of(opposite.begin(), opposite.end(), is_nearest)) return {};
  std::erase_if(opposite, [&](int j) {
    return gap(j) > opposite_rules.near * reach || !boundary.is_visible(zeros[i].x, zeros[j].x);
  });
  return opposite;
}

int total_index(const Zeros& zeros, const Group& group) {
  int sum = 0;
  for (const int i : group) sum += zeros[i].index;
  return sum;
}

/// The circle about the centroid of the zeros through the farthest of them.
zeros::Disc circle_about(const Zeros& zeros, const Group& group) {
  zeros::Disc circle;
  for (const int i : group) circle.centre += zeros[i].x / static_cast<double>(group.size());
  for (const int i : group) circle.radius = std::max(circle.radius, distance(zeros[i].x, circle.centre));
  return circle;
}

Group zeros_inside(const Zeros& zeros, const zeros::Disc& circle) {
  Group inside;
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i)
    if (distance(zeros[i].x, circle.centre) < circle.radius) inside.push_back(i);
  return inside;
}

/// The turns of a closed sequence of values about 0.
int winding(const std::vector<Complex>& values) {
  double angle = 0;
  for (std::size_t i = 0; i < values.size(); ++i) angle += std::arg(values[(i + 1) % values.size()] / values[i]);
  return static_cast<int>(std::lround(angle / (2 * pi)));
}

/// Whether at each sample of the circle the analytic part of the index's sign is the greater one, and has this index.
bool is_dominated(const field::FieldEvaluator& evaluator, const zeros::Disc& circle, int index) {
  const auto w = circle_samples(evaluator, circle.centre, circle.radius, index);
  if (!w) return false;
  const std::vector<Complex> part = analytic_part(*w);
  for (std::size_t i = 0; i < w->size(); ++i)
    if (!(std::abs(part[i]) > std::abs((*w)[i] - part[i]))) return false;
  return winding(part) == std::abs(index);
}

/// The zeros in the smallest circle about the group that is dominated. If no circle is, the search goes on about the
/// centroid of all zeros that are nearer than the boundary.
std::optional<Group> dominated_zeros(const field::FieldEvaluator& evaluator, const curve::FaceBoundary& boundary,
                                     const Zeros& zeros, Group group) {
  for (;;) {
    zeros::Disc circle = circle_about(zeros, group);
    const double outer = boundary.signed_distance(circle.centre);
    Group inside;
    for (circle.radius *= opposite_rules.first_circle; circle.radius < outer;
         circle.radius *= opposite_rules.next_circle) {
      inside = zeros_inside(zeros, circle);
      if (is_dominated(evaluator, circle, total_index(zeros, inside))) return inside;
    }
    if (inside.size() <= group.size()) return std::nullopt;
    group = inside;
  }
}

/// Whether the zeros contain each set as a whole or not at all.
bool contains_whole_sets(const Group& zeros, DisjointSets& sets, const std::vector<Group>& all) {
  std::size_t count = 0;
  for (const Group& set : all) {
    const bool is_met = std::any_of(zeros.begin(), zeros.end(), [&](int i) { return sets.find(i) == set[0]; });
    if (is_met) count += set.size();
  }
  return count == zeros.size();
}

void unite(DisjointSets& sets, const Group& group) {
  for (const int i : group) sets.unite(i, group[0]);
}

}  // namespace

std::optional<Vec2> moment_centre(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double inner,
                                  double outer) {
  for (double radius = outer; radius >= inner; radius *= 0.8) {
    const auto found = centroid(evaluator, centre, index, radius);
    if (found && distance(*found, centre) <= inner) return found;
  }
  return {};
}

std::vector<std::vector<int>> opposite_zeros(const field::FieldEvaluator& evaluator,
                                             const curve::FaceBoundary& boundary, const Zeros& zeros) {
  DisjointSets linked(zeros.size()), replaced(zeros.size());
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    Group group = linked_zeros(boundary, zeros, i);
    group.push_back(i);
    unite(linked, group);
    if (std::abs(total_index(zeros, group)) <= 1) unite(replaced, group);
  }
  const std::vector<Group> groups = linked.sets();
  for (const Group& group : groups) {
    if (std::abs(total_index(zeros, group)) <= 1) continue;  // single zeros too
    const std::optional<Group> wider = dominated_zeros(evaluator, boundary, zeros, group);
    if (wider && contains_whole_sets(*wider, linked, groups)) unite(replaced, *wider);
  }
  std::vector<Group> result = replaced.sets();
  std::erase_if(result, [](const Group& group) { return group.size() == 1; });
  return result;
}

}  // namespace quadrille::guide
