#include "layout/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {
namespace {

constexpr int samples_of_arc = 8;

void report_certificate(const LayoutCertificate& certificate, Report& report) {
  report.set("certificate.method", enum_name(*certificate.method));
  report.set("certificate.index_sum", certificate.index_sum);
  for (const FaceCount& count : certificate.face_valence_histogram)
    report.set(fmt::format("certificate.faces_of_{}_corners", count.corners), count.faces);
  report.set("certificate.t_junctions", certificate.t_junctions);
  report.set("certificate.merged_lines", certificate.merged_lines);
  report.set("certificate.collapsed_chords", certificate.collapsed_chords);
  report.set("certificate.shortened_spirals", certificate.shortened_spirals);
  report.set("certificate.largest_deviation_degrees", certificate.largest_deviation_degrees);
}

}  // namespace

void certify(const field::FieldsOfRegions& fields, LayoutMethod method, graph::CandidateLayout& layout,
             Report& report) {
  double& deviation = layout.certificate.largest_deviation_degrees;
  deviation = std::max(deviation, degrees(deviation_of_extended_lines(fields, layout)));
  certify(method, layout, report);
}

void certify(LayoutMethod method, graph::CandidateLayout& layout, Report& report) {
  LayoutCertificate& certificate = layout.certificate;
  certificate.method = method;
  certificate.index_sum = static_cast<int>(index_sum_of(layout.graph()));
  certificate.face_valence_histogram = graph::face_valence_histogram(layout.subdivision);
  certificate.t_junctions = static_cast<int>(layout.t_junctions.size());
  report_certificate(certificate, report);
}

double deviation_of_extended_lines(const field::FieldsOfRegions& fields, const graph::CandidateLayout& layout) {
  const ArcGraph& graph = layout.graph();
  std::vector<Vec2> positions;
  std::vector<double> angles;
  for (const SeparatrixLine& line : layout.lines) {
    if (line.kind != LineKind::extended) continue;
    for (const int arc : line.arcs)
      for (const ArcPiece& piece : graph.arcs[arc].pieces)
        for (int i = 1; i < samples_of_arc; ++i) {
          const double t = piece.t0 + (piece.t1 - piece.t0) * i / samples_of_arc;
          positions.push_back(curve::point(graph.curve(piece.curve), t));
          angles.push_back(angle_of(curve::tangent(graph.curve(piece.curve), t)));
        }
  }
  double deviation = 0;
  const std::vector<field::PointSample> samples = fields.values_at(positions);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].at.elem >= 0)
      deviation = std::max(deviation, std::abs(guided_angle(samples[i].value, angles[i]) - angles[i]));
  return deviation;
}

}  // namespace quadrille::layout
