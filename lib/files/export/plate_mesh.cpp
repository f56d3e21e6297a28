#include "export/plate_mesh.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "export/edge_numbering.hpp"
#include "export/periodic_edges.hpp"
#include "export/poly_faces.hpp"

namespace quadrille::exports {
namespace {

/// The plate's thickness, a fraction of the face's diameter.
constexpr double thickness = 0.1;

/// The name of the group of its two ends.
std::string end_name(const Groups& groups) {
  const std::vector<std::string> names = boundary_and_interface_names(groups);
  std::string name = "frontAndBack";
  while (std::find(names.begin(), names.end(), name) != names.end()) name += '_';
  return name;
}

HexFaceGroup named_group(const std::string& name) {
  HexFaceGroup group;
  group.name = name;
  return group;
}

void add_cells(const QuadMesh& mesh, const Frame& frame, HexMesh& plate) {
  const EdgeNumbering numbering = number_parts(mesh);
  const int above = numbering.num_vertices();
  for (const double z : {0.0, thickness * mesh.face.diameter})
    for (const int node : numbering.vertices) {
      const std::array<double, 3> x = frame.at(mesh.nodes[node]);
      plate.nodes.push_back({x[0], x[1], z});
    }
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int shift : {0, above})
      for (const int corner : {0, 1, 3, 2}) plate.elem_nodes.push_back(numbering.vertex(elem, corner) + shift);
  plate.elem_jacobian_bound.assign(mesh.elem_block.size(), 1);  // of which there is one for each element
}

/// Interfaces have a name, which is reported as lost, and no faces.
void add_groups(const QuadMesh& mesh, const Groups& groups, HexMesh& plate) {
  for (const std::string& name : groups.boundary_names) plate.face_groups.push_back(named_group(name));
  for (const std::string& name : groups.inner_names) {
    plate.face_groups.push_back(named_group(name));
    plate.face_groups.back().is_interface = true;
  }
  const auto add = [](HexFaceGroup& group, int elem, int face) {
    group.elems.push_back(elem), group.faces.push_back(face);
  };
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    add(plate.face_groups[groups.curve2boundary[e.curve]], e.elem, e.side);
  HexFaceGroup ends = named_group(end_name(groups));
  for (int elem = 0; elem < mesh.num_elems(); ++elem) add(ends, elem, 4), add(ends, elem, 5);
  plate.face_groups.push_back(std::move(ends));
}

/// Makes the groups of cyclic patches images of each other, face by face.
void join_groups(const QuadMesh& mesh, const Frame& frame, const Groups& groups, const std::vector<CyclicPatch>& cyclic,
                 HexMesh& plate) {
  for (int b = 0; b < groups.num_boundaries(); ++b) {
    if (cyclic[b].neighbour < 0 || !cyclic[b].is_first) continue;
    HexFaceGroup &first = plate.face_groups[b], &second = plate.face_groups[cyclic[b].neighbour];
    first = named_group(first.name), second = named_group(second.name);
    for (const PeriodicEdges& pair : periodic_edges(mesh)) {
      const QuadBoundaryEdge &from = mesh.boundary_edges[pair.first], &to = mesh.boundary_edges[pair.second];
      if (groups.curve2boundary[from.curve] != b) continue;
      first.elems.push_back(from.elem), first.faces.push_back(from.side);
      second.elems.push_back(to.elem), second.faces.push_back(to.side);
    }
    const std::array<double, 16> m = affine_motion(mesh.face, cyclic[b].pair, frame);
    first.periodic_with = cyclic[b].neighbour;
    first.motion = {{Vec3{m[0], m[1], 0}, Vec3{m[4], m[5], 0}, Vec3{0, 0, 1}}, {m[3], m[7], 0}};
  }
}

}  // namespace

PlateMesh plate_mesh(const QuadMesh& mesh, const Frame& frame, const Groups& groups,
                     const std::vector<CyclicPatch>& cyclic, const std::vector<PatchType>& types) {
  HexMesh plate;
  plate.length_unit = mesh.face.length_unit;
  plate.diameter = mesh.face.diameter;
  plate.num_quads = mesh.num_elems();
  plate.quad_block = mesh.elem_block;
  plate.block_region = groups.block2region;
  plate.region_names = groups.region_names;
  add_cells(mesh, frame, plate);
  add_groups(mesh, groups, plate);
  join_groups(mesh, frame, groups, cyclic, plate);
  std::vector<PatchType> with_ends = types;
  with_ends.push_back({plate.face_groups.back().name, "empty"});
  return {std::move(plate), std::move(with_ends)};
}

mesh::StraightCells straight_cells(const QuadMesh& mesh, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  const PlateMesh plate = plate_mesh(mesh, Frame{}, groups, cyclic_patches(mesh, groups, types), types);
  mesh::StraightCells cells = straight_cells(plate.mesh, poly_faces(plate.mesh, plate.types));
  cells.is_plate = true;
  return cells;
}

}  // namespace quadrille::exports
