#include "graph/node_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::graph {
namespace {

bool is_boundary(const ArcGraph& graph, HalfEdge h) { return graph.arcs[h.arc].is_boundary; }

// The curve and the parameter at which a half-edge starts.
std::pair<int, double> start_on_curve(const ArcGraph& graph, HalfEdge h) {
  const std::vector<ArcPiece>& pieces = graph.arcs[h.arc].pieces;
  return h.is_backwards ? std::pair{pieces.back().curve, pieces.back().t1}
                        : std::pair{pieces.front().curve, pieces.front().t0};
}

// The sectors at a T-junction: half a turn between the two half-edges of the line that continues, independent of the
// angles, as lines turn fast near a node. Empty if no two consecutive half-edges of the three are of one line.
std::vector<int> t_junction_quarters(const ArcGraph& graph, const std::vector<HalfEdge>& half_edges) {
  for (int k = 0; k < 3; ++k) {
    if (start_on_curve(graph, half_edges[k]) != start_on_curve(graph, half_edges[(k + 1) % 3])) continue;
    std::vector<int> quarters(3, 1);
    quarters[k] = 2;
    return quarters;
  }
  return {};
}

std::vector<int> quarters_from_angles(const ArcGraph& graph, int valence, const std::vector<HalfEdge>& half_edges,
                                      bool is_closed) {
  const int num = static_cast<int>(half_edges.size()), num_sectors = is_closed ? num : num - 1;
  if (num_sectors == 1) return {valence};
  std::vector<double> angles;
  angles.reserve(num_sectors);
  for (int k = 0; k < num_sectors; ++k)
    angles.push_back(wrap_two_pi(start_angle(graph, half_edges[(k + 1) % num]) - start_angle(graph, half_edges[k])));
  const double total = is_closed ? 2 * pi : std::accumulate(angles.begin(), angles.end(), 0.0);
  std::vector<int> quarters;
  quarters.reserve(num_sectors);
  for (const double angle : angles) quarters.push_back(static_cast<int>(std::lround(valence * angle / total)));
  return quarters;
}

bool is_on_interface(const ArcGraph& graph, HalfEdge h) {
  return !is_boundary(graph, h) && start_on_curve(graph, h).first < graph.face.num_curves();
}

// A region whose boundary is straight at the node may have no line there, although others have: the widest sectors are
// half turns.
std::vector<int> widest_are_straight(const ArcGraph& graph, int valence, const std::vector<HalfEdge>& half_edges,
                                     int num_sectors) {
  std::vector<std::pair<double, int>> by_width;
  for (int k = 0; k < num_sectors; ++k) {
    const HalfEdge next = half_edges[(k + 1) % half_edges.size()];
    by_width.push_back({-wrap_two_pi(start_angle(graph, next) - start_angle(graph, half_edges[k])), k});
  }
  std::sort(by_width.begin(), by_width.end());
  std::vector<int> quarters(num_sectors, 1);
  for (int k = 0; k < valence - num_sectors; ++k) quarters[by_width[k].second] = 2;
  return quarters;
}

}  // namespace

double start_angle(const ArcGraph& graph, HalfEdge h) {
  const GraphArc& arc = graph.arcs[h.arc];
  const ArcPiece& piece = h.is_backwards ? arc.pieces.back() : arc.pieces.front();
  const double t = h.is_backwards ? piece.t1 : piece.t0;
  const bool rises = h.is_backwards != (piece.t0 < piece.t1);
  const Vec2 along = curve::tangent(graph.curve(piece.curve), t, !rises);
  return angle_of(rises ? along : -along);
}

void sort_around_node(const ArcGraph& graph, std::vector<HalfEdge>& half_edges) {
  constexpr double before_all = -1, behind_all = 7;  // radians, outside [0, 2 pi)
  double reference = -pi;
  std::vector<std::pair<double, HalfEdge>> by_angle;
  for (const HalfEdge h : half_edges) {
    by_angle.push_back({start_angle(graph, h), h});
    if (!h.is_backwards && is_boundary(graph, h)) reference = by_angle.back().first;
  }
  for (auto& [angle, h] : by_angle)
    angle = !is_boundary(graph, h) ? wrap_two_pi(angle - reference) : h.is_backwards ? behind_all : before_all;
  std::sort(by_angle.begin(), by_angle.end());
  for (std::size_t k = 0; k < half_edges.size(); ++k) half_edges[k] = by_angle[k].second;
}

std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const ArcGraph& graph) {
  std::vector<std::vector<HalfEdge>> around(graph.nodes.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) around[start_of(graph.arcs, h)].push_back(h);
  for (std::vector<HalfEdge>& half_edges : around) sort_around_node(graph, half_edges);
  return around;
}

std::vector<int> sector_quarters(const ArcGraph& graph, int node, const std::vector<HalfEdge>& half_edges) {
  const int valence = graph.nodes[node].valence, num = static_cast<int>(half_edges.size());
  const bool is_closed = !is_boundary(graph, half_edges.front());
  const int num_sectors = is_closed ? num : num - 1;
  if (num_sectors == valence) return std::vector<int>(num_sectors, 1);
  if (is_closed && num == 3 && graph.nodes[node].kind == NodeKind::crossing)
    if (std::vector<int> quarters = t_junction_quarters(graph, half_edges); !quarters.empty()) return quarters;
  const bool has_interface =
      std::any_of(half_edges.begin(), half_edges.end(), [&](HalfEdge h) { return is_on_interface(graph, h); });
  if (has_interface && num_sectors < valence && valence <= 2 * num_sectors)
    return widest_are_straight(graph, valence, half_edges, num_sectors);
  return quarters_from_angles(graph, valence, half_edges, is_closed);
}

}  // namespace quadrille::graph
