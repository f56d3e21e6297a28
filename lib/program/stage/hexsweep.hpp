#pragma once
// The stage hexsweep: the hexahedra that a quad mesh sweeps.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

/// The options as a user gives them. Lengths in the unit of the file, angles in degrees.
struct HexsweepOptions {
  double height = 0;       ///< along the normal; 0: without another motion, layers as high as the quads are long
  std::string along;       ///< X,Y,Z
  std::string curve_file;  ///< path of points, which the caller reads
  double revolve = 0;      ///< about `axis`; 0: not given
  std::string axis;        ///< X1,Y1,X2,Y2 in the plane of the face, or six numbers in space
  double twist = 0;
  double taper = 1;          ///< > 0
  std::string centre;        ///< X,Y of twist and taper; empty: the middle of the face's box
  std::string terrain_file;  ///< path of heights, which the caller reads
  int layers = 0;            ///< 0: as high as the quads are long
  double layer_growth = 1;
  std::string bottom_layers, top_layers;  ///< first=H,growth=R,layers=N
  bool is_one_layer = false;
  bool has_periodic_ends = false;
  std::string bottom_name = "bottom", top_name = "top";
  bool allow_invalid = false;

  /// What can be refused without a mesh. Throws UsageError.
  void validate() const;
};
void declare(Options& options, HexsweepOptions& hexsweep);

using PointList = std::vector<Vec3>;

struct HexsweepInput {
  Input<QuadMesh> quads;
  std::optional<Input<PointList>> curve = {};    ///< points of --curve
  std::optional<Input<PointList>> terrain = {};  ///< x, y in the plane of the face, and the height
};

/// The proved mesh. Throws FormatError if the quads break a rule of their format, UsageError for options outside their
/// intervals, that exclude each other or do not fit the face, ComputeError if an element cannot be proved valid.
HexMesh hexsweep(const HexsweepInput& input, const HexsweepOptions& options, Run& run);

}  // namespace quadrille::stage
