#pragma once
// From checked loops of curves to the boundary of model/cad_face.hpp.

#include <vector>

#include "heal/loop.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::outline {

/// The joint at which `in` ends and `out` starts; `corner_angle`, radians: a greater tangent jump is a corner.
Joint joint_between(const Nurbs& in, const Nurbs& out, double corner_angle);

/// The face with these loops in the plane and the unit of `raw`: origin, diameter, joints, names. Curves without a name
/// are numbered. `outline`: the curves that go around the face, in the coordinates of `loops`; `corner_angle`: radians.
/// Not set: the face's own name, its fit distance, regions.
CadFace face_of_loops(const heal::RawFace& raw, const std::vector<heal::Loop>& loops, const std::vector<Nurbs>& outline,
                      double corner_angle);

}  // namespace quadrille::outline
