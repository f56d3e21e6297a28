#include "refine/relax_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/project.hpp"
#include "mesh/transfinite.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/interval_error.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr int power = 4;

double power_of(double mu) { return mu * mu * mu * mu; }
static_assert(power == 4);

/// The loop's curves one after the other, twice.
curve::Chain walked_twice(const CadFace& face, const curve::CurveTable& table, int loop) {
  std::vector<ArcPiece> pieces;
  for (int round = 0; round < 2; ++round)
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
      pieces.push_back({c, face.curves[c].begin(), face.curves[c].end()});
  return {table, std::move(pieces)};
}

/// The start of a closed curve that is smooth there.
bool is_seam(const CadFace& face, int curve) {
  return face.next_in_loop(curve) == curve && !face.joints[curve].is_corner &&
         std::abs(face.joints[curve].interior_angle - pi) < tolerance::same_angle;
}

bool is_periodic(const CadFace& face, int curve) {
  const auto is_of = [curve](const PeriodicPair& pair) { return pair.curves[0] == curve || pair.curves[1] == curve; };
  return std::any_of(face.periodic_pairs.begin(), face.periodic_pairs.end(), is_of);
}

/// Whether another curve has the same nodes, or nodes that a motion maps onto them.
bool is_shared(const CadFace& face, int curve) { return face.is_interface(curve) || is_periodic(face, curve); }

/// The edges on the boundary and on interfaces, loop by loop and in the order of each.
std::vector<std::vector<QuadBoundaryEdge>> edges_of_loops(const QuadMesh& mesh) {
  std::vector<QuadBoundaryEdge> edges = mesh.boundary_edges;
  edges.insert(edges.end(), mesh.interface_edges.begin(), mesh.interface_edges.end());
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.curve < b.curve; });
  std::vector<std::vector<QuadBoundaryEdge>> loops(mesh.face.num_loops());
  for (const QuadBoundaryEdge& edge : edges) loops[mesh.face.loop_of(edge.curve)].push_back(edge);
  return loops;
}

}  // namespace

ShapeEnergy::ShapeEnergy(const QuadMesh& mesh)
    : order_(mesh.order),
      elem_nodes_(mesh.elem_nodes),
      derivative_(spectral::differentiation_matrix(spectral::gll_points(mesh.order))) {
  inverse_lengths_.reserve(mesh.elem_nodes.size());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const Jacobians j = jacobians(elem, mesh.nodes);
    for (Eigen::Index k = 0; k < j.x1.size(); ++k)
      inverse_lengths_.push_back(
          {1 / std::hypot(j.x1.data()[k], j.y1.data()[k]), 1 / std::hypot(j.x2.data()[k], j.y2.data()[k])});
  }
}

ShapeEnergy::Jacobians ShapeEnergy::jacobians(int elem, const std::vector<Vec2>& nodes) const {
  const int width = order_ + 1, count = width * width;
  Eigen::MatrixXd x(width, width), y(width, width);
  const Vec2 start = nodes[elem_nodes_[elem * count]];
  for (int k = 0; k < count; ++k) {
    const Vec2 node = nodes[elem_nodes_[elem * count + k]] - start;
    x.data()[k] = node.x;
    y.data()[k] = node.y;
  }
  return {derivative_ * x, x * derivative_.transpose(), derivative_ * y, y * derivative_.transpose()};
}

double ShapeEnergy::value(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const Eigen::Index count = j.x1.size();
  double sum = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b);
    if (!(det > 0)) return std::numeric_limits<double>::infinity();
    sum += power_of((norm2(a) + norm2(b)) / (2 * det));
  }
  return sum / static_cast<double>(count);
}

ElementEnergy ShapeEnergy::with_derivatives(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const int width = order_ + 1, count = width * width;
  const std::vector<double>& xi = spectral::gll_points(order_);
  const std::array<Vec2, 4> corners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
  ElementEnergy energy;
  for (int k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b), mu = (norm2(a) + norm2(b)) / (2 * det);
    const double weight = 1.0 / count, slope = weight * power * mu * mu * mu, bend = weight * 12 * mu * mu;
    energy.value += weight * power_of(mu);
    const Vec2 by_a = (a - mu * Vec2{b.y, -b.x}) / det, by_b = (b - mu * Vec2{-a.y, a.x}) / det;
    for (int c = 0; c < 4; ++c) {
      const double d1 = scale.x * corners[c].x * (1 + corners[c].y * xi[k / width]) / 4;
      const double d2 = scale.y * corners[c].y * (1 + corners[c].x * xi[k % width]) / 4;
      const Vec2 g = d1 * by_a + d2 * by_b;
      const double round = slope * (d1 * d1 + d2 * d2) / det;
      energy.gradient[c] += slope * g;
      energy.hessian[c][0] += round + bend * g.x * g.x;
      energy.hessian[c][1] += bend * g.x * g.y;
      energy.hessian[c][2] += round + bend * g.y * g.y;
    }
  }
  return energy;
}

