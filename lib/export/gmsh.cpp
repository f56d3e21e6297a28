#include "export/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "base/error.hpp"
#include "export/equispaced.hpp"
#include "export/skeleton.hpp"

namespace quadrille {
namespace {

constexpr int max_order = 10;
constexpr std::array<int, max_order + 1> line_types{0, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
constexpr std::array<int, max_order + 1> quad_types{0, 3, 10, 36, 37, 38, 47, 48, 49, 50, 51};

/// Gmsh's sequence of the nodes of a quad: corners, sides (all travelling round), then the same again inside.
std::vector<int> quad_node_sequence(int order) {
  std::vector<int> sequence;
  const auto add = [&](int i, int j) { sequence.push_back(j * (order + 1) + i); };
  for (int low = 0, high = order; low <= high; ++low, --high) {
    if (low == high) {
      add(low, low);
      break;
    }
    add(low, low), add(high, low), add(high, high), add(low, high);
    for (int k = low + 1; k < high; ++k) add(k, low);
    for (int k = low + 1; k < high; ++k) add(high, k);
    for (int k = high - 1; k > low; --k) add(k, high);
    for (int k = high - 1; k > low; --k) add(low, k);
  }
  return sequence;
}

struct Box {
  Vec2 lower{1e300, 1e300}, upper{-1e300, -1e300};
  void add(Vec2 x) {
    lower = {std::min(lower.x, x.x), std::min(lower.y, x.y)};
    upper = {std::max(upper.x, x.x), std::max(upper.y, x.y)};
  }
};

class Writer {
 public:
  explicit Writer(const QuadMesh& mesh)
      : mesh_(mesh), skeleton_(mesh_skeleton(mesh)), positions_(equispaced_nodes(mesh)) {
    for (Vec2& x : positions_) x += mesh.face.origin;
    name_groups();
    classify_nodes();
  }

  std::string text() {
    print("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    write_names();
    write_entities();
    write_nodes();
    write_elements();
    return fmt::to_string(out_);
  }

 private:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  int num_blocks() const { return static_cast<int>(mesh_.block_names.size()); }

  std::string curve_name(int curve) const {
    const std::string& name = mesh_.face.curve_names[curve];
    return name.empty() ? fmt::format("curve_{}", curve) : name;
  }

  /// Boundary groups get the first numbers, in the sequence of the curves; each block is a group of its own.
  void name_groups() {
    std::map<std::string, int> tags;
    for (int curve = 0; curve < mesh_.face.num_curves(); ++curve) {
      const auto [group, is_new] = tags.try_emplace(curve_name(curve), static_cast<int>(group_names_.size()) + 1);
      if (is_new) group_names_.push_back(group->first);
      curve_group_.push_back(group->second);
    }
  }

  int block_group(int block) const { return static_cast<int>(group_names_.size()) + 1 + block; }

  /// A node belongs to the entity of lowest dimension that holds it.
  void classify_nodes() {
    entity_nodes_[0].resize(skeleton_.points.size());
    entity_nodes_[1].resize(skeleton_.curves.size());
    entity_nodes_[2].resize(num_blocks());
    std::vector<bool> taken(mesh_.nodes.size(), false);
    const auto take = [&](int dim, int entity, int node) {
      if (!taken[node]) entity_nodes_[dim][entity].push_back(node);
      taken[node] = true;
    };
    for (std::size_t p = 0; p < skeleton_.points.size(); ++p) take(0, static_cast<int>(p), skeleton_.points[p]);
    for (std::size_t c = 0; c < skeleton_.curves.size(); ++c)
      for (const SkeletonEdge& e : skeleton_.curves[c].edges)
        for (const int node : side_nodes(mesh_, e.elem, e.side)) take(1, static_cast<int>(c), node);
    const int count = mesh_.nodes_per_elem();
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int k = 0; k < count; ++k) take(2, mesh_.elem_block[elem], mesh_.elem_nodes[elem * count + k]);
  }

  static std::string quoted(std::string name) {
    std::replace(name.begin(), name.end(), '"', '\'');
    return name;
  }

  void write_names() {
    print("$PhysicalNames\n{}\n", group_names_.size() + mesh_.block_names.size());
    for (std::size_t g = 0; g < group_names_.size(); ++g) print("1 {} \"{}\"\n", g + 1, quoted(group_names_[g]));
    for (int b = 0; b < num_blocks(); ++b) print("2 {} \"{}\"\n", block_group(b), quoted(mesh_.block_names[b]));
    print("$EndPhysicalNames\n");
  }

  void write_box(const Box& box) { print("{} {} 0 {} {} 0", box.lower.x, box.lower.y, box.upper.x, box.upper.y); }

  void write_entities() {
    print("$Entities\n{} {} {} 0\n", skeleton_.points.size(), skeleton_.curves.size(), num_blocks());
    for (std::size_t p = 0; p < skeleton_.points.size(); ++p) {
      const Vec2 x = positions_[skeleton_.points[p]];
      print("{} {} {} 0 0\n", p + 1, x.x, x.y);
    }
    std::vector<std::vector<int>> bounding(num_blocks());
    std::vector<Box> block_box(num_blocks());
    for (std::size_t c = 0; c < skeleton_.curves.size(); ++c)
      write_curve_entity(static_cast<int>(c), bounding, block_box);
    for (int b = 0; b < num_blocks(); ++b) {
      for (const int node : entity_nodes_[2][b]) block_box[b].add(positions_[node]);
      print("{} ", b + 1);
      write_box(block_box[b]);
      print(" 1 {} {}", block_group(b), bounding[b].size());
      for (const int curve : bounding[b]) print(" {}", curve);
      print("\n");
    }
    print("$EndEntities\n");
  }

  void write_curve_entity(int c, std::vector<std::vector<int>>& bounding, std::vector<Box>& block_box) {
    const SkeletonCurve& curve = skeleton_.curves[c];
    Box box;
    for (const int node : entity_nodes_[1][c]) box.add(positions_[node]);
    for (const int point : {curve.from, curve.to}) box.add(positions_[skeleton_.points[point]]);
    for (int side = 0; side < 2; ++side) {
      const int block = curve.blocks[side];
      if (block < 0) continue;
      bounding[block].push_back(side == 0 ? c + 1 : -(c + 1));
      block_box[block].add(box.lower);
      block_box[block].add(box.upper);
    }
    print("{} ", c + 1);
    write_box(box);
    if (curve.cad_curve >= 0)
      print(" 1 {}", curve_group_[curve.cad_curve]);
    else
      print(" 0");
    print(" 2 {} {}\n", curve.from + 1, -(curve.to + 1));
  }

  void write_nodes() {
    std::size_t num_nodes = 0, num_entities = 0;
    for (const auto& entities : entity_nodes_)
      for (const auto& nodes : entities) num_nodes += nodes.size(), num_entities += !nodes.empty();
    print("$Nodes\n{} {} 1 {}\n", num_entities, num_nodes, num_nodes);
    node_tag_.assign(mesh_.nodes.size(), 0);
    int tag = 0;
    for (int dim = 0; dim < 3; ++dim)
      for (std::size_t e = 0; e < entity_nodes_[dim].size(); ++e) {
        const std::vector<int>& nodes = entity_nodes_[dim][e];
        if (nodes.empty()) continue;
        print("{} {} 0 {}\n", dim, e + 1, nodes.size());
        for (const int node : nodes) print("{}\n", node_tag_[node] = ++tag);
        for (const int node : nodes) print("{} {} 0\n", positions_[node].x, positions_[node].y);
      }
    print("$EndNodes\n");
  }

  void write_elements() {
    std::size_t num_lines = 0, num_line_entities = 0;
    for (const SkeletonCurve& curve : skeleton_.curves)
      if (curve.cad_curve >= 0) num_lines += curve.edges.size(), ++num_line_entities;
    std::vector<std::vector<int>> block_elems(num_blocks());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) block_elems[mesh_.elem_block[elem]].push_back(elem);
    const auto num_surfaces =
        std::count_if(block_elems.begin(), block_elems.end(), [](const auto& elems) { return !elems.empty(); });
    const std::size_t count = num_lines + mesh_.num_elems();
    print("$Elements\n{} {} 1 {}\n", num_line_entities + num_surfaces, count, count);
    int tag = 0;
    for (std::size_t c = 0; c < skeleton_.curves.size(); ++c) write_lines(static_cast<int>(c), tag);
    for (int b = 0; b < num_blocks(); ++b) write_quads(b, block_elems[b], tag);
    print("$EndElements\n");
  }

  void write_lines(int c, int& tag) {
    const SkeletonCurve& curve = skeleton_.curves[c];
    if (curve.cad_curve < 0) return;
    print("1 {} {} {}\n", c + 1, line_types[mesh_.order], curve.edges.size());
    for (const SkeletonEdge& e : curve.edges) {
      const std::vector<int> nodes = side_nodes(mesh_, e.elem, e.side);
      print("{} {} {}", ++tag, node_tag_[nodes.front()], node_tag_[nodes.back()]);
      for (int k = 1; k < mesh_.order; ++k) print(" {}", node_tag_[nodes[k]]);
      print("\n");
    }
  }

  void write_quads(int block, const std::vector<int>& elems, int& tag) {
    if (elems.empty()) return;
    const std::vector<int> sequence = quad_node_sequence(mesh_.order);
    print("2 {} {} {}\n", block + 1, quad_types[mesh_.order], elems.size());
    for (const int elem : elems) {
      print("{}", ++tag);
      for (const int local : sequence) print(" {}", node_tag_[mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + local]]);
      print("\n");
    }
  }

  const QuadMesh& mesh_;
  Skeleton skeleton_;
  std::vector<Vec2> positions_;
  std::vector<std::string> group_names_;
  std::vector<int> curve_group_, node_tag_;
  std::array<std::vector<std::vector<int>>, 3> entity_nodes_;  ///< by dimension and entity
  fmt::memory_buffer out_;
};

}  // namespace

std::string gmsh_msh41(const QuadMesh& mesh) {
  if (mesh.order > max_order)
    throw ComputeError(fmt::format(
        "Gmsh knows quads up to order {}, this mesh has order {}; refine with a lower --order", max_order, mesh.order));
  return Writer(mesh).text();
}

}  // namespace quadrille
