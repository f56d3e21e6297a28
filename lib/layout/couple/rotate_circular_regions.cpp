#include "couple/rotate_circular_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "couple/best_rotation.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::couple {
namespace {

constexpr double relative_circular = 1e-9;  // relative to the diameter: deviation of a boundary from circles
constexpr int samples_of_curve = 9;

Vec2 point_at(const Nurbs& curve, double fraction) {
  return curve::point(curve, curve.begin() + fraction * (curve.end() - curve.begin()));
}

std::optional<Vec2> circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 p = b - a, q = c - a;
  const double d = 2 * cross(p, q);
  if (std::abs(d) <= 1e-12 * norm(p) * norm(q)) return std::nullopt;
  return a + Vec2{q.y * norm2(p) - p.y * norm2(q), p.x * norm2(q) - q.x * norm2(p)} / d;
}

// The common centre of the circles that bound the face.
std::optional<Vec2> common_centre(const CadFace& face) {
  const Nurbs& first = face.curves.front();
  const std::optional<Vec2> centre = circumcentre(point_at(first, 0), point_at(first, 0.3), point_at(first, 0.6));
  if (!centre) return std::nullopt;
  for (int l = 0; l < face.num_loops(); ++l) {
    const double radius = distance(face.joints[face.loop_offsets[l]].position, *centre);
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c)
      for (int i = 0; i <= samples_of_curve; ++i) {
        const Vec2 x = point_at(face.curves[c], static_cast<double>(i) / samples_of_curve);
        if (std::abs(distance(x, *centre) - radius) > relative_circular * face.diameter) return std::nullopt;
      }
  }
  return centre;
}

class CircularRegions {
 public:
  explicit CircularRegions(RegionLayouts& regions) : regions_(regions) {
    for (std::size_t r = 0; r < regions.layouts.size(); ++r) {
      const CadFace& face = regions.layouts[r].graph().face;
      centres_.push_back(face.num_regions() == 1 && face.partners.empty() ? common_centre(face) : std::nullopt);
      is_settled_.push_back(!centres_.back());
      is_line_end_.push_back(line_ends(regions.layouts[r]));
      has_lines_.push_back(std::find(is_line_end_[r].begin(), is_line_end_[r].end(), true) != is_line_end_[r].end());
    }
    passing_.resize(regions.layouts.size());
    regions.rotations.assign(regions.layouts.size(), {});
  }

  int rotate_all() {
    int num_rotated = 0;
    if (std::none_of(is_settled_.begin(), is_settled_.end(), [](bool settled) { return settled; }))
      is_settled_[first_with_lines()] = true;
    for (bool is_new = true; is_new;) {
      is_new = false;
      // Those beside a settled region are rotated to its lines as they are now.
      std::vector<int> next;
      for (int r = 0; r < static_cast<int>(is_settled_.size()); ++r)
        if (!is_settled_[r] && has_settled_neighbour(r)) next.push_back(r);
      for (const int r : next) {
        num_rotated += has_lines_[r] ? rotate_one(r) : pass_through(r);
        is_new = true;
      }
      for (const int r : next) is_settled_[r] = true;
    }
    return num_rotated;
  }

 private:
  // Marks the nodes of the boundary where lines end, cuts left out.
  static std::vector<bool> line_ends(const graph::CandidateLayout& layout) {
    const ArcGraph& graph = layout.graph();
    std::vector<bool> marks(graph.nodes.size(), false);
    for (const SeparatrixLine& line : layout.lines)
      for (const int node : {line.origin, line.end})
        marks[node] = marks[node] || (line.kind != LineKind::cut && graph.nodes[node].curve >= 0);
    return marks;
  }

  // 0 if there are cuts alone.
  std::size_t first_with_lines() const {
    const auto first = std::find(has_lines_.begin(), has_lines_.end(), true);
    return first == has_lines_.end() ? 0 : static_cast<std::size_t>(first - has_lines_.begin());
  }

  // The region on the other side of a curve; -1: none.
  int neighbour(int region, int curve) const {
    const int partner = regions_.face.is_interface(curve) ? regions_.face.partners[curve] : -1;
    const int other = partner < 0 ? -1 : regions_.region_of_curve(partner);
    return other == region ? -1 : other;
  }

