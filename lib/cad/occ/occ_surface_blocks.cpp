#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "model/length_scale.hpp"
#include "occ/occ_block_geometry.hpp"
#include "occ/occ_splines.hpp"
#include "occ/surface_piece.hpp"

namespace quadrille::occ {
namespace {

constexpr double rounding = 1e-9;  // of a period

Parameter other(Parameter p) { return p == Parameter::u ? Parameter::v : Parameter::u; }

/// An edge on the boundary of a block in the parameters of the surface, `shift` from those of its piece.
struct Step {
  EdgeUse use;
  const SurfacePiece* piece = nullptr;
  Vec2 shift;

  const SurfaceNode& node(bool at_end) const { return at_end != use.is_backwards ? piece->end : piece->start; }
  Vec2 uv(bool at_end) const {
    return shift + (at_end != use.is_backwards ? piece->uv.poles.back() : piece->uv.poles.front());
  }
};

struct Box {
  Vec2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  void include(Vec2 x) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y)};
  }
};

Box box_of(const std::vector<Step>& steps) {
  Box box;
  for (const Step& step : steps)
    for (const Vec2 pole : step.piece->uv.poles) box.include(step.shift + pole);
  return box;
}

/// An edge of the wire of a block, with its curve in the parameters of the surface.
struct WireEdge {
  EdgeUse use;
  Handle(Geom2d_Curve) uv;
  double distance = 0;  ///< of this curve from the edge in space
};

class SurfaceBlocks : public BlockGeometry {
 public:
  explicit SurfaceBlocks(BlockLayout layout)
      : layout_(std::move(layout)),
        tolerance_(1e-7 * layout_.face.diameter),
        pieces_(layout_),
        surface_(pieces_.surface()),
        is_kept_(pieces_.keeps_orientation()),
        common_(occ_spline(surface_)) {}

  TopoDS_Vertex vertex(int n) override { return vertex(pieces_.node(n)); }
  TopoDS_Vertex vertex_at_end(const ArcPiece& piece) override { return vertex(pieces_.node(piece.curve, piece.t1)); }

