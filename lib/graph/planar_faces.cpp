#include "graph/planar_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::graph {
namespace {

bool is_boundary(const SeparatrixGraph& graph, HalfEdge h) { return graph.arcs[h.arc].is_boundary; }

// Where a half-edge leaves its first node: a curve and a parameter.
std::pair<int, double> leaves_at(const SeparatrixGraph& graph, HalfEdge h) {
  const std::vector<ArcPiece>& pieces = graph.arcs[h.arc].pieces;
  return !h.is_backwards ? std::pair{pieces.front().curve, pieces.front().t0}
                         : std::pair{pieces.back().curve, pieces.back().t1};
}

// The T-junction of an inner line: half a turn lies between the half-edges of the line that goes on, whatever the
// angles: near a node lines turn fast. Empty where no two neighbours of three are of one line.
std::vector<int> t_junction_quarters(const SeparatrixGraph& graph, const std::vector<HalfEdge>& half_edges) {
  for (int k = 0; k < 3; ++k) {
    if (leaves_at(graph, half_edges[k]) != leaves_at(graph, half_edges[(k + 1) % 3])) continue;
    std::vector<int> quarters(3, 1);
    quarters[k] = 2;
    return quarters;
  }
  return {};
}

// Quarter turns of the sectors between consecutive half-edges. Each is one where all lines of the node are there; else
// the angles share the valence out.
std::vector<int> sector_quarters(const SeparatrixGraph& graph, int node, const std::vector<HalfEdge>& half_edges) {
  const int valence = graph.nodes[node].valence, num = static_cast<int>(half_edges.size());
  const bool closed = !is_boundary(graph, half_edges.front());
  const int num_sectors = closed ? num : num - 1;
  if (num_sectors == valence) return std::vector<int>(num_sectors, 1);
  if (closed && num == 3 && graph.nodes[node].kind == NodeKind::crossing)
    if (std::vector<int> quarters = t_junction_quarters(graph, half_edges); !quarters.empty()) return quarters;
  std::vector<double> angles;
  angles.reserve(num_sectors);
  for (int k = 0; k < num_sectors; ++k)
    angles.push_back(wrap_two_pi(start_angle(graph, half_edges[(k + 1) % num]) - start_angle(graph, half_edges[k])));
  if (num_sectors == 1) return {valence};
  const double total = closed ? 2 * pi : std::accumulate(angles.begin(), angles.end(), 0.0);
  std::vector<int> quarters;
  quarters.reserve(num_sectors);
  for (const double angle : angles) quarters.push_back(static_cast<int>(std::lround(valence * angle / total)));
  return quarters;
}

int num_components(const SeparatrixGraph& graph) {
  std::vector<int> root(graph.nodes.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  int count = static_cast<int>(root.size());
  for (const GraphArc& arc : graph.arcs) {
    const int a = find(arc.from), b = find(arc.to);
    if (a == b) continue;
    root[b] = a;
    --count;
  }
  return count;
}

}  // namespace

double start_angle(const SeparatrixGraph& graph, HalfEdge h) {
  const GraphArc& arc = graph.arcs[h.arc];
  const bool forwards = !h.is_backwards;
  const ArcPiece& piece = forwards ? arc.pieces.front() : arc.pieces.back();
  const double t = forwards ? piece.t0 : piece.t1;
  const bool rising = forwards == (piece.t0 < piece.t1);
  const Vec2 along = curve::tangent(graph.curve(piece.curve), t, !rising);
  return angle_of(rising ? along : -along);
}

std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const SeparatrixGraph& graph) {
  struct Leaving {
    double turn;  // from the first half-edge's direction
    HalfEdge h;
  };
  std::vector<std::vector<Leaving>> leaving(graph.nodes.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}})
      leaving[start_of(graph.arcs, h)].push_back({start_angle(graph, h), h});
  std::vector<std::vector<HalfEdge>> around(graph.nodes.size());
  for (size_t n = 0; n < leaving.size(); ++n) {
    double reference = -pi;
    for (const Leaving& d : leaving[n])
      if (!d.h.is_backwards && is_boundary(graph, d.h)) reference = d.turn;
    for (Leaving& d : leaving[n]) {
      const bool at_boundary = is_boundary(graph, d.h);
      d.turn = at_boundary ? (!d.h.is_backwards ? -1 : 7) : wrap_two_pi(d.turn - reference);
    }
    std::sort(leaving[n].begin(), leaving[n].end(),
              [](const Leaving& a, const Leaving& b) { return a.turn != b.turn ? a.turn < b.turn : a.h < b.h; });
    for (const Leaving& d : leaving[n]) around[n].push_back(d.h);
  }
  return around;
}

