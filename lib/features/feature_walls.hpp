#pragma once
// Distances to the boundary of a face, curve by curve.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::features {

struct WallFoot {
  Vec2 position;
  double distance = 0;
  bool is_reflex = false;  ///< the boundary turns away from the domain there
};

class Walls {
 public:
  /// `face` must outlive the walls.
  explicit Walls(const CadFace& face);

  /// To the nearest point of the boundary.
  double distance_to(Vec2 x) const;
  /// The nearest point of each curve that is nearer than `reach`; one where several curves share it.
  std::vector<WallFoot> feet(Vec2 x, double reach) const;
  /// Whether the segment from a to b, both inside, stays inside.
  bool sees(Vec2 a, Vec2 b) const;

 private:
  struct Box {
    Vec2 low, high;
  };
  double bound(int curve, Vec2 x) const;

  const CadFace* face_;
  std::vector<Box> boxes_;  ///< of the poles, which hold the curve
};

}  // namespace quadrille::features
