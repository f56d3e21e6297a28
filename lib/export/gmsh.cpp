#include "export/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "export/equispaced.hpp"
#include "export/groups.hpp"
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

using Position = std::array<double, 3>;

struct Box {
  Position lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
  void add(const Position& x) {
    for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], x[k]), upper[k] = std::max(upper[k], x[k]);
  }
};

class Writer {
 public:
  Writer(const QuadMesh& mesh, const Frame& frame)
      : mesh_(mesh), skeleton_(mesh_skeleton(mesh)), groups_(mesh_groups(mesh)) {
    for (const Vec2 x : equispaced_nodes(mesh)) positions_.push_back(frame.at(x));
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

  /// Boundary groups get the first numbers, regions the next.
  int boundary_group(int curve) const { return 1 + groups_.curve2boundary[curve]; }
  int region_group(int block) const { return 1 + groups_.num_boundaries() + groups_.block2region[block]; }

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
    print("$PhysicalNames\n{}\n", groups_.num_boundaries() + groups_.num_regions());
    int tag = 0;
    for (const std::string& name : groups_.boundary_names) print("1 {} \"{}\"\n", ++tag, quoted(name));
    for (const std::string& name : groups_.region_names) print("2 {} \"{}\"\n", ++tag, quoted(name));
    print("$EndPhysicalNames\n");
  }

  void write_position(const Position& x) { print("{} {} {}", x[0], x[1], x[2]); }
  void write_box(const Box& box) { write_position(box.lower), print(" "), write_position(box.upper); }

  void write_entities() {
    print("$Entities\n{} {} {} 0\n", skeleton_.points.size(), skeleton_.curves.size(), num_blocks());
    for (std::size_t p = 0; p < skeleton_.points.size(); ++p) {
      print("{} ", p + 1);
      write_position(positions_[skeleton_.points[p]]);
      print(" 0\n");
    }
    std::vector<std::vector<int>> bounding(num_blocks());
    std::vector<Box> block_box(num_blocks());
    for (std::size_t c = 0; c < skeleton_.curves.size(); ++c)
      write_curve_entity(static_cast<int>(c), bounding, block_box);
    for (int b = 0; b < num_blocks(); ++b) {
      for (const int node : entity_nodes_[2][b]) block_box[b].add(positions_[node]);
      print("{} ", b + 1);
      write_box(block_box[b]);
      print(" 1 {} {}", region_group(b), bounding[b].size());
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
      print(" 1 {}", boundary_group(curve.cad_curve));
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
        for (const int node : nodes) write_position(positions_[node]), print("\n");
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
  Groups groups_;
  std::vector<Position> positions_;
  std::vector<int> node_tag_;
  std::array<std::vector<std::vector<int>>, 3> entity_nodes_;  ///< by dimension and entity
  fmt::memory_buffer out_;
};

}  // namespace

Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame) { return {Writer(mesh, frame).text(), false, {}, {}}; }

}  // namespace quadrille
