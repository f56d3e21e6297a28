#include "couple/meet_stations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "couple/interface_chains.hpp"
#include "couple/renew_lines.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "simplify/line_end_move.hpp"

namespace quadrille::couple {
namespace {

constexpr double greatest_fraction = 1.0 / 3;  // of the distance to the next end on either side
constexpr double greatest_bend = 0.1;          // radians
constexpr double relative_tie = 1e-6;          // distances of relative difference below it are equal
constexpr double relative_same = 1e-9;         // relative to the diameter: ends nearer than this need not move

double distance_along(const InterfaceChain& chain, double a, double b) {
  const double d = std::abs(a - b);
  return chain.is_closed ? std::min(d, chain.length() - d) : d;
}

/// The nearest station to a position, and how far the next one beyond it is.
struct Nearest {
  int station = -1;
  double distance = std::numeric_limits<double>::infinity();
  bool is_tied = false;
};

Nearest nearest(const InterfaceChain& chain, int side, double position, int except = -1) {
  Nearest best;
  const std::vector<Station>& stations = chain.stations[side];
  for (int i = 0; i < static_cast<int>(stations.size()); ++i) {
    if (i == except) continue;
    const double d = distance_along(chain, stations[i].position, position);
    if (best.station >= 0 && std::abs(d - best.distance) <= relative_tie * best.distance) {
      best.is_tied = true;
      continue;
    }
    if (d < best.distance) best.is_tied = false;
    if (d < best.distance) best.station = i, best.distance = d;
  }
  return best;
}

// Distance to the next end on the same side, or to the end of the chain.
double spacing(const InterfaceChain& chain, int side, int station) {
  const double position = chain.stations[side][station].position;
  double d = nearest(chain, side, position, station).distance;
  if (!chain.is_closed) d = std::min({d, position, chain.length() - position});
  return std::min(d, chain.length());
}

// The angle by which the more bent of two lines turns if they meet.
double bend(const Station& a, const Station& b, double distance) {
  const double moved = a.is_movable && b.is_movable ? distance / 2 : distance;
  double greatest = 0;
  for (const Station* s : {&a, &b})
    if (s->is_movable) greatest = std::max(greatest, moved / s->line_length);
  return greatest;
}

}  // namespace

std::vector<Meeting> meetings_on(const InterfaceChain& chain, double same) {
  std::vector<Meeting> meetings;
  for (int a = 0; a < static_cast<int>(chain.stations[0].size()); ++a) {
    const Station& lower = chain.stations[0][a];
    const Nearest across = nearest(chain, 1, lower.position);
    if (across.station < 0 || across.is_tied || across.distance <= same) continue;
    const Station& other = chain.stations[1][across.station];
    const Nearest back = nearest(chain, 0, other.position);
    if (back.station != a || back.is_tied || (!lower.is_movable && !other.is_movable)) continue;
    const double clearance = std::min(spacing(chain, 0, a), spacing(chain, 1, across.station));
    if (across.distance >= greatest_fraction * clearance && bend(lower, other, across.distance) > greatest_bend)
      continue;
    double middle = (lower.position + other.position) / 2;
    if (std::abs(lower.position - other.position) > chain.length() / 2)  // across the seam
      middle = middle >= chain.length() / 2 ? middle - chain.length() / 2 : middle + chain.length() / 2;
    meetings.push_back({{a, across.station},
                        !lower.is_movable   ? lower.position
                        : !other.is_movable ? other.position
                                            : middle});
  }
  return meetings;
}

Place place_on(const CadFace& face, const InterfaceChain& chain, double position) {
  std::size_t k = 0;
  while (k + 1 < chain.curves.size() && position >= chain.offsets[k + 1]) ++k;
  const int curve = chain.curves[k];
  return place_at(face, curve, curve::ArcLength(face.curves[curve]).parameter(position - chain.offsets[k]));
}

// The boundary arc beside the node that contains the place, and the way there.
std::optional<simplify::LineEndMove> move_to(const graph::CandidateLayout& layout, int node, const Place& place) {
  const std::vector<HalfEdge> around = layout.subdivision.around(node);
  const ArcGraph& graph = layout.graph();
  for (const bool is_forwards : {true, false}) {
    const int arc = is_forwards ? around.front().arc : around.back().arc;
    const std::vector<ArcPiece>& pieces = graph.arcs[arc].pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].curve != place.curve || place.t < pieces[i].t0 || place.t >= pieces[i].t1) continue;
      if (i == 0 && place.t == pieces[i].t0) continue;
      const Nurbs& curve = graph.face.curves[place.curve];
      const curve::ChainPoint at{curve::point(curve, place.t), curve::tangent(curve, place.t), static_cast<int>(i),
                                 place.t};
      return simplify::line_end_move(layout.subdivision, arc, at, is_forwards);
    }
  }
  return std::nullopt;
}

namespace {

// Returns the deviation of the line that moved, radians.
double move_end(RegionLayouts& regions, const Station& station, Place place) {
  if (!station.is_movable || regions.place_of(station.region, station.node) == place) return 0;
  graph::CandidateLayout& layout = regions.layouts[station.region];
  place.curve -= regions.first_curves[station.region];
  const auto move = move_to(layout, station.node, place);
  if (!move) return 0;
  const field::FieldsOfRegions field = regions.field_of(station.region);
  return simplify::move_line_end(layout.subdivision, *move, &field);
}

}  // namespace

int meet_stations(RegionLayouts& regions, CutEnds cuts) {
  const CadFace& face = regions.face;
  std::vector<std::vector<LineKind>> kinds = kinds_of_lines(regions);
  int num_meetings = 0;
  for (const InterfaceChain& chain : interface_chains(regions, cuts))
    for (const Meeting& meeting : meetings_on(chain, relative_same * face.diameter)) {
      const std::array<const Station*, 2> stations{&chain.stations[0][meeting.stations[0]],
                                                   &chain.stations[1][meeting.stations[1]]};
      const auto fixed =
          std::find_if(stations.begin(), stations.end(), [](const Station* s) { return !s->is_movable; });
      const Place place = fixed != stations.end() ? regions.place_of((*fixed)->region, (*fixed)->node)
                                                  : place_on(face, chain, meeting.position);
      for (const int side : {0, 1}) {
        const double deviation = move_end(regions, *stations[side], place_on_side(face, chain, side, place));
        double& largest = regions.layouts[stations[side]->region].certificate.largest_deviation_degrees;
        largest = std::max(largest, degrees(deviation));
      }
      ++num_meetings;
    }
  renew_lines(regions, std::move(kinds), LineKind::merged);
  return num_meetings;
}

}  // namespace quadrille::couple
