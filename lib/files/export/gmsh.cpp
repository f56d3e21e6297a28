#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "export/gmsh_model.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// Double quotes in a name become single ones.
std::string gmsh_quoted(std::string name) {
  std::replace(name.begin(), name.end(), '"', '\'');
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return '"' + name + '"';
}

/// Positions have the shortest digits that read back to the same bits.
class GmshWriter : TextWriter {
 public:
  GmshWriter(const GmshModel& model, bool is_41)
      : model_(model), is_41_(is_41), tags_before_(is_41 ? 0 : model.num_groups()) {}

  std::string text() {
    print("$MeshFormat\n{} 0 8\n$EndMeshFormat\n", is_41_ ? "4.1" : "2.2");
    write_names();
    if (is_41_) write_entities();
    write_nodes();
    write_elements();
    if (!model_.links.empty()) write_links();
    return std::move(out_);
  }

 private:
  int entity_tag(std::size_t entity) const { return static_cast<int>(entity) + 1 + tags_before_; }

  void print_position(const std::array<double, 3>& x) { print("{} {} {}", x[0], x[1], x[2]); }

  void print_tag(int tag) {
    const fmt::format_int digits(tag);
    out_ += ' ';
    out_.append(digits.data(), digits.size());
  }

  /// Calls `act` with the dimension, the number of the entity and the entity.
  template <typename Act>
  void for_entities(int first_dim, const Act& act) const {
    for (int dim = first_dim; dim <= model_.dimension; ++dim)
      for (std::size_t e = 0; e < model_.entities[dim].size(); ++e) act(dim, e, model_.entities[dim][e]);
  }

  void write_names() {
    print("$PhysicalNames\n{}\n", model_.num_groups());
    int tag = 0;
    for (const std::string& name : boundary_and_interface_names(model_.groups))
      print("{} {} {}\n", model_.dimension - 1, ++tag, gmsh_quoted(name));
    for (const std::string& name : model_.groups.region_names)
      print("{} {} {}\n", model_.dimension, ++tag, gmsh_quoted(name));
    print("$EndPhysicalNames\n");
  }

  void write_entities() {
    const auto& [points, curves, surfaces, volumes] = model_.entities;
    print("$Entities\n{} {} {} {}\n", points.size(), curves.size(), surfaces.size(), volumes.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      print("{} ", p + 1);
      print_position(model_.positions[points[p].own_nodes[0]]);
      print(" 0\n");
    }
    for_entities(1, [&](int, std::size_t e, const GmshEntity& entity) {
      print("{} ", entity_tag(e));
      print_box(entity);
      if (entity.group > 0)
        print(" 1 {} {}", entity.group, entity.bounds.size());
      else
        print(" 0 {}", entity.bounds.size());
      for (const int bound : entity.bounds) print(" {}", bound);
      print("\n");
    });
    print("$EndEntities\n");
  }

  /// The corners of the box around an entity: "x y z x y z".
  void print_box(const GmshEntity& entity) {
    std::array<double, 3> lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
    for (const int node : entity.elem_nodes)
      for (int c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], model_.positions[node][c]);
        upper[c] = std::max(upper[c], model_.positions[node][c]);
      }
    print_position(lower);
    out_ += ' ';
    print_position(upper);
  }

  void write_nodes() {
    const std::size_t count = model_.positions.size();
    std::size_t num_entities = 0;
    for_entities(0, [&](int, std::size_t, const GmshEntity& entity) { num_entities += !entity.own_nodes.empty(); });
    if (is_41_)
      print("$Nodes\n{} {} 1 {}\n", num_entities, count, count);
    else
      print("$Nodes\n{}\n", count);
    for_entities(0, [&](int dim, std::size_t e, const GmshEntity& entity) {
      const std::vector<int>& nodes = entity.own_nodes;
      if (is_41_ && !nodes.empty()) {
        print("{} {} 0 {}\n", dim, e + 1, nodes.size());
        for (const int node : nodes) print("{}\n", model_.node_tags[node]);
      }
      for (const int node : nodes) {
        if (!is_41_) print("{} ", model_.node_tags[node]);
        print_position(model_.positions[node]);
        out_ += '\n';
      }
    });
    print("$EndNodes\n");
  }

  std::size_t num_elements(int dim, const GmshEntity& entity) const {
    return entity.group > 0 ? entity.elem_nodes.size() / model_.node_orders[dim].size() : 0;
  }

  /// In 4.1 elements follow the line of their entity, in 2.2 each lists its groups itself.
  void write_elements() {
    std::size_t count = 0, num_entities = 0;
    for_entities(1, [&](int dim, std::size_t, const GmshEntity& entity) {
      count += num_elements(dim, entity), num_entities += num_elements(dim, entity) > 0;
    });
    if (is_41_)
      print("$Elements\n{} {} 1 {}\n", num_entities, count, count);
    else
      print("$Elements\n{}\n", count);
    int tag = 0;
    for_entities(1, [&](int dim, std::size_t e, const GmshEntity& entity) {
      const std::size_t size = model_.node_orders[dim].size(), num = num_elements(dim, entity);
      if (is_41_ && num > 0) print("{} {} {} {}\n", dim, entity_tag(e), model_.types[dim], num);
      for (std::size_t k = 0; k < num; ++k) {
        print("{}", ++tag);
        if (!is_41_) print(" {} 2 {} {}", model_.types[dim], entity.group, entity_tag(e));
        for (const int local : model_.node_orders[dim])
          print_tag(model_.node_tags[entity.elem_nodes[k * size + local]]);
        out_ += '\n';
      }
    });
    print("$EndElements\n");
  }

  void write_links() {
    print("$Periodic\n{}\n", model_.links.size());
    for (const GmshPeriodicLink& link : model_.links) {
      print("{} {} {}\n{}", link.dim, entity_tag(link.entity), entity_tag(link.master), is_41_ ? "16" : "Affine");
      for (const double number : link.motion) print(" {}", number);
      print("\n{}\n", link.nodes.size());
      for (const auto& [node, master] : link.nodes) print("{} {}\n", model_.node_tags[node], model_.node_tags[master]);
    }
    print("$EndPeriodic\n");
  }

  const GmshModel& model_;
  bool is_41_;
  int tags_before_;  ///< that of the first entity of each dimension
};

Exported gmsh22(const GmshModel& model) { return {GmshWriter(model, false).text(), false, {}, {}}; }

}  // namespace

std::string gmsh41_text(const GmshModel& model) { return GmshWriter(model, true).text(); }

Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame) {
  return {gmsh41_text(gmsh_model(mesh, frame)), false, {}, {}};
}
Exported gmsh_msh41(const HexMesh& mesh) { return {gmsh41_text(gmsh_model(mesh)), false, {}, {}}; }
Exported gmsh_msh22(const QuadMesh& mesh, const Frame& frame) { return gmsh22(gmsh_model(mesh, frame)); }
Exported gmsh_msh22(const HexMesh& mesh) { return gmsh22(gmsh_model(mesh)); }

}  // namespace quadrille::exports
