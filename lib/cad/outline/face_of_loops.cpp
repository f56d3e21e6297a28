#include "outline/face_of_loops.hpp"

#include <cmath>
#include <string>

#include "base/angle.hpp"
#include "base/assign_names.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "heal/interior_angle.hpp"
#include "outline/extent.hpp"

namespace quadrille::outline {
namespace {

using heal::Loop;
using heal::LoopCurve;

// (0, 0), unless the face is so far from it that coordinates lose significant digits; then the centre of the face,
// rounded to a few digits.
Vec2 chosen_origin(const curve::PoleBox& box, double diameter) {
  const Vec2 centre = box.centre();
  if (norm(centre) <= 10 * diameter) return {0, 0};
  const double unit = std::pow(10, std::floor(std::log10(diameter)));
  return {unit * std::round(centre.x / unit), unit * std::round(centre.y / unit)};
}

std::vector<std::string> names_of(const std::vector<Loop>& loops) {
  std::vector<std::string> names;
  for (const Loop& loop : loops)
    for (const LoopCurve& c : loop) names.push_back(c.name);
  return names;
}

}  // namespace

Joint joint_between(const Nurbs& in, const Nurbs& out, double corner_angle) {
  const Vec2 a = curve::tangent(in, in.end(), true), b = curve::tangent(out, out.begin());
  Joint joint{out.poles.front(), wrap_pi(angle_of(a)), wrap_pi(angle_of(b)), heal::interior_angle(in, out), false};
  // The factor ensures that angles equal to the limit up to rounding are treated alike at all corners of a symmetric
  // face.
  joint.is_corner = std::abs(pi - joint.interior_angle) > corner_angle * (1 + 1e-6);
  return joint;
}

CadFace face_of_loops(const heal::RawFace& raw, const std::vector<Loop>& loops, const std::vector<Nurbs>& outline,
                      double corner_angle) {
  CadFace face;
  face.length_unit = raw.length_unit;
  face.metres_per_unit = raw.metres_per_unit;
  face.plane_origin = raw.plane_origin;
  face.plane_x = raw.plane_x;
  face.plane_y = raw.plane_y;
  face.diameter = diameter(outline);
  face.origin = chosen_origin(curve::pole_box(outline), face.diameter);
  face.loop_offsets = {0};
  for (const Loop& loop : loops) {
    for (const LoopCurve& c : loop) {
      face.curves.push_back(c.curve);
      face.curve_cad_edges.push_back(c.cad_edge);
      for (Vec2& pole : face.curves.back().poles) pole -= face.origin;
    }
    face.loop_offsets.push_back(face.num_curves());
  }
  face.curve_names = names_of(loops);
  face.unnamed_curves = replace_empty_names(face.curve_names, "curve");
  for (int i = 0; i < face.num_curves(); ++i)
    face.joints.push_back(joint_between(face.curves[face.previous_in_loop(i)], face.curves[i], corner_angle));
  return face;
}

}  // namespace quadrille::outline
