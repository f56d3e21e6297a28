// Triangle meshes and fields: triangles as cells, the field as samples on each of them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "draw/marks.hpp"
#include "mesh/tri_topology.hpp"
#include "page/field_samples.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

namespace {

SideSamples side_of(const spectral::TriMap& map, int edge) {
  const Vec2 along = spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0);
  SideSamples samples;
  for (int k = 0; k <= 8; ++k) {
    Mat2 dx_dxi;
    map.evaluate(spectral::tri_edge_point(edge, k / 8.0), samples[k].position, dx_dxi);
    samples[k].derivative = dx_dxi * along;
  }
  return samples;
}

/// Degrees, with straight edges between the vertices.
double least_angle(const TriMesh& mesh, int elem) {
  double least = pi;
  for (int k = 0; k < 3; ++k) {
    const auto& v = mesh.elem2vertices[elem];
    const Vec2 x = mesh.vertices[v[k]];
    const Vec2 a = mesh.vertices[v[(k + 1) % 3]] - x, b = mesh.vertices[v[(k + 2) % 3]] - x;
    least = std::min(least, std::abs(std::atan2(cross(a, b), dot(a, b))));
  }
  return degrees(least);
}

Quantity least_angles(const TriMesh& mesh) {
  Quantity quantity{"least angle in degrees", "low", 0, 60, {}};
  for (int e = 0; e < mesh.num_elems(); ++e) quantity.values.push_back(least_angle(mesh, e));
  return quantity;
}

JsonObject samples_layer(const Field& field, const PageFrame& frame) {
  const FieldSamples samples = field_samples(draw::RegionFields(field), frame);
  JsonObject layer;
  layer.text("type", "samples").text("key", "field").text("title", "field").text("noun", "field").flag("shown", true);
  layer.flag("unit", field.kind == FieldKind::phase).data("forms", packed(samples.forms));
  layer.data("points", packed(samples.points)).data("scales", packed_floats(samples.scales));
  return layer.data("values", packed(samples.values));
}

Marks prescribed_nodes(const Field& field, const PageFrame& frame) {
  Marks marks;
  const auto add = [&](const PhaseForm& phase) {
    for (const PhaseNode& node : phase.prescribed.nodes)
      marks.add(frame, node.position, node.valence, "node", fmt::format("prescribed node of valence {}", node.valence));
  };
  add(field.phase);
  for (const PhaseForm& phase : field.region_phases) add(phase);
  return marks;
}

std::string orders_text(const std::vector<int>& orders) {
  if (orders.empty()) return "none";
  const auto [least, greatest] = std::minmax_element(orders.begin(), orders.end());
  return *least == *greatest ? std::to_string(*least) : fmt::format("{} to {}", *least, *greatest);
}

}  // namespace

JsonObject triangle_layer(const TriMesh& mesh, const std::vector<Quantity>& quantities, bool is_shown,
                          const PageFrame& frame) {
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  std::map<std::pair<int, int>, int> known;
  std::vector<std::int32_t> vertices, ends, sides;
  Bends bends;
  for (const Vec2 x : mesh.vertices) frame.append(vertices, x);
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.elem2vertices[e][k], b = mesh.elem2vertices[e][(k + 1) % 3];
      const int next = static_cast<int>(ends.size() / 2);
      const auto [edge, is_new] = known.try_emplace({std::min(a, b), std::max(a, b)}, next);
      sides.push_back(is_new ? edge->second + 1 : -edge->second - 1);
      if (!is_new) continue;
      ends.insert(ends.end(), {a, b});
      bends.append(side_of(maps[e], k));
    }
  JsonObject layer;
  layer.text("type", "cells").text("key", "mesh").text("title", "triangles").text("noun", "triangle");
  layer.number("sides", 3).flag("shown", is_shown).flag("plain", true).json("quantities", quantities_json(quantities));
  layer.data("vertices", packed(vertices)).data("ends", packed(ends)).data("elements", packed(sides));
  layer.data("pieces", packed(bends.pieces)).data("bends", packed(bends.points));
  return layer;
}

Sheet stage_sheet(const TriMesh& mesh, const PageFrame& frame) {
  Sheet sheet;
  sheet.title = "Triangle mesh";
  sheet.caption = fmt::format("{} triangles, {} of them curved (order {}){}", mesh.num_elems(),
                              mesh.curved_elems.size(), mesh.order, draw::regions_text(mesh.face));
  sheet.facts = {{"triangles", std::to_string(mesh.num_elems())},
                 {"curved", std::to_string(mesh.curved_elems.size())},
                 {"shape order", std::to_string(mesh.order)},
                 {"boundary edges", std::to_string(mesh.boundary_edges.size())}};
  std::vector<Quantity> quantities{least_angles(mesh)};
  if (!mesh.elem_layer.empty() && *std::max_element(mesh.elem_layer.begin(), mesh.elem_layer.end()) >= 0)
    quantities.push_back({"layer of a corner fan", "", 0, 0, {mesh.elem_layer.begin(), mesh.elem_layer.end()}});
  sheet.layers.push_back(triangle_layer(mesh, quantities, true, frame));
  return sheet;
}

Sheet stage_sheet(const Field& field, const PageFrame& frame) {
  Sheet sheet;
  const bool is_phase = field.kind == FieldKind::phase;
  sheet.title = is_phase ? "Phase form" : "Guiding field";
  sheet.caption = fmt::format("{} triangles, order {}{}", field.mesh.num_elems(), orders_text(field.elem_order),
                              draw::regions_text(field.mesh.face));
  sheet.facts = {{"triangles", std::to_string(field.mesh.num_elems())},
                 {"order", orders_text(field.elem_order)},
                 {"coefficients", std::to_string(field.coef_offsets.back())},
                 {"liftings", std::to_string(field.liftings.size())}};
  sheet.layers.push_back(samples_layer(field, frame));
  std::vector<Quantity> quantities{{"order", "", 0, 0, {field.elem_order.begin(), field.elem_order.end()}},
                                   {"estimated error", "high", 0, 0, field.elem_error, true},
                                   {"sensor", "high", 0, 0, field.elem_sensor, true}};
  sheet.layers.push_back(triangle_layer(field.mesh, quantities, false, frame));
  if (const Marks nodes = prescribed_nodes(field, frame); !nodes.texts.empty())
    sheet.layers.push_back(nodes.layer("nodes", "prescribed nodes"));
  return sheet;
}

}  // namespace quadrille::page
