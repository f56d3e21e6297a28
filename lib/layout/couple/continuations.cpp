#include "couple/continuations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "couple/match_line_ends.hpp"
#include "curve/chain.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "simplify/chord_blend.hpp"
#include "trace/advance.hpp"

namespace quadrille::couple {
namespace {

// Relative to the diameter of the region, or of the whole.
constexpr double relative_tolerance = 1e-10;  // of a step
constexpr double relative_step = 1.0 / 20;    // the greatest
constexpr double relative_hit = 1e-5;         // a line that comes nearer to a node is not continued
constexpr double relative_length = 4;         // the greatest of a line
constexpr double relative_fit_tol = 2e-9;     // as for traced lines

// A point of a region's boundary, circles about the centre, before or after a rotation.
BoundaryPoint rotated(const CadFace& face, const curve::Rotation& rotation, const BoundaryPoint& point) {
  if (rotation.angle == 0) return point;
  return nearest_boundary_point(face, face.loop_of(point.curve),
                                rotation.of(curve::point(face.curves[point.curve], point.t)));
}

/// The field of a region, rotated as its layout was.
struct RotatedField {
  const field::FieldEvaluator& field;
  curve::Rotation rotation;
};

std::optional<TracedLine> traced_line(const graph::CandidateLayout& layout, const RotatedField& rotated_field,
                                      const BoundaryPoint& start) {
  const auto& [field, rotation] = rotated_field;
  const CadFace& face = layout.graph().face;
  const double d = face.diameter;
  std::vector<Vec2> nodes;
  for (const GraphNode& node : layout.graph().nodes)
    if (node.curve < 0) nodes.push_back(rotation.inverse().of(node.position));
  const BoundaryPoint before = rotated(face, rotation.inverse(), start);
  const trace::Streamline line =
      trace::advance(field, trace::launch_from_boundary(field, before.curve, before.t), PointGrid(std::move(nodes)),
                     {relative_tolerance * d, relative_step * d, relative_length * d, relative_hit * d});
  if (line.steps.empty()) return std::nullopt;
  const auto point = [&field = field, &rotation = rotation, &line](double s, Vec2& direction) {
    const Vec2 x = line.at(field, s, direction);
    direction = rotation.of_vector(direction);
    return rotation.of(x);
  };
  TracedLine traced;
  traced.spline = curve::fit_line(point, line.length(), relative_fit_tol * d);
  traced.ends_on_boundary = line.end == trace::Streamline::End::boundary;
  if (traced.ends_on_boundary)
    traced.end = rotated(face, rotation, boundary_point(face, line.reached.curve, line.reached.t));
  return traced;
}

bool has_node_at(const SidePair& pair, int side, double position, double same) {
  return std::any_of(pair.nodes[side].begin(), pair.nodes[side].end(),
                     [&](const SideNode& node) { return pair.distance(node.position, position) <= same; });
}

std::vector<Continuation> traced_continuations(const RegionLayouts& regions, CutEnds cuts,
                                               const CanInsert& can_insert) {
  const CadFace& face = regions.face;
  std::vector<Continuation> found;
  for (const SidePair& pair : interface_sides(regions, cuts))
    for (const int side : {0, 1})
      for (const SideNode& node : pair.nodes[side]) {
        if (has_node_at(pair, 1 - side, node.position, relative_same * face.diameter)) continue;
        Continuation next;
        next.start = point_on_side(face, pair, 1 - side, regions.point_of(node.layout, node.node));
        next.region = regions.region_of_curve(next.start.curve);
        next.start.curve -= regions.first_curves[next.region];
        const graph::CandidateLayout& layout = regions.layouts[next.region];
        if (!can_insert(layout.subdivision, next.start)) continue;
        next.line = traced_line(layout, {*regions.fields[next.region], regions.rotation_of(next.region)}, next.start);
        found.push_back(std::move(next));
      }
  return found;
}

Vec2 position_on(const CadFace& face, const BoundaryPoint& point) {
  return curve::point(face.curves[point.curve], point.t);
}

// How far, relative to their lengths, each of two lines through a region ends from where the other one starts.
double end_distance(const CadFace& face, const Continuation& a, const Continuation& b) {
  if (a.region != b.region || !a.line || !b.line || !a.line->ends_on_boundary || !b.line->ends_on_boundary)
    return INFINITY;
  const auto distance_to = [&](const Continuation& from, const Continuation& to) {
    return distance(position_on(face, from.line->end), position_on(face, to.start)) / from.line->spline.end();
  };
  return std::max(distance_to(a, b), distance_to(b, a));
}

// The line from the start of one to the start of the other, a blend (simplify/chord_blend.hpp).
TracedLine merged(const CadFace& face, const Continuation& a, const Continuation& b) {
  const std::vector<Nurbs> splines{a.line->spline, b.line->spline};
  const curve::CurveTable table(face, splines);
  const int first = face.num_curves();
  const curve::Chain from(table, {{first, splines[0].begin(), splines[0].end()}});
  const curve::Chain to(table, {{first + 1, splines[1].end(), splines[1].begin()}});
  return {curve::fit_line(simplify::blended_curve(from, to), simplify::blend_length(from, to),
                          relative_fit_tol * face.diameter),
          true, b.start};
}

// Lines that cross a region in opposite directions, each the nearest to the other and not bent by more than
// `greatest_bend`, become one.
void merge_opposite_lines(const RegionLayouts& regions, std::vector<Continuation>& all) {
  const auto nearest = [&](std::size_t i) {
    std::optional<std::size_t> best;
    double least = greatest_bend;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i == j || all[i].region != all[j].region) continue;
      const double here = end_distance(regions.layouts[all[i].region].graph().face, all[i], all[j]);
      if (here >= least + relative_tie) continue;
      best = std::abs(here - least) <= relative_tie ? std::nullopt : std::optional(j);
      least = std::min(here, least);
    }
    return best;
  };
  std::vector<std::optional<std::size_t>> partners;
  for (std::size_t i = 0; i < all.size(); ++i) partners.push_back(nearest(i));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::optional<std::size_t> j = partners[i];
    if (!j || *j < i || partners[*j] != i) continue;
    all[i].line = merged(regions.layouts[all[i].region].graph().face, all[i], all[*j]);
    all[*j].line.reset();
  }
}

}  // namespace

std::vector<Continuation> continuations(const RegionLayouts& regions, CutEnds cuts, const CanInsert& can_insert) {
  std::vector<Continuation> all = traced_continuations(regions, cuts, can_insert);
  merge_opposite_lines(regions, all);
  return all;
}

}  // namespace quadrille::couple
