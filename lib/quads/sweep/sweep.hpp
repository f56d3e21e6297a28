#pragma once
// The hexahedra that a quad mesh sweeps: its nodes at the levels of the sweep, which are the Gauss-Lobatto-Legendre
// points of each layer, on the exact motion; every element proved valid.

#include <cstddef>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "sweep/sweep_motion.hpp"

namespace quadrille::sweep {

/// About the bytes that the hexahedra take while they are made and written.
double memory_of(const QuadMesh& quads, std::size_t layers);

struct SweepPlan {
  std::vector<double> ends;  ///< of the layers: ascending from 0 to 1
  /// By node of the quads: height along the normal by which the face lies higher at its beginning, and not at its end;
  /// linear in s. Empty: none.
  std::vector<double> bottom_heights;
  bool has_periodic_ends = false;  ///< bottom and top are periodic
  std::string bottom_name = "bottom", top_name = "top";
};

/// The nodes of the quads in the coordinates of the CAD model.
std::vector<Vec3> nodes_in_model(const QuadMesh& quads);
/// The normal of a planar face there, of unit length.
Vec3 normal_of(const CadFace& face);
Vec3 in_model(const CadFace& face, Vec2 x);  ///< x relative to face.origin

/// The mesh, measured; without provenance. Elements that run against the face's normal are those of the mirrored quads
/// (xi1 and xi2 exchanged). `lost`: names of periodic sides of the face that no motion maps onto each other any more.
/// Throws ComputeError before the work if the mesh would have too many nodes, or take more memory than there is,
/// UsageError if a name of an end is that of a side, or if ends are to be periodic that are none.
HexMesh sweep(const QuadMesh& quads, const SweepMotion& motion, const SweepPlan& plan, int threads, Progress* progress,
              std::vector<std::string>& lost);

/// The greatest distance of the body from the exact motion, where it is sampled: in the middles between the levels of
/// nodes, for the corners of the box of the face. A length.
double motion_error(const QuadMesh& quads, const SweepMotion& motion, const std::vector<double>& ends);

/// Throws ComputeError, with the position of the worst element and a remedy, unless every element is proved valid.
void require_valid_elements(const HexMesh& mesh);

void report_mesh(const HexMesh& mesh, Report& report);

}  // namespace quadrille::sweep
