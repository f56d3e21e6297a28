#pragma once
// Distances from walls of a curved face: lengths in space of straight lines of its chart, as the layers along walls
// have them (lib/method.md §12). In the plane a length is itself.

#include <memory>
#include <vector>

#include "curve/symmetry_lines.hpp"
#include "mesh/chart_map.hpp"
#include "model/cad_face.hpp"

namespace quadrille::offset {

/// A point of a wall, with the unit normal into the face.
struct WallFoot {
  Vec2 position, normal;
};

class ChartHeights {
 public:
  /// `face` must outlive the object, if it has a chart.
  explicit ChartHeights(const CadFace& face);

  /// The same of the whole of which the face, or what was mirrored before, is one half.
  void add_mirror(const curve::SymmetryLine& line) { mirrors_.push_back(line); }

  bool is_planar() const { return !map_; }
  double in_space(const WallFoot& foot, double in_chart) const;
  double in_chart(const WallFoot& foot, double in_space) const;
  /// The derivative of `in_chart` by the arc length of the wall in the chart, if that of the height in space is
  /// `slope`. `curvature`: of the wall, 1 / length.
  double slope_in_chart(const WallFoot& foot, double curvature, double in_chart, double slope) const;

 private:
  /// e^lambda; sets the gradient of lambda.
  double scale(Vec2 x, Vec2& gradient) const;

  std::shared_ptr<const mesh::ChartMap> map_;  ///< none in the plane
  std::vector<curve::SymmetryLine> mirrors_;
};

}  // namespace quadrille::offset
