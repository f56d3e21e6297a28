#pragma once
// Points of the boundaries of the regions of a face, and which of them are one point of the plane.
//
// A curve that two regions share is there twice (model/cad_face.hpp), so a point of it is two places, one on each
// curve; a junction of three regions is three joints. Each place is one sector about the point: the region that it
// bounds there.

#include <compare>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::couple {

/// A point of a curve, not its end: that is the start of the next curve in the loop.
struct Place {
  int curve = 0;
  double t = 0;

  auto operator<=>(const Place&) const = default;
  bool is_joint(const CadFace& face) const { return t == face.curves[curve].begin(); }
};

/// The place of a parameter, which may be that of the curve's end.
Place place_at(const CadFace& face, int curve, double t);

/// The place on a loop of a position on it.
Place place_on_loop(const CadFace& face, int loop, Vec2 position);

/// The parameter of the same point on the partner of `curve`.
double partner_parameter(const CadFace& face, int curve, double t);

/// All places of the point, counter-clockwise about it. If the point is inside the whole, from the lowest place on;
/// if it is on the boundary of the whole, from the one whose outgoing curve is of that boundary on.
std::vector<Place> places_of_point(const CadFace& face, const Place& place);

/// Whether regions surround the point.
bool is_inside_whole(const CadFace& face, const Place& place);

}  // namespace quadrille::couple
