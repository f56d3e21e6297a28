#include "export/gmsh_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "export/periodic_edges.hpp"
#include "export/renode.hpp"

namespace quadrille::exports {

namespace {

constexpr int max_order = 10;
constexpr std::array<int, max_order + 1> line_types{0, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
constexpr std::array<int, max_order + 1> quad_types{0, 3, 10, 36, 37, 38, 47, 48, 49, 50, 51};

void classify_nodes(const QuadMesh& mesh, GmshModel& model) {
  auto& entity_nodes = model.entity_nodes;
  entity_nodes[0].resize(model.skeleton.points.size());
  entity_nodes[1].resize(model.skeleton.curves.size());
  entity_nodes[2].resize(mesh.block_names.size());
  std::vector<bool> taken(mesh.nodes.size(), false);
  const auto take = [&](int dim, std::size_t entity, int node) {
    if (!taken[node]) entity_nodes[dim][entity].push_back(node);
    taken[node] = true;
  };
  for (std::size_t p = 0; p < entity_nodes[0].size(); ++p) take(0, p, model.skeleton.points[p]);
  for (std::size_t c = 0; c < entity_nodes[1].size(); ++c)
    for (const SkeletonEdge& e : model.skeleton.curves[c].edges)
      for (const int node : side_nodes(mesh, e.elem, e.side)) take(1, c, node);
  const int count = mesh.nodes_per_elem();
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int k = 0; k < count; ++k) take(2, mesh.elem_block[elem], mesh.elem_nodes[elem * count + k]);
}

std::string quoted(std::string name) {
  std::replace(name.begin(), name.end(), '"', '\'');
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return '"' + name + '"';
}

// The links of curves by the side of an element.
using SideTable = std::map<std::pair<int, int>, int>;

SideTable curves_by_side(const GmshModel& model) {
  SideTable table;
  for (std::size_t c = 0; c < model.skeleton.curves.size(); ++c)
    if (model.skeleton.curves[c].is_boundary())
      for (const SkeletonEdge& e : model.skeleton.curves[c].edges) table[{e.elem, e.side}] = static_cast<int>(c);
  return table;
}

}  // namespace

std::vector<int> gmsh_quad_order(int order) {
  std::vector<int> node_order;
  const auto add = [&](int i, int j) { node_order.push_back(j * (order + 1) + i); };
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
  return node_order;
}

int gmsh_quad_type(int order) { return quad_types[order]; }

void GmshNodes::number_nodes() {
  node_tags.assign(positions.size(), 0);
  int tag = 0;
  for (const auto& entities : entity_nodes)
    for (const auto& nodes : entities)
      for (const int node : nodes) node_tags[node] = ++tag;
}

GmshModel gmsh_model(const QuadMesh& mesh, const Frame& frame) {
  GmshModel model;
  model.skeleton = mesh_skeleton(mesh);
  model.groups = mesh_groups(mesh);
  model.positions = positions(mesh, frame, ElementPoints::equispaced);
  classify_nodes(mesh, model);
  model.number_nodes();
  model.block_elems.resize(mesh.block_names.size());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) model.block_elems[mesh.elem_block[elem]].push_back(elem);
  model.quad_node_order = gmsh_quad_order(mesh.order);
  model.line_type = line_types[mesh.order], model.quad_type = gmsh_quad_type(mesh.order);
  return model;
}

std::string gmsh_names(const Groups& groups, int dim) {
  std::string text =
      fmt::format("$PhysicalNames\n{}\n", groups.num_boundaries() + groups.num_interfaces() + groups.num_regions());
  int tag = 0;
  for (const std::string& name : boundary_and_interface_names(groups))
    text += fmt::format("{} {} {}\n", dim, ++tag, quoted(name));
  for (const std::string& name : groups.region_names) text += fmt::format("{} {} {}\n", dim + 1, ++tag, quoted(name));
  return text + "$EndPhysicalNames\n";
}

void append_gmsh_line(const GmshModel& model, const QuadMesh& mesh, const SkeletonEdge& edge, std::string& text) {
  const std::vector<int> nodes = side_nodes(mesh, edge.elem, edge.side);
  append_tag(model.node_tags[nodes.front()], text);
  append_tag(model.node_tags[nodes.back()], text);
  for (int k = 1; k < mesh.order; ++k) append_tag(model.node_tags[nodes[k]], text);
  text += '\n';
}

void append_gmsh_quad(const GmshModel& model, const QuadMesh& mesh, int elem, std::string& text) {
  const int* nodes = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
  for (const int local : model.quad_node_order) append_tag(model.node_tags[nodes[local]], text);
  text += '\n';
}

void append_tag(int tag, std::string& text) {
  const fmt::format_int digits(tag);
  text += ' ';
  text.append(digits.data(), digits.size());
}

