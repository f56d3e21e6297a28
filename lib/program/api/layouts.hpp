#pragma once
// Component `layouts`: irregular nodes, separatrices, blocks, quads, each from the one before.
//
// Positions are relative to face.origin. Errors are thrown (base/error.hpp): ComputeError if there is no result, with
// the reason and the place, UsageError for settings outside their intervals, FormatError for structs that break a rule
// of their format. Warnings, if wanted, are added to `warnings`. Faces may have several regions. Results are those of
// the tools, provenance included.

#include <functional>
#include <string>
#include <vector>

#include "layout/layout_choice.hpp"
#include "model/block_layout.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::api {

/// The irregular nodes and corner valences that critpoints chooses without options. If the result's form is `phase`,
/// the next step needs the field of these nodes (solve_field_of_nodes of component `fields`).
CriticalPoints find_nodes(const Field& field, std::vector<std::string>* warnings = nullptr);

struct TraceSettings {
  /// t_mesh and midpoint are for inspection and comparison; quantized, and automatic where it takes that, load CBC.
  layout::LayoutChoice layout = layout::LayoutChoice::automatic;
  double merge_distance = 0;  ///< length: also merge separatrices that pass within it
  double max_deviation = 40;  ///< degrees, 0 to 45: of a simplified line from the field
  /// Triangles for midpoint division, which `midpoint` needs and `automatic` takes where no separatrices make blocks:
  /// api::coarse_triangles of component `triangles`, or a mesher of the program's own: of a face, and of a function
  /// that names the triangles of a mesh that must be refined. Without it, there is no such division: ComputeError.
  std::function<TriMesh(const CadFace&, const std::function<std::vector<int>(const TriMesh&)>&)> coarse_mesher = {};
};

/// The graph of separatrices and boundary, with its certificate. `points` must be the nodes of `field`.
SeparatrixGraph trace_layout(const Field& field, const CriticalPoints& points, const TraceSettings& settings = {},
                             std::vector<std::string>* warnings = nullptr);

/// The blocks of a graph, as blocksplit makes them, named after the face.
BlockLayout make_blocks(const SeparatrixGraph& graph, std::vector<std::string>* warnings = nullptr);

struct QuadSettings {
  double size = 0;  ///< edge length; 0: diameter / 20
  int order = 4;    ///< shape order, 1 to 20
};

/// The quads of the blocks, as quadrefine makes them, each proved valid.
QuadMesh make_quads(const BlockLayout& layout, const QuadSettings& settings = {},
                    std::vector<std::string>* warnings = nullptr);

}  // namespace quadrille::api
