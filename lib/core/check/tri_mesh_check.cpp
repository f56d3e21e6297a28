#include <algorithm>
#include <array>

#include "check/rules.hpp"
#include "curve/nurbs.hpp"
#include "spectral/tri_bernstein.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::check {

namespace {

std::size_t nodes_per_elem(const TriMesh& mesh) {
  return static_cast<std::size_t>(mesh.order + 1) * static_cast<std::size_t>(mesh.order + 2) / 2;
}

void regions_have_elements(const TriMesh& mesh, Findings& findings) {
  const std::vector<int>& offsets = mesh.region_elems;
  const int num_regions = mesh.face.num_regions();
  if (offsets.empty() && num_regions == 1) return;
  if (std::ssize(offsets) != num_regions + 1 || !are_offsets(offsets, mesh.num_elems()))
    findings.add("region_elems must increase from 0 to the number of elements, {}, in {} entries", mesh.num_elems(),
                 num_regions + 1);
}

void arrays_agree(const TriMesh& mesh, Findings& findings) {
  if (mesh.order < 1 || mesh.order > 20) return findings.add("order {} is outside 1 to 20", mesh.order);
  if (mesh.elem2vertices.empty()) findings.add("the mesh has no elements");
  if (mesh.elem_layer.size() != mesh.elem2vertices.size())
    findings.add("elem_layer has {} entries for {} elements", mesh.elem_layer.size(), mesh.elem2vertices.size());
  if (mesh.curved_nodes.size() != mesh.curved_elems.size() * nodes_per_elem(mesh))
    findings.add("curved_nodes has {} entries, not {} for each of {} curved elements", mesh.curved_nodes.size(),
                 nodes_per_elem(mesh), mesh.curved_elems.size());
  regions_have_elements(mesh, findings);
}

void vertices_exist(const TriMesh& mesh, Findings& findings) {
  for (std::size_t e = 0; e < mesh.elem2vertices.size(); ++e) {
    const auto& [a, b, c] = mesh.elem2vertices[e];
    const std::size_t n = mesh.vertices.size();
    if (!is_index(a, n) || !is_index(b, n) || !is_index(c, n) || a == b || b == c || c == a)
      findings.add("element {} must have three different vertices below {}", e, n);
  }
}

void curved_elems_exist(const TriMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.curved_elems.size(); ++i)
    if (!is_index(mesh.curved_elems[i], mesh.elem2vertices.size()) ||
        (i > 0 && mesh.curved_elems[i] <= mesh.curved_elems[i - 1]))
      return findings.add("curved_elems must be elements in ascending order; entry {} is not", i);
}

void boundary_edges_exist(const TriMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i) {
    const BoundaryEdge& edge = mesh.boundary_edges[i];
    if (!is_index(edge.elem, mesh.elem2vertices.size()) || !is_index(edge.edge, 3) ||
        !is_index(edge.curve, mesh.face.curves.size()))
      findings.add("boundary edge {} names an element, edge or curve that does not exist", i);
  }
}

void numbers_are_finite(const TriMesh& mesh, Findings& findings) {
  if (!are_finite(mesh.vertices)) findings.add("vertices contain a number that is not finite");
  if (!are_finite(mesh.curved_nodes)) findings.add("curved_nodes contain a number that is not finite");
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    if (!is_finite(edge.t0) || !is_finite(edge.t1)) return findings.add("a boundary edge's parameter is not finite");
}

/// The edges of each curve, in order from its start to its end.
void boundary_is_covered(const TriMesh& mesh, Findings& findings) {
  std::size_t i = 0;
  const auto& edges = mesh.boundary_edges;
  for (int c = 0; c < mesh.face.num_curves(); ++c) {
    const Nurbs& curve = mesh.face.curves[c];
    double t = curve.begin();
    const double tol = 1e-12 * (curve.end() - curve.begin());
    for (; i < edges.size() && edges[i].curve == c; ++i) {
      if (std::abs(edges[i].t0 - t) > tol || !(edges[i].t0 < edges[i].t1))
        return findings.add("boundary edge {} does not continue curve {} at parameter {:.9g}", i, c, t);
      t = edges[i].t1;
    }
    if (std::abs(curve.end() - t) > tol)
      return findings.add("the boundary edges of curve {} end at parameter {:.9g}, the curve at {:.9g}", c, t,
                          curve.end());
  }
  if (i != edges.size()) findings.add("boundary edges must be sorted by curve; entry {} is not", i);
}

