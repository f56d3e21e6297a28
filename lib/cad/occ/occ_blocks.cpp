#include "occ/occ_blocks.hpp"

#include <fmt/format.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>
#include <memory>
#include <optional>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "occ/occ_block_geometry.hpp"
#include "occ/occ_splines.hpp"

namespace quadrille::occ {
namespace {

gp_Pnt point_in_space(const CadFace& face, double scale, Vec2 x) {
  const Vec2 p = x + face.origin;
  const auto c = [&](int k) { return scale * (face.plane_origin[k] + p.x * face.plane_x[k] + p.y * face.plane_y[k]); };
  return {c(0), c(1), c(2)};
}

gp_Pln plane_in_space(const CadFace& face, double scale) {
  const auto &e_x = face.plane_x, &e_y = face.plane_y;
  const gp_Dir x(e_x[0], e_x[1], e_x[2]), y(e_y[0], e_y[1], e_y[2]);
  return gp_Pln(gp_Ax3(point_in_space(face, scale, {0, 0}), x.Crossed(y), x));
}

Handle(Geom_BSplineCurve) spline(const CadFace& face, double scale, const Nurbs& curve) {
  SpaceCurve in_space{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec2 pole : curve.poles) {
    const gp_Pnt x = point_in_space(face, scale, pole);
    in_space.poles.push_back({x.X(), x.Y(), x.Z()});
  }
  return occ_spline(in_space);
}

/// An arc of a circle; `sweep` is positive if it is counter-clockwise.
struct CircularArc {
  Vec2 centre;
  double radius = 0, sweep = 0;
};

// The circle of a rational parabola chain, if all of it is on one.
std::optional<CircularArc> circular_arc(const Nurbs& curve) {
  constexpr double rounding = 1e-14;
  constexpr int samples = 7;  // of each span, with both ends: six points decide whether two conics are equal
  if (curve.degree != 2) return std::nullopt;
  std::vector<Vec2> points{curve::point(curve, curve.begin())};
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    for (int i = 1; i < samples && curve.knots[k - 1] < curve.knots[k]; ++i)
      points.push_back(
          curve::point(curve, curve.knots[k - 1] + (curve.knots[k] - curve.knots[k - 1]) * i / (samples - 1)));
  const Vec2 a = points[0], p = points[points.size() / 3] - a, q = points[2 * points.size() / 3] - a;
  const double area = 2 * cross(p, q);
  if (std::abs(area) <= 1e-6 * norm(p) * norm(q)) return std::nullopt;
  CircularArc arc;
  arc.centre = a + Vec2{q.y * norm2(p) - p.y * norm2(q), p.x * norm2(q) - q.x * norm2(p)} / area;
  arc.radius = distance(a, arc.centre);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double scale = arc.radius + norm(arc.centre);
    if (std::abs(distance(points[i], arc.centre) - arc.radius) > rounding * scale) return std::nullopt;
    if (i > 0) arc.sweep += wrap_pi(angle_of(points[i] - arc.centre) - angle_of(points[i - 1] - arc.centre));
  }
  return arc;
}

// From the start of `curve`, in its direction.
Handle(Geom_Circle) circle_in_space(const CadFace& face, double scale, const Nurbs& curve, const CircularArc& arc) {
  const gp_Pnt centre = point_in_space(face, scale, arc.centre);
  const gp_Dir normal = plane_in_space(face, scale).Axis().Direction();
  const gp_Dir to_start(gp_Vec(centre, point_in_space(face, scale, curve.poles.front())));
  return new Geom_Circle(gp_Ax2(centre, arc.sweep > 0 ? normal : normal.Reversed(), to_start), scale * arc.radius);
}

// An edge from vertex to vertex: a line or a circle if the curve is one, else an exact B-spline.
TopoDS_Edge edge_in_space(const CadFace& face, double scale, const Nurbs& curve, const TopoDS_Vertex& from,
                          const TopoDS_Vertex& to, double tolerance) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  double first = curve.begin(), last = curve.end();
  if (curve.degree == 1 && curve.poles.size() == 2) {
    const gp_Pnt a = point_in_space(face, scale, curve.poles.front());
    const gp_Pnt b = point_in_space(face, scale, curve.poles.back());
    builder.MakeEdge(edge, new Geom_Line(a, gp_Dir(gp_Vec(a, b))), tolerance);
    first = 0, last = a.Distance(b);
  } else if (const std::optional<CircularArc> arc = circular_arc(curve)) {
    builder.MakeEdge(edge, circle_in_space(face, scale, curve, *arc), tolerance);
    first = 0, last = std::abs(arc->sweep);
  } else {
    builder.MakeEdge(edge, spline(face, scale, curve), tolerance);
  }
  builder.Add(edge, from.Oriented(TopAbs_FORWARD));
  builder.Add(edge, to.Oriented(TopAbs_REVERSED));
  builder.Range(edge, first, last);
  return edge;
}