PlanarFaces planar_faces(const SeparatrixGraph& graph) {
  const size_t num_slots = 2 * graph.arcs.size();
  std::vector<HalfEdge> next(num_slots);
  std::vector<int> turn(num_slots, 0);
  std::vector<bool> seen(num_slots, false);
  const auto around = half_edges_around_nodes(graph);
  for (size_t n = 0; n < around.size(); ++n) {
    if (around[n].empty()) continue;
    const std::vector<HalfEdge>& half_edges = around[n];
    const std::vector<int> quarters = sector_quarters(graph, static_cast<int>(n), half_edges);
    // Coming in against half-edge k + 1, the face on the left goes on along half-edge k: the first one clockwise.
    for (size_t k = 0; k < quarters.size(); ++k) {
      const size_t in = half_edges[(k + 1) % half_edges.size()].reversed().index();
      next[in] = half_edges[k];
      turn[in] = quarters[k];
    }
  }
  PlanarFaces faces;
  faces.num_components = num_components(graph);
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const HalfEdge first : {HalfEdge{a}, HalfEdge{a, true}}) {
      if (seen[first.index()] || (first.is_backwards && is_boundary(graph, first))) continue;
      faces.cycles.emplace_back();
      faces.quarters.emplace_back();
      for (HalfEdge h = first; !seen[h.index()]; h = next[h.index()]) {
        seen[h.index()] = true;
        faces.cycles.back().push_back(h);
        faces.quarters.back().push_back(turn[h.index()]);
      }
    }
  return faces;
}

int num_corners(const std::vector<int>& quarters) {
  int corners = 0;
  for (const int q : quarters) corners += 2 - q;
  return corners;
}

Vec2 place_of(const SeparatrixGraph& graph, const std::vector<HalfEdge>& cycle) {
  Vec2 sum;
  for (const HalfEdge h : cycle) {
    const auto& pieces = graph.arcs[h.arc].pieces;
    const ArcPiece& piece = pieces[pieces.size() / 2];
    sum += curve::point(graph.curve(piece.curve), (piece.t0 + piece.t1) / 2);
  }
  return sum / static_cast<double>(cycle.size()) + graph.face.origin;
}

std::vector<int> cycles_without_four_corners(const PlanarFaces& faces) {
  std::vector<int> bad;
  for (int f = 0; f < static_cast<int>(faces.cycles.size()); ++f)
    if (num_corners(faces.quarters[f]) != 4 || faces.cycles[f].size() != 4) bad.push_back(f);
  return bad;
}

int require_four_corners(const SeparatrixGraph& graph) {
  const PlanarFaces faces = planar_faces(graph);
  const int num_faces = static_cast<int>(faces.cycles.size());
  const std::vector<int> bad = cycles_without_four_corners(faces);
  if (!bad.empty()) {
    const Vec2 place = place_of(graph, faces.cycles[bad.front()]);
    throw ComputeError(fmt::format(
        "{} of {} faces of the separatrix graph {} not four corners; the one around ({:.6g}, {:.6g}) has {}",
        bad.size(), num_faces, bad.size() == 1 ? "has" : "have", place.x, place.y,
        num_corners(faces.quarters[bad.front()])));
  }
  if (faces.num_components > 1)
    throw ComputeError(
        fmt::format("the separatrix graph falls into {} parts that nothing connects: a face of it has a "
                    "hole",
                    faces.num_components));
  return num_faces;
}

}  // namespace quadrille::graph
