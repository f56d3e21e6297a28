#include "occ/occ_face.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Sphere.hxx>
#include <numbers>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::occ {
namespace {

TopoDS_Face rectangle(const gp_Pln& plane) { return BRepBuilderAPI_MakeFace(plane, 0, 2, 0, 1).Face(); }

const gp_Pln xy(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));

OccModel model_of(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  OccModel model;
  model.shape = compound;
  return model;
}

FacesAndEdges read(const OccModel& model, const TopoDS_Face& face, Report& report) {
  return occ_faces(model, {{face, {}}}, "a.step", report);
}
heal::RawFace read(const TopoDS_Face& face) {
  Report report;
  return read(model_of({face}), face, report).faces.at(0);
}
std::string refusal(const TopoDS_Face& face) {
  return message_of<FormatError>([&] { read(face); });
}

/// The edges from point to point; the first ones of the same two points are taken again, in the other direction.
TopoDS_Wire wire(const std::vector<gp_Pnt>& points) {
  TopoDS_Wire result;
  const BRep_Builder builder;
  builder.MakeWire(result);
  std::vector<TopoDS_Vertex> vertices;
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t same = 0;
    while (points[same].Distance(points[i]) > 0) ++same;
    vertices.push_back(same < i ? vertices[same] : BRepBuilderAPI_MakeVertex(points[i]).Vertex());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TopoDS_Vertex &a = vertices[i], &b = vertices[(i + 1) % points.size()];
    TopoDS_Shape known;
    for (const TopoDS_Edge& edge : edges)
      if (TopExp::FirstVertex(edge).IsSame(b) && TopExp::LastVertex(edge).IsSame(a)) known = edge.Reversed();
    if (known.IsNull()) edges.push_back(BRepBuilderAPI_MakeEdge(a, b)), known = edges.back();
    builder.Add(result, known);
  }
  return result;
}

TopoDS_Face face_with(const std::vector<TopoDS_Shape>& wires) {
  TopoDS_Face face;
  const BRep_Builder builder;
  builder.MakeFace(face, new Geom_Plane(xy), 1e-7);
  for (const TopoDS_Shape& wire : wires) builder.Add(face, wire);
  return face;
}

using Numbers = std::array<double, 3>;

TEST(OccFaces, planes_parallel_to_two_axes_have_their_coordinates) {
  const heal::RawFace x = read(rectangle({gp_Pnt(5, 1, 2), gp_Dir(-1, 0, 0)})),
                      y = read(rectangle({gp_Pnt(1, 5, 2), gp_Dir(0, 1, 0)})),
                      z = read(rectangle({gp_Pnt(1, 2, 5), gp_Dir(0, 0, -1)}));
  EXPECT_EQ(x.plane_origin, (Numbers{5, 0, 0}));
  EXPECT_EQ(x.plane_x, (Numbers{0, 1, 0}));
  EXPECT_EQ(x.plane_y, (Numbers{0, 0, 1}));
  EXPECT_EQ(y.plane_origin, (Numbers{0, 5, 0}));
  EXPECT_EQ(y.plane_x, (Numbers{1, 0, 0}));
  EXPECT_EQ(y.plane_y, (Numbers{0, 0, 1}));
  EXPECT_EQ(z.plane_origin, (Numbers{0, 0, 5}));
  EXPECT_EQ(z.plane_x, (Numbers{1, 0, 0}));
  EXPECT_EQ(z.plane_y, (Numbers{0, 1, 0}));
}

TEST(OccFaces, other_planes_have_the_axes_of_the_file) {
  const heal::RawFace raw = read(rectangle(gp_Ax3({1, 2, 3}, {1, 0, 1}, {0, 1, 0})));
  EXPECT_EQ(raw.plane_origin, (Numbers{1, 2, 3}));
  EXPECT_EQ(raw.plane_x, (Numbers{0, 1, 0}));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(raw.plane_y[k], (k - 1) / std::numbers::sqrt2, 1e-15);
  ASSERT_EQ(raw.wires.size(), 1U);
  for (const heal::RawEdge& edge : raw.wires[0]) EXPECT_LT(edge.height, 1e-15);
}

TEST(OccFaces, a_crack_from_the_outline_is_an_inner_edge) {
  const heal::RawFace raw =
      read(face_with({wire({{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}})}));
  ASSERT_EQ(raw.wires.size(), 1U);
  EXPECT_EQ(raw.wires[0].size(), 5U);
  ASSERT_EQ(raw.inner_edges.size(), 1U);
  EXPECT_EQ(raw.inner_edges[0].cad_edge, 1);
  EXPECT_EQ(raw.wires[0][1].cad_edge, 3) << "an edge counts as often as the wire has it";
}

TEST(OccFaces, a_bridge_between_outline_and_hole_leaves_two_loops) {
  const heal::RawFace raw = read(face_with({wire({{0, 0, 0},
                                                  {3, 0, 0},
                                                  {3, 3, 0},
                                                  {0, 3, 0},
                                                  {0, 0, 0},
                                                  {1, 1, 0},
                                                  {1, 2, 0},
                                                  {2, 2, 0},
                                                  {2, 1, 0},
                                                  {1, 1, 0}})}));
  EXPECT_EQ(raw.inner_edges.size(), 1U);
  ASSERT_EQ(raw.wires.size(), 2U);
  EXPECT_EQ(raw.wires[0].size(), 4U);
  EXPECT_EQ(raw.wires[1].size(), 4U);
  EXPECT_EQ(raw.wires[1].front().start, (Vec2{1, 1}));
}

