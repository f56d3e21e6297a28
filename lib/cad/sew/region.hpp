#pragma once
// Faces of the file as regions of the whole, and the places at which their curves start and end.

#include <string>
#include <vector>

#include "curve/face_boundary.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::sew {

/// Loops, curves and their order as in CadFace: the outline first, the region on the left of each curve.
struct Region {
  std::string name;  ///< empty if the file has none
  int cad_face = 0;  ///< number of the face in the file, for messages
  std::vector<heal::LoopCurve> curves;
  std::vector<int> other_sides;         ///< one per curve: the other side of a slit in this region, or -1
  std::vector<int> loop_offsets = {0};  ///< loop l has the curves [loop_offsets[l], loop_offsets[l+1])

  int num_curves() const { return static_cast<int>(curves.size()); }
  int num_loops() const { return static_cast<int>(loop_offsets.size()) - 1; }
  int next_in_loop(int curve) const;
  int previous_in_loop(int curve) const;
};

/// A curve of one of several regions.
struct CurveId {
  int region = -1, curve = -1;

  bool exists() const { return region >= 0; }
  friend bool operator==(const CurveId&, const CurveId&) = default;
};

/// One entry for each curve of each region.
template <class T>
using ByCurve = std::vector<std::vector<T>>;

/// An entry `value` for each curve.
template <class T>
ByCurve<T> by_curve(const std::vector<Region>& regions, const T& value) {
  ByCurve<T> result;
  for (const Region& region : regions) result.emplace_back(region.curves.size(), value);
  return result;
}

Region region_of(const std::vector<heal::Loop>& loops, const std::string& name, int cad_face);

/// Whether the curve is a whole loop, smooth where it closes: a circle. The place of its seam means nothing.
bool has_seam(const Region& region, int curve);

/// "face 2 'lid'".
std::string face_text(const Region& region);

/// The curves of the region, which must outlive the tree, by their numbers. Its winding number is 1 inside.
inline curve::CurveTree boundary_of(const Region& region) {
  return curve::CurveTree(region.curves, &heal::LoopCurve::curve);
}

/// Contains the region.
curve::PoleBox region_box(const Region& region);

/// The curves of each loop.
std::vector<std::vector<Nurbs>> loop_curves(const Region& region);

/// A set of regions with the places at which their curves start.
struct Placed {
  std::vector<Region> regions;
  ByCurve<int> places;          ///< of the start of each curve; -1: the seam of a smooth closed curve is no place
  std::vector<Vec2> positions;  ///< of the places: where the region with the lowest number has it
  double greatest = 0;          ///< greatest distance from a place to the joint or curve of a region there, a length
};

/// Joints of different regions within `tol` of each other, a length, are one place; the nearest to each other are
/// united first, and no two joints of one region. A place within `tol` of the nearest curve of a region that has no
/// joint there splits this curve (a T-joint), except within 2 tol of its ends; slits are not split. A smooth closed
/// curve that is split has no seam afterwards. Curves keep their ends: move them to the places (curve_to_places). Cost:
/// quadratic in the number of joints.
Placed split_at_places(const std::vector<Region>& regions, double tol);

/// The curve of a region from place to place, bit for bit.
Nurbs curve_to_places(const Placed& placed, CurveId id);

}  // namespace quadrille::sew
