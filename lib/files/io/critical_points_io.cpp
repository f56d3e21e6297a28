#include "io/describe.hpp"

namespace quadrille::io {

namespace {

/// `id` is informative: the position in the list when the file was written. Edited lists need not keep it.
void describe_id(Archive& archive, std::size_t index) {
  int id = static_cast<int>(index);
  if (!archive.is_reading()) archive.field("id", id);
}

/// The field index 4 - V of a node; V may be any integer of the file, rule CRT-R02 refuses what is no valence.
int index_of(int valence) { return valence < -1000 ? 1000 : 4 - valence; }

void describe_source(Archive& a, NodeSource& source) {
  if (a.has("source")) a.extensible_field("source", source, NodeSource::other);
}

/// A node added by hand needs no more than its position and valence.
void describe_critical_point(Archive& a, CriticalPoint& point, std::size_t index) {
  describe_id(a, index);
  a.field("position", point.position);
  a.field("valence", point.valence);
  point.index = a.is_reading() ? index_of(point.valence) : point.index;
  a.later_field("index", point.index);
  a.later_field("elem", point.elem);
  a.later_field("xi", point.xi);
  const bool was_computed = a.has("jacobian");
  if (was_computed) a.field("jacobian", point.jacobian);
  a.later_field("error", point.error);
  if (!was_computed) point.source = NodeSource::hand;
  describe_source(a, point.source);
}

void describe_corner(Archive& a, Corner& corner) {
  a.field("joint", corner.joint);
  a.field("position", corner.position);
  a.field("angle_degrees", corner.angle_degrees);
  a.field("valence", corner.valence);
  if (!a.is_reading()) {
    bool is_degenerate = corner.valence == 0;
    a.field("degenerate", is_degenerate);
  }
  a.field("curves", corner.curves);
  describe_source(a, corner.source);
}

void describe_boundary_node(Archive& a, IrregularBoundaryPoint& point) {
  a.field("curve", point.curve);
  a.field("t", point.t);
  a.field("position", point.position);
  a.field("valence", point.valence);
  describe_source(a, point.source);
}

void describe_mark(Archive& a, NodeMark& mark) {
  a.field("position", mark.position);
  a.field("valence", mark.valence);
  a.field("where", mark.location, {}, "CRT-R16");
}

void describe_change(Archive& a, NodeChange& change) {
  a.extensible_field("kind", change.kind, ChangeKind::other);
  a.field("reason", change.reason);
  a.field("before", change.before, describe_mark);
  a.field("after", change.after, describe_mark);
}

void describe_cluster(Archive& a, Cluster& cluster) {
  a.field("centre", cluster.centre);
  a.field("radius", cluster.radius);
  a.field("index", cluster.index);
  a.field("members", cluster.members);
  a.field("member_indices", cluster.member_indices);
}

void describe_certificate(Archive& a, Certificate& certificate) {
  a.field("elements", certificate.elements);
  a.field("cells_examined", certificate.cells_examined);
  a.field("cells_excluded", certificate.cells_excluded);
  a.field("cells_isolated", certificate.cells_isolated);
  a.field("cells_left_to_corners", certificate.cells_left_to_corners);
  a.field("greatest_depth", certificate.greatest_depth);
  a.field("cells", certificate.cells, [](Archive& inner, CertificateCell& cell) {
    inner.field("elem", cell.elem);
    inner.field("vertices", cell.vertices);
    inner.field("verdict", cell.verdict, {}, "CRT-R15");
  });
  a.field("disc_centres", certificate.disc_centres);
  a.field("disc_radii", certificate.disc_radii);
}

/// The index sum stated in the file or, if it states none, computed from its lists.
void describe_index_sum(Archive& archive, CriticalPoints& points) {
  points.index_sum = archive.is_reading() ? index_sum_of(points) : points.index_sum;
  archive.object("index_sum", [&](Archive& a) {
    a.later_field("value", points.index_sum);
    a.field("expected", points.index_sum_expected);
  });
}

}  // namespace

void describe(Archive& archive, CriticalPoints& points) {
  if (archive.has("form")) archive.field("form", points.form, {}, "CRT-R12");
  archive.field("origin", points.origin);
  std::size_t next = 0, next_zero = 0;
  archive.field("critical_points", points.critical_points,
                [&](Archive& a, CriticalPoint& point) { describe_critical_point(a, point, next++); });
  archive.field("corners", points.corners, describe_corner);
  if (archive.has("boundary_nodes")) archive.field("boundary_nodes", points.boundary_nodes, describe_boundary_node);
  archive.later_field("hole_winding_offsets", points.hole_winding_offsets);
  describe_index_sum(archive, points);
  if (archive.has("changes")) archive.field("changes", points.changes, describe_change);
  if (archive.has("clusters")) archive.field("clusters", points.clusters, describe_cluster);
  if (archive.has("zeros"))
    archive.field("zeros", points.zeros,
                  [&](Archive& a, CriticalPoint& point) { describe_critical_point(a, point, next_zero++); });
  if (archive.has("certificate"))
    archive.object("certificate", [&](Archive& a) { describe_certificate(a, points.certificate); });
  const bool has_face = archive.is_reading() ? archive.has("face") : !points.face.curves.empty();
  if (has_face) describe_face(archive, points.face);
}

}  // namespace quadrille::io