void GmshBox::add(const std::array<double, 3>& x) {
  for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], x[k]), upper[k] = std::max(upper[k], x[k]);
}

void GmshBox::append(std::string& text) const {
  append_position(lower, text);
  text += ' ';
  append_position(upper, text);
}

void append_position(const std::array<double, 3>& x, std::string& text) {
  fmt::format_to(std::back_inserter(text), "{} {} {}", x[0], x[1], x[2]);
}

std::string gmsh_nodes41(const GmshNodes& model) {
  std::size_t num_entities = 0;
  for (const auto& entities : model.entity_nodes)
    for (const auto& nodes : entities) num_entities += !nodes.empty();
  const std::size_t count = model.positions.size();
  std::string text = fmt::format("$Nodes\n{} {} 1 {}\n", num_entities, count, count);
  for (std::size_t dim = 0; dim < model.entity_nodes.size(); ++dim)
    for (std::size_t e = 0; e < model.entity_nodes[dim].size(); ++e) {
      const std::vector<int>& nodes = model.entity_nodes[dim][e];
      if (nodes.empty()) continue;
      fmt::format_to(std::back_inserter(text), "{} {} 0 {}\n", dim, e + 1, nodes.size());
      for (const int node : nodes) fmt::format_to(std::back_inserter(text), "{}\n", model.node_tags[node]);
      for (const int node : nodes) append_position(model.positions[node], text), text += '\n';
    }
  return text + "$EndNodes\n";
}

std::string gmsh_nodes22(const GmshNodes& model) {
  std::string text = fmt::format("$Nodes\n{}\n", model.positions.size());
  for (const auto& entities : model.entity_nodes)
    for (const auto& nodes : entities)
      for (const int node : nodes) {
        fmt::format_to(std::back_inserter(text), "{} ", model.node_tags[node]);
        append_position(model.positions[node], text);
        text += '\n';
      }
  return text + "$EndNodes\n";
}

// A point that is the image of several has one link.
std::vector<GmshPeriodicLink> periodic_links(const GmshModel& model, const QuadMesh& mesh, const Frame& frame) {
  const SideTable curves = curves_by_side(model);
  std::map<int, GmshPeriodicLink> points, links;  // by the entity
  std::map<int, int> point_of_node;
  for (std::size_t p = 0; p < model.skeleton.points.size(); ++p)
    point_of_node[model.skeleton.points[p]] = static_cast<int>(p);
  std::set<std::pair<int, int>> known;  // the curve and the node
  for (const PeriodicEdges& edges : periodic_edges(mesh)) {
    const QuadBoundaryEdge &first = mesh.boundary_edges[edges.first], &second = mesh.boundary_edges[edges.second];
    const int master = curves.at({first.elem, first.side}), curve = curves.at({second.elem, second.side});
    GmshPeriodicLink& link =
        links.try_emplace(curve, GmshPeriodicLink{1, curve, master, affine_motion(mesh.face, edges.pair, frame), {}})
            .first->second;
    const std::vector<int> from = side_nodes(mesh, first.elem, first.side);
    const std::vector<int> to = side_nodes(mesh, second.elem, second.side);
    for (int k = 0; k <= mesh.order; ++k) {
      const int node = to[k], of = from[mesh.order - k];
      if (known.insert({curve, node}).second) link.nodes.push_back({node, of});
      const auto point = point_of_node.find(node), origin = point_of_node.find(of);
      if (point == point_of_node.end() || origin == point_of_node.end() || node == of) continue;
      points.try_emplace(point->second, GmshPeriodicLink{0, point->second, origin->second, link.motion, {{node, of}}});
    }
  }
  std::vector<GmshPeriodicLink> all;
  for (const auto* of : {&points, &links})
    for (const auto& [entity, link] : *of) all.push_back(link);
  return all;
}

std::string gmsh_periodic(const GmshNodes& model, const std::vector<GmshPeriodicLink>& links, const char* motion) {
  if (links.empty()) return {};
  std::string text = fmt::format("$Periodic\n{}\n", links.size());
  const auto out = std::back_inserter(text);
  for (const GmshPeriodicLink& link : links) {
    fmt::format_to(out, "{} {} {}\n{}", link.dim, model.entity_tag(link.entity), model.entity_tag(link.master), motion);
    for (const double number : link.motion) fmt::format_to(out, " {}", number);
    fmt::format_to(out, "\n{}\n", link.nodes.size());
    for (const auto& [node, master] : link.nodes)
      fmt::format_to(out, "{} {}\n", model.node_tags[node], model.node_tags[master]);
  }
  return text + "$EndPeriodic\n";
}

}  // namespace quadrille::exports
