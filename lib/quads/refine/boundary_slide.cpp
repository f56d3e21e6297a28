#include "refine/boundary_slide.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/project.hpp"
#include "sizing/interval_error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

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

BoundarySlide::BoundarySlide(const QuadMesh& mesh, SlidesOff slides_off)
    : mesh_(&mesh),
      slides_off_(slides_off),
      table_(mesh.face, no_splines_),
      curve_start_(mesh.face.curves.size(), 0.0) {
  const CadFace& face = mesh.face;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    loops_.push_back(walked_twice(face, table_, loop));
    for (int c = face.loop_offsets[loop] + 1; c < face.loop_offsets[loop + 1]; ++c)
      curve_start_[c] = curve_start_[c - 1] + table_.arc_length(c - 1).total();
    bool is_any_shared = false;
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) is_any_shared |= is_shared(face, c);
    is_loop_shared_.push_back(is_any_shared);
    find_free_joints(loop);
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
  for (int e = first; e < first + count; ++e) fix_beside_joints(e);
}

/// Whether vertices may slide off the joint after that piece, or edges pass it.
bool BoundarySlide::may_leave(const curve::Chain& chain, int piece) const {
  const CadFace& face = mesh_->face;
  const int before = chain.pieces()[piece].curve, after = chain.pieces()[piece + 1].curve;
  if (is_seam(face, after)) return true;
  if (face.joints[after].is_corner || std::abs(face.joints[after].interior_angle - pi) >= tolerance::same_angle)
    return false;
  if (face.curve_names[before] == face.curve_names[after])
    return face.is_interface(before) == face.is_interface(after) &&
           is_periodic(face, before) == is_periodic(face, after);
  return slides_off_ == SlidesOff::joints && !is_loop_shared_[face.loop_of(before)] && !face.has_given_name(before) &&
         !face.has_given_name(after);
}

void BoundarySlide::find_free_joints(int loop) {
  const CadFace& face = mesh_->face;
  for (int c = face.loop_offsets[loop], piece = 0; c < face.loop_offsets[loop + 1]; ++c, ++piece) {
    const int next = face.next_in_loop(c);
    if (face.curve_names[c] != face.curve_names[next] && may_leave(loops_[loop], piece))
      free_joints_.push_back({loop, curve_start_[next]});
  }
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
  // Another vertex will be there.
  for (const LoopJoint& joint : free_joints_)
    v.is_at_break &= joint.loop != v.loop || !is_at(v.length, joint.length / (2 * total));
  const std::vector<double> joints = chain.joint_fractions();
  for (std::size_t k = 0; k < joints.size(); ++k)
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

bool BoundarySlide::passes_free_joint(int edge, double slide_from, double slide_to) const {
  const Ends ends = ends_of(edge, slide_from, slide_to);
  const int loop = vertices_[edges_[edge].from].loop;
  const double same = tolerance::round_off * mesh_->face.diameter, total = loop_length(loop);
  return std::ranges::any_of(free_joints_, [&](const LoopJoint& joint) {
    const double onward = joint.length - 2 * total * ends.low;
    const double beyond = onward - total * std::floor((onward - same) / total);
    return joint.loop == loop && beyond < 2 * total * (ends.high - ends.low) - same;
  });
}

double BoundarySlide::error_between(int loop, double from, double to) const {
  const double total = loop_length(loop), turns = std::floor(from / total) * total;
  return sizing::interval_error(table_, loops_[loop], (from - turns) / (2 * total), (to - turns) / (2 * total),
                                mesh_->order);
}

}  // namespace quadrille::refine
