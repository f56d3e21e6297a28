#include "block/measure_blocks.hpp"

#include <algorithm>
#include <limits>

#include "base/tolerance.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "mesh/chords.hpp"
#include "mesh/transfinite.hpp"
#include "model/interfaces.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::block {
namespace {

constexpr int greatest_division = 16;

/// Cell (i, j) of n x n as a quad of order 8.
std::vector<Vec2> cell_nodes(const mesh::TransfiniteMap& map, int n, int i, int j) {
  std::vector<double> fractions;
  for (const double xi : spectral::gll_points(mesh::block_order)) fractions.push_back((1 + xi) / 2);
  std::vector<Vec2> nodes;
  for (const double t : fractions)
    for (const double s : fractions) nodes.push_back(map.position((i + s) / n, (j + t) / n));
  return nodes;
}

/// Whether all n x n cells are proved, and their least scaled Jacobian. Cells are not subdivided to sharpen their
/// bounds: the next n has the same effect.
bool is_proved(const mesh::TransfiniteMap& map, int n, double& scaled_jacobian) {
  scaled_jacobian = 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::vector<Vec2> nodes = cell_nodes(map, n, i, j);
      if (spectral::quad_jacobian_lower_bound(mesh::block_order, nodes.data(), 0) <= 0) return false;
      scaled_jacobian = std::min(scaled_jacobian, spectral::quad_scaled_jacobian(mesh::block_order, nodes.data()));
    }
  return true;
}

void prove(const mesh::TransfiniteMap& map, BlockMeasure& m) {
  m.divisions = 1;
  m.map_scaled_jacobian = m.scaled_jacobian;
  if (m.jacobian_bound > 0) return;
  for (int n = 2; n <= greatest_division; n *= 2)
    if (is_proved(map, m.divisions = n, m.map_scaled_jacobian)) return;
  m.divisions = 0;
  m.map_scaled_jacobian = -1;
}

/// Distance of x from an arc of the boundary.
double distance_to_arc(const BlockLayout& layout, const GraphArc& arc, Vec2 x) {
  double least = std::numeric_limits<double>::infinity();
  for (const ArcPiece& piece : arc.pieces) {
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    least = std::min(least, curve::project(layout.curve(piece.curve), x, low, high).distance);
  }
  return least;
}

/// count + 1 points of [-1, 1].
std::vector<double> equispaced(int count) {
  std::vector<double> points;
  for (int i = 0; i <= count; ++i) points.push_back(-1 + 2.0 * i / count);
  return points;
}

/// Distance of the polynomial of order 8 along an arc from the arc, between their common points.
void measure_boundary_distance(const BlockLayout& layout, const curve::Chain& chain, const GraphArc& arc,
                               BlockMeasure& m) {
  constexpr int count = 4 * mesh::block_order;
  static const std::vector<double> samples = equispaced(count);
  static const Eigen::MatrixXd basis = spectral::interpolation_matrix(spectral::gll_points(mesh::block_order), samples);
  std::vector<Vec2> nodes;
  for (const double xi : spectral::gll_points(mesh::block_order)) nodes.push_back(chain.position((1 + xi) / 2));
  for (int i = 0; i <= count; ++i) {
    Vec2 x;
    for (int k = 0; k <= mesh::block_order; ++k) x += basis(i, k) * nodes[k];
    // The distance to the point of the same fraction is an upper bound; only a greater one is worth a projection.
    if (distance(x, chain.position((1 + samples[i]) / 2)) <= m.boundary_distance) continue;
    const double d = distance_to_arc(layout, arc, x);
    if (d > m.boundary_distance) m.boundary_distance = d, m.boundary_distance_position = x;
  }
}

/// Green's formula over an arc, by Gauss's rule on each knot span of its curves: no arc length is inverted.
double area_left_of(const BlockLayout& layout, const GraphArc& arc) {
  double sum = 0;
  for (const ArcPiece& piece : arc.pieces) {
    const Nurbs& curve = layout.curve(piece.curve);
    const auto swept = [&](double t) {
      const curve::PointAndDerivative at = curve::point_and_derivative(curve, t);
      return cross(at.point, at.derivative);
    };
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    double along = 0;
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
      const double a = std::max(low, curve.knots[k - 1]), b = std::min(high, curve.knots[k]);
      if (a < b) along += curve::gauss_integral<8>(swept, a, b);
    }
    sum += piece.t0 > piece.t1 ? -along : along;
  }
  return sum / 2;
}

