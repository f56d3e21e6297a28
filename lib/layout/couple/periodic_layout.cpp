#include "couple/periodic_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "couple/meet_stations.hpp"
#include "couple/periodic_chains.hpp"
#include "couple/periodic_nodes.hpp"
#include "couple/renew_lines.hpp"
#include "curve/arc_length.hpp"
#include "graph/chord_strip.hpp"
#include "graph/separatrix_lines.hpp"
#include "model/periodic_arcs.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/quantized_parametrization.hpp"

namespace quadrille::couple {
namespace {

constexpr double relative_same = 1e-8;  // relative to the diameter: nodes nearer than this are one
constexpr double relative_tie = 1e-6;   // distances of relative difference below it are equal

using Fields = field::FieldsOfRegions;
using MeetingsOf = std::function<std::vector<Meeting>(const PeriodicChain&)>;

Place place_of(const GraphNode& node) { return {node.curve, node.t}; }

// Returns the deviation of the line, radians.
double move_end(graph::CandidateLayout& layout, const Station& station, const Place& place,
                const field::FieldsOfRegions& fields) {
  if (!station.is_movable || place_of(layout.graph().nodes[station.node]) == place) return 0;
  const auto move = move_to(layout, station.node, place);
  return move ? simplify::move_line_end(layout.subdivision, *move, &fields) : 0;
}

// The two ends at their common place.
void meet(graph::CandidateLayout& layout, const PeriodicChain& chain, const Meeting& meeting,
          const field::FieldsOfRegions& fields) {
  const CadFace face = layout.graph().face;
  const std::array<const Station*, 2> stations{&chain.chain.stations[0][meeting.stations[0]],
                                               &chain.chain.stations[1][meeting.stations[1]]};
  std::array<Place, 2> places;
  if (stations[1]->is_movable) {
    places[0] = stations[0]->is_movable ? place_on(face, chain.chain, meeting.position)
                                        : place_of(layout.graph().nodes[stations[0]->node]);
    places[1] = image_of(face, chain, places[0]);
  } else {
    places[1] = place_of(layout.graph().nodes[stations[1]->node]);
    places[0] = image_of(face, chain, places[1]);
  }
  for (const int side : {0, 1}) {
    const double deviation = degrees(move_end(layout, *stations[side], places[side], fields));
    double& largest = layout.certificate.largest_deviation_degrees;
    largest = std::max(largest, deviation);
  }
}

// Returns the number of pairs that meet.
int meet_lines(graph::CandidateLayout& layout, const Fields& fields, const MeetingsOf& meetings_of) {
  std::vector<LineKind> kinds = graph::spline_kinds(layout.graph(), layout.lines);
  std::vector<PeriodicChain> chains = periodic_chains(layout.graph().face);
  set_stations(layout, chains);
  int num_meetings = 0;
  for (const PeriodicChain& chain : chains)
    for (const Meeting& meeting : meetings_of(chain)) {
      meet(layout, chain, meeting, fields);
      ++num_meetings;
    }
  renew_lines(layout, std::move(kinds), LineKind::merged);
  return num_meetings;
}

// Where the ends of an arc are along the chain of first curves; no value if the arc is not on it.
std::optional<std::array<double, 2>> positions_on(const CadFace& face, const PeriodicChain& chain,
                                                  const GraphArc& arc) {
  std::array<double, 2> positions{};
  for (const int side : {0, 1}) {
    const ArcPiece& piece = side == 0 ? arc.pieces.front() : arc.pieces.back();
    const std::vector<int>& curves = chain.chain.curves;
    const auto found = std::find(curves.begin(), curves.end(), piece.curve);
    if (!arc.is_boundary || found == curves.end()) return std::nullopt;
    positions[side] = chain.chain.offsets[found - curves.begin()] +
                      curve::ArcLength(face.curves[piece.curve]).at(side == 0 ? piece.t0 : piece.t1);
  }
  return positions;
}

// Ends of lines on both sides between which every integer grid has no length, the nearest; equally near ones together.
std::vector<Meeting> forced_meetings(const ArcGraph& graph, const PeriodicChain& chain, const std::vector<int>& zero,
                                     double same) {
  std::vector<std::pair<double, Meeting>> found;
  const std::vector<Station>&firsts = chain.chain.stations[0], &seconds = chain.chain.stations[1];
  const auto add_between = [&](double low, double high) {
    for (int i = 0; i < static_cast<int>(firsts.size()); ++i)
      for (int j = 0; j < static_cast<int>(seconds.size()); ++j) {
        const Station &a = firsts[i], &b = seconds[j];
        if (std::abs(std::min(a.position, b.position) - low) > same ||
            std::abs(std::max(a.position, b.position) - high) > same || (!a.is_movable && !b.is_movable))
          continue;
        found.push_back({high - low, {{i, j}, (low + high) / 2}});
      }
  };
  for (const int a : zero)
    if (const auto ends = positions_on(graph.face, chain, graph.arcs[a])) add_between((*ends)[0], (*ends)[1]);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [length, meeting] : found) least = std::min(least, length);
  std::vector<Meeting> meetings;
  for (const auto& [length, meeting] : found)
    if (length <= least * (1 + relative_tie)) meetings.push_back(meeting);
  return meetings;
}

/// A layout with the T-junctions across its periodic sides, and what is known of its integer grid.
struct PeriodicTMesh {
  graph::CandidateLayout layout;
  int num_divided = 0;
  std::vector<HalfEdge> same;  // model/periodic_arcs.hpp, first_arcs
  std::vector<quantize::TFace> faces, across;
  std::vector<int> lengths;  // empty: there are none