  bool has_settled_neighbour(int region) const {
    const int first = regions_.first_curves[region], count = regions_.layouts[region].graph().face.num_curves();
    for (int c = first; c < first + count; ++c)
      if (const int other = neighbour(region, c); other >= 0 && is_settled_[other]) return true;
    return false;
  }

  double angle_about(Vec2 centre, Vec2 x) const { return angle_of(x - centre); }

  std::vector<EndAngles> angles_of_loops(int region) const {
    const CadFace& face = regions_.layouts[region].graph().face;
    std::vector<EndAngles> loops(face.num_loops());
    const std::vector<GraphNode>& nodes = regions_.layouts[region].graph().nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (is_line_end_[region][n])
        loops[face.loop_of(nodes[n].curve)].own.push_back(angle_about(*centres_[region], nodes[n].position));
    for (std::size_t other = 0; other < regions_.layouts.size(); ++other) {
      if (!is_settled_[other]) continue;
      const ArcGraph& graph = regions_.layouts[other].graph();
      for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (graph.nodes[n].curve < 0 || !is_line_end_[other][n]) continue;
        for (const BoundaryPoint& point :
             coincident_points(regions_.face, regions_.point_of(static_cast<int>(other), static_cast<int>(n))))
          if (regions_.region_of_curve(point.curve) == region)
            loops[face.loop_of(point.curve - regions_.first_curves[region])].others.push_back(
                angle_about(*centres_[region], graph.nodes[n].position));
      }
    }
    for (int c = 0; c < face.num_curves(); ++c)
      if (const int other = neighbour(region, c + regions_.first_curves[region]); other >= 0 && is_settled_[other])
        for (const double angle : passing_[other]) loops[face.loop_of(c)].others.push_back(angle);
    return loops;
  }

  // A ring without lines of its own lets those of its neighbours pass; it is not rotated.
  bool pass_through(int region) {
    for (const EndAngles& loop : angles_of_loops(region))
      passing_[region].insert(passing_[region].end(), loop.others.begin(), loop.others.end());
    return false;
  }

  bool rotate_one(int region) {
    const double angle = best_rotation(angles_of_loops(region));
    if (angle == 0) return false;
    graph::CandidateLayout& layout = regions_.layouts[region];
    SeparatrixGraph graph = graph::separatrix_graph(std::move(layout));
    regions_.rotations[region] = {*centres_[region], angle};
    rotate(graph, regions_.rotations[region]);
    layout = graph::candidate_layout(std::move(graph));
    return true;
  }

  static std::vector<ArcPiece> path(const CadFace& face, const GraphNode& from, const GraphNode& to) {
    std::vector<ArcPiece> pieces;
    int curve = from.curve;
    double t = from.t;
    while (curve != to.curve || (t >= to.t && pieces.empty())) {
      pieces.push_back({curve, t, face.curves[curve].end()});
      curve = face.next_in_loop(curve);
      t = face.curves[curve].begin();
    }
    if (t < to.t) pieces.push_back({curve, t, to.t});
    return pieces;
  }

  static void rotate(SeparatrixGraph& graph, const curve::Rotation& rotation) {
    for (Nurbs& spline : graph.splines)
      for (Vec2& pole : spline.poles) pole = rotation.of(pole);
    for (GraphNode& node : graph.nodes) {
      node.position = rotation.of(node.position);
      if (node.curve < 0) continue;
      const BoundaryPoint point = nearest_boundary_point(graph.face, graph.face.loop_of(node.curve), node.position);
      node.curve = point.curve;
      node.t = point.t;
    }
    for (GraphArc& arc : graph.arcs)
      if (arc.is_boundary) arc.pieces = path(graph.face, graph.nodes[arc.from], graph.nodes[arc.to]);
  }

  RegionLayouts& regions_;
  std::vector<std::optional<Vec2>> centres_;
  std::vector<bool> is_settled_, has_lines_;
  std::vector<std::vector<bool>> is_line_end_;  // of the nodes of each region
  std::vector<std::vector<double>> passing_;    // of rings without lines: angles of lines that pass
};

}  // namespace

int rotate_circular_regions(RegionLayouts& regions) {
  if (regions.layouts.size() == 1) return 0;
  return CircularRegions(regions).rotate_all();
}

}  // namespace quadrille::couple
