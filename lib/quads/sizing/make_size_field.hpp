#pragma once
// Makes the size field from options: one size for all elements, sizes near boundaries, by their curvature, from a file.
//
// Where no sizes are prescribed, elements follow the features of a face: those along a run of the boundary of length L
// are max(L / n, s) long, n = SizeField::default_per_curve. A chord has one count in all of its blocks, so that one
// short curve can make the mesh of the whole face many times as large. s is therefore the least for which the counts of
// chords make at most twice as many elements as without this rule. In a far field (model/name_rules) s = 0: the size
// away from the curves is that of the far field, and no measure of the body. Along a wake there, elements grow by 5 %
// from one to the next, from the size at its beginning, where it has the smaller one.
//
// A run is a part of the boundary between two consecutive corners or ends of given names. Along a run of length L the
// size is L / n; along a smooth closed loop, a hole, it is L / (3 n), because it has no ends at which elements begin.
// In one half of a symmetric whole the diameter and the runs are those of the whole.
// Runs shorter than a thousandth of the diameter per element count as so long: one tiny edge shall not make the mesh of
// the whole face fine.

#include <memory>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/size_sources.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

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
  /// with_curve_sizes has determined it.
  int per_curve = automatic;
  static constexpr int automatic = -1;
  double least_along_curves = 0;  ///< no element along a curve must be shorter for `per_curve`
  std::vector<NearSize> near;
  std::vector<SagLimit> sags;
  double curvature = 0;  ///< elements per full turn of the boundary; 0: sizes do not depend on curvature
  double growth = 0;  ///< from one element to the next, > 1; 0: the growth of `sources`, else SizeField::default_growth
  SizeSources sources;
  std::vector<std::string> symmetry;             ///< patterns of names of curves (curve/symmetry_lines.hpp)
  std::shared_ptr<const ChartScale> scale = {};  ///< of a curved face: all sizes are lengths in space
  void validate() const;                         ///< throws UsageError
};

/// The growth that applies: that of the options, of their sources, or the default.
double growth(const SizeOptions& options);

/// Sizes by curvature are at least 1e-4 diameters. Throws UsageError for names that no boundary has.
SizeField make_size_field(const CadFace& face, const SizeOptions& options);

/// "auto" or a number, 0 or above; throws UsageError.
int parse_per_curve(const std::string& text);

/// "NAME=H" or "NAME=H:H2" (the last = counts); throws UsageError.
NearSize parse_near_size(const std::string& text);

/// The options with numbers in place of an automatic `per_curve`: n and s by this rule, s to 19 %, or 0 if none is
/// small enough, if a size or a table is prescribed, or if no curve is short; with a wake among the curves with sizes
/// of their own (`near`), unless it is there. Throws UsageError.
SizeOptions with_curve_sizes(const MeasuredLayout& measured, const SizeOptions& options, SizeRule rule);

}  // namespace quadrille::sizing
