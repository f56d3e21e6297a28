#include "regions/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/face_boundary.hpp"

namespace quadrille::regions {

namespace {

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
  part.alignment = field.alignment;
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

namespace {

void append_mesh(TriMesh& whole, const TriMesh& part, int first_curve) {
  const int first_elem = whole.num_elems(), first_vertex = static_cast<int>(whole.vertices.size());
  append(whole.vertices, part.vertices);
  for (auto triangle : part.elem2vertices) {
    for (int& v : triangle) v += first_vertex;
    whole.elem2vertices.push_back(triangle);
  }
  for (const int e : part.curved_elems) whole.curved_elems.push_back(first_elem + e);
  append(whole.curved_nodes, part.curved_nodes);
  for (BoundaryEdge edge : part.boundary_edges) {
    edge.elem += first_elem;
    edge.curve += first_curve;
    whole.boundary_edges.push_back(edge);
  }
  append(whole.repairs, part.repairs);
  append(whole.elem_layer, part.elem_layer);
}

// The round of a region that has ended its own: its orders stay, nothing is raised.
AdaptStep round_after_last(const Field& part) {
  AdaptStep step;
  if (!part.adapt_steps.empty()) step = part.adapt_steps.back();
  step.num_raised = step.num_lowered = 0;
  step.elem_order = part.elem_order;
  step.elem_sensor = part.elem_sensor;
  step.max_sensor = part.elem_sensor.empty() ? 0 : *std::max_element(part.elem_sensor.begin(), part.elem_sensor.end());
  step.min_order = *std::min_element(part.elem_order.begin(), part.elem_order.end());
  step.max_order = *std::max_element(part.elem_order.begin(), part.elem_order.end());
  return step;
}

AdaptStep joined_step(const std::vector<Field>& parts, std::size_t round) {
  AdaptStep whole;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const AdaptStep step =
        round < parts[r].adapt_steps.size() ? parts[r].adapt_steps[round] : round_after_last(parts[r]);
    whole.num_unknowns += step.num_unknowns;
    whole.num_raised += step.num_raised;
    whole.num_lowered += step.num_lowered;
    whole.min_order = r == 0 ? step.min_order : std::min(whole.min_order, step.min_order);
    whole.max_order = std::max(whole.max_order, step.max_order);
    whole.max_sensor = std::max(whole.max_sensor, step.max_sensor);
    append(whole.elem_order, step.elem_order);
    append(whole.elem_sensor, step.elem_sensor);
  }
  return whole;
}

void append_points(CriticalPoints& whole, const CriticalPoints& part, int first_elem, int first_curve) {
  const auto append_nodes = [&](std::vector<CriticalPoint>& nodes, const std::vector<CriticalPoint>& part_nodes) {
    for (CriticalPoint node : part_nodes) {
      node.elem += first_elem;
      nodes.push_back(node);
    }
  };
  append_nodes(whole.critical_points, part.critical_points);
  append_nodes(whole.zeros, part.zeros);
  for (Corner corner : part.corners) {
    corner.joint += first_curve;
    for (int& curve : corner.curves) curve += first_curve;
    whole.corners.push_back(corner);
  }
  for (IrregularBoundaryPoint node : part.boundary_nodes) {
    node.curve += first_curve;
    whole.boundary_nodes.push_back(node);
  }
  append(whole.hole_winding_offsets, part.hole_winding_offsets);
  whole.index_sum += part.index_sum;
  whole.index_sum_expected += part.index_sum_expected;
  append(whole.clusters, part.clusters);
  append(whole.changes, part.changes);
}

void append_certificate(Certificate& whole, const Certificate& part, int first_elem) {
  whole.elements += part.elements;
  whole.cells_examined += part.cells_examined;
  whole.cells_excluded += part.cells_excluded;
  whole.cells_isolated += part.cells_isolated;
  whole.cells_left_to_corners += part.cells_left_to_corners;
  whole.greatest_depth = std::max(whole.greatest_depth, part.greatest_depth);
  for (CertificateCell cell : part.cells) {
    cell.elem += first_elem;
    whole.cells.push_back(cell);
  }
  append(whole.disc_centres, part.disc_centres);
  append(whole.disc_radii, part.disc_radii);
}

// Lists that are empty where they have nothing to add are filled up if a list of another part is not.
void complete_lists(const TriMesh& whole, std::vector<CriticalPoints>& parts) {
  const auto any = [&](auto&& has) { return std::any_of(parts.begin(), parts.end(), has); };
  if (any([](const CriticalPoints& p) { return !p.zeros.empty(); })) {
    for (CriticalPoints& part : parts)
      if (part.zeros.empty() && part.changes.empty()) part.zeros = part.critical_points;
  }
  if (any([](const CriticalPoints& p) { return !p.hole_winding_offsets.empty(); })) {
    for (std::size_t r = 0; r < parts.size(); ++r)
      parts[r].hole_winding_offsets.resize(holes_of(whole.face, static_cast<int>(r)).size(), 0);
  }
}

}  // namespace

TriMesh join(const CadFace& whole, std::vector<TriMesh> parts) {
  TriMesh mesh;
  if (parts.size() == 1) {
    mesh = std::move(parts.front());
  } else {
    mesh.provenance = parts.front().provenance;
    mesh.order = parts.front().order;
    for (std::size_t r = 0; r < parts.size(); ++r) {
      mesh.region_elems.push_back(mesh.num_elems());
      append_mesh(mesh, parts[r], curves_of(whole, static_cast<int>(r)).begin);
    }
    mesh.region_elems.push_back(mesh.num_elems());
  }
  mesh.face = whole;
  return mesh;
}

Field join(const TriMesh& whole, std::vector<Field> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Field field;
  field.provenance = parts.front().provenance;
  field.mesh = whole;
  field.kind = parts.front().kind;
  field.method = parts.front().method;
  field.alignment = parts.front().alignment;
  field.coef_offsets.push_back(0);
  std::size_t num_rounds = 0;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    Field& part = parts[r];
    const int first_curve = curves_of(whole.face, static_cast<int>(r)).begin, first_coef = field.coef_offsets.back();
    append(field.elem_order, part.elem_order);
    for (std::size_t e = 1; e < part.coef_offsets.size(); ++e)
      field.coef_offsets.push_back(first_coef + part.coef_offsets[e]);
    for (Lifting lifting : part.liftings) {
      lifting.joint += first_curve;
      field.liftings.push_back(lifting);
    }
    for (const auto reals : {&Field::u, &Field::v, &Field::elem_sensor, &Field::elem_error})
      append(field.*reals, part.*reals);
    num_rounds = std::max(num_rounds, part.adapt_steps.size());
    if (field.kind == FieldKind::phase) field.region_phases.push_back(part.phase);
  }
  for (std::size_t round = 0; round < num_rounds; ++round) field.adapt_steps.push_back(joined_step(parts, round));
  return field;
}

CriticalPoints join(const TriMesh& whole, std::vector<CriticalPoints> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  complete_lists(whole, parts);
  CriticalPoints points;
  points.provenance = parts.front().provenance;
  points.origin = parts.front().origin;
  points.face = whole.face;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const int region = static_cast<int>(r), first_elem = elems_of(whole, region).begin;
    append_certificate(points.certificate, parts[r].certificate, first_elem);
    if (parts[r].form == NodeForm::phase) points.form = NodeForm::phase;
    append_points(points, parts[r], first_elem, curves_of(whole.face, region).begin);
  }
  return points;
}

}  // namespace quadrille::regions
