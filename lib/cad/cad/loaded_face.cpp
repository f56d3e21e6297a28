#include "cad/loaded_face.hpp"

#include <utility>

#include "base/byte_archive.hpp"

namespace quadrille::cad {

namespace {

// Those of a joint are named because the padding after the last one is not data.
struct Members {
  static void of(auto& a, Is<Joint> auto& j) {
    a(j.position, j.tangent_in, j.tangent_out, j.interior_angle, j.is_corner);
  }
  static void of(auto& a, Is<Nurbs> auto& c) { a(c.degree, c.knots, c.poles, c.weights); }
  static void of(auto& a, Is<ListedShape> auto& s) { a(s.name, s.kind, s.length, s.place); }
  static void of(auto& a, Is<ListedFace> auto& f) { a(f.face, f.part, f.layer, f.edges, f.size, f.is_closed); }
  static void of(auto& a, Is<FaceList> auto& l) { a(l.length_unit, l.faces, l.not_built); }
  static void of(auto& a, Is<CadFace> auto& f) {
    a(f.length_unit, f.metres_per_unit, f.plane_origin, f.plane_x, f.plane_y, f.origin, f.diameter, f.fit_distance);
    a(f.curves, f.curve_names, f.unnamed_curves, f.curve_cad_edges, f.loop_offsets, f.joints, f.name);
    a(f.region_loops, f.region_names, f.partners);
  }
  static void of(auto& a, Is<SpaceCurve> auto& c) { a(c.degree, c.knots, c.poles, c.weights); }
  static void of(auto& a, Is<NurbsSurface> auto& s) {
    a(s.degree_u, s.degree_v, s.knots_u, s.knots_v, s.poles, s.weights, s.is_closed_u, s.is_closed_v);
  }
  static void of(auto& a, Is<InnerSpaceCurve> auto& c) { a(c.curve, c.name, c.cad_edge, c.faces); }
  static void of(auto& a, Is<FineBoundaryEdge> auto& e) { a(e.vertices, e.curve, e.t0, e.t1); }
  static void of(auto& a, Is<SpaceFace> auto& f) {
    a(f.face, f.curves, f.surface, f.is_reversed, f.vertices, f.triangles, f.triangle_uv, f.boundary_edges);
    a(f.inner_curves, f.tolerance, f.face_names, f.curve_faces);
  }
  static void of(auto& a, Is<LoadedFace> auto& l) { a(l.face, l.repairs); }
  static void of(auto& a, Is<LoadOptions> auto& o) {
    a(o.corner_angle, o.heal_tolerance, o.face, o.blunt_width, o.fit_tolerance, o.section);
  }
  static void of(auto& a, Is<CadRequest> auto& r) { a(r.task, r.name, r.bytes, r.options, r.face); }
  static void of(auto& a, Is<Report::Warning> auto& w) { a(w.code, w.message); }
};

template <class Face>
Face face_and_report(const std::string& bytes, Report& report) {
  Face face;
  std::vector<std::pair<std::string, Report::Value>> entries;
  std::vector<Report::Warning> warnings;
  from_bytes_by<Members>(bytes, face, entries, warnings);
  for (const auto& [key, value] : entries) report.set(key, value);
  for (const Report::Warning& warning : warnings) report.warn(warning.code, warning.message);
  return face;
}

}  // namespace

std::string to_bytes(const CadRequest& request) { return to_bytes_by<Members>(request); }

CadRequest request_from_bytes(const std::string& bytes) {
  CadRequest request;
  from_bytes_by<Members>(bytes, request);
  return request;
}

std::string to_bytes(const FaceList& list) { return to_bytes_by<Members>(list); }

FaceList list_from_bytes(const std::string& bytes) {
  FaceList list;
  from_bytes_by<Members>(bytes, list);
  return list;
}

std::string to_bytes(const LoadedFace& loaded, const Report& report) {
  return to_bytes_by<Members>(loaded, report.entries(), report.warnings());
}

LoadedFace from_bytes(const std::string& bytes, Report& report) { return face_and_report<LoadedFace>(bytes, report); }

std::string to_bytes(const SpaceFace& face, const Report& report) {
  return to_bytes_by<Members>(face, report.entries(), report.warnings());
}

SpaceFace space_face_from_bytes(const std::string& bytes, Report& report) {
  return face_and_report<SpaceFace>(bytes, report);
}

std::string to_bytes(const AnyFace& face, const Report& report) {
  const std::string kind = std::holds_alternative<SpaceFace>(face) ? "s" : "p";
  return kind + std::visit([&](const auto& f) { return to_bytes(f, report); }, face);
}

AnyFace any_face_from_bytes(const std::string& bytes, Report& report) {
  if (bytes.starts_with('s')) return space_face_from_bytes(bytes.substr(1), report);
  return from_bytes(bytes.substr(1), report);
}

}  // namespace quadrille::cad