BoundarySlide::BoundarySlide(const QuadMesh& mesh, bool leaves_breaks)
    : mesh_(&mesh),
      leaves_breaks_(leaves_breaks),
      table_(mesh.face, no_splines_),
      curve_start_(mesh.face.curves.size(), 0.0) {
  const CadFace& face = mesh.face;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    loops_.push_back(walked_twice(face, table_, loop));
    for (int c = face.loop_offsets[loop] + 1; c < face.loop_offsets[loop + 1]; ++c)
      curve_start_[c] = curve_start_[c - 1] + table_.arc_length(c - 1).total();
  }
  std::vector<std::vector<int>> curve_edges(face.curves.size());
  for (const std::vector<QuadBoundaryEdge>& edges : edges_of_loops(mesh)) {
    for (std::size_t k = 0; k < edges.size(); ++k)
      curve_edges[edges[k].curve].push_back(static_cast<int>(edges_.size() + k));
    add_loop(edges);
  }
  for (const PeriodicPair& pair : face.periodic_pairs) add_twins(pair.curves[0], pair.curves[1], curve_edges);
  for (const int curve : mesh.open_curves)
    if (curve < face.partners[curve]) add_twins(curve, face.partners[curve], curve_edges);
}

/// Curves with different numbers of edges have no common nodes, as between regions that do not conform.
void BoundarySlide::add_twins(int curve, int twin, const std::vector<std::vector<int>>& curve_edges) {
  const std::vector<int>&own = curve_edges[curve], &other = curve_edges[twin];
  for (std::size_t k = 0; own.size() == other.size() && k < own.size(); ++k) {
    const SlidingEdge &a = edges_[own[k]], &b = edges_[other[own.size() - 1 - k]];
    twins_.push_back({a.from, b.to});
    twins_.push_back({a.to, b.from});
  }
}

void BoundarySlide::add_loop(const std::vector<QuadBoundaryEdge>& loop_edges) {
  const int first_vertex = static_cast<int>(vertices_.size()), count = static_cast<int>(loop_edges.size());
  const int first = static_cast<int>(edges_.size());
  for (int k = 0; k < count; ++k) {
    const QuadBoundaryEdge& edge = loop_edges[k];
    const int node = side_start(*mesh_, edge.elem, edge.side), loop = mesh_->face.loop_of(edge.curve);
    vertices_.push_back({node, loop, length_at(loop, edge.curve, mesh_->nodes[node])});
    fix_at_breaks(static_cast<int>(vertices_.size()) - 1);
    edges_.push_back({edge.elem, edge.side, first_vertex + k, first_vertex + (k + 1) % count});
  }
  for (int k = 0; k < count; ++k)
    if (!leaves_breaks_ && is_shared(mesh_->face, loop_edges[k].curve))
      vertices_[first_vertex + k].is_fixed = vertices_[first_vertex + (k + 1) % count].is_fixed = true;
  for (int e = first; e < first + count; ++e) fix_beside_joints(e);
}

/// Whether vertices may slide off the joint after that piece: a seam, or if breaks may be left a smooth joint of curves
/// whose names are the same, or not given.
bool BoundarySlide::may_leave(const curve::Chain& chain, int piece) const {
  const CadFace& face = mesh_->face;
  const int before = chain.pieces()[piece].curve, after = chain.pieces()[piece + 1].curve;
  if (is_seam(face, after)) return true;
  const bool is_named = face.curve_names[before] != face.curve_names[after] &&
                        (face.has_given_name(before) || face.has_given_name(after));
  const bool is_same_kind =
      face.is_interface(before) == face.is_interface(after) && is_periodic(face, before) == is_periodic(face, after);
  return leaves_breaks_ && !is_named && is_same_kind && !face.joints[after].is_corner &&
         std::abs(face.joints[after].interior_angle - pi) < tolerance::same_angle;
}

/// An edge that passes a joint keeps its ends.
void BoundarySlide::fix_beside_joints(int edge) {
  const curve::Chain& chain = loops_[vertices_[edges_[edge].from].loop];
  const Ends ends = ends_of(edge, 0, 0);
  const double slack = 2 * tolerance::round_off * mesh_->face.diameter / chain.length();
  const std::vector<double> joints = chain.joint_fractions();
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (joints[k] > ends.low + slack && joints[k] < ends.high - slack && !may_leave(chain, static_cast<int>(k)))
      vertices_[edges_[edge].from].is_fixed = vertices_[edges_[edge].to].is_fixed = true;
}

