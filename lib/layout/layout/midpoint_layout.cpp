#include "layout/midpoint_layout.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::layout {
namespace {

/// The share of an edge's bulge by which the centre moves: (1/9) / (1/4), the products of barycentric coordinates there
/// and in the middle of the edge.
constexpr double bulge_at_centre = 4.0 / 9;

class Divider {
 public:
  explicit Divider(const TriMesh& mesh)
      : mesh_(&mesh), topology_(mesh::tri_topology(mesh)), table_(mesh.face, divided_.graph.splines) {}

  DividedTriangles divide() {
    divided_.graph.face = mesh_->face;
    add_vertices();
    for (int edge = 0; edge < num_edges(); ++edge) divide_edge(edge);
    for (int elem = 0; elem < mesh_->num_elems(); ++elem) add_centre(elem);
    for (int elem = 0; elem < mesh_->num_elems(); ++elem) add_blocks(elem);
    return std::move(divided_);
  }

 private:
  int num_edges() const { return static_cast<int>(topology_.edge2vertices.size()); }
  int num_vertices() const { return static_cast<int>(mesh_->vertices.size()); }
  int middle_of(int edge) const { return num_vertices() + edge; }
  Vec2 position(int node) const { return divided_.graph.nodes[node].position; }

  /// The edge on the boundary, or none.
  const BoundaryEdge* boundary_edge(int edge) const {
    if (topology_.edge2elems[edge][1] >= 0) return nullptr;
    const int elem = topology_.edge2elems[edge][0];
    for (int k = 0; k < 3; ++k)
      if (topology_.elem2edges[elem][k] == edge) return &mesh_->boundary_edges[topology_.elem2boundary_edge[elem][k]];
    return nullptr;
  }

  void add_vertices() {
    SeparatrixGraph& graph = divided_.graph;
    for (const Vec2 x : mesh_->vertices) graph.nodes.push_back({x, NodeKind::irregular, 0, -1, 0});
    for (const auto& vertices : mesh_->elem2vertices)
      for (const int v : vertices) ++graph.nodes[v].valence;
    for (GraphNode& node : graph.nodes)
      if (node.valence == 4) node.kind = NodeKind::crossing;
    for (const BoundaryEdge& edge : mesh_->boundary_edges) {
      GraphNode& node = graph.nodes[mesh_->elem2vertices[edge.elem][edge.edge]];
      const bool is_joint = edge.t0 == mesh_->face.curves[edge.curve].begin();
      node.kind = is_joint && mesh_->face.joints[edge.curve].is_corner ? NodeKind::corner : NodeKind::boundary;
      node.curve = edge.curve;
      node.t = edge.t0;
    }
  }

  /// Adds the middle of the edge and its halves, the arcs 2 edge and 2 edge + 1.
  void divide_edge(int edge) {
    SeparatrixGraph& graph = divided_.graph;
    if (const BoundaryEdge* b = boundary_edge(edge)) {
      const curve::ArcLength& length = table_.arc_length(b->curve);
      const double t = length.parameter((length.at(b->t0) + length.at(b->t1)) / 2);
      const auto& vertices = mesh_->elem2vertices[b->elem];
      graph.nodes.push_back({curve::point(mesh_->face.curves[b->curve], t), NodeKind::boundary, 2, b->curve, t});
      graph.arcs.push_back({vertices[b->edge], middle_of(edge), true, 0, {{b->curve, b->t0, t}}});
      graph.arcs.push_back({middle_of(edge), vertices[(b->edge + 1) % 3], true, 0, {{b->curve, t, b->t1}}});
      return;
    }
    const auto [from, to] = topology_.edge2vertices[edge];
    graph.nodes.push_back({(position(from) + position(to)) / 2, NodeKind::crossing, 4, -1, 0});
    const int spline = add_line(position(from), position(to));
    graph.arcs.push_back({from, middle_of(edge), false, 0, {{spline, 0, 0.5}}});
    graph.arcs.push_back({middle_of(edge), to, false, 0, {{spline, 0.5, 1}}});
  }

  /// Adds the centre of a triangle and the arcs to it from the middles of its edges.
  void add_centre(int elem) {
    SeparatrixGraph& graph = divided_.graph;
    Vec2 centre;
    for (int k = 0; k < 3; ++k) {
      const Vec2 from = mesh_->vertices[mesh_->elem2vertices[elem][k]];
      const Vec2 to = mesh_->vertices[mesh_->elem2vertices[elem][(k + 1) % 3]];
      const Vec2 middle = position(middle_of(topology_.elem2edges[elem][k]));
      centre += from / 3 + bulge_at_centre * (middle - (from + to) / 2);
    }
    const int node = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({centre, NodeKind::irregular, 3, -1, 0});
    for (int k = 0; k < 3; ++k) {
      const int middle = middle_of(topology_.elem2edges[elem][k]);
      graph.arcs.push_back({middle, node, false, 0, {{add_line(position(middle), centre), 0, 1}}});
    }
  }

  int add_line(Vec2 from, Vec2 to) {
    divided_.graph.splines.push_back({1, {0, 0, 1, 1}, {from, to}, {1, 1}});
    return mesh_->face.num_curves() + static_cast<int>(divided_.graph.splines.size()) - 1;
  }

