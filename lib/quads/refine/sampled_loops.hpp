#pragma once
// The loops of a face by arc length, sampled: cubic between samples, for what needs many points that are nearly exact.

#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {

struct LoopPoint {
  Vec2 position, tangent;  ///< tangent of length 1 up to the error of the interpolation
  Vec2 bend;               ///< derivative of the tangent by length, about
};

class SampledLoops {
 public:
  /// As fine as eight samples for each edge of the mesh on a curve: of a circle, of which an edge spans 20 degrees, the
  /// error is 1e-8 radii.
  explicit SampledLoops(const QuadMesh& mesh);

  /// The point at a length along a loop from the start of its first curve; any number of turns.
  LoopPoint at(int loop, double length) const;
  /// Of a loop.
  double length(int loop) const { return loops_[loop].length; }

 private:
  struct Curve {
    double start = 0, step = 0;  ///< lengths: of its start along the loop, between samples
    std::vector<LoopPoint> samples;
  };
  struct Loop {
    double length = 0;
    std::vector<Curve> curves;
  };
  std::vector<Loop> loops_;
};

}  // namespace quadrille::refine
