#include "io/describe.hpp"

namespace quadrille::io {

namespace {

void describe_certificate(Archive& archive, LayoutCertificate& certificate) {
  LayoutMethod method = certificate.method.value_or(LayoutMethod::traced);
  archive.field("method", method, {}, "SEP-R11");
  certificate.method = method;
  archive.field("reason", certificate.reason);
  archive.field("index_sum", certificate.index_sum);
  archive.field("face_valence_histogram", certificate.face_valence_histogram, [](Archive& a, FaceCount& count) {
    a.field("corners", count.corners);
    a.field("faces", count.faces);
  });
  archive.field("t_junctions", certificate.t_junctions);
  archive.field("merged_lines", certificate.merged_lines);
  archive.field("collapsed_chords", certificate.collapsed_chords);
  archive.field("shortened_spirals", certificate.shortened_spirals);
  archive.field("largest_deviation_degrees", certificate.largest_deviation_degrees);
}

}  // namespace

void describe(Archive& archive, SeparatrixGraph& graph) {
  LayoutCertificate& certificate = graph.certificate;
  if (archive.is_reading() ? archive.has("certificate") : certificate.method.has_value())
    archive.object("certificate", [&](Archive& a) { describe_certificate(a, certificate); });
  describe_graph(archive, graph.nodes, graph.arcs);
  archive.field("lines", graph.lines, [](Archive& a, SeparatrixLine& line) {
    a.field("origin", line.origin);
    a.field("end", line.end);
    a.field("kind", line.kind);
    a.field("arcs", line.arcs);
  });
  archive.field("t_junctions", graph.t_junctions);
  describe_nurbs(archive, "splines", graph.splines);
  describe_open_curves(archive, graph.open_curves);
  describe_face(archive, graph.face);
}

}  // namespace quadrille::io