/// By projection onto the curve of the edge that starts at x, or the one before; negative if it is on neither.
double BoundarySlide::length_at(int loop, int curve, Vec2 x) const {
  const CadFace& face = mesh_->face;
  curve::Projection best;
  int nearest = -1;
  const int num_curves = face.loop_offsets[loop + 1] - face.loop_offsets[loop];
  for (int c = curve, k = 0; k < std::min(num_curves, 3); ++k, c = face.previous_in_loop(c)) {
    const curve::Projection p = curve::project(face.curves[c], x);
    if (nearest < 0 || p.distance < best.distance) best = p, nearest = c;
    if (best.distance < tolerance::round_off * face.diameter) break;
  }
  if (best.distance > tolerance::round_off * face.diameter) return -1;
  return curve_start_[nearest] + table_.arc_length(nearest).at(best.t);
}

void BoundarySlide::fix_at_breaks(int vertex) {
  SlidingVertex& v = vertices_[vertex];
  const curve::Chain& chain = loops_[v.loop];
  const double total = chain.length() / 2;
  if (v.length < 0) {
    v.length = 0, v.is_fixed = true;
    return;
  }
  const double same = tolerance::round_off * mesh_->face.diameter;
  const bool has_seam = is_seam(mesh_->face, mesh_->face.loop_offsets[v.loop]);
  const auto is_at = [&](double x, double f) { return std::abs(std::remainder(x - f * 2 * total, total)) < same; };
  for (const double f : chain.break_fractions()) v.is_at_break |= is_at(v.length, f) && !(has_seam && is_at(0, f));
  if (!leaves_breaks_) v.is_fixed |= v.is_at_break;
  const std::vector<double> joints = chain.joint_fractions();
  for (std::size_t k = 0; leaves_breaks_ && k < joints.size(); ++k)
    if (is_at(v.length, joints[k]) && !may_leave(chain, static_cast<int>(k))) v.is_fixed = true;
}

curve::ChainPoint BoundarySlide::at(int vertex, double slide) const {
  const SlidingVertex& v = vertices_[vertex];
  const curve::Chain& chain = loops_[v.loop];
  const double total = chain.length() / 2, length = v.length + slide;
  return chain.at((length < 0 ? length + total : length) / (2 * total));
}

BoundarySlide::Ends BoundarySlide::ends_of(int edge, double slide_from, double slide_to) const {
  const SlidingVertex &from = vertices_[edges_[edge].from], &to = vertices_[edges_[edge].to];
  const double total = loops_[from.loop].length() / 2;
  double low = from.length, high = to.length;
  if (high <= low) high += total;
  low += slide_from, high += slide_to;
  if (low < 0) low += total, high += total;
  return {low / (2 * total), high / (2 * total)};
}

PartnerPoint BoundarySlide::edge_middle(int edge, double slide_from, double slide_to) const {
  const Ends ends = ends_of(edge, slide_from, slide_to);
  const curve::Chain& chain = loops_[vertices_[edges_[edge].from].loop];
  const curve::ChainPoint at = chain.at((ends.low + ends.high) / 2);
  return {chain.pieces()[at.piece].curve, at.t};
}

std::vector<Vec2> BoundarySlide::edge_nodes(int edge, double slide_from, double slide_to) const {
  const Ends ends = ends_of(edge, slide_from, slide_to);
  std::vector<Vec2> nodes;
  for (const double xi : spectral::gll_points(mesh_->order))
    nodes.push_back(
        loops_[vertices_[edges_[edge].from].loop].at(ends.low * (1 - xi) / 2 + ends.high * (1 + xi) / 2).position);
  return nodes;
}

double BoundarySlide::edge_error(int edge, double slide_from, double slide_to) const {
  const Ends ends = ends_of(edge, slide_from, slide_to);
  return sizing::interval_error(table_, loops_[vertices_[edges_[edge].from].loop], ends.low, ends.high, mesh_->order);
}

NodeFollow::NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary)
    : mesh_(&mesh), boundary_(&boundary), nodes_(mesh.nodes) {
  std::vector<int> node2vertex(mesh.nodes.size(), -1);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::array<int, 4> vertices{};
    for (int c = 0; c < 4; ++c) {
      const int node = side_start(mesh, elem, c);
      if (node2vertex[node] < 0) {
        node2vertex[node] = num_vertices();
        vertex_nodes_.push_back(node);
      }
      vertices[c] = node2vertex[node];
    }
    elem_vertices_.push_back(vertices);
  }
  on_boundary_.assign(vertex_nodes_.size(), -1);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    boundary2vertex_.push_back(node2vertex[boundary.vertices()[b].node]);
    on_boundary_[boundary2vertex_.back()] = static_cast<int>(b);
  }
}

int NodeFollow::node_of(int elem, int i, int j) const {
  return mesh_->elem_nodes[elem * mesh_->nodes_per_elem() + j * (mesh_->order + 1) + i];
}