/// Whether a block has the half-edges that it had in a layout before: a block that is cut has a new one.
bool is_in(const BlockLayout& before, const BlockLayout& layout, int block) {
  return block < before.num_blocks() && layout.block2arcs[block] == before.block2arcs[block];
}

/// area_left_of the arcs of a layout, each computed once.
class ArcAreas {
 public:
  explicit ArcAreas(const BlockLayout& layout) : layout_(&layout), areas_(layout.arcs.size()) {}
  double left_of(int arc) {
    if (!areas_[arc]) areas_[arc] = area_left_of(*layout_, layout_->arcs[arc]);
    return *areas_[arc];
  }

 private:
  const BlockLayout* layout_;
  std::vector<std::optional<double>> areas_;
};

BlockMeasure measure_block(const BlockLayout& layout, const BlockMaps& maps, ArcAreas& areas, int block) {
  BlockMeasure m;
  const mesh::TransfiniteMap map = maps.map(block);
  const mesh::BlockShape shape = mesh::block_shape(map);
  m.jacobian_bound = shape.jacobian_bound;
  m.scaled_jacobian = shape.scaled_jacobian;
  m.scaled_jacobian_position = shape.scaled_jacobian_position;
  prove(map, m);
  m.shortest_side = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 4; ++k) {
    const HalfEdge directed = layout.block2arcs[block][k];
    const int a = directed.arc;
    const curve::Chain& chain = maps.arc(a);
    if (chain.length() < (1 - tolerance::tied) * m.shortest_side)
      m.shortest_side = chain.length(), m.shortest_side_index = k;
    m.area += (directed.is_backwards ? -1 : 1) * areas.left_of(a);
    if (is_on_cad_curve(layout, layout.arcs[a])) measure_boundary_distance(layout, chain, layout.arcs[a], m);
  }
  return m;
}

}  // namespace

BlockMaps::BlockMaps(const BlockLayout& layout)
    : layout_(&layout), table_(layout.face, layout.splines), chains_(layout.arcs.size()) {}

const curve::Chain& BlockMaps::arc(int a) const {
  std::optional<curve::Chain>& chain = chains_[a];
  if (!chain) chain.emplace(table_, layout_->arcs[a].pieces);
  return *chain;
}

mesh::TransfiniteMap BlockMaps::map(int block) const {
  std::array<const curve::Chain*, 4> sides{};
  std::array<bool, 4> backwards{};
  for (int k = 0; k < 4; ++k) {
    const HalfEdge directed = layout_->block2arcs[block][k];
    sides[k] = &arc(directed.arc);
    backwards[k] = directed.is_backwards;
  }
  return mesh::TransfiniteMap(sides, backwards);
}

std::vector<BlockMeasure> measure_blocks(const BlockLayout& layout, Progress* progress, const Blocks& known) {
  const BlockMaps maps(layout);
  ArcAreas areas(layout);
  const Progress::Part part(progress, "blocks", layout.num_blocks());
  std::vector<BlockMeasure> measures;
  for (int b = 0; b < layout.num_blocks(); ++b, part.advance())
    measures.push_back(is_in(known.layout, layout, b) ? known.measures[b] : measure_block(layout, maps, areas, b));
  return measures;
}

void store_measures(const std::vector<BlockMeasure>& measures, BlockLayout& layout) {
  layout.block_jacobian_bound.clear();
  layout.block_scaled_jacobian.clear();
  layout.block_boundary_distance.clear();
  for (const BlockMeasure& m : measures) {
    layout.block_jacobian_bound.push_back(m.jacobian_bound);
    layout.block_scaled_jacobian.push_back(m.scaled_jacobian);
    layout.block_boundary_distance.push_back(m.boundary_distance);
  }
}

}  // namespace quadrille::block
