#include "triangulate/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "mesh/tri_topology.hpp"
#include "surface/positions.hpp"
#include "triangulate/corner_fans.hpp"
#include "triangulate/curved_edges.hpp"
#include "triangulate/draft.hpp"
#include "triangulate/refine_domain.hpp"

namespace quadrille::triangulate {
namespace {

struct MeshConstants {
  double edge_turn = radians(40.0);
  double default_size = 0.25;  ///< greatest size, relative to the diameter
  double straight = 1e-13;     ///< deviation of a straight curve from its chord, relative to the diameter
  /// Greatest ratio of the length of a boundary segment to its distance from segments that it does not touch.
  double gap_ratio = 2.5;
  /// An element is refined if det J may fall below this fraction of the determinant of its straight triangle.
  double least_jacobian_ratio = 0.05;
  int max_proof_rounds = 12;
};
constexpr MeshConstants mesh_constants;

/// The straight-sided mesh: elements, layers and boundary edges.
TriMesh assemble(const CadFace& face, int order, const Draft& draft) {
  TriMesh mesh;
  mesh.face = face;
  mesh.order = order;
  mesh.vertices = draft.vertices;
  mesh.elem2vertices = draft.triangles;
  mesh.elem_layer = draft.layers;
  std::map<std::pair<int, int>, std::pair<int, int>> vertices2edge;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) vertices2edge[{mesh.elem2vertices[e][k], mesh.elem2vertices[e][(k + 1) % 3]}] = {e, k};
  for (const DraftEdge& edge : draft.edges) {
    const auto found = vertices2edge.find({edge.from, edge.to});
    if (found == vertices2edge.end()) throw Defect("a boundary edge belongs to no element");
    mesh.boundary_edges.push_back({found->second.first, found->second.second, edge.curve, edge.t0, edge.t1});
  }
  std::sort(mesh.boundary_edges.begin(), mesh.boundary_edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.t0 < b.t0;
  });
  return mesh;
}

struct Result {
  TriMesh mesh;
  std::vector<int> draft_vertices;  ///< of each vertex of the mesh: on both sides of a slit the same
  std::vector<double> ratios;
  int num_fans = 0;
  int rounds = 0;
};

/// The mesh of the fans and of the refined domain between them.
Result complete_mesh(const Outline& outline, int order, Draft draft, const DomainRefiner& refiner,
                     const BoundaryMesh& boundary) {
  std::vector<char> is_free(draft.vertices.size(), 0);
  for (const auto& [a, b, c] : refiner.triangles()) {
    draft.add_triangle(a, b, c, -1);
    for (const int v : {a, b, c}) is_free[v] = 1;
  }
  for (const Segment& segment : boundary.segments()) is_free[segment.from] = is_free[segment.to] = 0;
  smooth(draft, is_free);
  for (const Segment& segment : boundary.segments()) {
    if (segment.is_rim()) continue;
    const int curve = segment.curve;
    draft.edges.push_back({segment.from, segment.to, curve, segment.t0, segment.t1});
    if (!outline.face().is_interface(curve)) continue;
    draft.edges.push_back({segment.to, segment.from, outline.face().partners[curve],
                           outline.partner_parameter(curve, segment.t1), outline.partner_parameter(curve, segment.t0)});
  }
  Result result;
  const std::vector<int> origins = cut_slits(draft);
  result.mesh = assemble(outline.face(), order, draft);
  for (const int v : sort_by_region(result.mesh)) result.draft_vertices.push_back(origins[v]);
  return result;
}

/// The elements that are not proved to be valid.
std::vector<int> doubtful_elements(const std::vector<double>& ratios) {
  std::vector<int> elems;
  for (int e = 0; e < static_cast<int>(ratios.size()); ++e)
    if (!(ratios[e] >= mesh_constants.least_jacobian_ratio)) elems.push_back(e);
  return elems;
}

/// Bisects the boundary edges of the elements `elems`; returns false if there is no edge that can be bisected.
bool split_at(const Result& result, const std::vector<int>& elems, DomainRefiner& refiner) {
  bool did_split = false;
  for (const int e : elems) {
    const auto& v = result.mesh.elem2vertices[e];
    for (int k = 0; k < 3; ++k)
      did_split |= refiner.split_between(result.draft_vertices[v[k]], result.draft_vertices[v[(k + 1) % 3]]);
  }
  return did_split;
}

Vec2 position_of(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
}

