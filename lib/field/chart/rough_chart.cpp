#include "chart/rough_chart.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::chart {
namespace {

using Complex = std::complex<double>;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// A triangle laid into the plane: corner 0 at 0, corner 1 on the positive real axis.
struct FlatTriangle {
  std::array<Complex, 3> corners;
  std::array<double, 3> angles{};
  std::array<double, 3> cotangents{};  ///< at the corner opposite to edge k, from corner k to k + 1

  Complex edge(int k) const { return corners[(k + 1) % 3] - corners[k]; }
};

// Cotangents of slivers are bounded, which keeps the system well conditioned and its matrix positive.
FlatTriangle flat_triangle(const IntrinsicTriangle& triangle) {
  constexpr double least_height = 1e-5;  // of the longest side
  const auto& [base, opposite, last] = triangle.lengths;
  const double along = (base * base + last * last - opposite * opposite) / (2 * base),
               longest = std::max({base, opposite, last});
  const double height = std::sqrt(std::max(last * last - along * along, 0.0));
  FlatTriangle t;
  t.corners = {Complex(0), Complex(base), Complex(along, std::max(height, least_height * longest * longest / base))};
  for (int k = 0; k < 3; ++k) {
    const Complex to_next = t.edge(k), to_last = t.corners[(k + 2) % 3] - t.corners[k];
    const Complex ratio = to_last * std::conj(to_next);
    t.angles[k] = std::arg(ratio);
    t.cotangents[(k + 1) % 3] = ratio.real() / ratio.imag();
  }
  return t;
}

class RoughChart {
 public:
  RoughChart(const CadFace& face, const IntrinsicTriangles& fine) : face_(&face), fine_(&fine) {
    for (const IntrinsicTriangle& t : fine.triangles) triangles_.push_back(flat_triangle(t));
  }
  std::vector<Vec2> positions();

 private:
  std::vector<int> loops_of_vertices() const;
  SparseMatrix stiffness(const std::vector<bool>& is_given) const;
  Eigen::VectorXd scales() const;
  std::vector<double> turns(const Eigen::VectorXd& s) const;

  const CadFace* face_;
  const IntrinsicTriangles* fine_;
  std::vector<FlatTriangle> triangles_;
};

/// Of each vertex, the loop on which it lies, or -1.
std::vector<int> RoughChart::loops_of_vertices() const {
  std::vector<int> loops(fine_->vertices.size(), -1);
  for (const FineBoundaryEdge& edge : fine_->boundary_edges)
    for (const int v : edge.vertices) loops[v] = face_->loop_of(edge.curve);
  return loops;
}

/// The cotangent matrix; rows and columns of given vertices are those of the identity.
SparseMatrix RoughChart::stiffness(const std::vector<bool>& is_given) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < triangles_.size(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int a = fine_->triangles[e].vertices[k], b = fine_->triangles[e].vertices[(k + 1) % 3];
      const double weight = triangles_[e].cotangents[k] / 2;
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
        if (is_given[i]) continue;
        entries.emplace_back(i, i, weight);
        if (!is_given[j]) entries.emplace_back(i, j, -weight);
      }
    }
  const auto n = static_cast<int>(is_given.size());
  for (int v = 0; v < n; ++v)
    if (is_given[v]) entries.emplace_back(v, v, 1);
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd solved(const SparseMatrix& matrix, const Eigen::MatrixXd& right) {
  const Eigen::SimplicialLDLT<SparseMatrix> factors(matrix);
  if (factors.info() != Eigen::Success) throw ComputeError("the fine triangles of the face are no connected surface");
  return factors.solve(right);
}

// The right-hand side is minus the angle defect inside, and at a hole the length times what makes the total turn of the
// hole's image that of a clockwise loop.
Eigen::VectorXd RoughChart::scales() const {
  const std::vector<int> loops = loops_of_vertices();
  const auto n = static_cast<Eigen::Index>(loops.size());
  Eigen::VectorXd turn = Eigen::VectorXd::Constant(n, 2 * pi), length = Eigen::VectorXd::Zero(n);
  for (std::size_t e = 0; e < triangles_.size(); ++e)
    for (int k = 0; k < 3; ++k) turn[fine_->triangles[e].vertices[k]] -= triangles_[e].angles[k];
  for (const FineBoundaryEdge& edge : fine_->boundary_edges)
    for (const int v : edge.vertices)
      length[v] += distance(fine_->vertices[edge.vertices[0]], fine_->vertices[edge.vertices[1]]) / 2;
  const int num_loops = face_->num_loops();
  std::vector<double> loop_turns(num_loops, 0), loop_lengths(num_loops, 0);
  for (Eigen::Index v = 0; v < n; ++v)
    if (loops[v] >= 0) loop_turns[loops[v]] += turn[v] - pi, loop_lengths[loops[v]] += length[v];
  Eigen::VectorXd right(n);
  std::vector<bool> is_given(n);
  for (Eigen::Index v = 0; v < n; ++v) {
    is_given[v] = loops[v] == 0;
    right[v] = loops[v] < 0  ? -turn[v]
               : is_given[v] ? 0
                             : -(2 * pi + loop_turns[loops[v]]) * length[v] / loop_lengths[loops[v]];
  }
  return solved(stiffness(is_given), right);
}

