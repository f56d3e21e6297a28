#include <algorithm>
#include <array>

#include "check/rules.hpp"
#include "model/interfaces.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::check {

namespace {

std::size_t nodes_per_elem(const QuadMesh& mesh) { return static_cast<std::size_t>(mesh.nodes_per_elem()); }

void arrays_agree(const QuadMesh& mesh, Findings& findings) {
  if (mesh.order < 1 || mesh.order > 30) return findings.add("order {} is outside 1 to 30", mesh.order);
  const std::size_t n = mesh.elem_block.size();
  if (n == 0) findings.add("the mesh has no elements");
  if (mesh.elem_nodes.size() != n * nodes_per_elem(mesh))
    findings.add("elem_nodes has {} entries, not {} for each of {} elements", mesh.elem_nodes.size(),
                 nodes_per_elem(mesh), n);
  if (mesh.elem_jacobian_bound.size() != n || mesh.elem_scaled_jacobian.size() != n)
    findings.add("elem_jacobian_bound and elem_scaled_jacobian must have one entry for each of {} elements", n);
  const std::size_t stored = mesh.elem_edge_ratio.empty() && mesh.elem_area_jump.empty() ? 0 : n;
  if (mesh.elem_edge_ratio.size() != stored || mesh.elem_area_jump.size() != stored ||
      mesh.elem_node_distance.size() != stored)
    findings.add("elem_edge_ratio, elem_area_jump and elem_node_distance must have one entry for each of {} elements",
                 n);
  if (!mesh.elem_prescribed_length.empty() && mesh.elem_prescribed_length.size() != n)
    findings.add("elem_prescribed_length has {} entries for {} elements", mesh.elem_prescribed_length.size(), n);
  if (const std::size_t expected = mesh.face.chart ? mesh.nodes.size() : 0; mesh.space_nodes.size() != expected)
    findings.add("space_nodes has {} entries, not {}: one for each node of a curved face", mesh.space_nodes.size(),
                 expected);
  if (!mesh.elem_prescribed_stretch.empty() && mesh.elem_prescribed_stretch.size() != n)
    findings.add("elem_prescribed_stretch has {} entries for {} elements", mesh.elem_prescribed_stretch.size(), n);
  if (!are_ascending_indices(mesh.unnamed_blocks, mesh.block_names.size()))
    findings.add("unnamed_blocks must be blocks in ascending order, each once");
}

void indices_exist(const QuadMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.elem_nodes.size(); ++i)
    if (!is_index(mesh.elem_nodes[i], mesh.nodes.size()))
      findings.add("element {}: node {} does not exist", i / nodes_per_elem(mesh), mesh.elem_nodes[i]);
  for (std::size_t e = 0; e < mesh.elem_block.size(); ++e)
    if (!is_index(mesh.elem_block[e], mesh.block_names.size()))
      findings.add("element {}: block {} does not exist", e, mesh.elem_block[e]);
  const auto exist = [&](const std::vector<QuadBoundaryEdge>& edges, const char* kind) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (!is_index(edges[i].elem, mesh.elem_block.size()) || !is_index(edges[i].side, 4) ||
          !is_index(edges[i].curve, mesh.face.curves.size()))
        findings.add("{} edge {} names an element, side or curve that does not exist", kind, i);
  };
  exist(mesh.boundary_edges, "boundary");
  exist(mesh.interface_edges, "interface");
}

void numbers_are_finite(const QuadMesh& mesh, Findings& findings) {
  if (!are_finite(mesh.space_nodes)) findings.add("space_nodes contain a number that is not finite");
  if (!are_finite(mesh.nodes)) findings.add("nodes contain a number that is not finite");
  if (!are_finite(mesh.elem_jacobian_bound) || !are_finite(mesh.elem_scaled_jacobian))
    findings.add("elem_jacobian_bound or elem_scaled_jacobian contains a number that is not finite");
}

void stored_bounds_are_positive(const QuadMesh& mesh, Findings& findings) {
  if (!mesh.is_valid) return;
  for (std::size_t e = 0; e < mesh.elem_jacobian_bound.size(); ++e)
    if (!(mesh.elem_jacobian_bound[e] > 0) || !(mesh.elem_scaled_jacobian[e] > 0) ||
        mesh.elem_scaled_jacobian[e] > 1 + 1e-12)
      findings.add("element {}: its Jacobian bound must be positive, its scaled Jacobian in (0, 1], at {}", e,
                   position_text(mesh.face, mesh.nodes[side_node(mesh, static_cast<int>(e), 0, 0)]));
}

/// A side of an element, with its corners as the sort key.
struct Side {
  int low, high, elem, side;
  auto operator<=>(const Side&) const = default;
};

