#pragma once
// Several regions of one plane that share curves: a fluid and a solid, a coating, the cells of a pattern.
//
// Up to the irregular nodes every region is a face of its own, with triangles, field and nodes of its own: the field is
// aligned with both sides of an interface, so that the regions do not know each other. `pairs` names the curves that
// are the same. All parts have the same plane, unit and origin.

#include <array>
#include <compare>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"

namespace quadrille {

/// A curve of one of several regions.
struct RegionCurve {
  int region = 0;  ///< index into Regions::parts
  int curve = 0;   ///< index into the curves of its face

  constexpr auto operator<=>(const RegionCurve&) const = default;
};

enum class PairKind {
  interface,  ///< both curves are in the same place
  periodic    ///< a motion maps the one onto the other
};
constexpr auto enum_names(PairKind) {
  return std::to_array<EnumName<PairKind>>({{PairKind::interface, "interface"}, {PairKind::periodic, "periodic"}});
}

/// Two curves that are the same, in opposite directions: poles and weights of the second are those of the first in the
/// opposite order, bit for bit, and its knots are mirrored. For `periodic`, after the motion.
struct CurvePair {
  std::array<RegionCurve, 2> curves;  ///< both of one region: an embedded curve, or two sides of the region
  PairKind kind = PairKind::interface;
  std::string name;  ///< of the interface
  double angle = 0;  ///< periodic: x -> R(angle) x + shift maps the first curve onto the second; radians
  Vec2 shift;        ///< a length; x with the face's origin added
};

/// One struct of a stage (TriMesh, Field, CriticalPoints) for each region.
template <typename T>
struct Regions {
  std::vector<T> parts;
  std::vector<CurvePair> pairs;

  int num_regions() const { return static_cast<int>(parts.size()); }
};

}  // namespace quadrille
