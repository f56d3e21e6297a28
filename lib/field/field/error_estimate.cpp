#include "field/error_estimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "field/boundary_misfit.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {

namespace {

constexpr double rounding = 1e-15;  // of values of size 1
// A misfit is the maximum of values that change sign along an edge, whereas a tail is a mean: less of a misfit affects
// other elements.
constexpr double sent_of_misfit = 0.1;

// The local error of an element and the quantities that determine its effect on other elements.
struct Source {
  double tail = 0;        // tau
  double unresolved = 0;  // tau / sigma
  Vec2 centre;
  double radius = 0;
  int order = 1;
};

// Norms of the modes by degree: of both components of v, or of s for a phase.
std::vector<double> norms_by_degree(const Field& field, int elem) {
  const int order = field.elem_order[elem], offset = field.coef_offsets[elem];
  std::vector<double> norms(order + 1, 0.0);
  for (const auto* component : {&field.u, &field.v, &field.phase.s}) {
    if (component->empty()) continue;
    for (int d = 0, i = 0; d <= order; ++d) {
      for (; i < spectral::num_tri_modes(d); ++i) norms[d] += (*component)[offset + i] * (*component)[offset + i];
    }
  }
  for (double& norm : norms) norm = std::sqrt(norm);
  return norms;
}

// The tail extrapolated by one degree. The mean (degree 0) does not enter the convergence rate; order 2 has one norm
// for each of the two maxima, and order 1 has no rate.
double extrapolated_tail(const std::vector<double>& norms) {
  constexpr double slowest = 0.95;
  const int order = static_cast<int>(norms.size()) - 1;
  if (order == 1) return slowest * norms[1];
  const int width = order == 2 ? 1 : 2;  // number of degrees per maximum
  const double last = std::max(norms[order], norms[order - width + 1]);
  const double before = std::max(norms[order - width], norms[std::max(order - 2 * width + 1, 1)]);
  const double rate = before > 0 ? std::min(std::pow(last / before, 1.0 / width), slowest) : slowest;
  return rate * last;
}

Source source(const Field& field, int elem, double misfit) {
  const std::vector<double> norms = norms_by_degree(field, elem);
  const auto& [a, b, c] = field.mesh.elem2vertices[elem];
  const std::vector<Vec2>& x = field.mesh.vertices;
  Source s;
  s.order = field.elem_order[elem];
  s.tail = std::max(extrapolated_tail(norms), sent_of_misfit * misfit);
  const double variation = std::sqrt(std::inner_product(norms.begin() + 1, norms.end(), norms.begin() + 1, 0.0));
  s.unresolved = variation > 0 ? std::min(s.tail / variation, 1.0) : 1;
  s.centre = (x[a] + x[b] + x[c]) / 3;
  s.radius = std::sqrt(std::max({norm2(x[a] - s.centre), norm2(x[b] - s.centre), norm2(x[c] - s.centre)}));
  return s;
}

constexpr double capacity = 0.73;  // of an equilateral triangle of circumradius 1

double integer_power(double base, int exponent) {
  double power = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) power *= base;
  }
  return power;
}

// Fraction of the tail of source s that contributes to the error at a distance from it.
double weight(const Source& s, double distance) {
  const double nearness = s.radius / std::max(distance, s.radius);
  return nearness * std::max(integer_power(capacity * nearness, s.order + 1), s.unresolved);
}

// Beyond this distance the weight is s.unresolved * s.radius / distance.
double end_of_near_field(const Source& s) {
  return s.radius * std::max(1.0, capacity * std::pow(s.unresolved, -1.0 / (s.order + 1)));
}

// The sources with the greatest contributions, in descending order; equal ones by element number.
std::vector<int> strongest(const std::vector<Source>& sources) {
  constexpr std::size_t most = 512;
  std::vector<int> ranking(sources.size());
  std::iota(ranking.begin(), ranking.end(), 0);
  const auto sends_more = [&](int a, int b) {
    const double left = sources[a].tail * sources[a].radius, right = sources[b].tail * sources[b].radius;
    return left != right ? left > right : a < b;
  };
  const auto end = ranking.begin() + static_cast<std::ptrdiff_t>(std::min(most, ranking.size()));
  std::partial_sort(ranking.begin(), end, ranking.end(), sends_more);
  ranking.erase(end, ranking.end());
  return ranking;
}

// The sum of the tails of the strongest sources by their weights. Nearly all of them are far, and those are summed by
// vector instructions.
class RemoteErrors {
 public:
  explicit RemoteErrors(const std::vector<Source>& sources) : sources_(sources), senders_(strongest(sources)) {
    const auto n = static_cast<Eigen::Index>(senders_.size());
    x_.resize(n), y_.resize(n), strength_.resize(n), near2_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Source& s = sources[senders_[i]];
      const double near = end_of_near_field(s);
      x_[i] = s.centre.x, y_[i] = s.centre.y;
      strength_[i] = s.tail * s.unresolved * s.radius;
      near2_[i] = near * near;
    }
  }

  double at(int elem) {
    const Vec2 x = sources_[elem].centre;
    distance2_ = (x_ - x.x).square() + (y_ - x.y).square();
    double sum = (distance2_ > near2_).select(strength_ / distance2_.sqrt(), 0).sum();
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      if (distance2_[i] > near2_[i] || senders_[i] == elem) continue;
      const Source& s = sources_[senders_[i]];
      sum += s.tail * weight(s, std::sqrt(distance2_[i]));
    }
    return sum;
  }

 private:
  const std::vector<Source>& sources_;
  std::vector<int> senders_;
  Eigen::ArrayXd x_, y_, strength_, near2_;  // of the senders
  Eigen::ArrayXd distance2_;
};

}  // namespace

std::vector<double> error_estimate(const Field& field, const PhaseBoundary* phase_boundary, Progress* progress) {
  constexpr double share_from_afar = 0.1;
  const int n = field.mesh.num_elems();
  const Progress::Part part(progress, "error estimate", n + std::ssize(field.mesh.boundary_edges));
  const std::vector<double> misfits = boundary_misfit(field, phase_boundary);
  part.advance(std::ssize(field.mesh.boundary_edges));
  std::vector<Source> sources(n);
  for (int e = 0; e < n; ++e) sources[e] = source(field, e, misfits[e]);
  RemoteErrors remote(sources);
  std::vector<double> errors(n);
  for (int e = 0; e < n; ++e, part.advance())
    errors[e] = std::max(sources[e].tail, misfits[e]) + share_from_afar * remote.at(e) + rounding;
  return errors;
}

double position_error(const Mat2& j, double field_error) {
  const double sum = j.xx * j.xx + j.xy * j.xy + j.yx * j.yx + j.yy * j.yy, d = std::abs(det(j));
  const double greatest = std::sqrt((sum + std::sqrt(std::max(sum * sum - 4 * d * d, 0.0))) / 2);
  return d > 0 ? field_error * greatest / d : std::numeric_limits<double>::infinity();
}

}  // namespace quadrille::field