std::vector<Side> sorted_sides(const QuadMesh& mesh) {
  std::vector<Side> all;
  all.reserve(4 * mesh.elem_block.size());
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 4; ++k) {
      const int a = side_node(mesh, e, k, 0), b = side_node(mesh, e, k, mesh.order);
      all.push_back({std::min(a, b), std::max(a, b), e, k});
    }
  std::sort(all.begin(), all.end());
  return all;
}

bool are_one_side(const QuadMesh& mesh, const Side& a, const Side& b) {
  for (int j = 0; j <= mesh.order; ++j)
    if (side_node(mesh, a.elem, a.side, j) != side_node(mesh, b.elem, b.side, mesh.order - j)) return false;
  return true;
}

struct Topology {
  std::vector<std::array<int, 2>> outer;  ///< element and side, sorted
  int num_edges = 0;
};

/// Pairs sides; two elements may touch along two different sides with the same corners, so each is matched by nodes.
Topology topology_of(const QuadMesh& mesh, Findings& findings) {
  const std::vector<Side> all = sorted_sides(mesh);
  std::vector<bool> is_paired(all.size());
  Topology topology;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_paired[i]) continue;
    ++topology.num_edges;
    bool has_partner = false, has_rival = false;
    for (std::size_t j = i + 1; j < all.size() && all[j].low == all[i].low && all[j].high == all[i].high; ++j) {
      if (is_paired[j]) continue;
      has_rival = true;
      if (!are_one_side(mesh, all[i], all[j])) continue;
      is_paired[j] = has_partner = true;
      break;
    }
    if (has_rival && !has_partner)
      findings.add("element {} does not share all nodes of side {} with its neighbour", all[i].elem, all[i].side);
    if (!has_partner) topology.outer.push_back({all[i].elem, all[i].side});
  }
  std::sort(topology.outer.begin(), topology.outer.end());
  return topology;
}

void mesh_is_conforming(const QuadMesh& mesh, Findings& findings) {
  const Topology topology = topology_of(mesh, findings);
  std::vector<std::array<int, 2>> named;
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) named.push_back({edge.elem, edge.side});
  std::sort(named.begin(), named.end());
  if (topology.outer != named)
    findings.add("{} sides belong to one element only, {} are named in boundary_edges; they must be the same",
                 topology.outer.size(), named.size());
}

/// Edges on the boundary and on interfaces together follow each loop of the face.
void boundary_walks_the_loops(const QuadMesh& mesh, Findings& findings) {
  std::vector<QuadBoundaryEdge> edges = mesh.boundary_edges;
  edges.insert(edges.end(), mesh.interface_edges.begin(), mesh.interface_edges.end());
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.curve < b.curve; });
  const auto start = [&](std::size_t i) { return side_node(mesh, edges[i].elem, edges[i].side, 0); };
  const auto end = [&](std::size_t i) { return side_node(mesh, edges[i].elem, edges[i].side, mesh.order); };
  const auto are_sorted = [](const auto& list) {
    return std::is_sorted(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.curve < b.curve; });
  };
  if (!are_sorted(mesh.boundary_edges) || !are_sorted(mesh.interface_edges))
    return findings.add("boundary_edges and interface_edges must be in the order of their curves");
  int num_loops = 0;
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next, ++num_loops) {
    const int loop = mesh.face.loop_of(edges[first].curve);
    for (next = first + 1; next < edges.size() && edges[next].curve < mesh.face.loop_offsets[loop + 1]; ++next) {
    }
    for (std::size_t i = first; i < next; ++i)
      if (end(i) != start(i + 1 < next ? i + 1 : first))
        return findings.add("edge {} on curve {} is not followed by the next one of its loop", i, edges[i].curve);
  }
  if (num_loops != mesh.face.num_loops())
    findings.add("boundary_edges form {} loops, the face has {}", num_loops, mesh.face.num_loops());
}

/// By curve: whether its edges are edges of two elements.
std::vector<bool> closed_interfaces(const QuadMesh& mesh) {
  std::vector<bool> is_closed(mesh.face.curves.size(), false);
  for (const QuadBoundaryEdge& edge : mesh.interface_edges)
    if (mesh.face.is_interface(edge.curve)) is_closed[edge.curve] = is_closed[mesh.face.partners[edge.curve]] = true;
  return is_closed;
}

