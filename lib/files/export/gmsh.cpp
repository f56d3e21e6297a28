#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "export/gmsh_model.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

template <class... Args>
void print(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

/// The boundary of each block: the signed tags of its curves, and the box around them.
struct BlockBounds {
  std::vector<std::vector<int>> curves;
  std::vector<GmshBox> boxes;
};

GmshBox box_of_curve(const GmshModel& model, int c) {
  const SkeletonCurve& curve = model.skeleton.curves[c];
  GmshBox box;
  for (const int node : model.entity_nodes[1][c]) box.add(model.positions[node]);
  for (const int point : {curve.from, curve.to}) box.add(model.positions[model.skeleton.points[point]]);
  return box;
}

BlockBounds block_bounds(const GmshModel& model) {
  BlockBounds bounds{std::vector<std::vector<int>>(model.block_elems.size()),
                     std::vector<GmshBox>(model.block_elems.size())};
  for (int c = 0; c < static_cast<int>(model.skeleton.curves.size()); ++c) {
    const GmshBox box = box_of_curve(model, c);
    for (int side = 0; side < 2; ++side) {
      const int block = model.skeleton.curves[c].blocks[side];
      if (block < 0) continue;
      bounds.curves[block].push_back(side == 0 ? c + 1 : -(c + 1));
      bounds.boxes[block].add(box.lower);
      bounds.boxes[block].add(box.upper);
    }
  }
  return bounds;
}

void append_curve_entity(const GmshModel& model, int c, std::string& text) {
  const SkeletonCurve& curve = model.skeleton.curves[c];
  print(text, "{} ", c + 1);
  box_of_curve(model, c).append(text);
  if (curve.cad_curve >= 0)
    print(text, " 1 {}", model.boundary_group(curve.cad_curve));
  else
    text += " 0";
  print(text, " 2 {} {}\n", curve.from + 1, -(curve.to + 1));
}

void append_surface_entity(const GmshModel& model, int block, const std::vector<int>& curves, GmshBox box,
                           std::string& text) {
  for (const int node : model.entity_nodes[2][block]) box.add(model.positions[node]);
  print(text, "{} ", block + 1);
  box.append(text);
  print(text, " 1 {} {}", model.region_group(block), curves.size());
  for (const int curve : curves) print(text, " {}", curve);
  text += '\n';
}

void append_entities(const GmshModel& model, std::string& text) {
  const Skeleton& skeleton = model.skeleton;
  const BlockBounds bounds = block_bounds(model);
  print(text, "$Entities\n{} {} {} 0\n", skeleton.points.size(), skeleton.curves.size(), model.block_elems.size());
  for (std::size_t p = 0; p < skeleton.points.size(); ++p) {
    print(text, "{} ", p + 1);
    append_position(model.positions[skeleton.points[p]], text);
    text += " 0\n";
  }
  for (std::size_t c = 0; c < skeleton.curves.size(); ++c) append_curve_entity(model, static_cast<int>(c), text);
  for (std::size_t b = 0; b < model.block_elems.size(); ++b)
    append_surface_entity(model, static_cast<int>(b), bounds.curves[b], bounds.boxes[b], text);
  text += "$EndEntities\n";
}

/// `tag`: the tag of the last element written.
void append_lines(const GmshModel& model, const QuadMesh& mesh, int c, int& tag, std::string& text) {
  const SkeletonCurve& curve = model.skeleton.curves[c];
  if (curve.cad_curve < 0) return;
  print(text, "1 {} {} {}\n", c + 1, model.line_type, curve.edges.size());
  for (const SkeletonEdge& e : curve.edges) {
    print(text, "{}", ++tag);
    append_gmsh_line(model, mesh, e, text);
  }
}

void append_quads(const GmshModel& model, const QuadMesh& mesh, int block, int& tag, std::string& text) {
  const std::vector<int>& elems = model.block_elems[block];
  if (elems.empty()) return;
  print(text, "2 {} {} {}\n", block + 1, model.quad_type, elems.size());
  for (const int elem : elems) {
    print(text, "{}", ++tag);
    append_gmsh_quad(model, mesh, elem, text);
  }
}

void append_elements(const GmshModel& model, const QuadMesh& mesh, std::string& text) {
  std::size_t num_lines = 0, num_entities = 0;
  for (const SkeletonCurve& curve : model.skeleton.curves)
    if (curve.cad_curve >= 0) num_lines += curve.edges.size(), ++num_entities;
  for (const auto& elems : model.block_elems) num_entities += !elems.empty();
  const std::size_t count = num_lines + mesh.num_elems();
  print(text, "$Elements\n{} {} 1 {}\n", num_entities, count, count);
  int tag = 0;
  for (std::size_t c = 0; c < model.skeleton.curves.size(); ++c)
    append_lines(model, mesh, static_cast<int>(c), tag, text);
  for (std::size_t b = 0; b < model.block_elems.size(); ++b) append_quads(model, mesh, static_cast<int>(b), tag, text);
  text += "$EndElements\n";
}

/// "tag type 2 physical elementary nodes": in this version each element lists its groups itself.
std::string elements_section(const GmshModel& model, const QuadMesh& mesh) {
  std::string text = fmt::format(
      "$Elements\n{}\n", mesh.boundary_edges.size() + interface_edges_once(mesh).size() + mesh.elem_block.size());
  int tag = 0;
  const auto begin = [&](int type, int group, std::size_t entity) {
    fmt::format_to(std::back_inserter(text), "{} {} 2 {} {}", ++tag, type, group, model.entity_tag(entity));
  };
  for (std::size_t c = 0; c < model.skeleton.curves.size(); ++c) {
    const SkeletonCurve& curve = model.skeleton.curves[c];
    if (curve.cad_curve < 0) continue;
    for (const SkeletonEdge& e : curve.edges) {
      begin(model.line_type, model.boundary_group(curve.cad_curve), c);
      append_gmsh_line(model, mesh, e, text);
    }
  }
  for (std::size_t block = 0; block < model.block_elems.size(); ++block)
    for (const int elem : model.block_elems[block]) {
      begin(model.quad_type, model.region_group(static_cast<int>(block)), block);
      append_gmsh_quad(model, mesh, elem, text);
    }
  text += "$EndElements\n";
  return text;
}

}  // namespace

std::string gmsh41_text(const GmshModel& model, const QuadMesh& mesh, const Frame& frame) {
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + gmsh_names(model.groups);
  append_entities(model, text);
  text += gmsh_nodes41(model);
  append_elements(model, mesh, text);
  text += gmsh_periodic(model, periodic_links(model, mesh, frame), "16");
  return text;
}

Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame) {
  return {gmsh41_text(gmsh_model(mesh, frame), mesh, frame), false, {}, {}};
}

Exported gmsh_msh22(const QuadMesh& mesh, const Frame& frame) {
  GmshModel model = gmsh_model(mesh, frame);
  model.tags_before = model.num_groups();
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + gmsh_names(model.groups);
  text += gmsh_nodes22(model);
  text += elements_section(model, mesh);
  text += gmsh_periodic(model, periodic_links(model, mesh, frame), "Affine");
  return {std::move(text), false, {}, {}};
}

}  // namespace quadrille::exports
