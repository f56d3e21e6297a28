#pragma once
// The quad mesh of a curved face as it is seen in space: parallel projection, far elements first, shaded by normals.

#include <array>
#include <string>

#include "base/vec3.hpp"
#include "draw/draw.hpp"

namespace quadrille::draw {

/// The axes of a picture: right and up in it, and towards the viewer.
struct SpaceView {
  Vec3 right, up, towards;

  Vec2 at(Vec3 x) const { return {dot(x, right), dot(x, up)}; }
  double depth(Vec3 x) const { return dot(x, towards); }  ///< greater: nearer
};

/// The direction from which hexahedra are seen without --view.
inline constexpr Vec3 hex_view{1, -1, 1};

/// Seen from the direction of `view`, z up if it can be; without one along a diagonal of the axes, on the side of the
/// mesh's mean normal. The mesh must have nodes in space.
SpaceView space_view(const QuadMesh& mesh, const ViewDirection& view);

/// The picture of the surface alone. Lengths of the window are those of the picture. `what`: the title, and what the
/// caption says before the direction.
struct SpaceTitle {
  std::string title, caption;
};
SpaceTitle quad_title(const QuadMesh& mesh);  ///< of the mesh of a curved face
std::string draw_in_space(const QuadMesh& mesh, const SpaceView& view, const DrawOptions& options,
                          const SpaceTitle& what);

/// Two pictures beside each other, each half as wide as `width`.
std::string side_by_side(const std::array<std::string, 2>& pictures, const std::string& title, int width);

}  // namespace quadrille::draw
