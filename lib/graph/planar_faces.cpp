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

// Tables over darts: the slot of a dart.
size_t slot(int dart) { return dart >= 0 ? 2 * static_cast<size_t>(dart) : 2 * static_cast<size_t>(-1 - dart) + 1; }

bool is_boundary(const SeparatrixGraph& graph, int dart) { return graph.arcs[dart_arc(dart)].is_boundary; }

// Where a dart leaves its first node: a curve and a parameter.
std::pair<int, double> leaves_at(const SeparatrixGraph& graph, int dart) {
  const std::vector<ArcPiece>& pieces = graph.arcs[dart_arc(dart)].pieces;
  return dart >= 0 ? std::pair{pieces.front().curve, pieces.front().t0}
                   : std::pair{pieces.back().curve, pieces.back().t1};
}

// The T-junction of an inner line: half a turn lies between the darts of the line that goes on, whatever the angles:
// near a node lines turn fast. Empty where no two neighbours of three are of one line.
std::vector<int> t_junction_quarters(const SeparatrixGraph& graph, const std::vector<int>& darts) {
  for (int k = 0; k < 3; ++k) {
    if (leaves_at(graph, darts[k]) != leaves_at(graph, darts[(k + 1) % 3])) continue;
    std::vector<int> quarters(3, 1);
    quarters[k] = 2;
    return quarters;
  }
  return {};
}

// Quarter turns of the sectors between consecutive darts. Each is one where all lines of the node are there; else the
// angles share the valence out.
std::vector<int> sector_quarters(const SeparatrixGraph& graph, int node, const std::vector<int>& darts) {
  const int valence = graph.nodes[node].valence, num = static_cast<int>(darts.size());
  const bool closed = !is_boundary(graph, darts.front());
  const int num_sectors = closed ? num : num - 1;
  if (num_sectors == valence) return std::vector<int>(num_sectors, 1);
  if (closed && num == 3 && graph.nodes[node].kind == NodeKind::crossing)
    if (std::vector<int> quarters = t_junction_quarters(graph, darts); !quarters.empty()) return quarters;
  std::vector<double> angles;
  angles.reserve(num_sectors);
  for (int k = 0; k < num_sectors; ++k)
    angles.push_back(wrap_two_pi(dart_angle(graph, darts[(k + 1) % num]) - dart_angle(graph, darts[k])));
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

double dart_angle(const SeparatrixGraph& graph, int dart) {
  const GraphArc& arc = graph.arcs[dart_arc(dart)];
  const bool forwards = dart >= 0;
  const ArcPiece& piece = forwards ? arc.pieces.front() : arc.pieces.back();
  const double t = forwards ? piece.t0 : piece.t1;
  const bool rising = forwards == (piece.t0 < piece.t1);
  const Vec2 along = curve::tangent(graph.curve(piece.curve), t, !rising);
  return angle_of(rising ? along : -along);
}

std::vector<std::vector<int>> darts_around_nodes(const SeparatrixGraph& graph) {
  struct Leaving {
    double turn;  // from the first dart's direction
    int dart;
  };
  std::vector<std::vector<Leaving>> leaving(graph.nodes.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const int dart : {a, reversed_dart(a)})
      leaving[dart_from(graph, dart)].push_back({dart_angle(graph, dart), dart});
  std::vector<std::vector<int>> around(graph.nodes.size());
  for (size_t n = 0; n < leaving.size(); ++n) {
    double reference = -pi;
    for (const Leaving& d : leaving[n])
      if (d.dart >= 0 && is_boundary(graph, d.dart)) reference = d.turn;
    for (Leaving& d : leaving[n]) {
      const bool at_boundary = is_boundary(graph, d.dart);
      d.turn = at_boundary ? (d.dart >= 0 ? -1 : 7) : wrap_two_pi(d.turn - reference);
    }
    std::sort(leaving[n].begin(), leaving[n].end(),
              [](const Leaving& a, const Leaving& b) { return a.turn != b.turn ? a.turn < b.turn : a.dart < b.dart; });
    for (const Leaving& d : leaving[n]) around[n].push_back(d.dart);
  }
  return around;
}

PlanarFaces planar_faces(const SeparatrixGraph& graph) {
  const size_t num_slots = 2 * graph.arcs.size();
  std::vector<int> next(num_slots, 0), turn(num_slots, 0);
  std::vector<bool> seen(num_slots, false);
  const auto around = darts_around_nodes(graph);
  for (size_t n = 0; n < around.size(); ++n) {
    if (around[n].empty()) continue;
    const std::vector<int>& darts = around[n];
    const std::vector<int> quarters = sector_quarters(graph, static_cast<int>(n), darts);
    // Coming in against dart k + 1, the face on the left goes on along dart k: the first one clockwise.
    for (size_t k = 0; k < quarters.size(); ++k) {
      const size_t in = slot(reversed_dart(darts[(k + 1) % darts.size()]));
      next[in] = darts[k];
      turn[in] = quarters[k];
    }
  }
  PlanarFaces faces;
  faces.num_components = num_components(graph);
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const int first : {a, reversed_dart(a)}) {
      if (seen[slot(first)] || (first < 0 && is_boundary(graph, first))) continue;
      faces.cycles.emplace_back();
      faces.quarters.emplace_back();
      for (int dart = first; !seen[slot(dart)]; dart = next[slot(dart)]) {
        seen[slot(dart)] = true;
        faces.cycles.back().push_back(dart);
        faces.quarters.back().push_back(turn[slot(dart)]);
      }
    }
  return faces;
}

int num_corners(const std::vector<int>& quarters) {
  int corners = 0;
  for (const int q : quarters) corners += 2 - q;
  return corners;
}

Vec2 place_of(const SeparatrixGraph& graph, const std::vector<int>& cycle) {
  Vec2 sum;
  for (const int dart : cycle) {
    const auto& pieces = graph.arcs[dart_arc(dart)].pieces;
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
