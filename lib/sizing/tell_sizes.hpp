#pragma once
// What became of the wanted sizes: achieved edge lengths against wanted ones, for the report.

#include <vector>

#include "base/report.hpp"
#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// Of the elements' edges on the arcs of one chord, or of all; lengths as arc lengths.
struct EdgeSizes {
  double length = 0;                           ///< of all edges
  double wanted = 0;                           ///< geometric mean over the length
  double least = 0, greatest = 0;              ///< achieved
  double mean_log = 0;                         ///< of ln(achieved / wanted), over the length
  double deviation = 0;                        ///< its root mean square
  double least_ratio = 0, greatest_ratio = 0;  ///< of achieved / wanted
};

/// One for each chord, then that of all. `arc_ends`: fractions of each arc's length (refine/divide_arcs).
std::vector<EdgeSizes> edge_sizes(const std::vector<mesh::Chord>& chords, const std::vector<curve::Chain>& chains,
                                  const std::vector<std::vector<double>>& arc_ends, const SizeField& sizes);

/// Sets sizes.* (the chords as columns, sizes.chord.*) and warns of prescribed counts that had to rise.
void tell_sizes(const std::vector<mesh::Chord>& chords, const std::vector<curve::Chain>& chains,
                const std::vector<std::vector<double>>& arc_ends, const SizeField& sizes,
                const std::vector<ChordCount>& prescribed, Report& report);

}  // namespace quadrille::sizing
