#include "couple/rotate_circular_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"

namespace quadrille::couple {
namespace {

/// How far the own ends, rotated by an angle, are from the others.
struct Offsets {
  double mean = 0, squares = 0;
};

Offsets offsets(const std::vector<EndAngles>& loops, double angle) {
  Offsets result;
  int count = 0;
  for (const EndAngles& loop : loops) {
    if (loop.others.empty()) continue;
    for (const double own : loop.own) {
      double least = std::numeric_limits<double>::infinity();
      for (const double other : loop.others)
        if (const double d = wrap_pi(other - own - angle); std::abs(d) < std::abs(least)) least = d;
      result.mean += least, result.squares += least * least, ++count;
    }
  }
  if (count > 0) result.mean /= count;
  return result;
}

bool is_among(const std::vector<double>& angles, double angle) {
  return std::any_of(angles.begin(), angles.end(),
                     [&](double a) { return std::abs(wrap_pi(a - angle)) <= tolerance::same_angle; });
}

// Whether a rotation by this angle maps the own ends onto themselves.
bool is_symmetry(const std::vector<EndAngles>& loops, double angle) {
  return std::all_of(loops.begin(), loops.end(), [&](const EndAngles& loop) {
    return std::all_of(loop.own.begin(), loop.own.end(), [&](double own) { return is_among(loop.own, own + angle); });
  });
}

// The best of these angles, up to symmetries of the own ends; of each class the least in magnitude.
std::vector<double> best_of(const std::vector<EndAngles>& loops, std::vector<double> angles) {
  std::stable_sort(angles.begin(), angles.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  double least = std::numeric_limits<double>::infinity();
  for (const double angle : angles) least = std::min(least, offsets(loops, angle).squares);
  std::vector<double> best;
  for (const double angle : angles) {
    const bool is_known =
        std::any_of(best.begin(), best.end(), [&](double b) { return is_symmetry(loops, angle - b); });
    if (!is_known && offsets(loops, angle).squares <= least + tolerance::tied * (1 + least)) best.push_back(angle);
  }
  return best;
}

// The rotations that bring an own end to another one, each moved to the nearest minimum.
std::vector<double> candidates(const std::vector<EndAngles>& loops) {
  std::vector<double> angles;
  for (const EndAngles& loop : loops)
    for (const double own : loop.own)
      for (const double other : loop.others) {
        const double angle = other - own;
        angles.push_back(wrap_pi(angle + offsets(loops, angle).mean));
      }
  return angles;
}

// In the middle between two neighbours of the equally good angles, their images under symmetries included.
std::vector<double> middles(const std::vector<EndAngles>& loops, const std::vector<double>& all,
                            const std::vector<double>& best) {
  std::vector<double> good, angles;
  for (const double angle : all)
    if (std::any_of(best.begin(), best.end(), [&](double b) { return is_symmetry(loops, angle - b); }))
      if (!is_among(good, angle)) good.push_back(angle);
  std::sort(good.begin(), good.end());
  for (std::size_t i = 0; i < good.size(); ++i) {
    const double next = i + 1 < good.size() ? good[i + 1] : good.front() + 2 * pi;
    angles.push_back(wrap_pi((good[i] + next) / 2));
  }
  return angles;
}

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
        if (std::abs(distance(x, *centre) - radius) > tolerance::round_off * face.diameter) return std::nullopt;
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

  std::vector<EndAngles> angles_of_loops(int region) const {
    const CadFace& face = regions_.layouts[region].graph().face;
    std::vector<EndAngles> loops(face.num_loops());
    const std::vector<GraphNode>& nodes = regions_.layouts[region].graph().nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (is_line_end_[region][n])
        loops[face.loop_of(nodes[n].curve)].own.push_back(angle_of(nodes[n].position - *centres_[region]));
    for (std::size_t other = 0; other < regions_.layouts.size(); ++other) {
      if (!is_settled_[other]) continue;
      const ArcGraph& graph = regions_.layouts[other].graph();
      for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (graph.nodes[n].curve < 0 || !is_line_end_[other][n]) continue;
        for (const BoundaryPoint& point :
             coincident_points(regions_.face, regions_.point_of(static_cast<int>(other), static_cast<int>(n))))
          if (regions_.region_of_curve(point.curve) == region)
            loops[face.loop_of(point.curve - regions_.first_curves[region])].others.push_back(
                angle_of(graph.nodes[n].position - *centres_[region]));
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
      if (arc.is_boundary) arc.pieces = graph::boundary_path(graph.face, graph.nodes[arc.from], graph.nodes[arc.to]);
  }

  RegionLayouts& regions_;
  std::vector<std::optional<Vec2>> centres_;
  std::vector<bool> is_settled_, has_lines_;
  std::vector<std::vector<bool>> is_line_end_;  // of the nodes of each region
  std::vector<std::vector<double>> passing_;    // of rings without lines: angles of lines that pass
};

}  // namespace

double best_rotation(const std::vector<EndAngles>& loops) {
  const std::vector<double> all = candidates(loops);
  if (all.empty()) return 0;
  const std::vector<double> best = best_of(loops, all);
  if (best.size() == 1) return best.front();
  const std::vector<double> between = best_of(loops, middles(loops, all, best));
  return between.size() == 1 ? between.front() : best.front();
}

int rotate_circular_regions(RegionLayouts& regions) {
  if (regions.layouts.size() == 1) return 0;
  return CircularRegions(regions).rotate_all();
}

}  // namespace quadrille::couple
