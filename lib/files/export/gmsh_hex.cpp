// Gmsh's MSH of hexahedra: volumes are the regions, surfaces the groups of faces.
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <numeric>

#include "export/gmsh_model.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

constexpr std::array<int, 10> hex_types{0, 5, 12, 92, 93, 94, 95, 96, 97, 98};

// Gmsh's edges, and its faces by their corners: those of the local quad (0, 0), (N, 0), (N, N), (0, N).
constexpr std::array<std::array<int, 2>, 12> gmsh_edges{
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}};
constexpr std::array<std::array<int, 4>, 6> gmsh_faces{
    {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}};

/// Gmsh's order of the local nodes of a hexahedron: corners, edges, faces (each as a quad), then the same recursively
/// for the inner nodes.
class HexOrder {
 public:
  explicit HexOrder(int order) : order_(order) {
    for (low_ = 0, high_ = order; low_ < high_; ++low_, --high_) add_shell();
    if (low_ == high_) node_order_.push_back(low_ * (1 + (order + 1) * (order + 2)));
  }
  std::vector<int> take() { return std::move(node_order_); }

 private:
  int stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? order_ + 1 : (order_ + 1) * (order_ + 1); }

  int corner(int c) const {
    int node = 0;
    for (int axis = 0; axis < 3; ++axis) node += stride(axis) * (hex_corner_indices[c][axis] == 0 ? low_ : high_);
    return node;
  }

  int step(int from, int to) const { return (corner(to) - corner(from)) / (high_ - low_); }

  void add_shell() {
    for (int c = 0; c < 8; ++c) node_order_.push_back(corner(c));
    for (const auto& [from, to] : gmsh_edges)
      for (int k = 1; k < high_ - low_; ++k) node_order_.push_back(corner(from) + k * step(from, to));
    const int inner = high_ - low_ - 1;  // nodes of a face inside, in each direction
    for (const auto& c : gmsh_faces) {
      const int along = step(c[0], c[1]), across = step(c[0], c[3]);
      for (const int local : gmsh_quad_order(inner - 1))
        node_order_.push_back(corner(c[0]) + (1 + local % inner) * along + (1 + local / inner) * across);
    }
  }

  int order_, low_ = 0, high_ = 0;
  std::vector<int> node_order_;
};

class GmshHexWriter : TextWriter {
 public:
  GmshHexWriter(const HexMesh& mesh, bool is_41)
      : mesh_(mesh), is_41_(is_41), node_order_(HexOrder(mesh.order).take()) {
    const HexNumbering numbering = number_parts(mesh);
    for (const HexFaceGroup& group : mesh.face_groups) faces_.push_back(faces_once(group, numbering));
    model_.groups = mesh_groups(mesh);
    model_.positions = positions(mesh, ElementPoints::equispaced);
    region_elems_.resize(model_.groups.num_regions());
    for (int elem = 0; elem < mesh.num_elems(); ++elem) region_elems_[region_of(elem)].push_back(elem);
    if (!is_41) model_.tags_before = model_.num_groups();
    classify_nodes();
    model_.number_nodes();
  }

  std::string text() {
    print("$MeshFormat\n{} 0 8\n$EndMeshFormat\n", is_41_ ? "4.1" : "2.2");
    out_ += gmsh_names(model_.groups, 2);
    if (is_41_) write_entities();
    out_ += is_41_ ? gmsh_nodes41(model_) : gmsh_nodes22(model_);
    write_elements();
    out_ += gmsh_periodic(model_, links(), is_41_ ? "16" : "Affine");
    return std::move(out_);
  }

 private:
  int region_of(int elem) const { return model_.groups.block2region[mesh_.quad_block[elem % mesh_.num_quads]]; }
  int surface_group(std::size_t g) const { return 1 + model_.groups.curve2boundary[g]; }
  int volume_group(std::size_t r) const {
    return 1 + model_.groups.num_boundaries() + model_.groups.num_interfaces() + static_cast<int>(r);
  }

  /// A node belongs to the first surface that has it, else to the first region.
  void classify_nodes() {
    model_.entity_nodes[2].resize(faces_.size());
    model_.entity_nodes[3].resize(region_elems_.size());
    std::vector<bool> is_taken(mesh_.nodes.size(), false);
    const auto take = [&](int node, std::vector<int>& nodes) {
      if (!is_taken[node]) nodes.push_back(node);
      is_taken[node] = true;
    };
    for (std::size_t g = 0; g < faces_.size(); ++g)
      for (const GroupFace at : faces_[g])
        for (const int node : face_nodes(mesh_, at.elem, at.face)) take(node, model_.entity_nodes[2][g]);
    const int count = mesh_.nodes_per_elem();
    for (std::size_t r = 0; r < region_elems_.size(); ++r)
      for (const int elem : region_elems_[r])
        for (int k = 0; k < count; ++k) take(elem_node(elem, k), model_.entity_nodes[3][r]);
  }

