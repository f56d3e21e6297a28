#include "space/assemble_space_face.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/vec3.hpp"
#include "base/warning_codes.hpp"
#include "heal/heal_rules.hpp"
#include "space/boundary_loops.hpp"
#include "space/space_curve.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

/// A curve of a loop without inner tangent jumps, and the edges of the triangulation on it.
struct Piece {
  SpaceCurve curve;
  int edge = 0;
  std::vector<FineBoundaryEdge> fine;
};

double box_diagonal(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return norm(high - low);
}

/// The polygon of the edge in the direction of the loop, with parameters on the reversed curve where it is reversed.
EdgePolygon directed(const EdgePolygon& polygon, const SpaceCurve& curve, bool is_reversed) {
  EdgePolygon result = polygon;
  if (!is_reversed) return result;
  std::reverse(result.vertices.begin(), result.vertices.end());
  std::reverse(result.parameters.begin(), result.parameters.end());
  for (double& t : result.parameters) t = curve.begin() + (curve.end() - t);
  return result;
}

/// The parts of an edge between its tangent jumps.
class EdgeCutter {
 public:
  EdgeCutter(const RawSpaceFace& raw, const LoopEdge& edge)
      : raw_(raw), polygon_(raw.polygons[edge.polygon]), curve_(raw.curves[polygon_.edge]) {
    if (edge.is_reversed) curve_ = surface::reversed(curve_);
    polygon_ = directed(polygon_, curve_, edge.is_reversed);
    breaks_ = tangent_jumps(curve_);
    breaks_.insert(breaks_.begin(), curve_.begin());
    breaks_.push_back(curve_.end());
    for (double& t : polygon_.parameters) t = snapped(t);
    polygon_.parameters.front() = curve_.begin(), polygon_.parameters.back() = curve_.end();
  }

  std::vector<Piece> pieces() const {
    std::vector<Piece> result;
    for (std::size_t b = 0; b + 1 < breaks_.size(); ++b)
      result.push_back({trimmed(curve_, breaks_[b], breaks_[b + 1]), polygon_.edge, fine_between(b)});
    return result;
  }

 private:
  double snapped(double t) const {
    const double near = 1e-9 * (curve_.end() - curve_.begin());
    for (const double b : breaks_)
      if (std::abs(t - b) <= near) return b;
    return t;
  }

  /// The kernel puts a vertex at each knot of a curve.
  std::vector<FineBoundaryEdge> fine_between(std::size_t b) const {
    std::vector<FineBoundaryEdge> fine;
    const std::vector<double>& t = polygon_.parameters;
    for (std::size_t i = 0; i + 1 < t.size(); ++i)
      if (t[i] >= breaks_[b] && t[i + 1] <= breaks_[b + 1])
        fine.push_back({{polygon_.vertices[i], polygon_.vertices[i + 1]}, 0, t[i], t[i + 1]});
    const bool is_whole = !fine.empty() && fine.front().t0 == breaks_[b] && fine.back().t1 == breaks_[b + 1];
    if (!is_whole)
      throw FormatError(fmt::format(
          "{}: edge {}: the CAD kernel's triangles do not end at its kink at {}: cut the "
          "edge there in the CAD program",
          raw_.labels.file, raw_.cad_edge(polygon_.edge), position_text(surface::point(curve_, breaks_[b]))));
    return fine;
  }

  const RawSpaceFace& raw_;
  EdgePolygon polygon_;
  SpaceCurve curve_;
  std::vector<double> breaks_;
};

/// Makes consecutive curves meet, and keeps account of how far they were moved.
class GapCloser {
 public:
  GapCloser(const RawSpaceFace& raw, const heal::HealScale& scale) : raw_(raw), scale_(scale) {}

  /// The ends of neighbours move to the middle between them.
  void close(std::vector<Piece>& loop) {
    std::vector<Vec3> starts;
    for (std::size_t i = 0; i < loop.size(); ++i)
      starts.push_back(joint(loop[(i + loop.size() - 1) % loop.size()], loop[i]));
    for (std::size_t i = 0; i < loop.size(); ++i)
      loop[i].curve = with_ends(std::move(loop[i].curve), starts[i], starts[(i + 1) % loop.size()]);
  }

  void report(Report& to) const {
    to.set("heal.tolerance", scale_.tolerance / scale_.diameter);
    to.set("heal.repairs", num_repairs_);
    to.set("heal.greatest", greatest_ / scale_.diameter);
    if (greatest_ > heal::heal_rules.large_tolerance * scale_.diameter)
      to.warn(warning::large_repair,
              fmt::format("{}: the ends of edges were moved by up to {:.3g} to meet", scale_.file, greatest_));
  }