std::vector<Vec2> NodeFollow::nodes(const VertexMoves& moves) const {
  std::vector<Vec2> shifts(nodes_.size());
  shift_sides(moves, shifts);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem) shift_inside(elem, shifts);
  std::vector<Vec2> nodes = nodes_;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (shifts[i] != Vec2{}) nodes[i] += shifts[i];
  // Sums have rounding errors; the boundary's nodes must lie on their curves.
  for_moved_edges(moves, [&](const SlidingEdge& edge, double from, double to, const std::vector<Vec2>& on_curve) {
    for (int k = 0; k <= mesh_->order; ++k)
      if ((k > 0 || from != 0) && (k < mesh_->order || to != 0)) nodes[edge_node(edge, k)] = on_curve[k];
  });
  return nodes;
}

int NodeFollow::edge_node(const SlidingEdge& edge, int k) const { return side_node(*mesh_, edge.elem, edge.side, k); }

template <class Visit>
void NodeFollow::for_moved_edges(const VertexMoves& moves, const Visit& visit) const {
  for (std::size_t e = 0; e < boundary_->edges().size(); ++e) {
    const SlidingEdge& edge = boundary_->edges()[e];
    const double from = slide(edge.from, moves), to = slide(edge.to, moves);
    if (from != 0 || to != 0) visit(edge, from, to, boundary_->edge_nodes(static_cast<int>(e), from, to));
  }
}

void NodeFollow::shift_sides(const VertexMoves& moves, std::vector<Vec2>& shifts) const {
  for (int v = 0; v < num_vertices(); ++v) {
    const int b = on_boundary_[v];
    if (moves[v] == Vec2{}) continue;
    shifts[vertex_nodes_[v]] = b < 0 ? moves[v] : boundary_->at(b, moves[v].x).position - nodes_[vertex_nodes_[v]];
  }
  const std::vector<double>& xi = spectral::gll_points(mesh_->order);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> nodes = side_nodes(*mesh_, elem, side);
      const Vec2 from = shifts[nodes.front()], to = shifts[nodes.back()];
      for (int k = 1; k < mesh_->order; ++k) shifts[nodes[k]] = (1 - xi[k]) / 2 * from + (1 + xi[k]) / 2 * to;
    }
  for_moved_edges(moves, [&](const SlidingEdge& edge, double, double, const std::vector<Vec2>& on_curve) {
    for (int k = 1; k < mesh_->order; ++k) shifts[edge_node(edge, k)] = on_curve[k] - nodes_[edge_node(edge, k)];
  });
}

/// Gordon-Hall blend of the shifts on the sides.
void NodeFollow::shift_inside(int elem, std::vector<Vec2>& shifts) const {
  const int n = mesh_->order;
  const std::vector<double>& xi = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return shifts[node_of(elem, i, j)]; };
  const std::array<Vec2, 4> corner{at(0, 0), at(n, 0), at(n, n), at(0, n)};
  if (std::ranges::count(corner, Vec2{}) == 4) return;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      shifts[node_of(elem, i, j)] =
          mesh::blend_sides({at(i, 0), at(n, j), at(i, n), at(0, j)}, corner, (1 + xi[i]) / 2, (1 + xi[j]) / 2);
    }
}

RelaxProblem::RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, bool leaves_breaks)
    : start(mesh),
      boundary(start, leaves_breaks),
      follow(start, boundary),
      energy(start),
      is_fixed(follow.num_vertices(), false),
      twin_(follow.num_vertices(), -1) {
  for (const auto& [a, b] : boundary.twins()) {
    twin_[follow.vertex_of(a)] = follow.vertex_of(b);
    twin_[follow.vertex_of(b)] = follow.vertex_of(a);
  }
  std::vector<int> num_loops(num_vertices(), 0);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    const int v = follow.vertex_of(static_cast<int>(b));
    if (boundary.vertices()[b].is_fixed || ++num_loops[v] > 2) fix_vertex(v);
  }
  for (std::size_t elem = 0; elem < frozen_elems.size(); ++elem)
    if (frozen_elems[elem])
      for (const int v : follow.elem_vertices()[elem]) fix_vertex(v);
}

void RelaxProblem::fix_vertex(int vertex) {
  is_fixed[vertex] = true;
  if (twin_[vertex] >= 0) is_fixed[twin_[vertex]] = true;
}

void RelaxProblem::join_twins(VertexMoves& moves) const {
  for (int v = 0; v < num_vertices(); ++v) {
    if (twin_[v] <= v) continue;
    const double slide = (moves[v].x - moves[twin_[v]].x) / 2;
    moves[v].x = slide, moves[twin_[v]].x = -slide;
  }
}

double RelaxProblem::total_energy(const std::vector<Vec2>& nodes) const {
  double sum = 0;
  for (int elem = 0; elem < start.num_elems(); ++elem) sum += energy.value(elem, nodes);
  return sum;
}

}  // namespace quadrille::refine
