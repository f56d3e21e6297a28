#include <algorithm>
#include <cctype>

#include "base/message_text.hpp"
#include "export/groups.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// What SPECFEM2D makes of a boundary, by the beginning of its name.
enum class Side { other, free_surface, absorbing };

Side kind_of(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (name.starts_with("free")) return Side::free_surface;
  return name.starts_with("abso") ? Side::absorbing : Side::other;
}

class SpecfemWriter : TextWriter {
 public:
  SpecfemWriter(const QuadMesh& quads, const Frame& frame, const Groups& groups)
      : quads_(quads), frame_(frame), groups_(groups) {}

  /// Corners counter-clockwise, middles of the sides after them, middle.
  std::string elements() {
    print("{}\n", quads_.num_elems());
    for (int elem = 0; elem < quads_.num_elems(); ++elem) {
      for (int k = 0; k < quads_.order; ++k)
        for (int side = 0; side < 4; ++side)
          print("{}{}", k + side == 0 ? "" : " ", side_node(quads_, elem, side, k) + 1);
      if (quads_.order == 2) print(" {}", quads_.elem_nodes[elem * quads_.nodes_per_elem() + 4] + 1);
      print("\n");
    }
    return std::move(out_);
  }

  std::string nodes() {
    print("{}\n", quads_.nodes.size());
    for (const Vec2 node : quads_.nodes) print("{} {}\n", frame_.at(node)[0], frame_.at(node)[1]);
    return std::move(out_);
  }

  std::string materials() {
    for (const int block : quads_.elem_block) print("{}\n", 1 + groups_.block2region[block]);
    return std::move(out_);
  }

  /// Element, 2, both corners; of absorbing sides also 1 below, 2 on the right, 3 above, 4 on the left.
  std::string sides(Side kind) {
    std::vector<QuadBoundaryEdge> edges = quads_.boundary_edges;
    std::erase_if(edges, [&](const QuadBoundaryEdge& e) {
      return kind_of(groups_.boundary_names[groups_.curve2boundary[e.curve]]) != kind;
    });
    print("{}\n", edges.size());
    for (const QuadBoundaryEdge& e : edges) {
      const int from = side_node(quads_, e.elem, e.side, 0), to = side_node(quads_, e.elem, e.side, quads_.order);
      print("{} 2 {} {}", e.elem + 1, from + 1, to + 1);
      if (kind == Side::absorbing) print(" {}", direction(quads_.nodes[to] - quads_.nodes[from]));
      print("\n");
    }
    return std::move(out_);
  }

 private:
  /// By the normal, which points to the right of the side.
  static int direction(Vec2 along) {
    if (std::abs(along.x) >= std::abs(along.y)) return along.x > 0 ? 1 : 3;
    return along.y > 0 ? 2 : 4;
  }

  const QuadMesh& quads_;
  const Frame& frame_;
  const Groups& groups_;
};

std::string unlisted_sides_loss(const Groups& groups) {
  const auto count = std::count_if(groups.boundary_names.begin(), groups.boundary_names.end(),
                                   [](const std::string& name) { return kind_of(name) == Side::other; });
  if (count == 0) return {};
  return counted(count, "boundary name") + (count == 1 ? " begins" : " begin") +
         " with neither free nor abso: these sides are in no file";
}

}  // namespace

Exported specfem2d(const QuadMesh& mesh, const Frame& frame) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Elements of SPECFEM2D");
  const Groups groups = mesh_groups(mesh);
  SpecfemWriter writer(quads, frame, groups);
  Exported exported;
  exported.bytes = writer.elements();
  exported.side_files = {{specfem_nodes, writer.nodes()},
                         {specfem_materials, writer.materials()},
                         {specfem_free_surface, writer.sides(Side::free_surface)},
                         {specfem_absorbing, writer.sides(Side::absorbing)},
                         names_table(groups, groups.boundary_names, groups.region_names)};
  exported.add_loss(split_loss(mesh, quads));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(unlisted_sides_loss(groups));
  if (groups.num_regions() > 1) exported.add_loss("regions are stored as numbers, which *.names.json lists");
  return exported;
}

}  // namespace quadrille::exports
