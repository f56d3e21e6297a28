#pragma once
// Places and lengths in space of a curved face, for prescribed sizes: these are lengths in space, e^lambda times those
// in the chart, and grow with distances in space.

#include <memory>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "mesh/chart_map.hpp"
#include "model/cad_face.hpp"

namespace quadrille::sizing {

class ChartScale {
 public:
  explicit ChartScale(const CadFace& face);

  struct Place {
    Vec3 position;     ///< in space, to the accuracy of the chart
    double scale = 1;  ///< length in space over length in the chart
  };
  Place at(Vec2 x) const;
  Vec2 gradient(Vec2 x) const;  ///< of lambda, by the position in the chart
  double least() const { return least_; }
  double greatest_gradient() const { return gradient_; }  ///< of lambda, 1 over a length in space

 private:
  CadFace face_;  ///< the chart and its boundary, for the map
  mesh::ChartMap map_;
  double least_ = 1, gradient_ = 0;
};

/// The length of a boundary curve, of a curved face in space.
double boundary_length(const CadFace& face, int curve);

/// The greatest distance of two points of the face, of a curved face in space.
double diameter_in_space(const CadFace& face);

/// Null for planar faces.
std::shared_ptr<const ChartScale> chart_scale(const CadFace& face);

}  // namespace quadrille::sizing
