#include "occ/occ_triangles.hpp"

#include <fmt/format.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/vec3.hpp"
#include "base/warning_codes.hpp"
#include "heal/heal_rules.hpp"
#include "occ/occ_completed_face.hpp"
#include "occ/occ_inner_edges.hpp"
#include "occ/occ_one_surface.hpp"
#include "occ/occ_space_edges.hpp"
#include "occ/occ_surface.hpp"
#include "occ/occ_united_face.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {

namespace {

constexpr double deflection = 1e-3;     // of the triangles from the surface, in diameters
constexpr double greatest_angle = 0.2;  // between neighbours, radians
constexpr double least_side = 1e-3;     // diameters

/// The triangulation of a face by the kernel, which has a node for each pair of parameters; one vertex for each point.
class Triangles {
 public:
  Triangles(const TopoDS_Face& face, const std::string& file) : face_(face), nodes_(triangulated(file)) {
    TopExp::MapShapes(face_, TopAbs_EDGE, edges_);
    for (int i = 1; i <= edges_.Extent(); ++i) merge_on(TopoDS::Edge(edges_(i)));
    for (int i = 0; i < mesh_->NbNodes(); ++i) first_.push_back(nodes_.find(i));
  }

  int num_edges() const { return edges_.Extent(); }
  TopoDS_Edge edge(int i) const { return TopoDS::Edge(edges_(i + 1).Oriented(TopAbs_FORWARD)); }

  /// Nodes on an edge, in the direction of its curve; of one side only.
  Handle(Poly_PolygonOnTriangulation) polygon(const TopoDS_Edge& e) const {
    return BRep_Tool::PolygonOnTriangulation(e, mesh_, location_);
  }

  /// Sets triangles and vertices; parameters are those of the spline.
  void copy_to(space::RawSpaceFace& raw, const ConvertedSurface& surface) {
    std::vector<Vec2> uv;
    for (int i = 1; i <= mesh_->NbNodes(); ++i) {
      const gp_Pnt2d p = mesh_->UVNode(i);
      uv.push_back(surface.spline_parameters({p.X(), p.Y()}));
    }
    number_.assign(uv.size(), -1);
    for (int i = 0; i < static_cast<int>(uv.size()); ++i)
      if (first_[i] == i) {
        number_[i] = static_cast<int>(raw.vertices.size());
        raw.vertices.push_back(surface::point(raw.surface, uv[i]));
      }
    for (int i = 1; i <= mesh_->NbTriangles(); ++i) add_triangle(mesh_->Triangle(i), uv, raw);
    drop_unused(raw);
  }

  /// Whether the two sides of an edge have other parameters.
  bool is_seam(const TopoDS_Edge& e) const {
    const Handle(Poly_PolygonOnTriangulation) other = polygon(TopoDS::Edge(e.Oriented(TopAbs_REVERSED)));
    return mesh_->UVNode(polygon(e)->Node(1)).Distance(mesh_->UVNode(other->Node(1))) > 0;
  }

  int vertex(int node) const { return number_[first_[node - 1]]; }

 private:
  DisjointSets triangulated(const std::string& file) {
    const double size = box_diagonal(face_);
    IMeshTools_Parameters parameters;
    parameters.Deflection = parameters.DeflectionInterior = deflection * size;
    parameters.Angle = parameters.AngleInterior = greatest_angle;
    parameters.MinSize = least_side * size;
    const BRepMesh_IncrementalMesh mesher(face_, parameters);
    mesh_ = BRep_Tool::Triangulation(face_, location_);
    if (mesh_.IsNull() || !mesh_->HasUVNodes())
      throw FormatError(fmt::format("{}: the CAD kernel finds no triangles of the face: {}", file,
                                    "repair it in the CAD program, or cut it into simpler faces"));
    return DisjointSets(mesh_->NbNodes());
  }

  void unite(int a, int b) { nodes_.unite(a - 1, b - 1); }

  /// All nodes of a pole are one, those on both sides of a seam are the same, and edges meet in their vertices.
  void merge_on(const TopoDS_Edge& e) {
    const auto forward = TopoDS::Edge(e.Oriented(TopAbs_FORWARD));
    const Handle(Poly_PolygonOnTriangulation) one = polygon(forward);
    if (one.IsNull()) return;
    const int n = one->NbNodes();
    const Handle(Poly_PolygonOnTriangulation) other = polygon(TopoDS::Edge(e.Oriented(TopAbs_REVERSED)));
    for (int i = 1; i <= n; ++i) {
      if (!other.IsNull() && other->NbNodes() == n) unite(one->Node(i), other->Node(i));
      if (BRep_Tool::Degenerated(e)) unite(one->Node(1), one->Node(i));
    }
    merge_at(TopExp::FirstVertex(forward), one->Node(1));
    merge_at(TopExp::LastVertex(forward), one->Node(n));
  }

