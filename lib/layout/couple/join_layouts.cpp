#include "couple/join_layouts.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/tolerance.hpp"

namespace quadrille::couple {
namespace {

constexpr int straight = 2;  // valence of a sector without a node

/// A node of a region's graph.
struct RegionNode {
  int region = 0, node = -1;
};

/// A point of the plane on boundaries of regions that becomes one node.
struct SharedPoint {
  std::vector<BoundaryPoint> points;  // coincident_points
  std::vector<RegionNode> members;
  bool is_inside = false;
};

class LayoutJoiner {
 public:
  explicit LayoutJoiner(const RegionLayouts& regions) : regions_(regions), face_(regions.face) {}

  SeparatrixGraph join() {
    graph_.face = face_;
    for (const graph::CandidateLayout& layout : regions_.layouts) nodes_.emplace_back(layout.graph().nodes.size(), -1);
    add_inner_nodes();
    for (const SharedPoint& shared : shared_points()) add_boundary_node(shared);
    for (int r = 0; r < num_regions(); ++r) add_arcs(r);
    add_t_junctions();
    return std::move(graph_);
  }

 private:
  int num_regions() const { return static_cast<int>(regions_.layouts.size()); }
  const ArcGraph& part(int region) const { return regions_.layouts[region].graph(); }
  bool is_lower_side(int curve) const { return !face_.is_interface(curve) || curve < face_.partners[curve]; }

  void add_inner_nodes() {
    for (int r = 0; r < num_regions(); ++r)
      for (std::size_t n = 0; n < nodes_[r].size(); ++n)
        if (part(r).nodes[n].curve < 0) {
          nodes_[r][n] = static_cast<int>(graph_.nodes.size());
          graph_.nodes.push_back(part(r).nodes[n]);
        }
  }

  // Of coincident points, the one that stands for all.
  BoundaryPoint lowest(const BoundaryPoint& point) const {
    const std::vector<BoundaryPoint> points = coincident_points(face_, point);
    return *std::min_element(points.begin(), points.end());
  }

  // Ordered by their lowest points. Points inside an interface that are nearly the same are united; at joints they are
  // the same, because each region moved what ends near a joint onto it.
  std::vector<SharedPoint> shared_points() const {
    std::map<BoundaryPoint, std::vector<RegionNode>> by_point;
    for (int r = 0; r < num_regions(); ++r)
      for (int n = 0; n < static_cast<int>(nodes_[r].size()); ++n)
        if (part(r).nodes[n].curve >= 0) by_point[lowest(regions_.point_of(r, n))].push_back({r, n});
    std::vector<SharedPoint> all;
    const double same = relative_same * face_.diameter;
    for (auto& [point, members] : by_point) {
      if (!all.empty() && all.back().points.front().curve == point.curve && face_.is_interface(point.curve) &&
          distance(all.back().points.front().position(face_), point.position(face_)) <= same) {
        append(all.back().members, members);
        continue;
      }
      all.push_back({coincident_points(face_, point), std::move(members), is_inside_whole(face_, point)});
    }
    return all;
  }

  static void append(std::vector<RegionNode>& all, const std::vector<RegionNode>& more) {
    all.insert(all.end(), more.begin(), more.end());
  }

  // The kind that the node has in the whole.
  NodeKind kind_of(const SharedPoint& shared) const {
    if (!shared.is_inside) {
      if (shared.points.size() > 1) return NodeKind::corner;
      const RegionNode& member = shared.members.front();
      const NodeKind kind = part(member.region).nodes[member.node].kind;
      // A cut that is left is the line of a neighbour, which ends where it would have gone on.
      return kind == NodeKind::cut ? NodeKind::boundary : kind;
    }
    const bool is_smooth = shared.points.size() == 2 &&
                           std::none_of(shared.members.begin(), shared.members.end(), [&](const RegionNode& member) {
                             return part(member.region).nodes[member.node].kind == NodeKind::corner;
                           });
    return is_smooth ? NodeKind::interface : NodeKind::junction;
  }

  void add_boundary_node(const SharedPoint& shared) {
    const int number = static_cast<int>(graph_.nodes.size());
    const BoundaryPoint& point = shared.points.front();
    int valence = straight * (static_cast<int>(shared.points.size()) - static_cast<int>(shared.members.size()));
    for (const RegionNode& member : shared.members) {
      valence += part(member.region).nodes[member.node].valence;
      nodes_[member.region][member.node] = number;
    }
    graph_.nodes.push_back({point.position(face_), kind_of(shared), valence, point.curve, point.t});
    for (const BoundaryPoint& p : shared.points) on_curve_[p.curve][p.t] = number;
  }

  // The parameters at which a piece is divided, with the nodes there.
  std::vector<std::pair<double, int>> divisions(const ArcPiece& piece) const {
    const auto on = on_curve_.find(piece.curve);
    if (on == on_curve_.end()) return {};
    return std::vector<std::pair<double, int>>(on->second.upper_bound(piece.t0), on->second.lower_bound(piece.t1));
  }

  // The parameter of a node on a curve, if it is nearly `t`; else t, as at the end of a curve.
  double moved_onto(int node, int curve, double t) const {
    const auto on = on_curve_.find(curve);
    if (on == on_curve_.end()) return t;
    const double tolerance = tolerance::same_point * (face_.curves[curve].end() - face_.curves[curve].begin());
    for (auto at = on->second.lower_bound(t - tolerance); at != on->second.end() && at->first <= t + tolerance; ++at)
      if (at->second == node) return at->first;
    return t;
  }

