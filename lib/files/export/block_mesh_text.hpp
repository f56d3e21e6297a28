#pragma once
// The text of OpenFOAM's blockMeshDict: blocks over a plane, between their lower and their upper side. Private to
// block_mesh*.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "export/plate_blocks.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

struct BlockMeshPatch {
  std::string name, type;
  std::string entries = {};                    ///< of a cyclic patch, as lines
  std::vector<std::array<int, 4>> faces = {};  ///< vertices
};

struct BlockMesh {
  const PlateBlocks& plates;
  const std::vector<Vec2>& nodes;  ///< positions of the mesh nodes in the plane
  /// The position of a point of the plane on the lower or the upper side, in the unit of the file.
  std::function<std::array<double, 3>(Vec2 x, bool is_above)> at;
  std::vector<double> layers = {1};     ///< fractions of the height, from below; the sum is 1
  std::vector<std::string> zones = {};  ///< by region
  std::vector<BlockMeshPatch> patches = {};
  double scale = 1;  ///< metres of the unit

  /// Vertices of the upper side are counted after those of the lower one.
  int above() const { return static_cast<int>(plates.vertices.size()); }
  /// Upright faces along sides of blocks, and the lower or upper faces of all blocks, seen from outside.
  std::vector<std::array<int, 4>> side_faces(int boundary) const;
  std::vector<std::array<int, 4>> end_faces(bool is_above) const;
};

/// Sentences on straight sides and on points that blockMesh places itself.
std::vector<std::string> block_mesh_losses(const QuadMesh& mesh, const PlateBlocks& plates);

std::string block_mesh_text(const BlockMesh& mesh);

}  // namespace quadrille::exports