void euler_count_holds(const QuadMesh& mesh, Findings& findings) {
  std::vector<bool> is_corner(mesh.nodes.size()), is_used(mesh.nodes.size());
  for (const int node : mesh.elem_nodes) is_used[node] = true;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 4; ++k) is_corner[side_node(mesh, e, k, 0)] = true;
  if (const auto unused = std::count(is_used.begin(), is_used.end(), false); unused > 0)
    findings.add("{} nodes belong to no element", unused);
  Findings ignored("");
  const int euler = static_cast<int>(std::count(is_corner.begin(), is_corner.end(), true)) -
                    topology_of(mesh, ignored).num_edges + mesh.num_elems();
  const int expected = euler_characteristic_of_whole(mesh.face, closed_interfaces(mesh));
  if (euler != expected)
    findings.add("vertices - edges + elements is {}, the face's Euler characteristic {}", euler, expected);
}

void irregular_nodes_agree(const QuadMesh& mesh, Findings& findings) {
  std::vector<int> valence(mesh.nodes.size());
  std::vector<bool> is_outer(mesh.nodes.size());
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 4; ++k) ++valence[side_node(mesh, e, k, 0)];
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) is_outer[side_node(mesh, edge.elem, edge.side, 0)] = true;
  int num_irregular = 0;
  for (std::size_t i = 0; i < valence.size(); ++i)
    if (valence[i] > 0 && !is_outer[i] && valence[i] != 4) ++num_irregular;
  if (num_irregular != mesh.num_irregular)
    findings.add("num_irregular is {}, the mesh has {} inner nodes of a valence other than 4", mesh.num_irregular,
                 num_irregular);
}

void root_tells_validity(const QuadMesh& mesh, Findings& findings) {
  const double least = *std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  if (mesh.least_jacobian_bound != least)
    findings.add("least_jacobian_bound is {}, the least of elem_jacobian_bound {}", mesh.least_jacobian_bound, least);
  if (!mesh.is_valid && least > 0) findings.add("is_valid is 0, but all bounds are positive");
}

void sizes_are_in_range(const QuadMesh& mesh, Findings& findings) {
  for (std::size_t e = 0; e < mesh.elem_prescribed_length.size(); ++e)
    if (!(mesh.elem_prescribed_length[e] >= 0)) findings.add("element {}: its prescribed length is negative", e);
  for (std::size_t e = 0; e < mesh.elem_prescribed_stretch.size(); ++e)
    if (const SymmetricTensor& s = mesh.elem_prescribed_stretch[e]; !(std::abs(det(s) - 1) < 1e-6 * s.xx * s.yy))
      findings.add("element {}: its prescribed stretch is no tensor of determinant 1", e);
  if (!mesh.is_valid) return;
  for (std::size_t e = 0; e < mesh.elem_edge_ratio.size(); ++e)
    if (!(mesh.elem_edge_ratio[e] >= 1 - 1e-12) || !(mesh.elem_area_jump[e] >= 1 - 1e-12) ||
        !(mesh.elem_node_distance[e] > 0))
      findings.add("element {}: its edge ratio and area jump must be at least 1, its node distance positive, at {}", e,
                   position_text(mesh.face, mesh.nodes[side_node(mesh, static_cast<int>(e), 0, 0)]));
}

/// A side of an element that lies on an interface: the same edge for both elements.
using EdgeOnCurve = std::pair<Side, int>;

/// The edges of both sides of an interface are the same, on curves that are partners, and their elements are of the
/// regions of these curves.
void interfaces_are_shared(const QuadMesh& mesh, Findings& findings) {
  std::vector<EdgeOnCurve> edges;
  for (std::size_t i = 0; i < mesh.interface_edges.size(); ++i) {
    const QuadBoundaryEdge& e = mesh.interface_edges[i];
    const int a = side_node(mesh, e.elem, e.side, 0), b = side_node(mesh, e.elem, e.side, mesh.order);
    edges.push_back({{std::min(a, b), std::max(a, b), e.elem, e.side}, e.curve});
    if (!mesh.face.is_interface(e.curve))
      findings.add("interface edge {}: its curve {} is on the boundary", i, e.curve);
  }
  if (!findings.is_empty()) return;
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_paired(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [side, curve] = edges[i];
    for (std::size_t j = i + 1;
         j < edges.size() && !is_paired[i] && edges[j].first.low == side.low && edges[j].first.high == side.high; ++j)
      if (!is_paired[j] && are_one_side(mesh, side, edges[j].first) && edges[j].second == mesh.face.partners[curve])
        is_paired[i] = is_paired[j] = true;
    if (!is_paired[i])
      findings.add("side {} of element {} on curve {} is not named from the other side of the interface, at {}",
                   side.side, side.elem, curve, position_text(mesh.face, mesh.nodes[side.low]));
  }
}

