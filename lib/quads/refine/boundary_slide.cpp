#include "refine/boundary_slide.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/project.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/interval_error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

/// In diameters: a vertex is at a break, or on its curve.
constexpr double same_position = 1e-9;
constexpr double smooth_turn = 1e-6;  ///< radians

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
         std::abs(face.joints[curve].interior_angle - pi) < smooth_turn;
}

/// Whether another curve has the same nodes, or nodes that a motion maps onto them.
bool is_shared(const CadFace& face, int curve) {
  const auto is_of = [curve](const PeriodicPair& pair) { return pair.curves[0] == curve || pair.curves[1] == curve; };
  return face.is_interface(curve) || std::any_of(face.periodic_pairs.begin(), face.periodic_pairs.end(), is_of);
}

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

BoundarySlide::BoundarySlide(const QuadMesh& mesh)
    : mesh_(&mesh), table_(mesh.face, no_splines_), curve_start_(mesh.face.curves.size(), 0.0) {
  const CadFace& face = mesh.face;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    loops_.push_back(walked_twice(face, table_, loop));
    for (int c = face.loop_offsets[loop] + 1; c < face.loop_offsets[loop + 1]; ++c)
      curve_start_[c] = curve_start_[c - 1] + table_.arc_length(c - 1).total();
  }
  for (const std::vector<QuadBoundaryEdge>& edges : edges_of_loops(mesh)) add_loop(edges);
}

void BoundarySlide::add_loop(const std::vector<QuadBoundaryEdge>& loop_edges) {
  const int first_vertex = static_cast<int>(vertices_.size()), count = static_cast<int>(loop_edges.size());
  const int first = static_cast<int>(edges_.size());
  for (int k = 0; k < count; ++k) {
    const QuadBoundaryEdge& edge = loop_edges[k];
    const int node = side_start(*mesh_, edge.elem, edge.side), loop = mesh_->face.loop_of(edge.curve);
    vertices_.push_back({node, loop, length_at(loop, edge.curve, mesh_->nodes[node]), false});
    fix_at_breaks(static_cast<int>(vertices_.size()) - 1);
    edges_.push_back({edge.elem, edge.side, first_vertex + k, first_vertex + (k + 1) % count});
  }
  for (int k = 0; k < count; ++k)
    if (is_shared(mesh_->face, loop_edges[k].curve))
      vertices_[first_vertex + k].is_fixed = vertices_[first_vertex + (k + 1) % count].is_fixed = true;
  for (int e = first; e < first + count; ++e) {
    const curve::Chain& chain = loops_[vertices_[edges_[e].from].loop];
    const Ends ends = ends_of(e, 0, 0);
    const double slack = 2 * same_position * mesh_->face.diameter / chain.length();
    for (const double joint : chain.joint_fractions()) {
      const bool is_inside = joint > ends.low + slack && joint < ends.high - slack;
      const int curve = chain.at(joint).piece % static_cast<int>(chain.pieces().size() / 2);
      if (is_inside && !is_seam(mesh_->face, chain.pieces()[curve].curve))
        vertices_[edges_[e].from].is_fixed = vertices_[edges_[e].to].is_fixed = true;
    }
  }
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
    if (best.distance < same_position * face.diameter) break;
  }
  if (best.distance > same_position * face.diameter) return -1;
  return curve_start_[nearest] + table_.arc_length(nearest).at(best.t);
}

void BoundarySlide::fix_at_breaks(int vertex) {
  SlidingVertex& v = vertices_[vertex];
  const curve::Chain& chain = loops_[v.loop];
  const double total = chain.length() / 2;
  if (v.length < 0) {
    v.length = 0;
    v.is_fixed = true;
    return;
  }
  const int first_curve = mesh_->face.loop_offsets[v.loop];
  for (const double f : chain.break_fractions()) {
    const double position = f * 2 * total;
    const double apart = std::abs(std::remainder(v.length - position, total));
    const bool is_start = std::abs(std::remainder(position, total)) < same_position * mesh_->face.diameter;
    if (apart < same_position * mesh_->face.diameter && !(is_start && is_seam(mesh_->face, first_curve)))
      v.is_fixed = true;
  }
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

}  // namespace quadrille::refine
