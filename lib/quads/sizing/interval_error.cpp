#include "sizing/interval_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::sizing {
namespace {

/// Row i: the polynomial of an interval's nodes at sample i.
struct Samples {
  std::vector<double> points;
  Eigen::MatrixXd from_nodes;

  Samples(int order, std::vector<double> at)
      : points(std::move(at)), from_nodes(spectral::interpolation_matrix(spectral::gll_points(order), points)) {}
};

/// Between the nodes.
const Samples& error_samples(int order) {
  static spectral::PerOrder<Samples> cache([](int n) {
    const int count = 2 * n + 2;
    std::vector<double> points;
    for (int i = 0; i < count; ++i) points.push_back(-std::cos((2 * i + 1) * pi / (2 * count)));
    return Samples(n, points);
  });
  return cache[order];
}

/// As a polygon, for the distance of points that may be far from the point of equal parameter.
const Samples& polygon_samples(int order) {
  static spectral::PerOrder<Samples> cache([](int n) {
    std::vector<double> points;
    for (int i = 0; i <= 16 * n; ++i) points.push_back(-1 + 2.0 * i / (16 * n));
    return Samples(n, points);
  });
  return cache[order];
}

/// Distance of x from the parabola through three points at s = -1, 0, 1, for s in [-1, 1]. On a polynomial of a smooth
/// side it is that polynomial but for terms of third order in the spacing of the points.
double distance_to_parabola(Vec2 x, Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 slope = (c - a) / 2, bend = a - 2 * b + c;
  const double length2 = norm2(c - a);
  double s = length2 > 0 ? std::clamp(2 * dot(x - (a + c) / 2, c - a) / length2, -1.0, 1.0) : 0;
  const auto at = [&](double u) { return b + u * slope + (u * u / 2) * bend; };
  for (int step = 0; step < 4; ++step) {
    const Vec2 tangent = slope + s * bend, off = at(s) - x;
    const double curvature = norm2(tangent) + dot(off, bend);
    if (!(curvature > 0)) break;
    s = std::clamp(s - dot(off, tangent) / curvature, -1.0, 1.0);
  }
  return distance(x, at(s));
}

/// The nodes' polynomial as a polygon, and the distances of the points before and after each point.
struct Polygon {
  std::vector<Vec2> points;
  std::vector<double> chords;
};

double distance_from(const Polygon& polygon, Vec2 x) {
  const std::vector<Vec2>& points = polygon.points;
  double nearest2 = norm2(x - points[0]);
  for (const Vec2 point : points) nearest2 = std::min(nearest2, norm2(x - point));
  double nearest = std::sqrt(nearest2);
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const double reach = nearest + polygon.chords[k];
    if (norm2(x - points[k]) < reach * reach)
      nearest = std::min(nearest, distance_to_parabola(x, points[k - 1], points[k], points[k + 1]));
  }
  return nearest;
}

/// Distance of the chain's breaks, and of points between them, from the interval's polynomial: there a kink or a short
/// bend such as a fillet is farthest from it, which comparison at nodes or at equal parameters would miss.
double bend_error(const curve::Chain& chain, double low, double high, const std::vector<curve::ChainPoint>& nodes,
                  int order) {
  std::vector<double> ends{low};
  for (const double f : chain.break_fractions())
    if (f > low + tolerance::round_off && f < high - tolerance::round_off) ends.push_back(f);
  if (ends.size() == 1) return 0;
  ends.push_back(high);

  const Eigen::MatrixXd& from_nodes = polygon_samples(order).from_nodes;
  Polygon polygon{std::vector<Vec2>(from_nodes.rows()), std::vector<double>(from_nodes.rows())};
  std::vector<Vec2>& points = polygon.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k <= order; ++k) points[i] += from_nodes(static_cast<int>(i), k) * nodes[k].position;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) polygon.chords[i] = distance(points[i - 1], points[i + 1]);

  double worst = 0;
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (const double part : {0.0, 0.25, 0.5, 0.75})
      worst = std::max(worst, distance_from(polygon, chain.position(ends[i - 1] + part * (ends[i] - ends[i - 1]))));
  return worst;
}

double between(double low, double high, double xi) { return low * (1 - xi) / 2 + high * (1 + xi) / 2; }

/// Distance of x from a curve whose nearest point has about the parameter t: a Newton step, then the distance from the
/// tangent.
double distance_from(const Nurbs& curve, Vec2 x, double t) {
  const auto [at, slope] = curve::point_and_derivative(curve, t);
  const double speed2 = norm2(slope);
  if (speed2 == 0) return distance(x, at);
  const auto [near, along] = curve::point_and_derivative(curve, t + dot(x - at, slope) / speed2);
  const double speed = norm(along);
  return speed == 0 ? distance(x, near) : std::abs(cross(x - near, along)) / speed;
}

/// The same for a chain by its fraction, which measures length: no step is needed.
double distance_from(const curve::Chain& chain, Vec2 x, double fraction) {
  const curve::ChainPoint near = chain.at(fraction);
  return std::abs(cross(x - near.position, near.tangent));
}

}  // namespace

double interval_error(const curve::CurveTable& table, const curve::Chain& chain, double low, double high, int order) {
  const Samples& samples = error_samples(order);
  std::vector<curve::ChainPoint> nodes;
  for (const double xi : spectral::gll_points(order)) nodes.push_back(chain.at(between(low, high, xi)));
  const int piece = nodes[order / 2].piece;
  const bool in_one_piece =
      std::all_of(nodes.begin(), nodes.end(), [&](const curve::ChainPoint& p) { return p.piece == piece; });
  double worst = std::max(0.0, bend_error(chain, low, high, nodes, order));
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    Vec2 value;
    double t = 0;
    for (int k = 0; k <= order; ++k) {
      const double weight = samples.from_nodes(static_cast<int>(i), k);
      value += weight * nodes[k].position;
      t += weight * nodes[k].t;
    }
    worst = std::max(worst, in_one_piece ? distance_from(table.curve(chain.pieces()[piece].curve), value, t)
                                         : distance_from(chain, value, between(low, high, samples.points[i])));
  }
  return worst;
}

}  // namespace quadrille::sizing