  /// The half of an edge at this vertex, towards the middle.
  HalfEdge half_from(int edge, int vertex) const {
    const bool is_first = divided_.graph.arcs[2 * edge].from == vertex;
    return is_first ? HalfEdge{2 * edge} : HalfEdge{2 * edge + 1, true};
  }

  void add_blocks(int elem) {
    const std::array<int, 3>& edges = topology_.elem2edges[elem];
    const auto to_centre = [&](int k) { return HalfEdge{2 * num_edges() + 3 * elem + k}; };
    auto& blocks = divided_.blocks.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh_->elem2vertices[elem][k], before = (k + 2) % 3;
      blocks[k] = {half_from(edges[k], vertex), to_centre(k), to_centre(before).reversed(),
                   half_from(edges[before], vertex).reversed()};
    }
  }

  const TriMesh* mesh_;
  mesh::TriTopology topology_;
  DividedTriangles divided_;
  curve::CurveTable table_;  ///< of the CAD curves
};

constexpr double least_share = 0.1;  ///< of the least Jacobian of the straight triangle's blocks

/// det J on [0, 1]^2 where a block of a straight triangle is smallest: at the centre.
double jacobian_at_centre(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]) / 12;
}

/// Whether the quadrilateral between a block's corners is convex; otherwise a side may have no length.
bool is_convex(const ArcGraph& graph, const std::array<HalfEdge, 4>& sides) {
  std::array<Vec2, 4> p;
  for (int k = 0; k < 4; ++k) p[k] = graph.nodes[start_of(graph.arcs, sides[k])].position;
  for (int k = 0; k < 4; ++k)
    if (!(cross(p[(k + 1) % 4] - p[k], p[(k + 2) % 4] - p[(k + 1) % 4]) > 0)) return false;
  return true;
}

std::vector<int> doubtful(const TriMesh& mesh) { return doubtful_triangles(mesh, divide_triangles(mesh)); }

void require(const CoarseMesher& mesher) {
  if (!mesher) throw ComputeError("midpoint division needs a mesher of coarse triangles, and this program has none");
}

void report_triangles(const TriMesh& triangles, const char* origin, Report& report) {
  report.set("midpoint.triangles", triangles.num_elems());
  report.set("midpoint.origin", origin);
}

}  // namespace

DividedTriangles divide_triangles(const TriMesh& mesh) { return Divider(mesh).divide(); }

double jacobian_bound(const curve::CurveTable& table, const ArcGraph& graph, const std::array<HalfEdge, 4>& sides) {
  std::vector<curve::Chain> chains;
  for (const HalfEdge side : sides) chains.emplace_back(table, graph.arcs[side.arc].pieces);
  const mesh::TransfiniteMap map(
      {&chains[0], &chains[1], &chains[2], &chains[3]},
      {sides[0].is_backwards, sides[1].is_backwards, sides[2].is_backwards, sides[3].is_backwards});
  return 4 * mesh::block_shape(map).jacobian_bound;
}

std::vector<int> doubtful_triangles(const TriMesh& mesh, const DividedTriangles& divided) {
  const curve::CurveTable table(divided.graph.face, divided.graph.splines);
  std::vector<int> doubtful;
  for (const int elem : mesh.curved_elems) {
    const double least = least_share * jacobian_at_centre(mesh, elem);
    const auto is_doubtful = [&](const auto& sides) {
      return !is_convex(divided.graph, sides) || !(jacobian_bound(table, divided.graph, sides) > least);
    };
    if (std::any_of(divided.blocks[elem].begin(), divided.blocks[elem].end(), is_doubtful)) doubtful.push_back(elem);
  }
  return doubtful;
}

TriMesh coarse_triangles(const CadFace& face, const CoarseMesher& mesher, Report& report) {
  require(mesher);
  Report unused(report.progress());  // the report of the triangle mesh is that of another mesh
  TriMesh triangles = mesher(face, doubtful, unused);
  report_triangles(triangles, "coarse", report);
  return triangles;
}

SeparatrixGraph midpoint_graph(const TriMesh& mesh, const CoarseMesher& mesher, Report& report) {
  require(mesher);
  try {
    return divide_triangles(coarse_triangles(mesh.face, mesher, report)).graph;
  } catch (const ComputeError&) {
    report_triangles(mesh, "field", report);
    return divide_triangles(mesh).graph;
  }
}

graph::CandidateLayout midpoint_layout(const TriMesh& mesh, const CoarseMesher& mesher, Report& report) {
  graph::CandidateLayout layout = graph::candidate_layout(midpoint_graph(mesh, mesher, report));
  report.set("midpoint.blocks", graph::require_four_corners(layout.subdivision));
  return layout;
}

std::string reason_without_field(LayoutChoice choice) {
  if (choice == LayoutChoice::midpoint) return "";
  if (choice == LayoutChoice::automatic) return "there is no field that separatrices could follow";
  throw UsageError("--layout " + std::string(enum_name(choice)) + " needs a field, not a triangle mesh");
}

void certify_midpoint(graph::CandidateLayout& layout, const std::string& reason, Report& report) {
  layout.certificate.reason = reason;
  if (!reason.empty()) report.warn(warning::midpoint_instead_of_separatrices, midpoint_warning(reason));
  certify(LayoutMethod::midpoint, layout, report);
  report.set("subdivision.built", layout.num_built);
}

}  // namespace quadrille::layout
