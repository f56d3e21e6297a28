#include "base/name_text.hpp"
#include "io/describe.hpp"

namespace quadrille::io {

void describe_nurbs(Archive& archive, const char* name, std::vector<Nurbs>& curves) {
  archive.field(name, curves, [](Archive& a, Nurbs& curve) {
    a.field("degree", curve.degree, {"1", "polynomial degree of the numerator"});
    a.field("knots", curve.knots, {"1", "clamped knot vector"});
    a.field("poles", curve.poles, {"length", "control points relative to face.origin"});
    a.field("weights", curve.weights, {"1", "weights of the poles, positive"});
  });
}

namespace {

/// A face of one region without slits has none of these members.
void describe_regions(Archive& archive, CadFace& face) {
  archive.nonempty_field("region_loops", face.region_loops,
                         {"", "region r holds loops region_loops[r] to region_loops[r+1]-1, its outline first"});
  archive.nonempty_field("region_names", face.region_names, {"", "name of each region"});
  archive.nonempty_field("partners", face.partners,
                         {"", "the same curve of the neighbour, -1 on the boundary of the whole"});
  archive.nonempty_field("periodic_pairs", face.periodic_pairs, [](Archive& a, PeriodicPair& pair) {
    a.field("curves", pair.curves, {"", "the motion maps the first onto the second, reversed"});
    a.field("angle", pair.angle, {"radian", "of the rotation about (0, 0), face.origin included"});
    a.field("shift", pair.shift, {"length", "added after the rotation"});
  });
}

/// Items whose name is made from their number; earlier minor versions lack them.
void describe_numbered_names(Archive& archive, const char* member, const char* long_name, std::vector<int>& unnamed,
                             const std::vector<std::string>& names, const std::string& noun) {
  if (archive.has(member))
    archive.field(member, unnamed, {"", long_name});
  else
    unnamed = presumed_numbered_names(names, noun);
}

}  // namespace

void describe_face(Archive& archive, CadFace& face) {
  archive.object("face", [&](Archive& a) {
    a.field("name", face.name, {"", "name of the face in the CAD file"});
    a.field("length_unit", face.length_unit, {"", "unit of all lengths"});
    a.field("metres_per_unit", face.metres_per_unit, {"m", "0 where unknown"});
    a.field("plane_origin", face.plane_origin, {"length", "origin of the plane in the CAD model's space"});
    a.field("plane_x", face.plane_x, {"1", "x axis of the plane"});
    a.field("plane_y", face.plane_y, {"1", "y axis of the plane"});
    a.field("origin", face.origin, {"length", "to be added to every position"});
    a.field("diameter", face.diameter, {"length", "largest distance between two points of the outline"});
    if (a.is_reading() ? a.has("fit_distance") : face.fit_distance > 0)
      a.field("fit_distance", face.fit_distance, {"length", "greatest distance of the curves from those of the file"});
    a.field("loop_offsets", face.loop_offsets, {"", "loop l holds curves loop_offsets[l] to loop_offsets[l+1]-1"});
    a.field("curve_names", face.curve_names, {"", "name of each curve"});
    describe_numbered_names(a, "unnamed_curves", "curves whose name is made from their number, ascending",
                            face.unnamed_curves, face.curve_names, "curve");
    a.field("curve_cad_edges", face.curve_cad_edges, {"", "number of the edge in the CAD file"});
    describe_nurbs(a, "curves", face.curves);
    a.field("joints", face.joints, [](Archive& b, Joint& joint) {
      b.field("position", joint.position, {"length", "start of the curve"});
      b.field("tangent_in", joint.tangent_in, {"radian", "tangent angle of the predecessor at its end"});
      b.field("tangent_out", joint.tangent_out, {"radian", "tangent angle of the curve at its start"});
      b.field("interior_angle", joint.interior_angle, {"radian", "angle inside the face"});
      b.field("is_corner", joint.is_corner, {"", "1 at a corner of the layout"});
    });
    describe_regions(a, face);
    describe_chart(a, face);
  });
}

void describe_open_curves(Archive& archive, std::vector<int>& curves) {
  archive.nonempty_field("open_curves", curves, {"", "curves of open interfaces, of both sides, ascending"});
}

void describe_blocks(Archive& archive, std::vector<std::string>& names, std::vector<int>& unnamed,
                     std::vector<int>& region) {
  archive.field("block_names", names, {"", "name of each block"});
  describe_numbered_names(archive, "unnamed_blocks", "blocks whose name is made from their number, ascending", unnamed,
                          names, "block");
  archive.nonempty_field("block_region", region, {"", "region of each block"});
}

void describe_graph(Archive& archive, std::vector<GraphNode>& nodes, std::vector<GraphArc>& arcs) {
  archive.field("nodes", nodes, [](Archive& a, GraphNode& node) {
    a.field("position", node.position, {"length", "relative to face.origin"});
    a.field("kind", node.kind, {"", "irregular, corner, boundary, crossing or cut"});
    a.field("valence", node.valence, {"", "quads at the node, or in its sector on the boundary"});
    a.field("curve", node.curve, {"", "CAD curve through a boundary node, else -1"});
    a.field("t", node.t, {"1", "parameter on that curve"});
  });
  archive.field("arcs", arcs, [](Archive& a, GraphArc& arc) {
    a.field("from", arc.from, {"", "node"});
    a.field("to", arc.to, {"", "node"});
    a.field("is_boundary", arc.is_boundary, {"", "1 on the boundary"});
    a.field("length", arc.length, {"", "prescribed integer length, 0 = free"});
    a.field("pieces", arc.pieces, [](Archive& b, ArcPiece& piece) {
      b.field("curve", piece.curve, {"", "CAD curve, or spline + number of CAD curves"});
      b.field("t0", piece.t0, {"1", "first parameter"});
      b.field("t1", piece.t1, {"1", "last parameter"});
    });
  });
}

}  // namespace quadrille::io
