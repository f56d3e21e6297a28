#pragma once
// A piece of an arc of a block layout on a curved face: the same curve in space and in the parameters of the surface.
// No OpenCASCADE types.

#include <array>

#include "mesh/chart_map.hpp"
#include "model/block_layout.hpp"

namespace quadrille::occ {

/// A direction of the parameters of a surface, or both.
enum class Parameter { none, u, v };
inline constexpr std::array both{Parameter::u, Parameter::v};

/// One of the two numbers.
constexpr double& part(Vec2& uv, Parameter p) { return p == Parameter::u ? uv.x : uv.y; }
constexpr double part(const Vec2& uv, Parameter p) { return p == Parameter::u ? uv.x : uv.y; }

/// The length of the interval of a parameter in which the surface closes; 0: it does not.
double period(const NurbsSurface& surface, Parameter p);

/// The parameter that the point does not determine, because one of its lines shrinks to a pole there.
Parameter undetermined(const NurbsSurface& surface, Vec2 uv, double diameter);

/// A point of the layout on the surface.
struct SurfaceNode {
  Vec3 position;  ///< on the boundary: on the curve in space
  Vec2 uv;        ///< of the nearest point of the surface
  Parameter free = Parameter::none;
};

struct SurfacePiece {
  SpaceCurve space;     ///< from the start of the piece to its end
  Nurbs uv;             ///< the same parameters; runs on beyond the interval of a parameter in which it closes
  double distance = 0;  ///< greatest, between the two, a length
  SurfaceNode start, end;
};

/// Pieces of the arcs of one layout, whose face has a chart with one surface. Throws ComputeError for more.
class SurfacePieces {
 public:
  explicit SurfacePieces(const BlockLayout& layout);

  /// The graph node n, and the point at t of a curve.
  SurfaceNode node(int n) const;
  SurfaceNode node(int curve, double t) const;
  /// Curves of the boundary are exact; others, and parameters, are splines within 1e-8 and 1e-6 diameters.
  SurfacePiece piece(const ArcPiece& piece, const SurfaceNode& start, const SurfaceNode& end) const;
  /// Whether triangles that are counter-clockwise in the chart are so in the parameters too: seen against X_u x X_v.
  bool keeps_orientation() const;

  const NurbsSurface& surface() const { return layout_.face.chart->surfaces.front(); }

 private:
  const BlockLayout& layout_;
  mesh::ChartMap map_;
};

}  // namespace quadrille::occ
