#include "prescribe/named_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/named_curves.hpp"
#include "model/interfaces.hpp"

namespace quadrille::prescribe {
namespace {

/// An arc and where it begins.
struct PlacedArc {
  int curve = 0;
  double t = 0;
  HalfEdge arc;
};

[[noreturn]] void refuse_partial(const sizing::MeasuredLayout& measured, int arc, const std::string& name,
                                 const std::string& option) {
  const Vec2 position = measured.chain(arc).position(0.5) + measured.blocks().face.origin;
  throw UsageError(
      fmt::format("{}: the side of a block through {} follows the boundary '{}' in part only: use the "
                  "number of its chord, {}, in --count",
                  option, position_text(position), name, measured.chord_of(arc)));
}

}  // namespace

std::vector<HalfEdge> named_arcs(const sizing::MeasuredLayout& measured, const std::string& name,
                                 const std::string& option) {
  const CadFace& face = measured.blocks().face;
  std::vector<bool> is_named(face.curves.size(), false);
  for (const int curve : curve::named_curves(face, name, option)) {
    is_named[curve] = true;
    if (face.is_interface(curve)) is_named[face.partners[curve]] = true;
  }
  std::vector<PlacedArc> placed;
  for (int a = 0; a < measured.num_arcs(); ++a) {
    const GraphArc& arc = measured.blocks().arcs[a];
    if (!is_on_cad_curve(measured.blocks(), arc)) continue;
    const auto follows = [&](const ArcPiece& piece) { return is_named[piece.curve]; };
    const auto num_named = std::count_if(arc.pieces.begin(), arc.pieces.end(), follows);
    if (num_named == 0) continue;
    if (num_named < std::ssize(arc.pieces)) refuse_partial(measured, a, name, option);
    const bool is_backwards = arc.pieces.front().t0 > arc.pieces.front().t1;
    const ArcPiece& first = is_backwards ? arc.pieces.back() : arc.pieces.front();
    placed.push_back({first.curve, std::min(first.t0, first.t1), {a, is_backwards}});
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedArc& a, const PlacedArc& b) {
    return std::tie(a.curve, a.t) < std::tie(b.curve, b.t);
  });
  std::vector<HalfEdge> arcs;
  for (const PlacedArc& one : placed) arcs.push_back(one.arc);
  return arcs;
}

}  // namespace quadrille::prescribe
