#pragma once
// The layers that a user prescribes along one wall: --wall NAME:first=H,growth=R,layers=N. In place of the first height
// it may have a y+ (yplus=Y), from which set_first_heights computes that height.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "prescribe/flat_plate.hpp"

namespace quadrille::layers {

enum class LayerLaw { uniform, geometric, tanh, gll };

struct WallSpec {
  std::vector<std::string> names;  ///< of boundary curves; all curves of these names make one wall
  double first = 0;                ///< height of the layer at the wall, > 0, file units; 0: from `yplus`
  double yplus = 0;                ///< of the upper side of the first layer, > 0; 0: `first` is given
  double growth = 1.2;   ///< of one layer against the one below it, in 1..2; beyond the layers the greatest growth
  int layers = 0;        ///< 1..1000; 0: as many as reach `thickness`
  double thickness = 0;  ///< file units; used if layers == 0
  bool as_many_as_fit = false;  ///< layers=fit: the greatest number that fits into the first row of blocks
  LayerLaw law = LayerLaw::geometric;
  bool own_blocks = false;  ///< blocks=own: a curve of the face at a distance from the wall has the layers below it
};

/// From "NAME[,NAME...]:key=value,..." with the keys first, yplus, growth, layers (a number or "fit"), thickness, law,
/// blocks ("own" or "shared").
/// `yplus`: of walls that have neither first nor yplus; 0: they are mistakes. Throws UsageError with the text.
WallSpec parse_wall_spec(const std::string& text, double yplus = 0);

/// The first heights of the walls with a y+. `unit`: that of the flow's lengths, in units of the file.
void set_first_heights(std::vector<WallSpec>& specs, const prescribe::PlateFlow& flow, double unit);

/// The spec number of each curve of the face, -1 if it is no wall. Names as in sizing/boundary_sizes. Throws UsageError
/// for a name that no curve has, with the names that exist, and for a curve that is named twice.
std::vector<int> curve_walls(const std::vector<WallSpec>& specs, const CadFace& face);

}  // namespace quadrille::layers
