#pragma once
// Changes the unit, or the size, of what a stage file has: all positions and lengths are multiplied by one factor.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "model/arc_graph.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille {

struct LengthUnit {
  std::string_view symbol;  ///< for --unit
  std::string_view name;    ///< as in CadFace::length_unit
  double metres;
};

inline constexpr std::array<LengthUnit, 8> length_units{{{"m", "metre", 1},
                                                         {"cm", "centimetre", 1e-2},
                                                         {"mm", "millimetre", 1e-3},
                                                         {"um", "micrometre", 1e-6},
                                                         {"nm", "nanometre", 1e-9},
                                                         {"km", "kilometre", 1e3},
                                                         {"in", "inch", 0.0254},
                                                         {"ft", "foot", 0.3048}}};

/// The symbol of a unit of length: "mm" for "millimetre", "" for "unknown". A name without a symbol is returned as it
/// is.
inline std::string unit_symbol(const CadFace& face) {
  for (const LengthUnit& known : length_units)
    if (known.name == face.length_unit) return std::string(known.symbol);
  return face.length_unit == "unknown" ? "" : face.length_unit;
}

/// What a user asks of written coordinates.
struct ScaleRequest {
  std::string unit = "file";      ///< symbol of a length unit; "file": that of the CAD file
  std::optional<double> scale{};  ///< > 0; a further factor
  /// A scale without a unit enlarges the shape; else its numbers have no known unit, also those times 1.
  bool keeps_unit = false;
};

/// Coordinates are multiplied by `factor`, which gives numbers in `unit`.
struct LengthScale {
  double factor = 1;
  std::string unit = "unknown";  ///< "metre", ...
  double metres_per_unit = 0;    ///< 0: unknown
};

/// The factor for lengths in the unit `own`, rounded to 15 digits, so that an inch is 25.4 mm. Throws UsageError if a
/// unit is requested where `own` is unknown.
inline LengthScale length_scale(const std::string& own, double metres_per_unit, const ScaleRequest& request) {
  const double scale = request.scale.value_or(1);
  LengthScale result{scale, own, metres_per_unit};
  for (const LengthUnit& unit : length_units) {
    if (unit.symbol != request.unit) continue;
    if (!(metres_per_unit > 0))
      throw UsageError("--unit " + request.unit +
                       ": the CAD file states no length unit: give the factor by --scale instead");
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), "%.15g", scale * metres_per_unit / unit.metres);
    return {std::strtod(digits.data(), nullptr), std::string(unit.name), unit.metres};
  }
  if (request.scale && !request.keeps_unit) result.unit = "unknown", result.metres_per_unit = 0;
  return result;
}

inline LengthScale length_scale(const CadFace& face, const ScaleRequest& request) {
  return length_scale(face.length_unit, face.metres_per_unit, request);
}

/// A hexahedral mesh has the name of its unit only.
inline LengthScale length_scale(const HexMesh& mesh, const ScaleRequest& request) {
  const auto known = std::find_if(length_units.begin(), length_units.end(),
                                  [&](const LengthUnit& unit) { return unit.name == mesh.length_unit; });
  return length_scale(mesh.length_unit, known == length_units.end() ? 0 : known->metres, request);
}

inline void scale_lengths(Chart& chart, double factor) {
  for (Vec2& node : chart.nodes) node = factor * node;
  for (Vec3& node : chart.space_nodes) node = factor * node;
  for (NurbsSurface& surface : chart.surfaces)
    for (Vec3& pole : surface.poles) pole = factor * pole;
  for (SpaceCurve& curve : chart.space_curves)
    for (Vec3& pole : curve.poles) pole = factor * pole;
}

inline void scale_lengths(CadFace& face, const LengthScale& scale) {
  const double factor = scale.factor;
  face.length_unit = scale.unit;
  face.metres_per_unit = scale.metres_per_unit;
  for (double& x : face.plane_origin) x *= factor;
  face.origin = factor * face.origin;
  face.fit_distance *= factor;
  face.diameter *= factor;
  for (Nurbs& curve : face.curves)
    for (Vec2& pole : curve.poles) pole = factor * pole;
  for (Joint& joint : face.joints) joint.position = factor * joint.position;
  for (PeriodicPair& pair : face.periodic_pairs) pair.shift = factor * pair.shift;
  if (!face.chart) return;
  Chart chart = *face.chart;
  scale_lengths(chart, factor);
  face.chart = std::make_shared<const Chart>(std::move(chart));
}

inline void scale_lengths(ArcGraph& graph, const LengthScale& scale) {
  scale_lengths(graph.face, scale);
  for (Nurbs& curve : graph.splines)
    for (Vec2& pole : curve.poles) pole = scale.factor * pole;
  for (GraphNode& node : graph.nodes) node.position = scale.factor * node.position;
}

/// Areas and Jacobians get the square of the factor.
inline void scale_lengths(QuadMesh& mesh, const LengthScale& scale) {
  const double factor = scale.factor;
  scale_lengths(mesh.face, scale);
  for (Vec2& node : mesh.nodes) node = factor * node;
  for (Vec3& node : mesh.space_nodes) node = factor * node;
  for (double& bound : mesh.elem_jacobian_bound) bound *= factor * factor;
  mesh.least_jacobian_bound *= factor * factor;
  for (auto* lengths : {&mesh.elem_node_distance, &mesh.elem_prescribed_length})
    for (double& length : *lengths) length *= factor;
}

/// Jacobians get the cube of the factor.
inline void scale_lengths(HexMesh& mesh, const LengthScale& scale) {
  const double factor = scale.factor, cube = factor * factor * factor;
  mesh.length_unit = scale.unit;
  mesh.diameter *= factor;
  for (Vec3& node : mesh.nodes) node = factor * node;
  for (HexFaceGroup& group : mesh.face_groups) group.motion.shift = factor * group.motion.shift;
  for (double& bound : mesh.elem_jacobian_bound) bound *= cube;
  mesh.least_jacobian_bound *= cube;
}

}  // namespace quadrille
