#pragma once
// A face of the file as a region of the whole, its boundary curves in one list.

#include <string>
#include <vector>

#include "curve/face_boundary.hpp"
#include "heal/loop.hpp"

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

}  // namespace quadrille::sew
