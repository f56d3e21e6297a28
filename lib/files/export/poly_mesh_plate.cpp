// OpenFOAM's polyMesh of a quad mesh: a plate one cell thick, as blockMesh makes it from a blockMeshDict.
#include "export/groups.hpp"
#include "export/patches.hpp"
#include "export/plate_mesh.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

Exported poly_mesh(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  require_boundaries(groups.boundary_names, types);
  const std::vector<CyclicPatch> cyclic = cyclic_patches(mesh, groups, types);
  const PlateMesh plate = plate_mesh(mesh, frame, groups, cyclic, types);
  Exported exported = poly_mesh(plate.mesh, plate.types);
  if (const double moved = boundary_distance(mesh); moved > 1e-12 * mesh.face.diameter)
    exported.add_loss(straight_sides_loss(moved, mesh.face.diameter));
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic,
                                "a cyclic patch has periodic curves of one motion only, and no type by --patch-type"));
  return exported;
}

}  // namespace quadrille::exports
