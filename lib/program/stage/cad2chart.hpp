#pragma once
// The stage cad2chart: one face of a CAD file, planar or curved, in the plane of its isothermal chart.

#include <string>

#include "base/options.hpp"
#include "base/run.hpp"
#include "model/charted_face.hpp"
#include "model/space_face.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct Cad2chartOptions {
  std::string face;            ///< number or name of the face; empty: the only one
  double corner_angle = 1;     ///< degrees; greater tangent jumps are corners of the layout
  double heal_tolerance = -1;  ///< diameters; -1: 1e-5, or the tolerances of the shape if larger
  double closedness = 1e-6;    ///< radians; error of angles in the chart that is aimed at
  double scale_range = 1000;   ///< greatest ratio of two scales of the chart
};
void declare(Options& options, Cad2chartOptions& cad2chart);

/// Reads the face in a program with the CAD kernel (cad/load_face.hpp) and makes its chart (chart/make_chart.hpp).
/// `cad`: the bytes of a STEP, IGES or BREP file. Throws FormatError for a file or a face that cannot be read,
/// ComputeError for a face that has no chart in the limits of the options.
ChartedFace cad2chart(const Input<std::string>& cad, const Cad2chartOptions& options, Run& run);

/// The same of a face that was read from `cad`.
ChartedFace cad2chart(const SpaceFace& face, const Input<std::string>& cad, const Cad2chartOptions& options, Run& run);

}  // namespace quadrille::stage
