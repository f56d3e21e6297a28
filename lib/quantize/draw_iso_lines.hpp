#pragma once
// The iso-lines of a face as splines: images of straight lines of the unit square under the face's transfinite map
// (mesh/transfinite.hpp), so that lines of one direction never cross.

#include "curve/chain.hpp"
#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {

/// Appends the lines of a face to `graph`, with a node where two of them cross, a spline and arcs for each, and lines
/// of kind LineKind::extended. `table`: of the T-mesh's curves.
void draw_iso_lines(const ArcGraph& t_mesh, const QuantizedParametrization& parametrization, const SplitArcs& split,
                    const curve::CurveTable& table, int face, SeparatrixGraph& graph);

}  // namespace quadrille::quantize