  int elem_node(int elem, int local) const {
    return mesh_.elem_nodes[static_cast<std::size_t>(elem) * mesh_.nodes_per_elem() + local];
  }

  /// "tag box 1 group 0": without the entities that bound it, which readers do not need.
  void write_entity(std::size_t entity, const GmshBox& box, int group) {
    print("{} ", model_.entity_tag(entity));
    box.append(out_);
    print(" 1 {} 0\n", group);
  }

  void write_entities() {
    print("$Entities\n0 0 {} {}\n", faces_.size(), region_elems_.size());
    for (std::size_t g = 0; g < faces_.size(); ++g) {
      GmshBox box;
      for (const GroupFace at : faces_[g])
        for (const int node : face_nodes(mesh_, at.elem, at.face)) box.add(model_.positions[node]);
      write_entity(g, box, surface_group(g));
    }
    for (std::size_t r = 0; r < region_elems_.size(); ++r) {
      GmshBox box;
      for (const int elem : region_elems_[r])
        for (int k = 0; k < mesh_.nodes_per_elem(); ++k) box.add(model_.positions[elem_node(elem, k)]);
      write_entity(r, box, volume_group(r));
    }
    print("$EndEntities\n");
  }

  /// In 4.1 elements follow the line of their entity, in 2.2 each lists its groups itself.
  void begin_entity(int dim, std::size_t entity, int type, std::size_t count) {
    if (is_41_ && count > 0) print("{} {} {} {}\n", dim, model_.entity_tag(entity), type, count);
  }
  void begin_element(int type, int group, std::size_t entity) {
    print("{}", ++tag_);
    if (!is_41_) print(" {} 2 {} {}", type, group, model_.entity_tag(entity));
  }

  void write_elements() {
    std::size_t count = mesh_.num_elems(), num_entities = 0;
    for (const auto& faces : faces_) count += faces.size(), num_entities += !faces.empty();
    for (const auto& elems : region_elems_) num_entities += !elems.empty();
    if (is_41_)
      print("$Elements\n{} {} 1 {}\n", num_entities, count, count);
    else
      print("$Elements\n{}\n", count);
    for (std::size_t g = 0; g < faces_.size(); ++g) write_faces(g);
    for (std::size_t r = 0; r < region_elems_.size(); ++r) write_hexes(r);
    print("$EndElements\n");
  }

  void write_faces(std::size_t g) {
    const int type = gmsh_quad_type(mesh_.order);
    const std::vector<int> face_order = gmsh_quad_order(mesh_.order);
    begin_entity(2, g, type, faces_[g].size());
    for (const GroupFace at : faces_[g]) {
      begin_element(type, surface_group(g), g);
      const std::vector<int> nodes = face_nodes(mesh_, at.elem, at.face);
      for (const int local : face_order) append_tag(model_.node_tags[nodes[local]], out_);
      out_ += '\n';
    }
  }

  void write_hexes(std::size_t r) {
    const int type = hex_types[mesh_.order];
    begin_entity(3, r, type, region_elems_[r].size());
    for (const int elem : region_elems_[r]) {
      begin_element(type, volume_group(r), r);
      for (const int local : node_order_) append_tag(model_.node_tags[elem_node(elem, local)], out_);
      out_ += '\n';
    }
  }

  /// One for each group that has an image.
  std::vector<GmshPeriodicLink> links() const {
    std::vector<GmshPeriodicLink> all;
    std::vector<bool> is_known;  // of the nodes of the last link
    int group = -1;
    for (const PeriodicFaces& faces : periodic_faces(mesh_)) {
      if (faces.group != group) {
        group = faces.group;
        const HexFaceGroup& first = mesh_.face_groups[group];
        all.push_back({2, first.periodic_with, group, affine_motion(first.motion), {}});
        is_known.assign(mesh_.nodes.size(), false);
      }
      for (const auto& [node, image] : faces.nodes) {
        if (!is_known[image]) all.back().nodes.push_back({image, node});
        is_known[image] = true;
      }
    }
    return all;
  }

  const HexMesh& mesh_;
  bool is_41_;
  std::vector<int> node_order_;
  GmshNodes model_;
  std::vector<std::vector<GroupFace>> faces_;   ///< by group, those of interfaces once
  std::vector<std::vector<int>> region_elems_;  ///< by region
  int tag_ = 0;                                 ///< of the last element written
};

}  // namespace

Exported gmsh_msh41(const HexMesh& mesh) { return {GmshHexWriter(mesh, true).text(), false, {}, {}}; }

Exported gmsh_msh22(const HexMesh& mesh) { return {GmshHexWriter(mesh, false).text(), false, {}, {}}; }

}  // namespace quadrille::exports