 private:
  Vec3 joint(const Piece& in, const Piece& out) {
    const Vec3 end = in.curve.poles.back(), begin = out.curve.poles.front();
    const double moved = distance(end, begin) / 2;
    if (moved > std::max(scale_.tolerance, scale_.rounding))
      throw FormatError(fmt::format("{}: edge {} ends at {}, {:.3g} from the start of edge {}{}", scale_.file,
                                    raw_.cad_edge(in.edge), position_text(end), 2 * moved, raw_.cad_edge(out.edge),
                                    heal::remedy(scale_, moved)));
    greatest_ = std::max(greatest_, moved);
    num_repairs_ += moved > scale_.rounding;
    return end == begin ? begin : 0.5 * (end + begin);
  }

  const RawSpaceFace& raw_;
  heal::HealScale scale_;
  double greatest_ = 0;
  int num_repairs_ = 0;
};

/// What was read beside curves and triangles.
CadFace labelled_face(const heal::RawFace& labels) {
  CadFace face;
  face.name = labels.name;
  face.length_unit = labels.length_unit, face.metres_per_unit = labels.metres_per_unit;
  face.loop_offsets = {0};
  return face;
}

void add_loop(const RawSpaceFace& raw, std::vector<Piece> loop, SpaceFace& result) {
  for (Piece& piece : loop) {
    for (FineBoundaryEdge& e : piece.fine) {
      e.curve = static_cast<int>(result.curves.size());
      result.boundary_edges.push_back(e);
    }
    const heal::RawEdge& edge = raw.labels.wires.front()[piece.edge];
    result.curves.push_back(std::move(piece.curve));
    result.face.curve_names.push_back(edge.name);
    result.face.curve_cad_edges.push_back(edge.cad_edge);
    result.curve_faces.push_back(raw.edge_faces.empty() ? 0 : raw.edge_faces[piece.edge]);
  }
  result.face.loop_offsets.push_back(static_cast<int>(result.curves.size()));
}

/// Parameters on the surface of each vertex, in one of its triangles.
std::vector<Vec2> vertex_parameters(const SpaceFace& face) {
  std::vector<Vec2> result(face.vertices.size());
  for (std::size_t i = 0; i < face.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) result[face.triangles[i][k]] = face.triangle_uv[i][k];
  return result;
}

/// The vertices lie on the surface, but not where the curve has their parameters: they are first guesses alone.
void warn_of_edges_off_the_surface(const SpaceFace& face, const heal::HealScale& scale, Report& report) {
  const std::vector<Vec2> uv = vertex_parameters(face);
  double greatest = 0;
  int at = -1;
  for (const FineBoundaryEdge& e : face.boundary_edges) {
    const Vec3 x = surface::point(face.curves[e.curve], e.t0);
    const int vertex = e.vertices[0];
    const double off =
        std::min(distance(x, face.vertices[vertex]), surface::project(face.surface, x, uv[vertex]).distance);
    if (off > greatest) greatest = off, at = e.curve;
  }
  report.set("surface.edge_distance", greatest / scale.diameter);
  if (greatest > heal::heal_rules.default_tolerance * scale.diameter)
    report.warn(warning::edge_off_surface,
                fmt::format("{}: edges lie off the surface of the face by up to {:.3g}, most edge {}: nodes on the "
                            "boundary lie on the edges",
                            scale.file, greatest, face.face.curve_cad_edges[at]));
}

/// Cut where their tangents jump.
void add_inner_curves(const RawSpaceFace& raw, SpaceFace& result) {
  for (std::size_t i = 0; i < raw.inner_edges.size(); ++i) {
    const auto& [curve, faces] = raw.inner_edges[i];
    const heal::RawEdge& labels = raw.labels.inner_edges[i];
    std::vector<double> breaks = tangent_jumps(curve);
    breaks.insert(breaks.begin(), curve.begin());
    breaks.push_back(curve.end());
    for (std::size_t b = 1; b < breaks.size(); ++b)
      result.inner_curves.push_back({trimmed(curve, breaks[b - 1], breaks[b]), labels.name, labels.cad_edge, faces});
  }
}

}  // namespace

SpaceFace assemble_space_face(const RawSpaceFace& raw, double heal_tolerance, Report& report) {
  const auto loops = boundary_loops(raw);
  SpaceFace result;
  result.face = labelled_face(raw.labels);
  result.surface = raw.surface, result.is_reversed = raw.is_reversed;
  result.vertices = raw.vertices, result.triangles = raw.triangles, result.triangle_uv = raw.triangle_uv;
  const heal::HealScale scale = heal::heal_scale(raw.labels, heal_tolerance, box_diagonal(raw.vertices));
  result.face_names = raw.face_names;
  result.tolerance = std::max(scale.tolerance, scale.rounding);
  GapCloser closer(raw, scale);
  for (const std::vector<LoopEdge>& edges : loops) {
    std::vector<Piece> loop;
    for (const LoopEdge& edge : edges)
      for (Piece& piece : EdgeCutter(raw, edge).pieces()) loop.push_back(std::move(piece));
    closer.close(loop);
    add_loop(raw, std::move(loop), result);
  }
  result.face.unnamed_curves = replace_empty_names(result.face.curve_names, "curve");
  closer.report(report);
  warn_of_edges_off_the_surface(result, scale, report);
  add_inner_curves(raw, result);
  return result;
}

}  // namespace quadrille::space
