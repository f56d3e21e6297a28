// Proofs of the elements. A straight sweep of a plane quad carries the quad's: det J = det J of the quad times half the
// height of the layer. Layers that a rigid motion maps onto each other are proved once. Both up to the rounding of the
// nodes, which the bounds allow for; where that leaves nothing, and everywhere else, the element itself is proved.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.hpp"
#include "spectral/bernstein_tables.hpp"
#include "spectral/hex_map.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "sweep/swept_quads.hpp"

namespace quadrille::sweep {

namespace {

constexpr double node_ulps = 64;   ///< of a node from the exact motion, of the greatest coordinate
constexpr double equal_steps = 4;  ///< units of rounding by which layers differ that are one
constexpr int chunk = 64;          ///< elements of one piece of work

struct Figures {
  spectral::HexBounds bounds;
  double scaled_jacobian = -1;
};

std::vector<Vec3> element(const HexMesh& mesh, int elem) {
  std::vector<Vec3> nodes;
  const auto count = static_cast<std::size_t>(mesh.nodes_per_elem());
  nodes.reserve(count);
  for (std::size_t k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  return nodes;
}

Figures proved(const HexMesh& mesh, int elem) {
  const std::vector<Vec3> nodes = element(mesh, elem);
  return {spectral::hex_bounds(mesh.order, nodes.data()), spectral::hex_scaled_jacobian(mesh.order, nodes.data())};
}

/// |x_xi1| and |x_xi2| of a plane quad are at most these: the greatest at the nodes, times the square of Lebesgue's
/// constant of these.
std::array<double, 2> derivative_bounds(const QuadMesh& quads, int elem, const Eigen::MatrixXd& d) {
  constexpr double lebesgue2 = 9;
  const int n = quads.order + 1;
  std::array<double, 2> greatest{};
  const auto node = [&](int i, int j) { return quads.nodes[quads.elem_nodes[elem * n * n + j * n + i]]; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      Vec2 a, b;
      for (int k = 0; k < n; ++k) a += d(i, k) * node(k, j), b += d(j, k) * node(i, k);
      greatest = {std::max(greatest[0], norm(a)), std::max(greatest[1], norm(b))};
    }
  return {lebesgue2 * greatest[0], lebesgue2 * greatest[1]};
}

/// Of a layer of height 1 along the vector: to be multiplied with its height.
std::vector<Figures> straight_figures(const SweptQuads& swept, Vec3 along) {
  const QuadMesh& quads = swept.quads;
  const auto vector = [](const std::array<double, 3>& a) { return Vec3{a[0], a[1], a[2]}; };
  const double rise = std::abs(dot(cross(vector(quads.face.plane_x), vector(quads.face.plane_y)), along));
  const Eigen::MatrixXd d = spectral::differentiation_matrix(spectral::gll_points(quads.order));
  std::vector<Figures> figures(quads.num_elems());
  for (int q = 0; q < quads.num_elems(); ++q) {
    auto [a, b] = derivative_bounds(quads, q, d);
    if (swept.is_mirrored()) std::swap(a, b);
    figures[q].bounds = {quads.elem_jacobian_bound[q] * rise / 2 * (1 - 16 * spectral::unit_roundoff),
                         {a, b, norm(along) / 2}};
    figures[q].scaled_jacobian =
        quads.elem_scaled_jacobian[q] * (quads.elem_scaled_jacobian[q] > 0 ? rise / norm(along) : 1);
  }
  return figures;
}

/// By layer: the first one of its height.
std::vector<int> first_equals(const std::vector<double>& ends) {
  std::vector<int> firsts;
  for (std::size_t l = 0; l + 1 < ends.size(); ++l) {
    int first = 0;
    while (first < static_cast<int>(l) &&
           std::abs((ends[first + 1] - ends[first]) - (ends[l + 1] - ends[l])) > equal_steps * spectral::unit_roundoff)
      ++first;
    firsts.push_back(first);
  }
  return firsts;
}

/// Bound of the distance of nodes from where the exact motion has them.
double rounding_of(const SweptQuads& swept, const SweepMotion& motion, const HexMesh& mesh) {
  double greatest = 0;
  const auto include = [&](Vec3 x) { greatest = std::max({greatest, std::abs(x.x), std::abs(x.y), std::abs(x.z)}); };
  for (const Vec3 x : swept.nodes) include(x);
  for (const Vec3 x : mesh.nodes) include(x);
  if (motion.shape().axis) include(motion.shape().axis->point);
  include(motion.shape().centre);
  return node_ulps * spectral::unit_roundoff * greatest;
}

class Measure {
 public:
  Measure(const SweptQuads& swept, const SweepMotion& motion, const std::vector<double>& ends, bool has_heights,
          HexMesh& mesh)
      : ends_(ends), mesh_(mesh), rounding_(rounding_of(swept, motion, mesh)) {
    const bool is_steady = motion.is_steady() && !has_heights;
    if (is_steady && motion.is_straight() && swept.quads.space_nodes.empty())
      quads_ = straight_figures(swept, motion.shape().along);
    else if (is_steady)
      firsts_ = first_equals(ends);
    known_.resize(firsts_.empty() ? 0 : mesh.num_elems());
  }

  void run(int threads, const Progress::Part& part) {
    const int num = mesh_.num_elems();
    for (const bool is_repeat : {false, true})  // what is repeated must be known
      parallel_for((num + chunk - 1) / chunk, threads, [&](int c) {
        for (int e = c * chunk; e < std::min(num, (c + 1) * chunk); ++e) {
          if (repeats(e) != is_repeat) continue;
          measure_element(e);
          part.advance();
        }
      });
  }

 private:
  int layer(int elem) const { return elem / mesh_.num_quads; }
  bool repeats(int elem) const { return !firsts_.empty() && firsts_[layer(elem)] != layer(elem); }

  std::optional<Figures> carried(int elem) const {
    const int quad = elem % mesh_.num_quads;
    if (repeats(elem)) return known_[firsts_[layer(elem)] * mesh_.num_quads + quad];
    if (quads_.empty()) return std::nullopt;
    Figures of = quads_[quad];
    const double height = ends_[layer(elem) + 1] - ends_[layer(elem)];
    of.bounds.jacobian *= height;
    of.bounds.derivatives[2] *= height;
    return of;
  }

  void measure_element(int elem) {
    double& bound = mesh_.elem_jacobian_bound[elem];
    std::optional<Figures> of = carried(elem);
    if (of) bound = spectral::moved_jacobian_bound(mesh_.order, of->bounds, rounding_);
    if (!of || !(bound > 0)) {
      of = proved(mesh_, elem);
      bound = of->bounds.jacobian;
    }
    mesh_.elem_scaled_jacobian[elem] = std::min(of->scaled_jacobian, 1.0);
    if (!known_.empty()) known_[elem] = *of;
  }

  const std::vector<double>& ends_;
  HexMesh& mesh_;
  double rounding_;
  std::vector<Figures> quads_;  ///< of a straight sweep, by quad
  std::vector<int> firsts_;     ///< of a steady motion, by layer
  std::vector<Figures> known_;
};

}  // namespace

void measure(const SweptQuads& swept, const SweepMotion& motion, const std::vector<double>& ends, bool has_heights,
             int threads, Progress* progress, HexMesh& mesh) {
  const Progress::Part part(progress, "elements", mesh.num_elems());
  Measure(swept, motion, ends, has_heights, mesh).run(threads, part);
  mesh.least_jacobian_bound = *std::ranges::min_element(mesh.elem_jacobian_bound);
  mesh.is_valid = mesh.least_jacobian_bound > 0;
}

}  // namespace quadrille::sweep
