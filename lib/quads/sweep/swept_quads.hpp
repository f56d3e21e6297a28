#pragma once
// The quads as they are swept: their nodes in space, and their elements, mirrored where the sweep runs against their
// normal. Private to this folder.

#include <array>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "sweep/sweep_motion.hpp"

namespace quadrille::sweep {

struct SweptQuads {
  const QuadMesh& quads;
  std::vector<Vec3> nodes;
  std::vector<int> elem_nodes;
  std::array<int, 4> face_of_side{0, 1, 2, 3};

  bool is_mirrored() const { return face_of_side[0] != 0; }
};

SweptQuads swept_quads(const QuadMesh& quads, const SweepMotion& motion);

/// Names of sides, interfaces and ends, layer by layer in the order of the quads' edges, and those that are periodic:
/// mesh.nodes, elem_nodes and num_quads must be there. Of two periodic groups the first has `periodic_with`.
void add_face_groups(const SweptQuads& swept, HexMesh& mesh, std::vector<std::string>& lost);
void add_ends(const std::string& bottom, const std::string& top, HexMesh& mesh);
/// Makes the last two groups periodic by the motion; false if it does not map the first onto the second.
bool join_ends(const SpaceMotion& motion, HexMesh& mesh);

/// Bounds and scaled Jacobians. `ends`: of the layers.
void measure(const SweptQuads& swept, const SweepMotion& motion, const std::vector<double>& ends, bool has_heights,
             int threads, Progress* progress, HexMesh& mesh);

}  // namespace quadrille::sweep