Vec2 start_vertex(const TriMesh& mesh, const BoundaryEdge& edge) {
  return mesh.vertices[mesh.elem2vertices[edge.elem][edge.edge]];
}
Vec2 end_vertex(const TriMesh& mesh, const BoundaryEdge& edge) {
  return mesh.vertices[mesh.elem2vertices[edge.elem][(edge.edge + 1) % 3]];
}

void boundary_vertices_lie_on_curves(const TriMesh& mesh, Findings& findings) {
  const double tol = gap_tol * mesh.face.diameter;
  for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i) {
    const BoundaryEdge& edge = mesh.boundary_edges[i];
    const Nurbs& curve = mesh.face.curves[edge.curve];
    if (edge.t0 < curve.begin() || edge.t1 > curve.end())
      return findings.add("boundary edge {} leaves the domain of curve {}", i, edge.curve);
    if (distance(start_vertex(mesh, edge), curve::point(curve, edge.t0)) > tol ||
        distance(end_vertex(mesh, edge), curve::point(curve, edge.t1)) > tol)
      findings.add("boundary edge {} does not end on curve {} at its parameters, near {}", i, edge.curve,
                   position_text(mesh.face, start_vertex(mesh, edge)));
  }
}

void curved_corners_are_vertices(const TriMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.curved_elems.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 vertex = mesh.vertices[mesh.elem2vertices[mesh.curved_elems[i]][k]];
      if (distance(mesh.curved_nodes[i * nodes_per_elem(mesh) + k], vertex) > 1e-12 * mesh.face.diameter)
        findings.add("element {}: its geometry node {} is not its vertex", mesh.curved_elems[i], k);
    }
}

void elements_are_counter_clockwise(const TriMesh& mesh, Findings& findings) {
  std::size_t next_curved = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (next_curved < mesh.curved_elems.size() && mesh.curved_elems[next_curved] == e) {
      ++next_curved;  // TRI-R13 proves these
      continue;
    }
    const auto& [a, b, c] = mesh.elem2vertices[e];
    if (!(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]) > 0))
      findings.add("element {} is not counter-clockwise, at {}", e, position_text(mesh.face, mesh.vertices[a]));
  }
}

/// An edge of an element, with its two vertices as the sort key.
struct HalfEdge {
  int low, high, elem, edge;
  bool is_reversed;
  auto operator<=>(const HalfEdge&) const = default;
};

std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh) {
  std::vector<HalfEdge> all;
  all.reserve(3 * mesh.elem2vertices.size());
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.elem2vertices[e][k], b = mesh.elem2vertices[e][(k + 1) % 3];
      all.push_back({std::min(a, b), std::max(a, b), e, k, a > b});
    }
  std::sort(all.begin(), all.end());
  return all;
}

/// Calls pair(first, second) for inner edges and single(edge) for the others; false when three elements meet.
template <typename Pair, typename Single>
void for_each_edge(const std::vector<HalfEdge>& all, const Pair& pair, const Single& single) {
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < all.size() && all[i].low == all[j].low && all[i].high == all[j].high;
  };
  for (std::size_t i = 0; i < all.size();) {
    const bool is_inner = same(i, i + 1);
    if (is_inner)
      pair(all[i], all[i + 1]);
    else
      single(all[i]);
    i += is_inner ? 2 : 1;
  }
}

void edges_are_shared(const TriMesh& mesh, Findings& findings) {
  std::vector<std::array<int, 2>> outer, named;
  for (const BoundaryEdge& edge : mesh.boundary_edges) named.push_back({edge.elem, edge.edge});
  for_each_edge(
      sorted_half_edges(mesh),
      [&](const HalfEdge& a, const HalfEdge& b) {
        if (a.is_reversed == b.is_reversed)
          findings.add("elements {} and {} walk their common edge in the same direction", a.elem, b.elem);
      },
      [&](const HalfEdge& a) {
        outer.push_back({a.elem, a.edge});
      });
  std::sort(outer.begin(), outer.end());
  std::sort(named.begin(), named.end());
  if (outer != named)
    findings.add("{} edges belong to one element only, {} are named in boundary_edges; they must be the same",
                 outer.size(), named.size());
}

