#include "prescribe/named_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/named_places.hpp"
#include "surface/positions.hpp"

namespace quadrille::prescribe {
namespace {

[[noreturn]] void refuse_partial(const sizing::MeasuredLayout& measured, int arc, const std::string& name,
                                 const std::string& option) {
  const CadFace& face = measured.blocks().face;
  throw UsageError(fmt::format(
      "{}: the side of a block through {} follows the boundary '{}' in part only: use the "
      "number of its chord, {}, in --count",
      option, surface::position_text(face, measured.chain(arc).position(0.5)), name, measured.chord_of(arc)));
}

}  // namespace

std::vector<HalfEdge> named_arcs(const sizing::MeasuredLayout& measured, const std::string& name,
                                 const std::string& option) {
  const CadFace& face = measured.blocks().face;
  std::vector<bool> is_named(face.curves.size(), false);
  const int region = curve::named_region(face, name);
  for (const int curve : curve::named_curves(face, name, option)) {
    is_named[curve] = true;
    if (face.is_interface(curve)) is_named[face.partners[curve]] = true;
  }
  std::vector<std::tuple<int, double, HalfEdge>> placed;  // curve and parameter at which the arc begins
  for (int a = 0; a < measured.num_arcs(); ++a) {
    const GraphArc& arc = measured.blocks().arcs[a];
    if (!measured.is_on_cad_curve(a)) continue;
    if (region >= 0 && measured.region_of(a) >= 0 && measured.region_of(a) != region) continue;
    const auto follows = [&](const ArcPiece& piece) { return is_named[piece.curve]; };
    const auto num_named = std::count_if(arc.pieces.begin(), arc.pieces.end(), follows);
    if (num_named == 0) continue;
    if (num_named < std::ssize(arc.pieces)) refuse_partial(measured, a, name, option);
    const bool is_backwards = arc.pieces.front().t0 > arc.pieces.front().t1;
    const ArcPiece& first = is_backwards ? arc.pieces.back() : arc.pieces.front();
    placed.emplace_back(first.curve, std::min(first.t0, first.t1), HalfEdge{a, is_backwards});
  }
  std::ranges::stable_sort(placed, {}, [](const auto& p) { return std::pair(std::get<0>(p), std::get<1>(p)); });
  std::vector<HalfEdge> arcs;
  for (const auto& [curve, t, arc] : placed) arcs.push_back(arc);
  return arcs;
}

}  // namespace quadrille::prescribe
