#pragma once
// Makes the size field from options: one size for all elements, sizes near boundaries, by their curvature, from a file.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/size_sources.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// Edges of length `size` along a named boundary; with "NAME@REGION" in this region alone. `other_size` > 0: that of
/// the boundary's right end (of greatest x, then y); `size` is then that of its left end.
struct NearSize {
  std::string boundary;
  double size = 0;
  double other_size = 0;
};

struct SizeOptions {
  double size = 0;  ///< if no source prescribes less; 0: diameter / 20, or the greatest size of a table
  /// The least number of elements along each boundary curve (sizing/curve_sizes); 0: none; automatic: 0, unless
  /// sizing/automatic_sizes has determined it.
  int per_curve = automatic;
  static constexpr int automatic = -1;
  double least_along_curves = 0;  ///< no element along a curve must be shorter for `per_curve`
  std::vector<NearSize> near;
  double curvature = 0;  ///< elements per full turn of the boundary; 0: sizes do not depend on curvature
  double growth = 0;  ///< from one element to the next, > 1; 0: the growth of `sources`, else SizeField::default_growth
  SizeSources sources;
  void validate() const;  ///< throws UsageError
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
