#include "regions/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/face_boundary.hpp"
#include "outline/extent.hpp"
#include "regions/region_numbers.hpp"

namespace quadrille::regions {
namespace {

CadFace part_of_face(const CadFace& face, int region) {
  CadFace part = face;
  const IndexRange loops = loops_of(face, region), curves = curves_of(face, region);
  part.curves = part_of(face.curves, curves);
  part.curve_names = part_of(face.curve_names, curves);
  part.curve_cad_edges = part_of(face.curve_cad_edges, curves);
  part.joints = part_of(face.joints, curves);
  part.unnamed_curves.clear();
  for (const int c : face.unnamed_curves)
    if (curves.contains(c)) part.unnamed_curves.push_back(c - curves.begin);
  part.loop_offsets.clear();
  for (int l = loops.begin; l <= loops.end; ++l) part.loop_offsets.push_back(face.loop_offsets[l] - curves.begin);
  part.name = face.region_names[region];
  part.region_loops.clear();
  part.region_names.clear();
  part.periodic_pairs.clear();
  part.partners = part_of(face.partners, curves);
  for (int& partner : part.partners) partner = curves.contains(partner) ? partner - curves.begin : -1;
  if (std::all_of(part.partners.begin(), part.partners.end(), [](int p) { return p < 0; })) part.partners.clear();
  const IndexRange outline{0, part.loop_offsets[1]};
  part.diameter = outline::diameter(part_of(part.curves, outline));
  return part;
}

TriMesh part_of_mesh(const TriMesh& mesh, CadFace face, int region) {
  TriMesh part;
  part.provenance = mesh.provenance;
  part.face = std::move(face);
  part.order = mesh.order;
  if (region == 0) part.repairs = mesh.repairs;
  const IndexRange elems = elems_of(mesh, region), curves = curves_of(mesh.face, region);
  part.elem_layer = part_of(mesh.elem_layer, elems);
  part.elem2vertices = part_of(mesh.elem2vertices, elems);
  int first = static_cast<int>(mesh.vertices.size()), last = -1;
  for (const auto& triangle : part.elem2vertices)
    for (const int v : triangle) first = std::min(first, v), last = std::max(last, v);
  for (auto& triangle : part.elem2vertices)
    for (int& v : triangle) v -= first;
  part.vertices = part_of(mesh.vertices, {first, last + 1});
  const int per_elem = (mesh.order + 1) * (mesh.order + 2) / 2;
  for (std::size_t i = 0; i < mesh.curved_elems.size(); ++i) {
    if (!elems.contains(mesh.curved_elems[i])) continue;
    part.curved_elems.push_back(mesh.curved_elems[i] - elems.begin);
    const auto node = mesh.curved_nodes.begin() + static_cast<std::ptrdiff_t>(i) * per_elem;
    part.curved_nodes.insert(part.curved_nodes.end(), node, node + per_elem);
  }
  for (BoundaryEdge edge : mesh.boundary_edges) {
    if (!curves.contains(edge.curve)) continue;
    edge.elem -= elems.begin;
    edge.curve -= curves.begin;
    part.boundary_edges.push_back(edge);
  }
  return part;
}

// The counts stay with the first region, so that join restores their sums.
AdaptStep part_of_step(const AdaptStep& step, IndexRange elems, int region) {
  AdaptStep part = region == 0 ? step : AdaptStep{};
  part.min_order = step.min_order;
  part.max_order = step.max_order;
  part.max_sensor = step.max_sensor;
  part.elem_order = part_of(step.elem_order, elems);
  part.elem_sensor = part_of(step.elem_sensor, elems);
  return part;
}

Field part_of_field(const Field& field, TriMesh mesh, int region) {
  Field part;
  const IndexRange elems = elems_of(field.mesh, region), curves = curves_of(field.mesh.face, region);
  part.provenance = field.provenance;
  part.mesh = std::move(mesh);
  part.kind = field.kind;
  part.method = field.method;
  part.elem_order = part_of(field.elem_order, elems);
  part.coef_offsets = part_of(field.coef_offsets, {elems.begin, elems.end + 1});
  const IndexRange coefficients{part.coef_offsets.front(), part.coef_offsets.back()};
  for (int& offset : part.coef_offsets) offset -= coefficients.begin;
  part.u = part_of(field.u, coefficients);
  part.v = part_of(field.v, coefficients);
  for (Lifting lifting : field.liftings) {
    if (!curves.contains(lifting.joint)) continue;
    lifting.joint -= curves.begin;
    part.liftings.push_back(lifting);
  }
  if (!field.region_phases.empty()) part.phase = field.region_phases[region];
  part.elem_sensor = part_of(field.elem_sensor, elems);
  part.elem_error = part_of(field.elem_error, elems);
  for (const AdaptStep& step : field.adapt_steps) part.adapt_steps.push_back(part_of_step(step, elems, region));
  return part;
}

int region_at(const std::vector<CadFace>& faces, const CriticalPoint& node) {
  for (std::size_t r = 0; r < faces.size(); ++r)
    if (curve::CurveTree(faces[r].curves).winding_number(node.position) == 1) return static_cast<int>(r);
  throw FormatError(fmt::format("the node at {} is in no region of the face: move it into one",
                                position_text(node.position + faces.front().origin)));
}

CriticalPoints without_nodes(const CriticalPoints& points, const CadFace& face) {
  CriticalPoints part;
  part.provenance = points.provenance;
  part.form = points.form;
  part.origin = points.origin;
  part.index_sum_expected = 4 * face.euler_characteristic();
  part.face = face;
  return part;
}

}  // namespace

std::vector<CadFace> split(const CadFace& face) {
  if (face.num_regions() == 1) return {face};
  std::vector<CadFace> parts;
  for (int r = 0; r < face.num_regions(); ++r) parts.push_back(part_of_face(face, r));
  return parts;
}

std::vector<TriMesh> split(const TriMesh& mesh) {
  if (mesh.face.num_regions() == 1) return {mesh};
  std::vector<CadFace> faces = split(mesh.face);
  std::vector<TriMesh> parts;
  for (int r = 0; r < mesh.face.num_regions(); ++r) parts.push_back(part_of_mesh(mesh, std::move(faces[r]), r));
  return parts;
}

std::vector<Field> split(const Field& field) {
  if (field.mesh.face.num_regions() == 1) return {field};
  std::vector<TriMesh> meshes = split(field.mesh);
  std::vector<Field> parts;
  for (std::size_t r = 0; r < meshes.size(); ++r)
    parts.push_back(part_of_field(field, std::move(meshes[r]), static_cast<int>(r)));
  return parts;
}

std::vector<CriticalPoints> split(const CriticalPoints& points, const TriMesh& mesh) {
  const CadFace& face = mesh.face;
  if (face.num_regions() == 1) return {points};
  const std::vector<CadFace> faces = split(face);
  std::vector<CriticalPoints> parts;
  for (const CadFace& part : faces) parts.push_back(without_nodes(points, part));
  const auto region_of_curve = [&](int curve) { return face.region_of_loop(face.loop_of(curve)); };
  for (CriticalPoint node : points.critical_points) {
    const int r = region_at(faces, node);
    const IndexRange elems = elems_of(mesh, r);
    node.elem = elems.contains(node.elem) ? node.elem - elems.begin : 0;
    parts[r].critical_points.push_back(node);
  }
  for (Corner corner : points.corners) {
    const int r = region_of_curve(corner.joint), first = curves_of(face, r).begin;
    corner.joint -= first;
    for (int& curve : corner.curves) curve -= first;
    parts[r].corners.push_back(corner);
  }
  for (IrregularBoundaryPoint node : points.boundary_nodes) {
    const int r = region_of_curve(node.curve);
    node.curve -= curves_of(face, r).begin;
    parts[r].boundary_nodes.push_back(node);
  }
  for (std::size_t r = 0; r < parts.size(); ++r) {
    parts[r].hole_winding_offsets = part_of(points.hole_winding_offsets, holes_of(face, static_cast<int>(r)));
    parts[r].index_sum = index_sum_of(parts[r]);
  }
  return parts;
}

}  // namespace quadrille::regions
