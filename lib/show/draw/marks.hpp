#pragma once
// What several pictures have in common: the boundary, corners, irregular nodes, curve pieces, outlines of elements.

#include <string>
#include <vector>

#include "base/message_text.hpp"
#include "draw/picture.hpp"
#include "model/separatrix_graph.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

/// Appends `curve` between two parameters; an empty path begins at its start.
void append_nurbs(PathData& path, const Picture& picture, const Nurbs& curve, double t0, double t1);

/// The pieces of a side of a block, in the direction of the side.
std::vector<ArcPiece> side_pieces(const BlockLayout& layout, HalfEdge side);

/// The number of the tint of each region (region_colour()): that of its name, because a face that embedded curves
/// divide has several regions of one name.
std::vector<int> region_tints(const CadFace& face);

/// The face as an area (below everything), each region in its tint, and its boundary (above the rest). Every curve has
/// its name as hover text.
void draw_face_area(Picture& picture, const CadFace& face);
/// The tints that regions have in the area of the face: an entry for each name.
void legend_regions(Picture& picture, const CadFace& face);
/// The data of a path around the face, for the fill rule evenodd.
std::string face_outline(const Picture& picture, const CadFace& face);
/// Curves in which two regions meet, or which are slits, have a style of their own.
void draw_boundary(Picture& picture, const CadFace& face);
/// A small dot on each corner; hover: position and angle.
void draw_corners(Picture& picture, const CadFace& face);
/// Its legend entry, where the face has corners.
void legend_corner(Picture& picture, const CadFace& face);

/// The text ", 2 regions"; empty for one.
std::string regions_text(const CadFace& face);

/// What the lines are in which two regions meet, if the face has such, and a scale bar in the unit of the face.
void legend_scale(Picture& picture, const CadFace& face);

/// A regular polygon of `valence` vertices (3 to 8, else a circle) in the colour of the valence.
std::string valence_mark(Vec2 centre, int valence, double radius, const std::string& title = {});
/// The same polygon, hollow and pale: a node that was removed or moved.
std::string valence_outline(Vec2 centre, int valence, double radius, const std::string& title = {});
/// A square standing on a vertex, in the colour of the field index 2 - valence: a node on the boundary.
std::string boundary_mark(Vec2 centre, int valence, double radius, const std::string& title = {});
/// A thin line with its head at `to`; at least 9 pixels long.
std::string arrow_mark(Vec2 from, Vec2 to);
/// The colour of an element in the legend.
std::string square_mark(const std::string& fill);
std::string circle_mark(const std::string& css_class, Vec2 centre, double radius, const std::string& title = {});

/// Legend entries for the valences that occur, each once, ascending.
void legend_valences(Picture& picture, std::vector<int> valences);

/// The one with the least scaled Jacobian, which pictures mark: only below 0.5, which is an angle of 30 degrees between
/// the coordinate lines. -1: none is below, or the qualities are unknown.
int worst_to_mark(const std::vector<double>& scaled_jacobians);

/// "(0.5, -0.25)" with the face's origin added.
std::string position_text(Vec2 x, Vec2 origin);

/// The closed outline of a triangle.
PathData tri_outline(const Picture& picture, const spectral::TriMap& map);

/// The side of a quad from corner `side` to the next, as position and derivative along s in [0, 1], in pixels.
PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side);

/// The closed outline of a quad.
PathData quad_outline(const Picture& picture, const QuadMesh& mesh, int elem);

}  // namespace quadrille::draw