Result proved_mesh(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits,
                   const Doubts& doubts, Progress* progress) {
  const Outline& outline = fit.outline();
  Draft draft;
  std::vector<Fan> fans = plan_fans(fit, options, limits);
  build_fans(outline, fans, draft);
  BoundaryMesh boundary(fit, fans, limits, draft);
  boundary.resolve_gaps(mesh_constants.gap_ratio);
  boundary.grade(options.growth, options.size_points);
  DomainRefiner refiner(boundary, draft, limits.size, options.growth, options.size_points);
  const Progress::Part part(progress, "round");
  for (int round = 1;; ++round) {
    part.advance();
    refiner.refine(progress);
    Result result = complete_mesh(outline, options.order, draft, refiner, boundary);
    result.rounds = round;
    result.num_fans = static_cast<int>(fans.size());
    curve_elements(fit, result.mesh);
    result.ratios = jacobian_ratio_bounds(result.mesh);
    const auto invalid = doubtful_elements(result.ratios);
    const auto elems = invalid.empty() && doubts ? doubts(result.mesh) : invalid;
    if (elems.empty()) return result;
    if (round == mesh_constants.max_proof_rounds || !split_at(result, elems, refiner)) {
      if (invalid.empty()) return result;
      const Vec2 position = position_of(result.mesh, invalid.front());
      throw ComputeError("no valid curved element at " + surface::position_text(result.mesh.face, position));
    }
  }
}

void write_report(const Result& result, const EdgeFit& fit, double curve_tol, Report& report) {
  const TriMesh& mesh = result.mesh;
  double error = 0;
  for (const BoundaryEdge& edge : mesh.boundary_edges) error = std::max(error, fit.error(edge.curve, edge.t0, edge.t1));
  report.set("mesh.elements", mesh.num_elems());
  report.set("mesh.vertices", mesh.vertices.size());
  report.set("mesh.boundary_edges", mesh.boundary_edges.size());
  report.set("mesh.curved_elements", mesh.curved_elems.size());
  report.set("mesh.corner_fans", result.num_fans);
  report.set("mesh.fan_elements",
             std::count_if(mesh.elem_layer.begin(), mesh.elem_layer.end(), [](int l) { return l >= 0; }));
  report.set("mesh.least_angle_degrees", degrees(mesh::least_angle(mesh)));
  report.set("mesh.least_jacobian_ratio", *std::min_element(result.ratios.begin(), result.ratios.end()));
  report.set("mesh.curve_error", error / mesh.face.diameter);
  report.set("mesh.proof_rounds", result.rounds);
  if (error > curve_tol) {
    report.warn(warning::curve_tolerance_missed,
                fmt::format("element edges of order {} deviate from the curves by up to {:.1e} of the diameter",
                            mesh.order, error / mesh.face.diameter));
  }
}

/// The limits of the coarse triangles: few triangles, and no more than the blocks need.
struct CoarseLimits {
  double size = 0.5;     ///< diameters
  double growth = 1;     ///< of sizes with the distance
  double curve_tol = 1;  ///< diameters: the blocks follow the curves, not the triangles
  int fan_layers = 0;    ///< small triangles at singular corners serve the field only
};

TriangulateOptions coarse_options(const CadFace& face) {
  constexpr CoarseLimits coarse;
  TriangulateOptions options;
  options.size = coarse.size * face.diameter;
  options.growth = coarse.growth;
  options.curve_tol = coarse.curve_tol;
  options.fan_layers = coarse.fan_layers;
  return options;
}

}  // namespace

void TriangulateOptions::validate() const {
  if (order < 1 || order > 16) throw UsageError("the order must lie in 1..16");
  if (!(size >= 0)) throw UsageError("the size must not be negative");
  if (!(growth > 0 && growth <= 2)) throw UsageError("the growth must lie in (0, 2]");
  if (!(curve_tol > 0)) throw UsageError("the curve tolerance must be positive");
  if (fan_layers < -1) throw UsageError("the number of fan layers must not be negative");
  if (!(fan_factor > 0 && fan_factor < 1)) throw UsageError("the fan factor must lie in (0, 1)");
}

TriMesh triangulate(const CadFace& face, const TriangulateOptions& options, Report& report, const Doubts& doubts) {
  options.validate();
  const Outline outline(face, mesh_constants.straight * face.diameter);
  const EdgeFit fit(outline, options.order);
  EdgeLimits limits;
  limits.size = options.size > 0 ? options.size : mesh_constants.default_size * face.diameter;
  limits.turn = mesh_constants.edge_turn;
  limits.curve_tol = options.curve_tol * face.diameter;
  Result result = proved_mesh(fit, options, limits, doubts, report.progress());
  write_report(result, fit, limits.curve_tol, report);
  return std::move(result.mesh);
}

TriMesh coarse_triangles(const CadFace& face, const Doubts& doubts, Report& report) {
  return triangulate(face, coarse_options(face), report, doubts);
}

}  // namespace quadrille::triangulate
