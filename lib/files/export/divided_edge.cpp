#include "export/divided_edge.hpp"

#include <algorithm>
#include <numeric>

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {
namespace {

/// Distance of x from the line through a and b.
double from_line(Vec2 x, Vec2 a, Vec2 b) { return std::abs(cross(normalized(b - a), x - a)); }

bool is_straight(const QuadMesh& mesh, const DividedEdge& edge) {
  const Vec2 a = edge.vertices.front(), b = edge.vertices.back();
  const double tol = 1e-10 * distance(a, b) + 1e-14 * mesh.face.diameter;
  if (distance(a, b) <= tol) return false;
  return std::all_of(edge.inner.begin(), edge.inner.end(), [&](Vec2 x) { return from_line(x, a, b) <= tol; });
}

/// blockMesh's mean in one direction: two edges, one on each side, at weights of their own.
struct TwoEdges {
  Vec2 straight, curved;  ///< mean of the points on the chords; mean deviation of the edges from them
};

TwoEdges mean(double low_weight, Vec2 low_chord, Vec2 low, double high_weight, Vec2 high_chord, Vec2 high) {
  const double sum = low_weight + high_weight;
  const double l = low_weight / sum, h = high_weight / sum;
  return {l * low_chord + h * high_chord, l * (low - low_chord) + h * (high - high_chord)};
}

}  // namespace

std::vector<double> DividedEdge::weights() const {
  std::vector<double> sums{0};
  for (const double fraction : fractions) sums.push_back(sums.back() + fraction);
  sums.back() = 1;
  return sums;
}

DividedEdge DividedEdge::reversed() const {
  DividedEdge other = *this;
  std::reverse(other.vertices.begin(), other.vertices.end());
  std::reverse(other.fractions.begin(), other.fractions.end());
  std::reverse(other.inner.begin(), other.inner.end());
  return other;
}

DividedEdge divided_edge(const QuadMesh& mesh, const std::vector<SkeletonEdge>& sides) {
  const std::vector<double> between{-0.5, 0, 0.5};
  const Eigen::MatrixXd basis = spectral::interpolation_matrix(spectral::gll_points(mesh.order), between);
  DividedEdge edge;
  edge.vertices.push_back(mesh.nodes[side_start(mesh, sides.front().elem, sides.front().side)]);
  for (const SkeletonEdge& side : sides) {
    const std::vector<int> nodes = side_nodes(mesh, side.elem, side.side);
    Vec2 previous = edge.vertices.back();
    double length = 0;
    const auto go_to = [&](Vec2 x) {
      length += distance(previous, x);
      edge.inner.push_back(previous = x);
    };
    for (int row = 0; mesh.order > 1 && row < 3; ++row) {
      Vec2 x;
      for (int k = 0; k <= mesh.order; ++k) x += basis(row, k) * mesh.nodes[nodes[k]];
      go_to(x);
    }
    go_to(mesh.nodes[nodes.back()]);
    edge.vertices.push_back(previous);
    edge.fractions.push_back(length);
  }
  edge.inner.pop_back();
  const double sum = std::accumulate(edge.fractions.begin(), edge.fractions.end(), 0.0);
  for (double& fraction : edge.fractions) fraction /= sum;
  edge.is_straight = is_straight(mesh, edge);
  return edge;
}

std::vector<Vec2> block_mesh_points(const DividedEdge& bottom, const DividedEdge& right, const DividedEdge& top,
                                    const DividedEdge& left) {
  const Vec2 a = bottom.vertices.front(), b = bottom.vertices.back(), c = top.vertices.back(), d = left.vertices.back();
  const std::vector<double> wb = bottom.weights(), wr = right.weights(), wt = top.weights(), wl = left.weights();
  std::vector<Vec2> points;
  for (int j = 0; j <= left.num_cells(); ++j)
    for (int i = 0; i <= bottom.num_cells(); ++i) {
      const double s = wb[i], u = wt[i], t = wl[j], v = wr[j];  // fractions: below, above, left, right
      const TwoEdges along_i = mean((1 - s) * (1 - t) + s * (1 - v), a + s * (b - a), bottom.vertices[i],
                                    (1 - u) * t + u * v, d + u * (c - d), top.vertices[i]);
      const TwoEdges along_j = mean((1 - t) * (1 - s) + t * (1 - u), a + t * (d - a), left.vertices[j],
                                    (1 - v) * s + v * u, b + v * (c - b), right.vertices[j]);
      const double wa = (1 - s) * (1 - t), wbc = s * (1 - v), wc = u * v, wd = (1 - u) * t;
      const Vec2 corners = (wa * a + wbc * b + wc * c + wd * d) / (wa + wbc + wc + wd);
      points.push_back((along_i.straight + along_j.straight + corners) / 3 + along_i.curved + along_j.curved);
    }
  return points;
}

}  // namespace quadrille::exports