  bool is_conforming() const { return num_divided == 0 && layout.t_junctions.empty(); }
};

PeriodicTMesh periodic_t_mesh(const graph::CandidateLayout& layout, double relative_unit) {
  PeriodicTMesh t_mesh{layout, 0, {}, {}, {}, {}};
  t_mesh.num_divided = divide_periodic_sides(t_mesh.layout);
  if (t_mesh.is_conforming()) return t_mesh;
  const ArcGraph& graph = t_mesh.layout.graph();
  t_mesh.same = first_arcs(graph);
  t_mesh.faces = quantize::t_mesh_faces(t_mesh.layout.subdivision);
  t_mesh.across = quantize::faces_across_periodic_sides(t_mesh.faces, t_mesh.same);
  t_mesh.lengths =
      quantize::quantize_or_explain(t_mesh.across, graph::arc_lengths(graph), relative_unit * graph.face.diameter)
          .lengths;
  for (std::size_t a = 0; a < t_mesh.lengths.size(); ++a) t_mesh.lengths[a] = t_mesh.lengths[t_mesh.same[a].arc];
  return t_mesh;
}

}  // namespace

graph::CandidateLayout conforming_across_periodic_sides(graph::CandidateLayout layout, const Fields& fields,
                                                        double relative_unit, Report& report) {
  const double same = relative_same * layout.graph().face.diameter;
  int num_met = meet_lines(layout, fields, [&](const PeriodicChain& chain) { return meetings_on(chain.chain, same); });
  PeriodicTMesh t_mesh = periodic_t_mesh(layout, relative_unit);
  while (!t_mesh.is_conforming() && t_mesh.lengths.empty()) {
    const ArcGraph& graph = t_mesh.layout.graph();
    const std::vector<int> zero = quantize::forced_zero_arcs(t_mesh.across, static_cast<int>(graph.arcs.size()));
    const int num_forced = meet_lines(
        layout, fields, [&](const PeriodicChain& chain) { return forced_meetings(graph, chain, zero, same); });
    const int num_before = t_mesh.num_divided;
    num_met += num_forced;
    t_mesh = periodic_t_mesh(layout, relative_unit);
    if (t_mesh.lengths.empty() && t_mesh.num_divided >= num_before)
      throw ComputeError(
          "the lines of the layout cannot be continued across the periodic sides: a strip of blocks winds onto itself; "
          "cut the repeated shape so that its periodic sides end at right angles, or leave out a pair (cad2tri "
          "--periodic)");
  }
  report.set("couple.periodic_lines_met", num_met);
  report.set("couple.periodic_t_junctions", t_mesh.num_divided);
  if (t_mesh.is_conforming()) return std::move(t_mesh.layout);
  return quantize::extend_lines(t_mesh.layout, t_mesh.faces, t_mesh.lengths, t_mesh.same);
}

}  // namespace quadrille::couple