TEST(OccFaces, wires_with_the_face_on_both_sides_are_inner_edges) {
  TopoDS_Face face = face_with({wire({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}})});
  BRep_Builder().Add(face, wire({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}).Oriented(TopAbs_INTERNAL));
  const heal::RawFace raw = read(face);
  EXPECT_EQ(raw.wires.size(), 1U);
  EXPECT_EQ(raw.inner_edges.size(), 3U);
}

TEST(OccFaces, points_inside_are_ignored_with_a_warning) {
  TopoDS_Face face = rectangle(xy);
  BRep_Builder().Add(face, BRepBuilderAPI_MakeVertex(gp_Pnt(1, 0.5, 0)).Vertex().Oriented(TopAbs_INTERNAL));
  Report report;
  read(model_of({face}), face, report);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, warning::inner_point_ignored);
}

TEST(OccFaces, lost_edges_and_empty_wires_are_errors) {
  const TopoDS_Face face = rectangle(xy);
  OccModel model = model_of({face});
  model.num_edges[face.TShape().get()] = 5;
  Report report;
  EXPECT_EQ(message_of<FormatError>([&] { read(model, face, report); }),
            "a.step: the file names 5 edges of the face, of which 4 can be built");
  EXPECT_EQ(refusal(face_with({wire({})})), "a.step: a wire of the face has no edges");
}

TEST(OccFaces, curves_and_points_beside_the_face_are_counted) {
  const TopoDS_Face face = rectangle(xy);
  const TopoDS_Edge infinite = BRepBuilderAPI_MakeEdge(gp_Lin(gp_Pnt(0, 0, 0), gp_Dir(1, 1, 0)));
  const OccModel model = model_of({face, BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 1), gp_Pnt(6, 0, 1)).Edge(), infinite,
                                   BRepBuilderAPI_MakeVertex(gp_Pnt(9, 9, 9)).Vertex()});
  Report report;
  const FacesAndEdges found = read(model, face, report);
  ASSERT_EQ(found.free_edges.size(), 1U);
  EXPECT_EQ(found.free_edges[0].height, 1);
  EXPECT_EQ(found.num_ignored_curves, 1);
  EXPECT_EQ(found.num_points, 1);
  warn_of_ignored(found, "a.step", report);
  ASSERT_EQ(report.warnings().size(), 2U);
  EXPECT_EQ(report.warnings()[0].message, "a.step: ignored 1 curve beside the face");
  EXPECT_EQ(report.warnings()[1].code, warning::points_ignored);
}

TEST(RequireUnscaled, placements_with_a_scale_are_refused) {
  const TopoDS_Face face = rectangle(xy);
  gp_Trsf scaled, mirrored;
  scaled.SetScale(gp_Pnt(0, 0, 0), 2);
  mirrored.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  EXPECT_NO_THROW(require_unscaled(TopoDS::Face(face.Moved(mirrored, false)), "a.step"));
  expect_contains(message_of<FormatError>([&] { require_unscaled(TopoDS::Face(face.Moved(scaled, false)), "a.step"); }),
                  "a.step: the face is placed with a scale of 2: ");
}

TEST(PlaneOf, flat_surfaces_of_any_kind_are_planes) {
  const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(new Geom_Plane(xy), 0., 1., 0., 1.);
  const auto plane_of_surface = [](const Handle(Geom_Surface) & surface) {
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, surface, 1e-7);
    return plane_of(face);
  };
  EXPECT_TRUE(plane_of_surface(part));
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(part);
  const auto plane = plane_of_surface(spline);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(std::abs(plane->Axis().Direction().Z()), 1, 1e-12);
  spline->SetPole(2, 2, gp_Pnt(1, 1, 0.1));
  EXPECT_FALSE(plane_of_surface(spline));
  EXPECT_FALSE(plane_of(BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 1)).Face()));
}

FacesAndEdges curves_alone(const std::vector<TopoDS_Shape>& edges) {
  Report report;
  return face_of_curves(model_of(edges), "a.step", report);
}

TEST(FaceOfCurves, is_the_plane_of_the_curves_with_one_wire) {
  const gp_Pnt a(0, 5, 0), b(2, 5, 0), c(0, 5, 1);
  const TopoDS_Edge infinite = BRepBuilderAPI_MakeEdge(gp_Lin(gp_Pnt(0, 0, 0), gp_Dir(1, 1, 1)));
  const FacesAndEdges found =
      curves_alone({BRepBuilderAPI_MakeEdge(a, b).Edge(), infinite, BRepBuilderAPI_MakeEdge(a, c).Edge(),
                    BRepBuilderAPI_MakeEdge(b, c).Edge()});
  ASSERT_EQ(found.faces.size(), 1U);
  EXPECT_EQ(found.faces[0].plane_origin, (Numbers{0, 5, 0}));
  ASSERT_EQ(found.faces[0].wires.size(), 1U);
  ASSERT_EQ(found.faces[0].wires[0].size(), 3U);
  EXPECT_EQ(found.faces[0].wires[0][1].end, (Vec2{0, 1}));
  EXPECT_EQ(found.num_ignored_curves, 1);
}

TEST(FaceOfCurves, curves_without_a_plane_are_refused) {
  const auto line = [](double from, double to) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(from, from, 0), gp_Pnt(to, to, 0)).Edge();
  };
  EXPECT_EQ(message_of<FormatError>([&] {
              curves_alone({line(0, 1), line(1, 3)});
            }),
            "a.step: the file holds no face, and its curves lie on one line");
  EXPECT_EQ(message_of<FormatError>([&] { curves_alone({}); }),
            "a.step: the file holds no face; expected one planar face");
}

}  // namespace
}  // namespace quadrille::occ
