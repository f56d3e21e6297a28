#pragma once
// Part of a loop of the boundary, walked in the loop's direction and taken by the fraction in [0, 1] of its arc length.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::features {

/// From t0 to t1 > t0 on a curve of the face.
struct CurvePart {
  int curve = 0;
  double t0 = 0, t1 = 0;
};

/// A place on the boundary. Where two curves meet it is the beginning of the second.
struct BoundaryPlace {
  int curve = 0;
  double t = 0;
  Vec2 position;
};

struct StretchFoot {
  double fraction = 0;
  double distance = 0;
  Vec2 position;
};

class Stretch {
 public:
  /// Parts that follow each other; `face` must outlive the stretch. `is_closed`: a whole loop.
  Stretch(const CadFace& face, std::vector<CurvePart> parts, bool is_closed);

  double length() const { return ends_.back(); }
  bool is_closed() const { return is_closed_; }
  const std::vector<CurvePart>& parts() const { return parts_; }
  /// At a fraction of the length; beyond [0, 1] it is clamped, or wraps where closed.
  BoundaryPlace at(double fraction) const;
  /// The nearest point. Linear in the number of parts.
  StretchFoot foot(Vec2 x) const;

 private:
  const CadFace* face_;
  std::vector<CurvePart> parts_;
  bool is_closed_;
  std::vector<double> ends_;  ///< length up to the end of each part
};

}  // namespace quadrille::features
