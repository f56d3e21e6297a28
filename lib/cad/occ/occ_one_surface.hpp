#pragma once
// Whether faces of a model lie on one surface, whatever entity of the file each of them has for it.

#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include "base/vec3.hpp"

namespace quadrille::occ {

/// How far a face lies off the surface of another one, a length, and where.
struct SurfaceGap {
  double distance = 0;
  Vec3 position;
};

/// The distance of a point from the surface, without its trims.
double distance_from(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p);

/// By samples on the edges of the face and inside.
SurfaceGap gap_from_surface(const TopoDS_Face& face, const TopoDS_Face& of_surface);

/// Whether the normals of the two surfaces, which are one, are opposite.
bool has_opposite_normal(const TopoDS_Face& face, const TopoDS_Face& of_surface);

/// The diagonal of the box around samples on the edges, a length. The kernel's own boxes are those of infinite surfaces
/// as long as faces lack parameter curves.
double extent_of_edges(const TopoDS_Face& face);

/// The distance within which two surfaces are one, a length: the tolerance of the file, or 1e-7 of the face's size.
double same_surface_tolerance(const TopoDS_Face& face, double file_tolerance);

}  // namespace quadrille::occ
