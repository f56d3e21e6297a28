#include "couple/continuations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/chain.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "simplify/chord_blend.hpp"
#include "trace/advance.hpp"

namespace quadrille::couple {
namespace {

// Relative to the diameter of the region, or of the whole.
constexpr double relative_same = 1e-8;        // a line nearer than this to a node ends there already
constexpr double relative_tolerance = 1e-10;  // of a step
constexpr double relative_step = 1.0 / 20;    // the greatest
constexpr double relative_hit = 1e-5;         // a line that comes nearer to a node is not continued
constexpr double relative_length = 4;         // the greatest of a line
constexpr double relative_fit_tol = 2e-9;     // as for traced lines

constexpr double greatest_bend = 0.1;  // radians: of lines that become one
constexpr double relative_tie = 1e-6;  // bends that differ by less are equal

// The place of a region's boundary, circles about the centre, before or after a turn.
Place turned(const CadFace& face, const curve::Turn& turn, const Place& place) {
  if (turn.angle == 0) return place;
  return place_on_loop(face, face.loop_of(place.curve), turn.of(curve::point(face.curves[place.curve], place.t)));
}

/// The field of a region, turned as its layout was.
struct TurnedField {
  const field::FieldEvaluator& field;
  curve::Turn turn;
};

std::optional<TracedLine> traced_line(const graph::CandidateLayout& layout, const TurnedField& turned_field,
                                      const Place& start) {
  const auto& [field, turn] = turned_field;
  const CadFace& face = layout.graph().face;
  const double d = face.diameter;
  std::vector<Vec2> nodes;
  for (const GraphNode& node : layout.graph().nodes)
    if (node.curve < 0) nodes.push_back(turn.inverse().of(node.position));
  const Place before = turned(face, turn.inverse(), start);
  const trace::Streamline line =
      trace::advance(field, trace::launch_from_boundary(field, before.curve, before.t), PointGrid(std::move(nodes)),
                     {relative_tolerance * d, relative_step * d, relative_length * d, relative_hit * d});
  if (line.steps.empty()) return std::nullopt;
  const auto point = [&field = field, &turn = turn, &line](double s, Vec2& direction) {
    const Vec2 x = line.at(field, s, direction);
    direction = turn.of_vector(direction);
    return turn.of(x);
  };
  TracedLine traced;
  traced.spline = curve::fit_line(point, line.length(), relative_fit_tol * d);
  traced.ends_on_boundary = line.end == trace::Streamline::End::boundary;
  if (traced.ends_on_boundary) traced.end = turned(face, turn, place_at(face, line.reached.curve, line.reached.t));
  return traced;
}

bool has_station_at(const InterfaceChain& chain, int side, double position, double same) {
  return std::any_of(chain.stations[side].begin(), chain.stations[side].end(), [&](const Station& s) {
    const double d = std::abs(s.position - position);
    return std::min(d, chain.is_closed ? chain.length() - d : d) <= same;
  });
}

std::vector<Continuation> ways_on(const RegionLayouts& regions, CutEnds cuts, const Admits& admits) {
  const CadFace& face = regions.face;
  std::vector<Continuation> found;
  for (const InterfaceChain& chain : interface_chains(regions, cuts))
    for (const int side : {0, 1})
      for (const Station& station : chain.stations[side]) {
        if (has_station_at(chain, 1 - side, station.position, relative_same * face.diameter)) continue;
        Continuation way;
        way.start = place_on_side(face, chain, 1 - side, regions.place_of(station.region, station.node));
        way.region = regions.region_of_curve(way.start.curve);
        way.start.curve -= regions.first_curves[way.region];
        const graph::CandidateLayout& layout = regions.layouts[way.region];
        if (!admits(layout.subdivision, way.start)) continue;
        way.line = traced_line(layout, {*regions.fields[way.region], regions.turn_of(way.region)}, way.start);
        found.push_back(std::move(way));
      }
  return found;
}

// How far, relative to their lengths, each of two lines through a region ends from where the other one starts.
double apart(const CadFace& face, const Continuation& a, const Continuation& b) {
  if (a.region != b.region || !a.line || !b.line || !a.line->ends_on_boundary || !b.line->ends_on_boundary)
    return INFINITY;
  return std::max(distance(a.end_in(face), b.start_in(face)) / a.line->spline.end(),
                  distance(b.end_in(face), a.start_in(face)) / b.line->spline.end());
}

// The line from the start of one to the start of the other, a blend (simplify/chord_blend.hpp).
TracedLine united(const CadFace& face, const Continuation& a, const Continuation& b) {
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
void unite_opposite_lines(const RegionLayouts& regions, std::vector<Continuation>& ways) {
  const auto nearest = [&](std::size_t i) {
    std::optional<std::size_t> best;
    double least = greatest_bend;
    for (std::size_t j = 0; j < ways.size(); ++j) {
      if (i == j || ways[i].region != ways[j].region) continue;
      const double here = apart(regions.layouts[ways[i].region].graph().face, ways[i], ways[j]);
      if (here >= least + relative_tie) continue;
      best = std::abs(here - least) <= relative_tie ? std::nullopt : std::optional(j);
      least = std::min(here, least);
    }
    return best;
  };
  std::vector<std::optional<std::size_t>> partners;
  for (std::size_t i = 0; i < ways.size(); ++i) partners.push_back(nearest(i));
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const std::optional<std::size_t> j = partners[i];
    if (!j || *j < i || partners[*j] != i) continue;
    ways[i].line = united(regions.layouts[ways[i].region].graph().face, ways[i], ways[*j]);
    ways[*j].line.reset();
  }
}

}  // namespace

std::vector<Continuation> continuations(const RegionLayouts& regions, CutEnds cuts, const Admits& admits) {
  std::vector<Continuation> ways = ways_on(regions, cuts, admits);
  unite_opposite_lines(regions, ways);
  return ways;
}

}  // namespace quadrille::couple