  TopoDS_Edge edge(int /*arc*/, const ArcPiece& piece, const TopoDS_Vertex& from, const TopoDS_Vertex& to) override {
    const SurfacePiece made = pieces_.piece(piece, nodes_.at(key(from)), nodes_.at(key(to)));
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, occ_spline(made.space), tolerance_);
    builder_.Add(edge, from.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, to.Oriented(TopAbs_REVERSED));
    builder_.Range(edge, made.space.begin(), made.space.end());
    for (const auto& [vertex, end] : {std::pair{from, made.space.poles.front()}, {to, made.space.poles.back()}})
      if (const double gap = BRep_Tool::Pnt(vertex).Distance(occ_point(end)); gap > tolerance_ / 2)
        builder_.UpdateVertex(vertex, 2 * gap);
    edge_pieces_.emplace(key(edge), made);
    return edge;
  }

  TopoDS_Face face(int block, const std::vector<EdgeUse>& loop) override {
    std::vector<Step> steps = steps_of(loop);
    const Parameter around = turns_about_pole(steps);
    if (around != Parameter::none) begin_at_seam(block, around, steps);
    const Handle(Geom_BSplineSurface) surface = surface_for(block, steps);
    std::vector<WireEdge> edges = wire_edges(steps);
    if (around != Parameter::none) close_at_pole(around, surface, steps, edges);
    return face_of(surface, edges);
  }

 private:
  static const void* key(const TopoDS_Shape& shape) { return shape.TShape().get(); }

  TopoDS_Vertex vertex(const SurfaceNode& node) {
    TopoDS_Vertex v;
    builder_.MakeVertex(v, occ_point(node.position), tolerance_);
    nodes_.emplace(key(v), node);
    return v;
  }

  /// Along the boundary without jumps, but for steps along a pole.
  std::vector<Step> steps_of(const std::vector<EdgeUse>& loop) const {
    std::vector<Step> steps;
    for (const EdgeUse& use : loop) {
      Step step{use, &edge_pieces_.at(key(use.edge)), {}};
      if (!steps.empty()) step.shift = shift_behind(steps.back(), step);
      steps.push_back(step);
    }
    return steps;
  }

  /// Whole periods by which a step is moved to the end of the one before.
  Vec2 shift_behind(const Step& before, const Step& step) const {
    Vec2 shift;
    for (const Parameter p : both) {
      const double length = period(surface_, p), gap = part(before.uv(true), p) - part(step.uv(false), p);
      if (length == 0) continue;
      const bool is_pole = before.node(true).free == p;
      if (!is_pole)
        part(shift, p) = length * std::round(gap / length);
      else if (direction_at_pole(p, before.uv(true)) > 0)
        part(shift, p) = length * std::ceil(gap / length - rounding);
      else
        part(shift, p) = length * std::floor(gap / length + rounding);
    }
    return shift;
  }

  double begin_of(Parameter p) const { return p == Parameter::u ? surface_.knots_u.front() : surface_.knots_v.front(); }
  double end_of(Parameter p) const { return p == Parameter::u ? surface_.knots_u.back() : surface_.knots_v.back(); }

  /// 1 or -1: whether p rises along a pole at uv, with the face on the left.
  double direction_at_pole(Parameter p, Vec2 uv) const {
    const double at = part(uv, other(p));
    const bool is_high = at - begin_of(other(p)) > end_of(other(p)) - at;
    return (is_high == (p == Parameter::u) ? -1 : 1) * (is_kept_ ? 1 : -1);
  }

  /// The parameter that rises or falls by a period along the boundary: there is a pole inside.
  Parameter turns_about_pole(const std::vector<Step>& steps) const {
    const Vec2 gap = steps.front().uv(false) - steps.back().uv(true);
    for (const Parameter p : both)
      if (const double length = period(surface_, p); length > 0 && steps.back().node(true).free != p)
        if (std::abs(part(gap, p)) > length / 2) return p;
    return Parameter::none;
  }

  /// Turns the loop so that it begins where its parameter is least or greatest, and stays on one side of it.
  void begin_at_seam(int block, Parameter around, std::vector<Step>& steps) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      std::vector<EdgeUse> loop;
      for (const Step& step : steps) loop.push_back(step.use);
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      steps = steps_of(loop);
      const Box box = box_of(steps);
      if (part(box.high, around) - part(box.low, around) < period(surface_, around) * (1 + rounding)) return;
    }
    throw ComputeError(fmt::format(
        "block {} has a pole of the surface inside, and winds about it: it cannot be a face of a STEP model", block));
  }

  /// The surface of the chart or, for a block across a seam, a part of it; `steps` are moved to its parameters.
  Handle(Geom_BSplineSurface) surface_for(int block, std::vector<Step>& steps) const {
    bool is_inside = true;
    Vec2 low{surface_.knots_u.front(), surface_.knots_v.front()},
        high{surface_.knots_u.back(), surface_.knots_v.back()};
    for (const Parameter p : both) {
      const double length = period(surface_, p);
      if (length == 0) continue;
      const Box box = box_of(steps);
      const double room = length - (part(box.high, p) - part(box.low, p));
      if (room < -rounding * length)
        throw ComputeError(fmt::format(
            "block {} goes round the surface and overlaps itself there: it cannot be a face of a STEP model", block));
      const double shift = -length * std::floor((part(box.low, p) - begin_of(p)) / length);
      for (Step& step : steps) part(step.shift, p) += shift;
      const double margin = std::max(room, 0.0) / 4;
      is_inside = is_inside && part(box.low, p) + shift > begin_of(p) + rounding * length &&
                  part(box.high, p) + shift < end_of(p) - rounding * length;
      part(low, p) = std::max(part(box.low, p) + shift - margin, begin_of(p));
      part(high, p) = std::min(part(box.high, p) + shift + margin, end_of(p) + length);
    }
    return is_inside ? common_ : occ_part(surface_, low, high);
  }

  static WireEdge wire_edge(const Step& step) {
    return {step.use, occ_spline(step.piece->uv, step.shift), step.piece->distance};
  }

  std::vector<WireEdge> wire_edges(const std::vector<Step>& steps) const {
    std::vector<WireEdge> edges;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      edges.push_back(wire_edge(steps[i]));
      const Step& next = steps[(i + 1) % steps.size()];
      const Parameter pole = steps[i].node(true).free;
      if (pole == Parameter::none) continue;
      Vec2 to = next.uv(false);
      if (i + 1 == steps.size()) to += shift_behind(steps[i], next);
      if (std::abs(part(to, pole) - part(steps[i].uv(true), pole)) > rounding * (end_of(pole) - begin_of(pole)))
        edges.push_back(edge_at_pole(end_vertex(steps[i].use), steps[i].uv(true), to));
    }
    return edges;
  }

  static TopoDS_Vertex end_vertex(const EdgeUse& use) {
    return use.is_backwards ? TopExp::FirstVertex(use.edge) : TopExp::LastVertex(use.edge);
  }

  /// An edge that is a point in space.
  WireEdge edge_at_pole(const TopoDS_Vertex& pole, Vec2 from, Vec2 to) const {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    builder_.Add(edge, pole.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, pole.Oriented(TopAbs_REVERSED));
    builder_.Degenerated(edge, true);
    const Vec2 along = normalized(to - from);
    return {{edge, false},
            new Geom2d_TrimmedCurve(new Geom2d_Line(gp_Pnt2d(from.x, from.y), gp_Dir2d(along.x, along.y)), 0,
                                    distance(from, to))};
  }

  /// Adds a seam from the start of the loop to the pole inside, the pole, and the seam back.
  void close_at_pole(Parameter around, const Handle(Geom_BSplineSurface) & surface, const std::vector<Step>& steps,
                     std::vector<WireEdge>& edges) const {
    const Parameter towards = other(around);
    const Vec2 from = steps.front().uv(false), end = steps.back().uv(true);
    const bool is_rising = part(end, around) > part(from, around);
    // The pole is on the left of the loop.
    const bool is_high = (is_rising == (around == Parameter::u)) == is_kept_;
    Vec2 pole = from, last = end;
    part(pole, towards) = part(last, towards) = is_high ? end_of(towards) : begin_of(towards);
    const Handle(Geom_Curve) line = around == Parameter::u ? surface->UIso(from.x) : surface->VIso(from.y);
    TopoDS_Vertex top;
    builder_.MakeVertex(top, surface->Value(pole.x, pole.y), tolerance_);
    // The edge runs with its parameter; so does its curve in the parameters of the surface.
    TopoDS_Edge seam;
    const TopoDS_Vertex foot = end_vertex(steps.back().use);
    builder_.MakeEdge(seam, line, tolerance_);
    builder_.Add(seam, (is_high ? foot : top).Oriented(TopAbs_FORWARD));
    builder_.Add(seam, (is_high ? top : foot).Oriented(TopAbs_REVERSED));
    const double at_foot = part(from, towards), at_top = part(pole, towards);
    builder_.Range(seam, std::min(at_foot, at_top), std::max(at_foot, at_top));
    const auto straight = [&](double fixed) -> Handle(Geom2d_Curve) {
      if (around == Parameter::u) return new Geom2d_Line(gp_Pnt2d(fixed, 0), gp_Dir2d(0, 1));
      return new Geom2d_Line(gp_Pnt2d(0, fixed), gp_Dir2d(1, 0));
    };
    edges.push_back({{seam, !is_high}, straight(part(end, around))});
    edges.push_back(edge_at_pole(top, last, pole));
    edges.push_back({{seam, is_high}, straight(part(from, around))});
  }

  /// Edges that occur twice have a curve for each side.
  void set_curves(const Handle(Geom_BSplineSurface) & surface, const std::vector<WireEdge>& edges) const {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const WireEdge& edge = edges[i];
      const auto same = [&](const WireEdge& e) { return e.use.edge.IsSame(edge.use.edge); };
      const auto twin = std::find_if(edges.begin() + static_cast<long>(i) + 1, edges.end(), same);
      if (std::find_if(edges.begin(), edges.begin() + static_cast<long>(i), same) !=
          edges.begin() + static_cast<long>(i))
        continue;
      const double tolerance = std::max(tolerance_, 1.1 * edge.distance);
      if (twin == edges.end()) {
        builder_.UpdateEdge(edge.use.edge, edge.uv, surface, TopLoc_Location(), tolerance);
        if (BRep_Tool::Degenerated(edge.use.edge))
          builder_.Range(edge.use.edge, surface, TopLoc_Location(), edge.uv->FirstParameter(),
                         edge.uv->LastParameter());
        continue;
      }
      // The first curve is that of the edge as the face, seen against the normal of the surface, has it forwards.
      const bool is_forwards = edge.use.is_backwards != is_kept_;
      builder_.UpdateEdge(edge.use.edge, is_forwards ? edge.uv : twin->uv, is_forwards ? twin->uv : edge.uv, surface,
                          TopLoc_Location(), tolerance);
    }
  }

  TopoDS_Face face_of(const Handle(Geom_BSplineSurface) & surface, const std::vector<WireEdge>& edges) const {
    set_curves(surface, edges);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const WireEdge& edge : edges)
      builder_.Add(wire, edge.use.edge.Oriented(edge.use.is_backwards ? TopAbs_REVERSED : TopAbs_FORWARD));
    wire.Closed(true);
    TopoDS_Face face;
    builder_.MakeFace(face, surface, tolerance_);
    builder_.Add(face, is_kept_ ? wire : TopoDS::Wire(wire.Reversed()));
    return is_kept_ ? face : TopoDS::Face(face.Reversed());
  }

  BlockLayout layout_;
  double tolerance_;
  SurfacePieces pieces_;
  const NurbsSurface& surface_;
  bool is_kept_;
  Handle(Geom_BSplineSurface) common_;
  BRep_Builder builder_;
  std::map<const void*, SurfaceNode> nodes_;
  std::map<const void*, SurfacePiece> edge_pieces_;
};

}  // namespace

std::unique_ptr<BlockGeometry> surface_blocks(const BlockLayout& layout, double scale) {
  BlockLayout scaled = layout;
  scale_lengths(scaled, {scale, layout.face.length_unit, layout.face.metres_per_unit});
  return std::make_unique<SurfaceBlocks>(std::move(scaled));
}

}  // namespace quadrille::occ
