#pragma once
// Makes the size field from options: one size for all elements, sizes near boundaries, by their curvature, from a file.
//
// A constant size along a boundary acts from the exact circular arc. Other curves are cut into segments so short that
// neither their distance from the curve nor linear interpolation between their ends changes the size by a relative
// amount above 1e-5: sizes of mirror images agree although the starts of their curves differ.
//
// A run is a part of the boundary between two consecutive corners or ends of given names. Along a run of length L the
// size is L / n; along a smooth closed loop, a hole, it is L / (3 n), because it has no ends at which elements begin.
// In one half of a symmetric whole the diameter and the runs are those of the whole.
// Runs shorter than a thousandth of the diameter per element count as so long: one tiny edge shall not make the mesh of
// the whole face fine.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/size_sources.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// `size` along one curve. `slope` > 0: growth of sizes per distance from it.
std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope);

/// A size in proportion to the distance from one end of a chain of curves: `size` there, `other_size` at the other end.
struct GrowingSize {
  Vec2 end, other_end;
  double size = 0, other_size = 0;
};
/// The ends of the curves: their joint of least x (then y), and the one of greatest x (then y); equal within 1e-6
/// diameters.
GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size);
std::vector<SizeSegment> segments_near(const Nurbs& curve, const GrowingSize& size, double slope);

/// 2 pi / (elements_per_turn |curvature|) along one curve, between `least` and `greatest`; segments all at `greatest`
/// are omitted. Corners prescribe no size.
std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope);

/// sqrt(8 sag / |curvature|) along one curve, between `sag` and `greatest`, in the same way: the size of which the
/// straight edge is this distance away from the curve.
std::vector<SizeSegment> segments_by_sag(const Nurbs& curve, double sag, double greatest, double slope);

/// The least size along a curve, in diameters.
inline constexpr double least_curve_size = 1e-3;

/// The sources of sizes below `greatest`, none below `least`. `per_curve`: n > 0; `slope` > 0: growth of sizes per
/// distance.
std::vector<SizeSegment> segments_by_curves(const CadFace& face, int per_curve, double least, double greatest,
                                            double slope);

/// Edges of length `size` along a named boundary; with "NAME@REGION" in this region alone. `other_size` > 0: that of
/// the boundary's right end (of greatest x, then y); `size` is then that of its left end.
struct NearSize {
  std::string boundary;
  double size = 0;
  double other_size = 0;
};

/// Straight edges along a curve are at most this distance away from it.
struct SagLimit {
  Nurbs curve;
  double sag = 0;
};

struct SizeOptions {
  double size = 0;  ///< if no source prescribes less; 0: diameter / 20, or the greatest size of a table
  /// The least number of elements along each boundary curve (sizing/make_size_field); 0: none; automatic: 0, unless
  /// with_curve_sizes (sizing/curve_sizes) has determined it.
  int per_curve = automatic;
  static constexpr int automatic = -1;
  double least_along_curves = 0;  ///< no element along a curve must be shorter for `per_curve`
  std::vector<NearSize> near;
  std::vector<SagLimit> sags;
  double curvature = 0;  ///< elements per full turn of the boundary; 0: sizes do not depend on curvature
  double growth = 0;  ///< from one element to the next, > 1; 0: the growth of `sources`, else SizeField::default_growth
  SizeSources sources;
  std::vector<std::string> symmetry;  ///< patterns of names of curves (curve/symmetry_lines.hpp)
  void validate() const;              ///< throws UsageError
};

/// The growth that applies: that of the options, of their sources, or the default.
double growth(const SizeOptions& options);

/// Sizes by curvature are at least 1e-4 diameters. Throws UsageError for names that no boundary has.
SizeField make_size_field(const CadFace& face, const SizeOptions& options);

/// "auto" or a number, 0 or above; throws UsageError.
int parse_per_curve(const std::string& text);

/// "NAME=H" or "NAME=H:H2" (the last = counts); throws UsageError.
NearSize parse_near_size(const std::string& text);

}  // namespace quadrille::sizing
