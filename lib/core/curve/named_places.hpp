#pragma once
// Curves and positions on a face as options and files of users name them.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// Of a planar face. `coordinates`: x, y of the plane, with face.origin, or x, y, z of the CAD model's space. The
/// result is relative to face.origin, as all positions are. Throws FormatError, with a message that begins with
/// `where`, if a position in space lies more than a thousandth of the diameter off the plane.
Vec2 face_position(const CadFace& face, const std::vector<double>& coordinates, const std::string& where);

/// The distance of each curve from a position with the same coordinates; of a curved face in space, where it must have
/// three. Throws FormatError, with a message that begins with `where`.
std::vector<double> curve_distances(const CadFace& face, const std::vector<double>& coordinates,
                                    const std::string& where);

/// The position in space of three coordinates on a curved face. Throws FormatError, with a message that begins with
/// `where`, if there are two.
Vec3 space_position(const std::vector<double>& coordinates, const std::string& where);

/// The curves named `name`, or else those that it selects (select_curves; of them those on the boundary, if any), or
/// the curve of that number: of an interface the curves of both regions, with "NAME@REGION" those of this region alone.
/// Throws UsageError, which lists the names, the nearest one first, for none; `option` begins its message.
std::vector<int> named_curves(const CadFace& face, const std::string& name, const std::string& option);

/// The region that "NAME@REGION" picks; -1 if no region is named.
int named_region(const CadFace& face, const std::string& name);

}  // namespace quadrille::curve