  void merge_at(const TopoDS_Vertex& v, int node) {
    if (v.IsNull()) return;
    const int index = vertices_.Add(v);
    if (index > static_cast<int>(nodes_at_.size())) nodes_at_.push_back(node);
    unite(nodes_at_[index - 1], node);
  }

  void add_triangle(const Poly_Triangle& t, const std::vector<Vec2>& uv, space::RawSpaceFace& raw) const {
    std::array<int, 3> nodes{}, v{};
    t.Get(nodes[0], nodes[1], nodes[2]);
    std::array<Vec2, 3> corners{};
    for (int k = 0; k < 3; ++k) v[k] = vertex(nodes[k]), corners[k] = uv[nodes[k] - 1];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return;  // at a pole
    // Counter-clockwise in the parameters, and so against the normal.
    if ((cross(corners[1] - corners[0], corners[2] - corners[0]) < 0) != raw.is_reversed)
      std::swap(v[1], v[2]), std::swap(corners[1], corners[2]);
    raw.triangles.push_back(v), raw.triangle_uv.push_back(corners);
  }

  /// The kernel has nodes that no triangle has.
  void drop_unused(space::RawSpaceFace& raw) {
    std::vector<int> renumbered(raw.vertices.size(), -1);
    std::vector<Vec3> used;
    for (auto& t : raw.triangles)
      for (int& v : t) {
        if (renumbered[v] < 0) renumbered[v] = static_cast<int>(used.size()), used.push_back(raw.vertices[v]);
        v = renumbered[v];
      }
    for (int& v : number_)
      if (v >= 0) v = renumbered[v];
    raw.vertices = std::move(used);
  }

  TopoDS_Face face_;
  TopLoc_Location location_;
  Handle(Poly_Triangulation) mesh_;
  DisjointSets nodes_;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::vector<int> nodes_at_;  ///< one of each of vertices_
  std::vector<int> first_;     ///< of the nodes that are one with this node
  std::vector<int> number_;    ///< of the vertex of such a first node
};

/// Warns if the curve has no exact form.
ConvertedCurve converted_edge(const TopoDS_Edge& edge, double first, double last, int number,
                              const heal::RawFace& labels, Report& report) {
  ConvertedCurve converted(edge, first, last, labels.tolerance / 100);
  if (converted.error() > labels.tolerance / 10)
    report.warn(warning::edge_approximated,
                fmt::format("{}: edge {} has no exact rational form and was approximated to {:.3g}", labels.file,
                            number, converted.error()));
  return converted;
}

/// Parts of the edges of the file, and their polygons.
class CurveReader {
 public:
  CurveReader(const FaceEdges& edges, const Triangles& triangles, space::RawSpaceFace& raw, Report& report)
      : edges_(edges), triangles_(triangles), raw_(raw), report_(report) {}

  void read() {
    raw_.curves.resize(edges_.size());
    std::map<int, std::vector<EdgePart>> parts;
    for (int i = 0; i < triangles_.num_edges(); ++i) {
      const TopoDS_Edge edge = triangles_.edge(i);
      if (BRep_Tool::Degenerated(edge) || triangles_.polygon(edge).IsNull() || triangles_.is_seam(edge)) continue;
      EdgePart part{edge, edges_.number_of(edge), 0, 0};
      BRep_Tool::Range(edge, part.first, part.last);
      if (part.number >= 0) parts[part.number].push_back(part);
    }
    for (auto& [number, of_edge] : parts) add_edge(number, in_order(std::move(of_edge)));
  }

 private:
  int start(const EdgePart& part) const { return vertex_at(part, 1); }
  int end(const EdgePart& part) const { return vertex_at(part, triangles_.polygon(part.edge)->NbNodes()); }
  int vertex_at(const EdgePart& part, int i) const { return triangles_.vertex(triangles_.polygon(part.edge)->Node(i)); }

  /// Each begins where the one before it ends; around a closed curve, parameters then rise beyond its period.
  std::vector<EdgePart> in_order(std::vector<EdgePart> parts) const {
    std::sort(parts.begin(), parts.end(), [](const EdgePart& a, const EdgePart& b) { return a.first < b.first; });
    const auto gap = std::adjacent_find(parts.begin(), parts.end(),
                                        [&](const EdgePart& a, const EdgePart& b) { return end(a) != start(b); });
    if (gap == parts.end()) return parts;
    double begin = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(parts.front().edge, begin, last);
    std::rotate(parts.begin(), gap + 1, parts.end());
    for (std::size_t i = 1; i < parts.size() && curve->IsPeriodic(); ++i)
      while (parts[i].first < parts[i - 1].first) parts[i].first += curve->Period(), parts[i].last += curve->Period();
    return parts;
  }