// The edges of a face with regions and slits, which both sides of a common curve share.
class SharedEdges {
 public:
  SharedEdges(const CadFace& face, double scale, OccShape& result)
      : face_(face), scale_(scale), result_(result), places_(face.num_curves()) {
    for (int c = 0; c < face.num_curves(); ++c)
      if (face.is_interface(c)) places_.unite(c, face.next_in_loop(face.partners[c]));
    vertices_.resize(face.num_curves());
    edges_.resize(face.num_curves());
  }

  /// The wire of a loop; adds the names of new edges to the result.
  TopoDS_Wire wire(int loop) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (int c = face_.loop_offsets[loop]; c < face_.loop_offsets[loop + 1]; ++c) builder_.Add(wire, edge(c));
    wire.Closed(true);
    return wire;
  }

  /// The edges of a loop, each once.
  std::vector<TopoDS_Shape> edges_of(int loop) {
    std::vector<TopoDS_Shape> edges;
    for (int c = face_.loop_offsets[loop]; c < face_.loop_offsets[loop + 1]; ++c)
      if (c < face_.partners[c]) edges.push_back(edge(c));
    return edges;
  }

 private:
  TopoDS_Vertex vertex(int joint) {
    TopoDS_Vertex& v = vertices_[places_.find(joint)];
    if (v.IsNull())
      builder_.MakeVertex(v, point_in_space(face_, scale_, face_.curves[joint].poles.front()), tolerance());
    return v;
  }

  TopoDS_Shape edge(int c) {
    const int partner = face_.partners.empty() ? -1 : face_.partners[c];
    if (partner >= 0 && !edges_[partner].IsNull()) return edges_[partner].Oriented(TopAbs_REVERSED);
    edges_[c] = edge_in_space(face_, scale_, face_.curves[c], vertex(c), vertex(face_.next_in_loop(c)), tolerance());
    if (face_.has_given_name(c)) result_.names.emplace_back(edges_[c], face_.curve_names[c]);
    return edges_[c];
  }

  double tolerance() const { return 1e-7 * face_.diameter * scale_; }

  const CadFace& face_;
  double scale_;
  OccShape& result_;
  BRep_Builder builder_;
  DisjointSets places_;  // of joints
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;  // by curve; null: not made, or that of the partner is used
};

/// In the plane of the face.
class PlaneBlocks : public BlockGeometry {
 public:
  PlaneBlocks(const BlockLayout& layout, double scale)
      : layout_(layout),
        scale_(scale),
        tolerance_(1e-7 * layout.face.diameter * scale),
        plane_(new Geom_Plane(plane_in_space(layout.face, scale))) {}

  TopoDS_Vertex vertex(int n) override { return vertex(layout_.nodes[n].position); }
  TopoDS_Vertex vertex_at_end(const ArcPiece& piece) override {
    return vertex(curve::point(layout_.curve(piece.curve), piece.t1));
  }

  TopoDS_Edge edge(int arc, const ArcPiece& piece, const TopoDS_Vertex& from, const TopoDS_Vertex& to) override {
    const Nurbs& whole = layout_.curve(piece.curve);
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    Nurbs part = curve::trimmed(whole, low, high);
    if (piece.t0 > piece.t1) part = curve::reversed(part);
    for (const auto& [vertex, end] : {std::pair{from, part.poles.front()}, std::pair{to, part.poles.back()}}) {
      const double gap = BRep_Tool::Pnt(vertex).Distance(in_space(end));
      if (gap > tolerance_)
        throw ComputeError(fmt::format("arc {} ends {:.3g} off its node at {}", arc, gap / scale_,
                                       position_text(end + layout_.face.origin)));
    }
    return edge_in_space(layout_.face, scale_, part, from, to, tolerance_);
  }

  TopoDS_Face face(int /*block*/, const std::vector<EdgeUse>& loop) override {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const EdgeUse& use : loop)
      builder_.Add(wire, use.edge.Oriented(use.is_backwards ? TopAbs_REVERSED : TopAbs_FORWARD));
    wire.Closed(true);
    TopoDS_Face face;
    builder_.MakeFace(face, plane_, tolerance_);
    builder_.Add(face, wire);
    return face;
  }

 private:
  gp_Pnt in_space(Vec2 x) const { return point_in_space(layout_.face, scale_, x); }

  TopoDS_Vertex vertex(Vec2 x) {
    TopoDS_Vertex v;
    builder_.MakeVertex(v, in_space(x), tolerance_);
    return v;
  }

  const BlockLayout& layout_;
  double scale_, tolerance_;
  Handle(Geom_Plane) plane_;
  BRep_Builder builder_;
};

