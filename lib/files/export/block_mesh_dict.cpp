#include <fmt/format.h>

#include <algorithm>

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

class BlockMeshWriter : TextWriter {
 public:
  BlockMeshWriter(const QuadMesh& mesh, const Frame& frame, const PlateBlocks& plates)
      : mesh_(mesh), frame_(frame), plates_(plates), above_(static_cast<int>(plates.vertices.size())) {}

  std::string text(const std::vector<std::string>& patches, const std::vector<std::string>& types,
                   const std::vector<CyclicPatch>& cyclic, const std::vector<std::string>& zones) {
    print(
        "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class dictionary;\n    object blockMeshDict;\n}}\n\n");
    // blockMesh scales points, but neither separations nor centres of rotation, and checks these before and after.
    for (const CyclicPatch& patch : cyclic)
      if (patch.neighbour >= 0) metres_ = scale();
    print("scale {};\n\n", scale() / metres_);
    write_vertices();
    write_splines();
    write_blocks(zones);
    write_patches(patches, types, cyclic);
    print("mergePatchPairs\n(\n);\n");
    return std::move(out_);
  }

 private:
  double scale() const { return mesh_.face.metres_per_unit > 0 ? mesh_.face.metres_per_unit : 1.0; }

  double height(bool is_above) const { return is_above ? thickness_share * mesh_.face.diameter : 0.0; }

  void write_point(Vec2 position, bool is_above) {
    const std::array<double, 3> x = frame_.at(position);
    print("({} {} {})", metres_ * x[0], metres_ * x[1], metres_ * height(is_above));
  }

  void write_vertices() {
    print("vertices\n(\n");
    for (const bool is_above : {false, true})
      for (const int node : plates_.vertices) {
        print("    ");
        write_point(mesh_.nodes[node], is_above);
        print("\n");
      }
    print(");\n\n");
  }

  void write_splines() {
    print("edges\n(\n");
    for (const PlateSpline& spline : plates_.splines)
      for (const bool is_above : {false, true}) {
        const int shift = is_above ? above_ : 0;
        print("    spline {} {}\n    (\n", spline.from + shift, spline.to + shift);
        for (const Vec2 x : spline.inner) {
          print("        ");
          write_point(x, is_above);
          print("\n");
        }
        print("    )\n");
      }
    print(");\n\n");
  }

  void write_blocks(const std::vector<std::string>& zones) {
    print("blocks\n(\n");
    for (const PlateBlock& block : plates_.blocks) {
      const std::array<int, 4>& c = block.corners;
      print("    hex ({} {} {} {} {} {} {} {}) {} ({} {} 1) ", c[0], c[1], c[2], c[3], c[0] + above_, c[1] + above_,
            c[2] + above_, c[3] + above_, zones[block.region], block.edges[0].num_cells(), block.edges[1].num_cells());
      write_grading(block);
    }
    print(");\n\n");
  }

  /// blockMesh's twelve edges: four in each direction; those in the plane below, above it, above, below.
  void write_grading(const PlateBlock& block) {
    if (std::all_of(block.edges.begin(), block.edges.end(), is_even)) {
      print("simpleGrading (1 1 1)\n");
      return;
    }
    print("edgeGrading\n    (\n");
    for (const int edge : {0, 2, 2, 0, 3, 1, 1, 3}) write_sections(block.edges[edge]);
    print("        1 1 1 1\n    )\n");
  }

  static bool is_even(const DividedEdge& edge) {
    const double even = 1.0 / edge.num_cells();
    return std::all_of(edge.fractions.begin(), edge.fractions.end(),
                       [&](double fraction) { return std::abs(fraction - even) < 1e-12; });
  }

  void write_sections(const DividedEdge& edge) {
    print("        ");
    if (is_even(edge)) {
      print("1\n");
      return;
    }
    print("(");
    for (const double fraction : edge.fractions) print("({} 1 1)", fraction);
    print(")\n");
  }

  void write_patches(const std::vector<std::string>& names, const std::vector<std::string>& types,
                     const std::vector<CyclicPatch>& cyclic) {
    print("boundary\n(\n");
    for (std::size_t p = 0; p < names.size(); ++p) {
      if (plates_.patches[p].empty()) continue;
      const bool is_cyclic = cyclic[p].neighbour >= 0;
      print("    {}\n    {{\n        type {};\n", names[p], is_cyclic ? "cyclic" : types[p]);
      if (is_cyclic)
        print("        neighbourPatch {};\n{}", names[cyclic[p].neighbour],
              cyclic_transform(mesh_.face, cyclic[p], metres_));
      print("        faces\n        (\n");
      for (const auto& [from, to] : plates_.patches[p])
        print("            ({} {} {} {})\n", from, to, to + above_, from + above_);
      print("        );\n    }}\n");
    }
    print("    {}\n    {{\n        type empty;\n        faces\n        (\n", front_and_back);
    for (const PlateBlock& block : plates_.blocks) {
      const std::array<int, 4>& c = block.corners;
      print("            ({} {} {} {})\n", c[0], c[3], c[2], c[1]);
      print("            ({} {} {} {})\n", c[0] + above_, c[1] + above_, c[2] + above_, c[3] + above_);
    }
    print("        );\n    }}\n);\n\n");
  }

  const QuadMesh& mesh_;
  const Frame& frame_;
  const PlateBlocks& plates_;
  int above_;          ///< number of a vertex in the upper plane less its number in the lower one
  double metres_ = 1;  ///< factor of all written lengths; `scale` has the rest
};

void report_losses(const QuadMesh& mesh, const PlateBlocks& plates, std::vector<std::string>& losses) {
  const double diameter = mesh.face.diameter, least = 1e-12 * diameter;
  if (const double moved = boundary_distance(mesh); moved > least)
    losses.push_back(straight_sides_loss(moved, diameter));
  if (plates.moved > least)
    losses.push_back(fmt::format("blockMesh places the points inside blocks itself, which moves them by up to {}",
                                 length_text(plates.moved, diameter)));
}

}  // namespace

Exported block_mesh_dict(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  PlateBlocks plates = plate_blocks(mesh, groups);
  const std::vector<std::string> type_names = patch_types(mesh, groups, types);
  std::vector<CyclicPatch> cyclic = cyclic_patches(mesh, groups, types);
  order_cyclic_blocks(mesh, groups, cyclic, plates);
  Exported exported;
  report_losses(mesh, plates, exported.losses);
  if (const std::string interfaces = interface_loss(groups); !interfaces.empty())
    exported.add_loss(interfaces + " (blockMesh makes no face zones; splitMeshRegions -cellZones divides the mesh)");
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic,
                                "a cyclic patch has periodic curves of one motion only, and no type by --patch-type"));
  const auto [patches, zones] = add_plain_names(groups, true, {{front_and_back}}, exported);
  exported.bytes = BlockMeshWriter(mesh, frame, plates).text(patches, type_names, cyclic, zones);
  return exported;
}

}  // namespace quadrille::exports
