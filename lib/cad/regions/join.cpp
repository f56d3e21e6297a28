#include "regions/join.hpp"

#include <algorithm>
#include <utility>

#include "regions/region_numbers.hpp"

namespace quadrille::regions {
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
  field.coef_offsets.push_back(0);
  std::size_t num_rounds = 0;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    Field& part = parts[r];
    const int first_curve = curves_of(whole.face, static_cast<int>(r)).begin, first_coef = field.coef_offsets.back();
    append(field.elem_order, part.elem_order);
    for (std::size_t e = 1; e < part.coef_offsets.size(); ++e)
      field.coef_offsets.push_back(first_coef + part.coef_offsets[e]);
    append(field.u, part.u);
    append(field.v, part.v);
    for (Lifting lifting : part.liftings) {
      lifting.joint += first_curve;
      field.liftings.push_back(lifting);
    }
    append(field.elem_sensor, part.elem_sensor);
    append(field.elem_error, part.elem_error);
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