  void add_edge(int number, const std::vector<EdgePart>& parts) {
    try {
      const ConvertedCurve converted = converted_edge(parts.front().edge, parts.front().first, parts.back().last,
                                                      raw_.cad_edge(number), raw_.labels, report_);
      raw_.curves[number] = converted.curve();
      add_polygon(number, parts, converted);
    } catch (const FormatError& e) {
      throw FormatError(fmt::format("{}: edge {}: {}", raw_.labels.file, raw_.cad_edge(number), e.what()));
    }
  }

  void add_polygon(int number, const std::vector<EdgePart>& parts, const ConvertedCurve& curve) {
    space::EdgePolygon polygon{number, {}, {}};
    for (const EdgePart& part : parts) {
      const Handle(Poly_PolygonOnTriangulation) nodes = triangles_.polygon(part.edge);
      double first = 0, last = 0;
      BRep_Tool::Range(part.edge, first, last);
      for (int i = polygon.vertices.empty() ? 1 : 2; i <= nodes->NbNodes(); ++i) {
        polygon.vertices.push_back(triangles_.vertex(nodes->Node(i)));
        polygon.parameters.push_back(curve.parameter(nodes->Parameter(i) + part.first - first));
      }
    }
    if (std::count(polygon.vertices.begin(), polygon.vertices.end(), -1) > 0)
      throw FormatError("the CAD kernel's triangles of the face do not reach it: repair the face in the CAD program");
    raw_.polygons.push_back(std::move(polygon));
  }

  const FaceEdges& edges_;
  const Triangles& triangles_;
  space::RawSpaceFace& raw_;
  Report& report_;
};

ParameterBox box_of(const TopoDS_Face& face) {
  ParameterBox box;
  BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
  return box;
}

/// Offset surfaces, for example, are only approximated by the kernel.
void report_deviation(const ConvertedSurface& surface, const TopoDS_Face& face, double size, const std::string& file,
                      Report& report) {
  const ParameterBox box = box_of(face);
  constexpr int samples = 24;
  double greatest = 0;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j)
      greatest = std::max(greatest, surface.deviation({box.u0 + (box.u1 - box.u0) * i / samples,
                                                       box.v0 + (box.v1 - box.v0) * j / samples}));
  report.set("surface.deviation", greatest / size);
  if (greatest > 1e-9 * size)
    report.warn(warning::surface_approximated,
                fmt::format("{}: the surface of the face has no exact rational form and was approximated to {:.3g}",
                            file, greatest));
}

/// The curves of the inner edges, seen against the normal of the face.
void read_inner_edges(const std::vector<LabelledEdge>& edges, space::RawSpaceFace& raw, Report& report) {
  for (const LabelledEdge& e : edges) {
    require_curve(e.edge);
    double first = 0, last = 0;
    BRep_Tool::Range(e.edge, first, last);
    space::RawInnerEdge inner{converted_edge(e.edge, first, last, e.labels.cad_edge, raw.labels, report).curve(),
                              e.faces};
    if (raw.is_reversed) std::swap(inner.faces[0], inner.faces[1]);
    raw.inner_edges.push_back(std::move(inner));
    raw.labels.inner_edges.push_back(e.labels);
  }
}

FaceEdges outer_edges(const std::vector<LabelledEdge>& edges, space::RawSpaceFace& raw) {
  std::vector<TopoDS_Edge> outer;
  raw.labels.wires.assign(1, {});
  for (const LabelledEdge& e : edges) {
    require_curve(e.edge);
    raw.labels.shape_tolerance = std::max(raw.labels.shape_tolerance, BRep_Tool::Tolerance(e.edge));
    raw.labels.wires.front().push_back(e.labels);
    raw.edge_faces.push_back(e.bounded_face());
    outer.push_back(e.edge);
  }
  return FaceEdges(std::move(outer));
}

}  // namespace

void read_curved_face(const OccModel& model, const std::vector<FaceChoice>& choices, double heal_tolerance,
                      space::RawSpaceFace& raw, Report& report) {
  const std::string& file = raw.labels.file;
  UnitedFace united =
      united_face(model, choices, file,
                  heal::heal_scale(raw.labels, heal_tolerance, extent_of_edges(choices.front().face)).tolerance);
  const TopoDS_Face& whole = united.face;
  const FaceEdges edges = outer_edges(united.outer, raw);
  raw.is_reversed = choices.front().face.Orientation() == TopAbs_REVERSED;
  const double size = box_diagonal(whole);
  add_edges_inside(model, choices, file, heal::heal_scale(raw.labels, heal_tolerance, size).tolerance, united, report);
  const ConvertedSurface surface(basis_surface(whole), box_of(whole), std::min(raw.labels.tolerance, 1e-7 * size));
  raw.surface = surface.spline();
  report_deviation(surface, whole, size, file, report);
  Triangles triangles(whole, file);
  triangles.copy_to(raw, surface);
  CurveReader(edges, triangles, raw, report).read();
  read_inner_edges(united.inner, raw, report);
}

}  // namespace quadrille::occ
