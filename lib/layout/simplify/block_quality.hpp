#pragma once
// Quality measures of the blocks of a layout, by which changes are accepted or rejected.

#include <map>
#include <set>
#include <vector>

#include "graph/subdivision.hpp"

namespace quadrille::simplify {

/// The worst values over a set of blocks.
struct BlockQuality {
  double least_angle = 4, greatest_angle = 0;  ///< at corners, radians
  double least_scaled_jacobian = 1;            ///< of blocks as quads of order 8 (mesh/transfinite.hpp)

  void add(const BlockQuality& other);
};

/// The nodes of blocks as quads of order 8.
using BlockQuads = std::vector<std::vector<Vec2>>;

/// The quality of these faces, each of which must have four sides. Appends their quads.
BlockQuality worst_quality(const graph::Subdivision& subdivision, const std::vector<int>& faces, BlockQuads& quads);

/// Whether all Jacobians of the quads are proved positive: takes longer than the measurement of their quality.
bool are_valid(const BlockQuads& quads);

/// Qualities of faces, each measured once as long as its sides stay as they are.
class BlockQualities {
 public:
  BlockQuality worst(const graph::Subdivision& subdivision, const std::vector<int>& faces);

 private:
  std::map<std::vector<double>, BlockQuality> known_;  // by the pieces of the four sides
};

/// All faces, ascending.
std::vector<int> all_faces(const graph::Subdivision& subdivision);

/// Faces with a side among these arcs, ascending.
std::vector<int> faces_beside(const graph::Subdivision& subdivision, const std::set<int>& arcs);

}  // namespace quadrille::simplify