/// vertices - edges + elements of each region, a vertex with the region of the last of its elements.
void add_euler_counts(const TriMesh& mesh, const std::vector<bool>& is_used, std::vector<int>& euler) {
  std::vector<int> elem_region(mesh.elem2vertices.size()), vertex_region(mesh.vertices.size());
  for (std::size_t r = 0; r + 1 < mesh.region_elems.size(); ++r)
    std::fill(elem_region.begin() + mesh.region_elems[r], elem_region.begin() + mesh.region_elems[r + 1],
              static_cast<int>(r));
  for (int e = 0; e < mesh.num_elems(); ++e) {
    ++euler[elem_region[e]];
    for (const int v : mesh.elem2vertices[e]) vertex_region[v] = elem_region[e];
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (is_used[v]) ++euler[vertex_region[v]];
  for_each_edge(
      sorted_half_edges(mesh), [&](const HalfEdge& a, const HalfEdge&) { --euler[elem_region[a.elem]]; },
      [&](const HalfEdge& a) { --euler[elem_region[a.elem]]; });
}

void euler_count_holds(const TriMesh& mesh, Findings& findings) {
  std::vector<bool> is_used(mesh.vertices.size());
  for (const auto& vertices : mesh.elem2vertices)
    for (const int v : vertices) is_used[v] = true;
  const auto num_used = static_cast<int>(std::count(is_used.begin(), is_used.end(), true));
  if (num_used != static_cast<int>(mesh.vertices.size()))
    findings.add("{} vertices belong to no element", static_cast<int>(mesh.vertices.size()) - num_used);
  std::vector<int> euler(mesh.face.num_regions());
  add_euler_counts(mesh, is_used, euler);
  for (int r = 0; r < mesh.face.num_regions(); ++r) {
    const int num_loops = mesh.face.region_loops.empty() ? mesh.face.num_loops()
                                                         : mesh.face.region_loops[r + 1] - mesh.face.region_loops[r];
    if (euler[r] != 2 - num_loops)
      findings.add("vertices - edges + elements is {}, the Euler characteristic {}{}", euler[r], 2 - num_loops,
                   mesh.face.num_regions() > 1 ? fmt::format(" of region {}", r) : "");
  }
}

const Vec2* curved_nodes_of(const TriMesh& mesh, int elem) {
  const auto found = std::lower_bound(mesh.curved_elems.begin(), mesh.curved_elems.end(), elem);
  if (found == mesh.curved_elems.end() || *found != elem) return nullptr;
  return mesh.curved_nodes.data() + static_cast<std::size_t>(found - mesh.curved_elems.begin()) * nodes_per_elem(mesh);
}

/// The j-th geometry node of an edge; for straight elements the nodes lie on the chord.
Vec2 edge_node(const TriMesh& mesh, const HalfEdge& edge, int j) {
  if (const Vec2* nodes = curved_nodes_of(mesh, edge.elem))
    return nodes[spectral::tri_edge_node(mesh.order, edge.edge, j)];
  const auto& vertices = mesh.elem2vertices[edge.elem];
  const Vec2 a = mesh.vertices[vertices[edge.edge]], b = mesh.vertices[vertices[(edge.edge + 1) % 3]];
  // Fractions of the edge are taken from edge 0, on which only the first coordinate changes.
  const double s = (spectral::tri_nodes(mesh.order)[spectral::tri_edge_node(mesh.order, 0, j)].x + 1) / 2;
  return (1 - s) * a + s * b;
}

void neighbours_share_shapes(const TriMesh& mesh, Findings& findings) {
  const auto compare = [&](const HalfEdge& a, const HalfEdge& b) {
    if (!curved_nodes_of(mesh, a.elem) && !curved_nodes_of(mesh, b.elem)) return;
    for (int j = 1; j < mesh.order; ++j)
      if (distance(edge_node(mesh, a, j), edge_node(mesh, b, mesh.order - j)) > 1e-12 * mesh.face.diameter)
        return findings.add("elements {} and {} disagree on the shape of their common edge, at {}", a.elem, b.elem,
                            position_text(mesh.face, edge_node(mesh, a, j)));
  };
  for_each_edge(sorted_half_edges(mesh), compare, [](const HalfEdge&) {});
}

void jacobians_are_positive(const TriMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.curved_elems.size(); ++i) {
    const Vec2* nodes = mesh.curved_nodes.data() + i * nodes_per_elem(mesh);
    const spectral::TriMap map(mesh.order, nodes);
    const double bound =
        spectral::jacobian_lower_bound(mesh.order, spectral::bernstein_from_orthogonal(mesh.order, map.coefs_x()),
                                       spectral::bernstein_from_orthogonal(mesh.order, map.coefs_y()));
    if (!(bound > 0))
      findings.add("element {} is not proved valid: its Jacobian's lower bound is {:.3g}, at {}", mesh.curved_elems[i],
                   bound, position_text(mesh.face, nodes[0]));
  }
}

