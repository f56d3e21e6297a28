#pragma once
// The layers that a user prescribes along one wall: --wall NAME:first=H,growth=R,layers=N. In place of the first height
// it may have a y+ (yplus=Y), from which set_first_heights computes that height, as on a flat plate with a turbulent
// boundary layer:
//
//   y = y+ nu / u_tau,  u_tau = U sqrt(c_f / 2),  c_f = (2 log10 Re_x - 0.65)^-2.3,  Re_x = U x / nu.
//
// c_f is the local skin friction of a smooth plate at the length x: H. Schlichting, Boundary-Layer Theory, 7th ed.,
// 1979, ch. XXI. It holds for Re_x between 5e5 and 1e9; where the layer is laminar, friction is less and y too small.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"

namespace quadrille::layers {

enum class LayerLaw { uniform, geometric, tanh, gll };
constexpr auto enum_names(LayerLaw) { return std::to_array({"uniform", "geometric", "tanh", "gll"}); }

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

/// Layers of a boundary that the option itself names: "first=H,growth=R,layers=N", or thickness and law, without names.
/// Throws UsageError.
WallSpec parse_layer_spec(const std::string& option, const std::string& text);

/// The spec number of each curve of the face, -1 if it is no wall. Throws UsageError
/// for a name that no curve has, with the names that exist, and for a curve that is named twice.
std::vector<int> curve_walls(const std::vector<WallSpec>& specs, const CadFace& face);

/// All in units that fit together: lengths in one unit, viscosity in length^2 / time. 0: not given.
struct PlateFlow {
  double velocity = 0;   ///< U of the free stream
  double viscosity = 0;  ///< nu, kinematic
  double length = 0;     ///< x, from the leading edge to where y+ applies

  double reynolds_number() const { return velocity * length / viscosity; }
  double skin_friction() const;
  /// In the unit of `length`.
  double height(double yplus) const;
  /// Throws UsageError, which names the missing options, unless all are given if `is_used`, and none if not; and if the
  /// Reynolds number is below 1000, for which the formula means nothing.
  void validate(bool is_used) const;
};

/// Sets flow.* and issues a warning outside the interval of the formula.
void report_flow(const PlateFlow& flow, Report& report);

/// The first heights of the walls with a y+. `unit`: that of the flow's lengths, in units of the file.
void set_first_heights(std::vector<WallSpec>& specs, const PlateFlow& flow, double unit);

/// Distances of the layers' upper ends from the wall, ascending; the first is spec.first under every law.
///   uniform    equal layers
///   geometric  each layer is `growth` times the one below
///   tanh       the geometric law's count and thickness, with heights T (1 - tanh(d (1 - k / m)) / tanh(d)): growing
///              fastest at the wall and not at all at the top
///   gll        the lower half of the 2 m + 1 Gauss-Lobatto-Legendre points, scaled to the first height
std::vector<double> layer_heights(const WallSpec& spec, int layers);

/// The greatest growth beyond the layers of a wall.
double growth_beyond(const WallSpec& spec);

/// The height of one more layer: as much greater than the last one as that than the one below it.
double next_layer(const std::vector<double>& heights);

/// The heights of as many layers if they and `above` intervals, which where there is room are one more layer, must fit
/// below `room`: the first layer keeps its height, and all others grow less; with room for less than one more interval
/// of the first height all layers are equal.
std::vector<double> compressed_heights(const std::vector<double>& heights, double room, int above = 1);

/// The number of layers: spec.layers, or the least number that reaches spec.thickness. Throws UsageError if that would
/// be more than LayerConstants::max_layers.
int requested_layers(const WallSpec& spec);

/// The least height of blocks with all layers: their thickness and one more interval, which is as much longer than the
/// last layer as that than the one below it. This is the distance of the curve above layers in blocks of their own.
/// Throws UsageError unless first and the number of layers are known.
double block_height(const WallSpec& spec);

/// The distance from the wall at which irregular nodes leave room for all layers and for edges that grow above: more
/// than the height of the blocks, whose far sides lie nearer to a round wall than the nodes between which they run
/// (LayerConstants::node_distance). Throws as block_height.
double node_clearance(const WallSpec& spec);

}  // namespace quadrille::layers