/// Of each triangle, the direction of its real axis in the image: carried from triangle to triangle across edges, with
/// the turn by *ds along the way between the circumcentres.
std::vector<double> RoughChart::turns(const Eigen::VectorXd& s) const {
  std::vector<double> turns(triangles_.size(), 0);
  std::vector<bool> is_known(triangles_.size(), false);
  std::deque<int> queue{0};
  is_known[0] = true;
  std::size_t count = 1;
  for (; !queue.empty(); queue.pop_front()) {
    const int e = queue.front();
    const IntrinsicTriangle& fine = fine_->triangles[e];
    for (int k = 0; k < 3; ++k) {
      const int other = fine.across[k] / 3, j = fine.across[k] % 3;
      if (fine.across[k] < 0 || is_known[other]) continue;
      const double weight = (triangles_[e].cotangents[k] + triangles_[other].cotangents[j]) / 2;
      turns[other] = turns[e] + std::arg(triangles_[e].edge(k)) - std::arg(-triangles_[other].edge(j)) -
                     weight * (s[fine.vertices[(k + 1) % 3]] - s[fine.vertices[k]]);
      is_known[other] = true, ++count;
      queue.push_back(other);
    }
  }
  if (count < triangles_.size()) throw ComputeError("the fine triangles of the face are no connected surface");
  return turns;
}

std::vector<Vec2> RoughChart::positions() {
  const Eigen::VectorXd s = scales();
  const std::vector<double> turn = turns(s);
  std::vector<bool> is_given(fine_->vertices.size(), false);
  is_given[0] = true;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(s.size(), 2);
  for (std::size_t e = 0; e < triangles_.size(); ++e) {
    const auto& v = fine_->triangles[e].vertices;
    const Complex factor = std::polar(std::exp((s[v[0]] + s[v[1]] + s[v[2]]) / 3), turn[e]);
    for (int k = 0; k < 3; ++k) {
      const Complex step = factor * triangles_[e].edge(k) * (triangles_[e].cotangents[k] / 2);
      const int a = v[k], b = v[(k + 1) % 3];
      right.row(b) += Eigen::RowVector2d(step.real(), step.imag());
      right.row(a) -= Eigen::RowVector2d(step.real(), step.imag());
    }
  }
  right.row(0).setZero();
  const Eigen::MatrixXd x = solved(stiffness(is_given), right);
  std::vector<Vec2> positions;
  for (Eigen::Index v = 0; v < x.rows(); ++v) positions.push_back({x(v, 0), x(v, 1)});
  return positions;
}

/// Sorted by curve, then t0.
std::vector<BoundaryEdge> boundary_edges(const IntrinsicTriangles& fine) {
  std::vector<BoundaryEdge> edges;
  for (int e = 0; e < static_cast<int>(fine.triangles.size()); ++e)
    for (int k = 0; k < 3; ++k)
      if (const int across = fine.triangles[e].across[k]; across < 0) {
        const FineBoundaryEdge& edge = fine.boundary_edges[-1 - across];
        edges.push_back({e, k, edge.curve, edge.t0, edge.t1});
      }
  std::sort(edges.begin(), edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.t0 < b.t0;
  });
  return edges;
}

}  // namespace

SurfaceMesh rough_chart(const CadFace& face, const IntrinsicTriangles& fine) {
  SurfaceMesh mesh;
  mesh.plane.vertices = RoughChart(face, fine).positions();
  mesh.plane.boundary_edges = boundary_edges(fine);
  for (const IntrinsicTriangle& t : fine.triangles) {
    mesh.plane.elem2vertices.push_back(t.vertices);
    Vec3 sum;  // where the parametrisation degenerates, the normal is that of the other corners
    for (const int v : t.vertices) sum += fine.normals[v];
    for (int k = 0; k < 3; ++k) {
      const int v = t.vertices[k];
      const Vec3 normal = fine.normals[v];
      mesh.nodes.push_back(fine.vertices[v]);
      mesh.normals.push_back(norm2(normal) > 0 || norm2(sum) == 0 ? normal : normalized(sum));
      mesh.uv.push_back(t.uv[k]);
      mesh.image.push_back(mesh.plane.vertices[v]);
    }
  }
  mesh.plane.face.diameter = 0;
  for (const Vec2 x : mesh.image)
    mesh.plane.face.diameter = std::max(mesh.plane.face.diameter, norm(x - mesh.image[0]));
  return mesh;
}

}  // namespace quadrille::chart
