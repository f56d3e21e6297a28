#pragma once
// A quad mesh in the terms of HOHQMesh's formats: corners, and for each element its curved sides and their names.
//
// Corners count from 1, counter-clockwise. Sides 1 to 4 join corners 1-2, 2-3, 4-3 and 1-4: they run in the local
// coordinate's direction, not round the element. Here they are numbered from 0, as in model/quad_mesh.hpp. Source:
// HOHQMesh, "The HOHQMesh Mesh File Formats".

#include <array>
#include <string>
#include <vector>

#include "export/exported.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct HohqmeshEdge {
  int elem = 0, side = 0;                ///< the element of lower number; the edge runs counter-clockwise round it
  int other_elem = -1, other_side = -1;  ///< -1 on the boundary; may lie across a periodic side
};

/// With the losses and side files of the format.
struct HohqmeshModel : Exported {
  std::vector<int> corners;                      ///< mesh node of each corner, in the order of the elements
  std::vector<std::array<int, 4>> elem_corners;  ///< from 1
  std::vector<std::array<bool, 4>> is_curved;    ///< by element and side, the same for both elements of an edge
  std::vector<std::array<int, 4>> boundary;      ///< by element and side: index into names; -1 inside
  std::vector<std::string> names;                ///< of boundaries, single words
  std::vector<std::string> materials;            ///< by element: its region, a single word; empty if they are lost
  std::vector<HohqmeshEdge> edges;
  /// By mesh node: positions; the nodes of a side moved from its Gauss-Lobatto-Legendre to its Chebyshev-Lobatto
  /// points.
  std::vector<std::array<double, 3>> points;

  /// The name of a side; "---" inside.
  const std::string& name(int elem, int side) const;
};

/// Whether the file stores the region of each element.
enum class Materials { lost, kept };

/// Throws ComputeError where an element would be folded once its interior is rebuilt from its sides.
HohqmeshModel hohqmesh_model(const QuadMesh& mesh, const Frame& frame, Materials materials);

/// Makes one edge of the two of each periodic pair whose motion is a translation, between the elements on both sides;
/// it has no name any more.
void join_periodic_edges(const QuadMesh& mesh, HohqmeshModel& model);

/// A sentence about the other periodic pairs; empty if there are none.
std::string rotation_loss(const CadFace& face);

/// Trixi.jl compares the second line of an .inp, its leading blank included, and finds the order as the sixth word of
/// its line.
inline constexpr const char* inp_heading = "*Heading\n File created by HOHQMesh\n";
inline constexpr const char* inp_second_part =
    "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = {}\n";

/// The mesh nodes of a side in its local direction, both ends included.
std::vector<int> hohqmesh_side(const QuadMesh& mesh, int elem, int side);

}  // namespace quadrille::exports
