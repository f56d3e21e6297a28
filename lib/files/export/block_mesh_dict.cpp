#include <fmt/format.h>

#include <algorithm>

#include "export/block_mesh_text.hpp"
#include "export/groups.hpp"
#include "export/patches.hpp"
#include "export/plate_blocks.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// The plane's mesh is thickness_share of the face's diameter thick.
constexpr double thickness_share = 0.1;
constexpr const char* front_and_back = "frontAndBack";

/// The blocks with one layer of cells: sides, then both ends as one patch.
BlockMesh plate(const QuadMesh& mesh, const Frame& frame, const PlateBlocks& plates, double metres) {
  const double height = metres * (thickness_share * mesh.face.diameter);
  return {plates, mesh.nodes, [&frame, metres, height](Vec2 position, bool is_above) {
            const std::array<double, 3> x = frame.at(position);
            return std::array<double, 3>{metres * x[0], metres * x[1], is_above ? height : 0.0};
          }};
}

void add_patches(const CadFace& face, const std::vector<std::string>& names, const std::vector<std::string>& types,
                 const std::vector<CyclicPatch>& cyclic, double metres, BlockMesh& blocks) {
  for (std::size_t p = 0; p < names.size(); ++p) {
    BlockMeshPatch patch{names[p], types[p], {}, blocks.side_faces(static_cast<int>(p))};
    if (cyclic[p].neighbour >= 0) {
      patch.type = "cyclic";
      patch.entries = fmt::format("        neighbourPatch {};\n{}", names[cyclic[p].neighbour],
                                  cyclic_transform(face, cyclic[p], metres));
    }
    blocks.patches.push_back(std::move(patch));
  }
  BlockMeshPatch ends{front_and_back, "empty"};
  const std::vector<std::array<int, 4>> below = blocks.end_faces(false), above = blocks.end_faces(true);
  for (std::size_t b = 0; b < below.size(); ++b) ends.faces.insert(ends.faces.end(), {below[b], above[b]});
  blocks.patches.push_back(std::move(ends));
}

}  // namespace

Exported block_mesh_dict(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  PlateBlocks plates = plate_blocks(mesh, groups);
  const std::vector<std::string> type_names = patch_types(mesh, groups, types);
  std::vector<CyclicPatch> cyclic = cyclic_patches(mesh, groups, types);
  order_cyclic_blocks(mesh, groups, cyclic, plates);
  Exported exported;
  exported.losses = block_mesh_losses(mesh, plates);
  if (const std::string interfaces = interface_loss(groups); !interfaces.empty())
    exported.add_loss(interfaces + " (blockMesh makes no face zones; splitMeshRegions -cellZones divides the mesh)");
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic,
                                "a cyclic patch has periodic curves of one motion only, and no type by --patch-type"));
  const PlainNames words = add_plain_names(groups, true, {{front_and_back}}, exported);
  // blockMesh scales points, but neither separations nor centres of rotation, and checks these before and after.
  const double scale = mesh.face.metres_per_unit > 0 ? mesh.face.metres_per_unit : 1.0;
  const bool is_cyclic =
      std::any_of(cyclic.begin(), cyclic.end(), [](const CyclicPatch& patch) { return patch.neighbour >= 0; });
  const double metres = is_cyclic ? scale : 1.0;
  BlockMesh blocks = plate(mesh, frame, plates, metres);
  blocks.scale = scale / metres;
  blocks.zones = words.regions;
  add_patches(mesh.face, words.boundaries, type_names, cyclic, metres, blocks);
  exported.bytes = block_mesh_text(blocks);
  return exported;
}

}  // namespace quadrille::exports