/// The least and the greatest vertex of each region.
std::vector<std::array<int, 2>> vertex_ranges(const TriMesh& mesh) {
  std::vector<std::array<int, 2>> ranges;
  for (std::size_t r = 0; r + 1 < mesh.region_elems.size(); ++r) {
    ranges.push_back({static_cast<int>(mesh.vertices.size()), -1});
    auto& [least, greatest] = ranges.back();
    for (int e = mesh.region_elems[r]; e < mesh.region_elems[r + 1]; ++e)
      for (const int v : mesh.elem2vertices[e]) least = std::min(least, v), greatest = std::max(greatest, v);
  }
  return ranges;
}

void regions_are_apart(const TriMesh& mesh, Findings& findings) {
  const std::vector<std::array<int, 2>> ranges = vertex_ranges(mesh);
  for (std::size_t r = 0; r + 1 < ranges.size(); ++r)
    if (ranges[r][1] >= ranges[r + 1][0])
      findings.add("vertex {} of region {} comes before vertex {} of region {}, or is the same", ranges[r + 1][0],
                   r + 1, ranges[r][1], r);
  if (mesh.face.num_regions() == 1) return;
  for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i) {
    const BoundaryEdge& edge = mesh.boundary_edges[i];
    const int region = mesh.face.region_of_loop(mesh.face.loop_of(edge.curve));
    if (edge.elem < mesh.region_elems[region] || edge.elem >= mesh.region_elems[region + 1])
      findings.add("boundary edge {} is on curve {} of region {}, but its element {} is of another region", i,
                   edge.curve, region, edge.elem);
  }
}

constexpr Rule<TriMesh> tri_mesh_rules[] = {
    {"TRI-R01", RuleKind::structure, arrays_agree},
    {"TRI-R02", RuleKind::structure, vertices_exist},
    {"TRI-R03", RuleKind::structure, curved_elems_exist},
    {"TRI-R04", RuleKind::structure, boundary_edges_exist},
    {"TRI-R05", RuleKind::structure, numbers_are_finite},
    {"TRI-R06", RuleKind::quick, boundary_is_covered},
    {"TRI-R07", RuleKind::quick, boundary_vertices_lie_on_curves},
    {"TRI-R08", RuleKind::quick, curved_corners_are_vertices},
    {"TRI-R09", RuleKind::quick, elements_are_counter_clockwise},
    {"TRI-R10", RuleKind::quick, edges_are_shared},
    {"TRI-R11", RuleKind::full, euler_count_holds},
    {"TRI-R12", RuleKind::full, neighbours_share_shapes},
    {"TRI-R13", RuleKind::full, jacobians_are_positive},
    {"TRI-R14", RuleKind::quick, regions_are_apart},
};

}  // namespace

std::vector<Violation> violations_of(const TriMesh& mesh, CheckDepth depth) {
  return apply_rules_after(mesh.face, tri_mesh_rules, mesh, depth);
}

template std::vector<Violation> check_stage(const TriMesh&, CheckDepth);

}  // namespace quadrille::check
