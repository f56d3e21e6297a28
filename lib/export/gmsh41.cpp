#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "export/gmsh.hpp"
#include "export/gmsh_model.hpp"

namespace quadrille::exports {
namespace {

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
      : mesh_(mesh), model_(gmsh_model(mesh, frame)), bounding_(num_blocks()), block_box_(num_blocks()) {}

  std::string text() {
    text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + gmsh_names(model_.groups);
    write_entities();
    write_nodes();
    write_elements();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  std::size_t num_blocks() const { return model_.block_elems.size(); }

  void write_box(const Box& box) {
    append_position(box.lower, text_);
    text_ += ' ';
    append_position(box.upper, text_);
  }

  void write_entities() {
    const Skeleton& skeleton = model_.skeleton;
    print("$Entities\n{} {} {} 0\n", skeleton.points.size(), skeleton.curves.size(), num_blocks());
    for (std::size_t p = 0; p < skeleton.points.size(); ++p) {
      print("{} ", p + 1);
      append_position(model_.positions[skeleton.points[p]], text_);
      text_ += " 0\n";
    }
    for (std::size_t c = 0; c < skeleton.curves.size(); ++c) write_curve_entity(static_cast<int>(c));
    for (std::size_t b = 0; b < num_blocks(); ++b) write_surface_entity(static_cast<int>(b));
    text_ += "$EndEntities\n";
  }

  void write_curve_entity(int c) {
    const SkeletonCurve& curve = model_.skeleton.curves[c];
    Box box;
    for (const int node : model_.entity_nodes[1][c]) box.add(model_.positions[node]);
    for (const int point : {curve.from, curve.to}) box.add(model_.positions[model_.skeleton.points[point]]);
    for (int side = 0; side < 2; ++side) {
      const int block = curve.blocks[side];
      if (block < 0) continue;
      bounding_[block].push_back(side == 0 ? c + 1 : -(c + 1));
      block_box_[block].add(box.lower);
      block_box_[block].add(box.upper);
    }
    print("{} ", c + 1);
    write_box(box);
    if (curve.cad_curve >= 0)
      print(" 1 {}", model_.boundary_group(curve.cad_curve));
    else
      text_ += " 0";
    print(" 2 {} {}\n", curve.from + 1, -(curve.to + 1));
  }

  void write_surface_entity(int block) {
    for (const int node : model_.entity_nodes[2][block]) block_box_[block].add(model_.positions[node]);
    print("{} ", block + 1);
    write_box(block_box_[block]);
    print(" 1 {} {}", model_.region_group(block), bounding_[block].size());
    for (const int curve : bounding_[block]) print(" {}", curve);
    text_ += '\n';
  }

  void write_nodes() {
    std::size_t num_entities = 0;
    for (const auto& entities : model_.entity_nodes)
      for (const auto& nodes : entities) num_entities += !nodes.empty();
    print("$Nodes\n{} {} 1 {}\n", num_entities, mesh_.nodes.size(), mesh_.nodes.size());
    for (int dim = 0; dim < 3; ++dim)
      for (std::size_t e = 0; e < model_.entity_nodes[dim].size(); ++e) {
        const std::vector<int>& nodes = model_.entity_nodes[dim][e];
        if (nodes.empty()) continue;
        print("{} {} 0 {}\n", dim, e + 1, nodes.size());
        for (const int node : nodes) print("{}\n", model_.node_tags[node]);
        for (const int node : nodes) append_position(model_.positions[node], text_), text_ += '\n';
      }
    text_ += "$EndNodes\n";
  }

  void write_elements() {
    std::size_t num_lines = 0, num_entities = 0;
    for (const SkeletonCurve& curve : model_.skeleton.curves)
      if (curve.cad_curve >= 0) num_lines += curve.edges.size(), ++num_entities;
    for (const auto& elems : model_.block_elems) num_entities += !elems.empty();
    const std::size_t count = num_lines + mesh_.num_elems();
    print("$Elements\n{} {} 1 {}\n", num_entities, count, count);
    int tag = 0;
    for (std::size_t c = 0; c < model_.skeleton.curves.size(); ++c) write_lines(static_cast<int>(c), tag);
    for (std::size_t b = 0; b < num_blocks(); ++b) write_quads(static_cast<int>(b), tag);
    text_ += "$EndElements\n";
  }

  void write_lines(int c, int& tag) {
    const SkeletonCurve& curve = model_.skeleton.curves[c];
    if (curve.cad_curve < 0) return;
    print("1 {} {} {}\n", c + 1, model_.line_type, curve.edges.size());
    for (const SkeletonEdge& e : curve.edges) {
      print("{}", ++tag);
      append_gmsh_line(model_, mesh_, e, text_);
    }
  }

  void write_quads(int block, int& tag) {
    const std::vector<int>& elems = model_.block_elems[block];
    if (elems.empty()) return;
    print("2 {} {} {}\n", block + 1, model_.quad_type, elems.size());
    for (const int elem : elems) {
      print("{}", ++tag);
      append_gmsh_quad(model_, mesh_, elem, text_);
    }
  }

  const QuadMesh& mesh_;
  const GmshModel model_;
  std::vector<std::vector<int>> bounding_;  ///< signed tags of the curves around each block
  std::vector<Box> block_box_;
  std::string text_;
};

}  // namespace

Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame) { return {Writer(mesh, frame).text(), false, {}, {}}; }

}  // namespace quadrille::exports
