#include <array>

#include "export/abaqus_text.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/serendipity.hpp"

namespace quadrille::exports {
namespace {

/// The places of the nodes in a grid of 3 x 3 x 3: corners, middles of the edges below, above and upright.
constexpr std::array<int, 20> c3d20_order{0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15};

/// S1 is the bottom, S2 the top, S3 to S6 the sides of the quad.
constexpr std::array<int, 6> surface_numbers{3, 4, 5, 6, 1, 2};

class AbaqusHexWriter : AbaqusText {
 public:
  explicit AbaqusHexWriter(const HexMesh& mesh)
      : mesh_(mesh),
        numbering_(number_hexes(mesh)),
        faces_(lines_as_boundaries(mesh_groups(mesh))),
        numbers_(serendipity_numbers(mesh)) {}

  const Groups& faces() const { return faces_; }

  std::string text(const PlainNames& words) {
    print("*HEADING\nhexahedra of order {}\n*NODE, NSET=NALL\n", mesh_.order);
    for (std::size_t node = 0; node < numbers_.size(); ++node) {
      const Vec3 x = mesh_.nodes[node];
      if (numbers_[node] > 0) print_node(numbers_[node], {x.x, x.y, x.z});
    }
    for (std::size_t region = 0; region < words.regions.size(); ++region)
      write_region(words.regions[region], static_cast<int>(region));
    print_all_elements(words.regions);
    for (std::size_t name = 0; name < words.boundaries.size(); ++name)
      write_faces(words.boundaries[name], static_cast<int>(name));
    return std::move(out_);
  }

 private:
  std::vector<int> element(int elem) const {
    const int* own = &mesh_.elem_nodes[elem * mesh_.nodes_per_elem()];
    std::vector<int> nodes;
    if (mesh_.order == 1)
      for (int corner = 0; corner < 8; ++corner) nodes.push_back(own[hex_corner_node(1, corner)]);
    else
      for (const int local : c3d20_order) nodes.push_back(own[local]);
    return nodes;
  }

  /// At most 16 numbers in a line, which goes on after a comma.
  void write_region(const std::string& name, int region) {
    print("*ELEMENT, TYPE=C3D{}, ELSET={}\n", mesh_.order == 1 ? 8 : 20, name);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      if (faces_.block2region[mesh_.quad_block[elem % mesh_.num_quads]] != region) continue;
      print("{}", elem + 1);
      const std::vector<int> nodes = element(elem);
      for (std::size_t k = 0; k < nodes.size(); ++k) print("{}{}", k == 15 ? ",\n" : ", ", numbers_[nodes[k]]);
      print("\n");
    }
  }

  void write_faces(const std::string& name, int number) {
    std::vector<GroupFace> all;
    std::vector<int> nodes;
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g) {
      if (faces_.curve2boundary[g] != number) continue;
      const std::vector<GroupFace> own = faces_once(mesh_.face_groups[g], numbering_);
      all.insert(all.end(), own.begin(), own.end());
    }
    for (const GroupFace at : all)
      for (const int node : face_nodes(mesh_, at.elem, at.face))
        if (numbers_[node] > 0) nodes.push_back(numbers_[node]);
    if (all.empty()) return;
    print_node_set(name, std::move(nodes));
    print("*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
    for (const GroupFace at : all) print("{}, S{}\n", at.elem + 1, surface_numbers[at.face]);
  }

  const HexMesh& mesh_;
  HexNumbering numbering_;
  Groups faces_;
  std::vector<int> numbers_;  ///< by mesh node, from 1; 0: it is not written
};

}  // namespace

Exported abaqus_c3d(const HexMesh& mesh) {
  AbaqusHexWriter writer(mesh);
  Exported exported;
  exported.add_loss(serendipity_loss(mesh, "CalculiX"));
  exported.add_loss(periodic_loss(mesh));
  exported.bytes = writer.text(add_plain_names(writer.faces(), true, abaqus_set_names, exported));
  return exported;
}

}  // namespace quadrille::exports