class ShellBuilder {
 public:
  ShellBuilder(const BlockLayout& layout, BlockGeometry& geometry) : layout_(layout), geometry_(geometry) {}

  OccShape build() {
    for (int n = 0; n < static_cast<int>(layout_.nodes.size()); ++n) vertices_.push_back(geometry_.vertex(n));
    for (int a = 0; a < static_cast<int>(layout_.arcs.size()); ++a) edges_.push_back(edges_of_arc(a));
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (int b = 0; b < layout_.num_blocks(); ++b) {
      const TopoDS_Face face = geometry_.face(b, loop_of(layout_.block2arcs[b]));
      if (layout_.face.chart && !BRepCheck_Analyzer(face).IsValid())
        throw ComputeError(fmt::format("block {}: the CAD kernel finds its face on the surface not valid", b));
      builder.Add(shell, face);
      const bool has_name = b < static_cast<int>(layout_.block_names.size());
      result_.names.emplace_back(face, has_name ? layout_.block_names[b] : fmt::format("block_{}", b));
    }
    result_.shape = shell;
    return std::move(result_);
  }

 private:
  // The edges of the pieces of an arc from its first node to its last, each in the direction of the arc.
  std::vector<TopoDS_Edge> edges_of_arc(int a) {
    const GraphArc& arc = layout_.arcs[a];
    std::vector<TopoDS_Edge> edges;
    TopoDS_Vertex last = vertices_[arc.from];
    for (size_t i = 0; i < arc.pieces.size(); ++i) {
      const ArcPiece& piece = arc.pieces[i];
      const bool is_last = i + 1 == arc.pieces.size();
      const TopoDS_Vertex next = is_last ? vertices_[arc.to] : geometry_.vertex_at_end(piece);
      if (piece.t0 == piece.t1)
        throw ComputeError(fmt::format("arc {} has an empty piece of curve {}", a, piece.curve));
      edges.push_back(geometry_.edge(a, piece, last, next));
      if (piece.curve < layout_.face.num_curves())
        result_.names.emplace_back(edges.back(), layout_.face.curve_names[piece.curve]);
      last = next;
    }
    return edges;
  }

  std::vector<EdgeUse> loop_of(const std::array<HalfEdge, 4>& arcs) const {
    std::vector<EdgeUse> loop;
    for (const auto& [arc, backwards] : arcs) {
      std::vector<TopoDS_Edge> edges = edges_[arc];
      if (backwards) std::reverse(edges.begin(), edges.end());
      for (const TopoDS_Edge& edge : edges) loop.push_back({edge, backwards});
    }
    return loop;
  }

  const BlockLayout& layout_;
  BlockGeometry& geometry_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<std::vector<TopoDS_Edge>> edges_;
  OccShape result_;
};

}  // namespace

OccShape occ_blocks(const BlockLayout& layout, double scale) {
  std::unique_ptr<BlockGeometry> geometry;
  if (layout.face.chart)
    geometry = surface_blocks(layout, scale);
  else
    geometry = std::make_unique<PlaneBlocks>(layout, scale);
  return ShellBuilder(layout, *geometry).build();
}

OccShape occ_face_shape(const CadFace& face, double scale) {
  OccShape result;
  const BRep_Builder builder;
  const Handle(Geom_Plane) plane = new Geom_Plane(plane_in_space(face, scale));
  SharedEdges edges(face, scale, result);
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  std::vector<TopoDS_Shape> free_edges;  // loops of slits: the writer of STEP loses wires that enclose nothing
  for (int r = 0; r < face.num_regions(); ++r) {
    TopoDS_Face shape;
    builder.MakeFace(shape, plane, 1e-7 * face.diameter * scale);
    for (int l = 0; l < face.num_loops(); ++l) {
      if (face.region_of_loop(l) != r) continue;
      if (!face.is_slit_loop(l))
        builder.Add(shape, edges.wire(l));
      else
        for (const TopoDS_Shape& edge : edges.edges_of(l)) free_edges.push_back(edge);
    }
    const std::string& name = face.region_names.empty() ? face.name : face.region_names[r];
    if (!name.empty() && name != fmt::format("region_{}", r)) result.names.emplace_back(shape, name);
    builder.Add(shell, shape);
    result.shape = shape;
  }
  if (face.num_regions() > 1) result.shape = shell;
  if (free_edges.empty()) return result;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, result.shape);
  for (const TopoDS_Shape& edge : free_edges) builder.Add(compound, edge);
  result.shape = compound;
  return result;
}

}  // namespace quadrille::occ
