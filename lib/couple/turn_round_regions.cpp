#include "couple/turn_round_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::couple {
namespace {

constexpr double relative_round = 1e-9;  // relative to the diameter: deviation of a boundary from circles
constexpr double relative_tie = 1e-6;
constexpr int samples_of_curve = 9;

Vec2 rotated(Vec2 x, Vec2 centre, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec2 d = x - centre;
  return centre + Vec2{c * d.x - s * d.y, s * d.x + c * d.y};
}

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
std::optional<Vec2> round_centre(const CadFace& face) {
  const Nurbs& first = face.curves.front();
  const std::optional<Vec2> centre = circumcentre(point_at(first, 0), point_at(first, 0.3), point_at(first, 0.6));
  if (!centre) return std::nullopt;
  for (int l = 0; l < face.num_loops(); ++l) {
    const double radius = distance(face.joints[face.loop_offsets[l]].position, *centre);
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c)
      for (int i = 0; i <= samples_of_curve; ++i) {
        const Vec2 x = point_at(face.curves[c], static_cast<double>(i) / samples_of_curve);
        if (std::abs(distance(x, *centre) - radius) > relative_round * face.diameter) return std::nullopt;
      }
  }
  return centre;
}

class RoundRegions {
 public:
  explicit RoundRegions(RegionLayouts& regions) : regions_(regions) {
    for (std::size_t r = 0; r < regions.layouts.size(); ++r) {
      const CadFace& face = regions.layouts[r].graph().face;
      centres_.push_back(face.num_regions() == 1 && face.partners.empty() ? round_centre(face) : std::nullopt);
      is_settled_.push_back(!centres_.back());
      is_line_end_.push_back(line_ends(regions.layouts[r]));
      has_lines_.push_back(std::find(is_line_end_[r].begin(), is_line_end_[r].end(), true) != is_line_end_[r].end());
    }
    passing_.resize(regions.layouts.size());
  }

  int turn_all() {
    int num_turned = 0;
    if (std::none_of(is_settled_.begin(), is_settled_.end(), [](bool settled) { return settled; }))
      is_settled_[first_with_lines()] = true;
    for (bool is_new = true; is_new;) {
      is_new = false;
      // Those beside a settled region are turned to its lines as they are now.
      std::vector<int> turned;
      for (int r = 0; r < static_cast<int>(is_settled_.size()); ++r)
        if (!is_settled_[r] && has_settled_neighbour(r)) turned.push_back(r);
      for (const int r : turned) {
        num_turned += has_lines_[r] ? turn(r) : pass_through(r);
        is_new = true;
      }
      for (const int r : turned) is_settled_[r] = true;
    }
    return num_turned;
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

  /// Angles about the centre at which lines end on a loop: of the region, and of its settled neighbours.
  struct LoopAngles {
    std::vector<double> own, others;
  };

  std::vector<LoopAngles> angles_of_loops(int region) const {
    const CadFace& face = regions_.layouts[region].graph().face;
    std::vector<LoopAngles> loops(face.num_loops());
    const std::vector<GraphNode>& nodes = regions_.layouts[region].graph().nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (is_line_end_[region][n])
        loops[face.loop_of(nodes[n].curve)].own.push_back(angle_about(*centres_[region], nodes[n].position));
    for (std::size_t other = 0; other < regions_.layouts.size(); ++other) {
      if (!is_settled_[other]) continue;
      const ArcGraph& graph = regions_.layouts[other].graph();
      for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (graph.nodes[n].curve < 0 || !is_line_end_[other][n]) continue;
        for (const Place& place :
             places_of_point(regions_.face, regions_.place_of(static_cast<int>(other), static_cast<int>(n))))
          if (regions_.region_of_curve(place.curve) == region)
            loops[face.loop_of(place.curve - regions_.first_curves[region])].others.push_back(
                angle_about(*centres_[region], graph.nodes[n].position));
      }
    }
    for (int c = 0; c < face.num_curves(); ++c)
      if (const int other = neighbour(region, c + regions_.first_curves[region]); other >= 0 && is_settled_[other])
        for (const double angle : passing_[other]) loops[face.loop_of(c)].others.push_back(angle);
    return loops;
  }

  // A ring without lines of its own lets those of its neighbours pass; it is not turned.
  bool pass_through(int region) {
    for (const LoopAngles& loop : angles_of_loops(region))
      passing_[region].insert(passing_[region].end(), loop.others.begin(), loop.others.end());
    return false;
  }

  // From each own end, turned by `angle`, to the nearest other: their mean offset, and the sum of squares.
  static std::pair<double, double> offsets(const std::vector<LoopAngles>& loops, double angle) {
    double sum = 0, squares = 0;
    int count = 0;
    for (const LoopAngles& loop : loops)
      for (const double own : loop.own) {
        double least = std::numeric_limits<double>::infinity();
        for (const double other : loop.others)
          if (const double d = wrap_pi(other - own - angle); std::abs(d) < std::abs(least)) least = d;
        if (loop.others.empty()) continue;
        sum += least, squares += least * least, ++count;
      }
    return {count > 0 ? sum / count : 0, squares};
  }

  // The angle with the least sum of squares; of equal ones the least in magnitude.
  static double best_angle(const std::vector<LoopAngles>& loops) {
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (const LoopAngles& loop : loops)
      for (const double own : loop.own)
        for (const double other : loop.others) {
          double angle = wrap_pi(other - own);
          angle = wrap_pi(angle + offsets(loops, angle).first);
          const double squares = offsets(loops, angle).second, tie = relative_tie * (1 + squares);
          if (squares < least - tie || (squares <= least + tie && std::abs(angle) < std::abs(best) - relative_tie)) {
            best = angle;
            least = std::min(least, squares);
          }
        }
    return best;
  }

  bool turn(int region) {
    const double angle = best_angle(angles_of_loops(region));
    if (angle == 0) return false;
    graph::CandidateLayout& layout = regions_.layouts[region];
    SeparatrixGraph graph = graph::separatrix_graph(std::move(layout));
    rotate(graph, *centres_[region], angle);
    layout = graph::candidate_layout(std::move(graph));
    return true;
  }

  // The place on its loop of a position on it.
  static Place on_loop(const CadFace& face, int loop, Vec2 x) {
    Place best;
    double least = std::numeric_limits<double>::infinity();
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
      if (distance(face.joints[c].position, x) <= relative_round * face.diameter) return {c, face.curves[c].begin()};
      const curve::Projection p = curve::project(face.curves[c], x);
      if (p.distance < least) {
        least = p.distance;
        best = place_at(face, c, p.t);
      }
    }
    return best;
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

  static void rotate(SeparatrixGraph& graph, Vec2 centre, double angle) {
    for (Nurbs& spline : graph.splines)
      for (Vec2& pole : spline.poles) pole = rotated(pole, centre, angle);
    for (GraphNode& node : graph.nodes) {
      node.position = rotated(node.position, centre, angle);
      if (node.curve < 0) continue;
      const Place place = on_loop(graph.face, graph.face.loop_of(node.curve), node.position);
      node.curve = place.curve;
      node.t = place.t;
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

int turn_round_regions(RegionLayouts& regions) {
  if (regions.layouts.size() == 1) return 0;
  return RoundRegions(regions).turn_all();
}

}  // namespace quadrille::couple
