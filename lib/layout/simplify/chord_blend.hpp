#pragma once
// The line that replaces two lines side by side: it starts on the one and ends on the other,
//
//   M(f) = cos^2(pi f / 2) A(f) + sin^2(pi f / 2) B(f),   f the fraction of the length of either,
//
// as where separatrices are merged (trace/merge_candidates.hpp): the weights are flat at both ends, so M starts along A
// and ends along B.

#include <optional>

#include "curve/chain.hpp"
#include "curve/least_squares_spline.hpp"
#include "field/evaluate.hpp"
#include "graph/arc_pieces.hpp"

namespace quadrille::simplify {

/// M as a function of f * blend_length, with its derivative. The chains must outlive it.
curve::CurveFunction blended_curve(const curve::Chain& from, const curve::Chain& to);
double blend_length(const curve::Chain& from, const curve::Chain& to);

/// The largest angle between a blend and the direction of the field's cross that the two lines follow there, radians,
/// at equal steps inside it.
double deviation_of_blend(const field::FieldsOfRegions& fields, const curve::Chain& from, const curve::Chain& to);

struct BlendOptions {
  double max_deviation = 0.7;  ///< radians: of a blend from the cross of the field
  double fit_tol = 0;          ///< a length: greatest distance of splines from their blends
};

/// A blend as a spline, and the lines that it was made from, both in its direction.
struct Blend {
  graph::Pieces from, to;
  Nurbs spline;
  double deviation = 0;  ///< deviation_of_blend
};

/// std::nullopt if it would deviate too far.
std::optional<Blend> make_blend(const field::FieldsOfRegions& fields, const curve::CurveTable& table,
                                const graph::Pieces& from, const graph::Pieces& to, const BlendOptions& options);

/// The spline of the blend that starts at the start of the line `from` and ends at the end of `to`, or of the reverse
/// blend, reversed. The arcs between do not matter: a line may have been divided differently since.
std::optional<Nurbs> find_blend(const std::vector<Blend>& blends, const graph::Pieces& from, const graph::Pieces& to);

/// Where a spline crosses a chain: Newton's method from (s, fraction). Returns false if there is no crossing inside the
/// chain and the spline's domain.
bool cross_chain(const Nurbs& spline, const curve::Chain& chain, double& s, double& fraction);

/// A crossing of a blend with a rung.
struct RungCrossing {
  double s = 0;          ///< on the blend
  curve::ChainPoint at;  ///< on the rung
};

/// Where a blend crosses these rungs, which divide it into about equal parts; std::nullopt if it does not cross them in
/// order.
std::optional<std::vector<RungCrossing>> cross_rungs(const ArcGraph& graph, const std::vector<HalfEdge>& rungs,
                                                     const Nurbs& spline);

}  // namespace quadrille::simplify
