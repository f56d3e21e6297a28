#include "export/block_mesh_text.hpp"

#include <algorithm>
#include <cmath>

#include "export/patches.hpp"
#include "export/renode.hpp"

namespace quadrille::exports {

namespace {

bool is_even(const std::vector<double>& fractions) {
  const double even = 1.0 / static_cast<double>(fractions.size());
  return std::all_of(fractions.begin(), fractions.end(),
                     [&](double fraction) { return std::abs(fraction - even) < 1e-12; });
}

class BlockMeshWriter : TextWriter {
 public:
  explicit BlockMeshWriter(const BlockMesh& mesh) : mesh_(mesh), plates_(mesh.plates), above_(mesh.above()) {}

  std::string text() {
    print(
        "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class dictionary;\n    object blockMeshDict;\n}}\n\n");
    print("scale {};\n\n", mesh_.scale);
    write_vertices();
    write_splines();
    write_blocks();
    write_patches();
    print("mergePatchPairs\n(\n);\n");
    return std::move(out_);
  }

 private:
  void write_point(Vec2 position, bool is_above) {
    const std::array<double, 3> x = mesh_.at(position, is_above);
    print("({} {} {})", x[0], x[1], x[2]);
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

  void write_blocks() {
    print("blocks\n(\n");
    for (const PlateBlock& block : plates_.blocks) {
      const std::array<int, 4>& c = block.corners;
      print("    hex ({} {} {} {} {} {} {} {}) {} ({} {} {}) ", c[0], c[1], c[2], c[3], c[0] + above_, c[1] + above_,
            c[2] + above_, c[3] + above_, mesh_.zones[block.region], block.edges[0].num_cells(),
            block.edges[1].num_cells(), mesh_.layers.size());
      write_grading(block);
    }
    print(");\n\n");
  }

  /// blockMesh's twelve edges: four in each direction; those in the plane below, above it, above, below.
  void write_grading(const PlateBlock& block) {
    const auto& edges = block.edges;
    const bool are_even =
        std::all_of(edges.begin(), edges.end(), [](const DividedEdge& edge) { return is_even(edge.fractions); });
    if (are_even && is_even(mesh_.layers)) {
      print("simpleGrading (1 1 1)\n");
      return;
    }
    print("edgeGrading\n    (\n");
    for (const int edge : {0, 2, 2, 0, 3, 1, 1, 3}) write_sections(edges[edge].fractions);
    if (is_even(mesh_.layers))
      print("        1 1 1 1\n");
    else
      for (int edge = 0; edge < 4; ++edge) write_sections(mesh_.layers);
    print("    )\n");
  }

  void write_sections(const std::vector<double>& fractions) {
    print("        ");
    if (is_even(fractions)) {
      print("1\n");
      return;
    }
    print("(");
    for (const double fraction : fractions) print("({} 1 1)", fraction);
    print(")\n");
  }

  void write_patches() {
    print("boundary\n(\n");
    for (const BlockMeshPatch& patch : mesh_.patches) {
      if (patch.faces.empty()) continue;
      print("    {}\n    {{\n        type {};\n{}        faces\n        (\n", patch.name, patch.type, patch.entries);
      for (const auto& [a, b, c, d] : patch.faces) print("            ({} {} {} {})\n", a, b, c, d);
      print("        );\n    }}\n");
    }
    print(");\n\n");
  }

  const BlockMesh& mesh_;
  const PlateBlocks& plates_;
  int above_;
};

}  // namespace

std::vector<std::array<int, 4>> BlockMesh::side_faces(int boundary) const {
  std::vector<std::array<int, 4>> faces;
  for (const auto& [from, to] : plates.patches[boundary]) faces.push_back({from, to, to + above(), from + above()});
  return faces;
}

std::vector<std::array<int, 4>> BlockMesh::end_faces(bool is_above) const {
  std::vector<std::array<int, 4>> faces;
  const int shift = above();
  for (const PlateBlock& block : plates.blocks) {
    const auto& [a, b, c, d] = block.corners;
    if (is_above)
      faces.push_back({a + shift, b + shift, c + shift, d + shift});
    else
      faces.push_back({a, d, c, b});
  }
  return faces;
}

std::vector<std::string> block_mesh_losses(const QuadMesh& mesh, const PlateBlocks& plates) {
  std::vector<std::string> losses;
  const double diameter = mesh.face.diameter, least = 1e-12 * diameter;
  if (const double moved = boundary_distance(mesh); moved > least)
    losses.push_back(straight_sides_loss(moved, diameter));
  if (plates.moved > least)
    losses.push_back(fmt::format("blockMesh places the points inside blocks itself, which moves them by up to {}",
                                 length_text(plates.moved, diameter)));
  return losses;
}

std::string block_mesh_text(const BlockMesh& mesh) { return BlockMeshWriter(mesh).text(); }

}  // namespace quadrille::exports