void regions_fit(const QuadMesh& mesh, Findings& findings) {
  if (mesh.face.num_regions() == 1 && mesh.block_region.empty()) return;
  if (mesh.block_region.size() != mesh.block_names.size())
    return findings.add("block_region has {} entries for {} blocks", mesh.block_region.size(), mesh.block_names.size());
  const std::vector<int> curve_region = curve_regions(mesh.face);
  const auto region_of = [&](int elem) { return mesh.block_region[mesh.elem_block[elem]]; };
  std::vector<std::array<int, 2>> between;  // sides on interfaces
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& e : *edges)
      if (region_of(e.elem) != curve_region[e.curve])
        findings.add("element {} is of region {}, but its side {} lies on curve {} of region {}, at {}", e.elem,
                     region_of(e.elem), e.side, e.curve, curve_region[e.curve],
                     position_text(mesh.face, mesh.nodes[side_node(mesh, e.elem, e.side, 0)]));
  for (const QuadBoundaryEdge& e : mesh.interface_edges) between.push_back({e.elem, e.side});
  std::sort(between.begin(), between.end());
  const std::vector<Side> all = sorted_sides(mesh);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Side &a = all[i - 1], &b = all[i];
    if (region_of(a.elem) == region_of(b.elem) || a.low != b.low || a.high != b.high || !are_one_side(mesh, a, b))
      continue;
    if (!std::binary_search(between.begin(), between.end(), std::array{a.elem, a.side}))
      findings.add("elements {} and {} of two regions share a side that is not on an interface, at {}", a.elem, b.elem,
                   position_text(mesh.face, mesh.nodes[a.low]));
  }
}

/// Elements on both sides of an interface that is not open share its edges, and so its vertices.
void interfaces_are_closed(const QuadMesh& mesh, Findings& findings) {
  const std::vector<bool> is_open = open_interfaces(mesh.face, mesh.open_curves, findings);
  if (is_open.empty()) return;
  const auto add_edges = [&](const std::vector<QuadBoundaryEdge>& edges, bool is_wrong_where_open, const char* what) {
    for (const QuadBoundaryEdge& e : edges)
      if (mesh.face.is_interface(e.curve) && is_open[e.curve] == is_wrong_where_open)
        findings.add("side {} of element {} on the interface curve {} {}, at {}", e.side, e.elem, e.curve, what,
                     position_text(mesh.face, mesh.nodes[side_node(mesh, e.elem, e.side, 0)]));
  };
  add_edges(mesh.boundary_edges, false, "has nodes of its own, though the interface is not open");
  add_edges(mesh.interface_edges, true, "is shared, though the interface is open");
}

constexpr Rule<QuadMesh> quad_mesh_rules[] = {
    {"QUA-R01", RuleKind::structure, arrays_agree},
    {"QUA-R02", RuleKind::structure, indices_exist},
    {"QUA-R03", RuleKind::structure, numbers_are_finite},
    {"QUA-R04", RuleKind::quick, stored_bounds_are_positive},
    {"QUA-R05", RuleKind::full, mesh_is_conforming},
    {"QUA-R06", RuleKind::full, boundary_walks_the_loops},
    {"QUA-R07", RuleKind::full, euler_count_holds},
    {"QUA-R08", RuleKind::full, irregular_nodes_agree},
    {"QUA-R09", RuleKind::full, jacobians_are_as_stored},
    {"QUA-R10", RuleKind::quick, root_tells_validity},
    {"QUA-R11", RuleKind::quick, sizes_are_in_range},
    {"QUA-R12", RuleKind::full, interfaces_are_shared},
    {"QUA-R13", RuleKind::full, regions_fit},
    {"QUA-R14", RuleKind::full, interfaces_are_closed},
    {"QUA-R15", RuleKind::full, boundary_is_on_curves_in_space},
};

}  // namespace

std::string validity_warning(const QuadMesh& mesh) {
  if (mesh.is_valid) return "";
  const auto worst = std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  const int elem = static_cast<int>(worst - mesh.elem_jacobian_bound.begin());
  return fmt::format("the mesh is not valid: {} of {} elements are not proved, the worst is element {} of {} at {}",
                     mesh.num_unproved(), mesh.num_elems(), elem, mesh.block_names[mesh.elem_block[elem]],
                     position_text(mesh.face, mesh.nodes[side_node(mesh, elem, 0, 0)]));
}

std::vector<Violation> violations_of(const QuadMesh& mesh, CheckDepth depth) {
  return apply_rules_after(mesh.face, quad_mesh_rules, mesh, depth);
}

template std::vector<Violation> check_stage(const QuadMesh&, CheckDepth);

}  // namespace quadrille::check