  // A boundary arc of a region, divided at the nodes of the whole.
  void add_boundary_arcs(int region, const GraphArc& arc) {
    std::vector<ArcPiece> pieces = arc.pieces;
    for (ArcPiece& piece : pieces) piece.curve += regions_.first_curves[region];
    int from = nodes_[region][arc.from];
    const int last = nodes_[region][arc.to];
    pieces.front().t0 = moved_onto(from, pieces.front().curve, pieces.front().t0);
    pieces.back().t1 = moved_onto(last, pieces.back().curve, pieces.back().t1);
    std::vector<ArcPiece> path;
    const auto end_arc = [&](int to) {
      const int curve = path.front().curve;
      if (is_lower_side(curve)) graph_.arcs.push_back({from, to, !face_.is_interface(curve), arc.length, path});
      path.clear();
      from = to;
    };
    for (const ArcPiece& piece : pieces) {
      const auto on = on_curve_.find(piece.curve);
      const bool is_joint = on != on_curve_.end() && on->second.contains(piece.t0);
      if (!path.empty() && is_joint) end_arc(on->second.at(piece.t0));
      double t0 = piece.t0;
      for (const auto& [t, node] : divisions(piece)) {
        path.push_back({piece.curve, t0, t});
        end_arc(node);
        t0 = t;
      }
      path.push_back({piece.curve, t0, piece.t1});
    }
    end_arc(last);
  }

  void add_arcs(int region) {
    const ArcGraph& own = part(region);
    const int first_spline = static_cast<int>(graph_.splines.size());
    std::vector<int> numbers(own.arcs.size(), -1);
    for (std::size_t a = 0; a < own.arcs.size(); ++a) {
      if (own.arcs[a].is_boundary) {
        add_boundary_arcs(region, own.arcs[a]);
        continue;
      }
      GraphArc arc = own.arcs[a];
      for (ArcPiece& piece : arc.pieces) piece.curve += face_.num_curves() - own.face.num_curves() + first_spline;
      arc.from = nodes_[region][arc.from];
      arc.to = nodes_[region][arc.to];
      numbers[a] = static_cast<int>(graph_.arcs.size());
      graph_.arcs.push_back(std::move(arc));
    }
    graph_.splines.insert(graph_.splines.end(), own.splines.begin(), own.splines.end());
    for (SeparatrixLine line : regions_.layouts[region].lines) {
      line.origin = nodes_[region][line.origin];
      line.end = nodes_[region][line.end];
      for (int& arc : line.arcs) arc = numbers[arc];
      graph_.lines.push_back(std::move(line));
    }
  }

  // Nodes on an interface where one region has a line and another one, for which the boundary is straight, has none;
  // and those where a continued line ends.
  void add_t_junctions() {
    std::vector<int> sectors(graph_.nodes.size(), 0);
    for (const GraphArc& arc : graph_.arcs) ++sectors[arc.from], ++sectors[arc.to];
    std::vector<bool> is_on_interface(graph_.nodes.size(), false);
    for (const GraphArc& arc : graph_.arcs)
      if (!arc.is_boundary && arc.pieces.front().curve < face_.num_curves())
        is_on_interface[arc.from] = is_on_interface[arc.to] = true;
    for (std::size_t n = 0; n < sectors.size(); ++n) {
      const GraphNode& node = graph_.nodes[n];
      const bool may_be_t = is_on_interface[n] || node.kind == NodeKind::crossing;
      if (may_be_t && sectors[n] - (node.is_inner() ? 0 : 1) < node.valence)
        graph_.t_junctions.push_back(static_cast<int>(n));
    }
  }

  const RegionLayouts& regions_;
  const CadFace& face_;
  SeparatrixGraph graph_;
  std::vector<std::vector<int>> nodes_;            // of each region's graph: number in the whole
  std::map<int, std::map<double, int>> on_curve_;  // of each curve: the nodes on it by parameter, not at its end
};

LayoutCertificate joined_certificate(const RegionLayouts& regions) {
  LayoutCertificate whole;
  whole.method = LayoutMethod::traced;
  for (const graph::CandidateLayout& layout : regions.layouts) {
    const LayoutCertificate& part = layout.certificate;
    if (part.method && *part.method > *whole.method) {
      whole.method = part.method;
      whole.reason = part.reason;
    }
    whole.merged_lines += part.merged_lines;
    whole.collapsed_chords += part.collapsed_chords;
    whole.shortened_spirals += part.shortened_spirals;
    whole.largest_deviation_degrees = std::max(whole.largest_deviation_degrees, part.largest_deviation_degrees);
  }
  return whole;
}

}  // namespace

void close_lines(SeparatrixGraph& graph) {
  const int num_curves = graph.face.num_curves();
  for (const GraphArc& arc : graph.arcs) {
    for (const auto& [node, piece, t] : {std::tuple(arc.from, &arc.pieces.front(), arc.pieces.front().t0),
                                         std::tuple(arc.to, &arc.pieces.back(), arc.pieces.back().t1)}) {
      if (piece->curve < num_curves) continue;
      Nurbs& spline = graph.splines[piece->curve - num_curves];
      if (t == spline.begin()) spline.poles.front() = graph.nodes[node].position;
      if (t == spline.end()) spline.poles.back() = graph.nodes[node].position;
    }
  }
}

SeparatrixGraph join_layouts(const RegionLayouts& regions) {
  SeparatrixGraph graph = LayoutJoiner(regions).join();
  close_lines(graph);
  graph.certificate = joined_certificate(regions);
  return graph;
}

}  // namespace quadrille::couple
