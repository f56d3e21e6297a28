#include <memory>
#include <utility>

#include "io/describe.hpp"

namespace quadrille::io {

namespace {

void describe_surface(Archive& archive, NurbsSurface& surface) {
  archive.field("degree_u", surface.degree_u, {"1", "polynomial degree of the numerator in u"});
  archive.field("degree_v", surface.degree_v, {"1", "polynomial degree of the numerator in v"});
  archive.field("knots_u", surface.knots_u, {"1", "clamped knot vector in u"});
  archive.field("knots_v", surface.knots_v, {"1", "clamped knot vector in v"});
  archive.field("poles", surface.poles, {"length", "control points in the coordinates of the CAD file, v fastest"});
  archive.field("weights", surface.weights, {"1", "weights of the poles, positive"});
  archive.field("is_closed_u", surface.is_closed_u, {"", "1 where both ends in u are the same curve"});
  archive.field("is_closed_v", surface.is_closed_v, {"", "1 where both ends in v are the same curve"});
}

void describe_space_curve(Archive& archive, SpaceCurve& curve) {
  archive.field("degree", curve.degree, {"1", "polynomial degree of the numerator"});
  archive.field("knots", curve.knots, {"1", "clamped knot vector"});
  archive.field("poles", curve.poles, {"length", "control points in the coordinates of the CAD file"});
  archive.field("weights", curve.weights, {"1", "weights of the poles, positive"});
}

void describe_members(Archive& archive, Chart& chart) {
  archive.field("order", chart.order, {"", "order P of the triangles"});
  archive.field("elem2vertices", chart.elem2vertices, {"", "vertices of each element, counter-clockwise"});
  archive.field("nodes", chart.nodes, {"length", "(P+1)(P+2)/2 nodes per element, in the chart"});
  archive.field("space_nodes", chart.space_nodes, {"length", "the same nodes in the coordinates of the CAD file"});
  archive.field("uv", chart.uv, {"1", "the same nodes: parameters on the surface of their element"});
  archive.field("log_scale", chart.log_scale, {"1", "the same nodes: ln of length in space over length in the chart"});
  archive.field("elem_surface", chart.elem_surface, {"", "surface of each element"});
  archive.field("surfaces", chart.surfaces, describe_surface);
  archive.field("space_curves", chart.space_curves, describe_space_curve);
  archive.field("closedness", chart.closedness, {"radian", "error of the angles of the chart"});
}

}  // namespace

void describe_chart(Archive& archive, CadFace& face) {
  if (archive.is_reading() ? !archive.has("chart") : !face.chart) return;
  Chart chart = face.chart ? *face.chart : Chart();
  archive.packed_object("chart", [&](Archive& a) { describe_members(a, chart); });
  if (archive.is_reading()) face.chart = std::make_shared<const Chart>(std::move(chart));
}

void describe(Archive& archive, ChartedFace& charted) { describe_face(archive, charted.face); }

}  // namespace quadrille::io
