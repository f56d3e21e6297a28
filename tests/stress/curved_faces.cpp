// curved_faces FOLDER [N] [SEED]: writes N curved faces as FOLDER/NNN_FAMILY.step, of random sizes and places, the same
// for the same seed, and FOLDER/faces.tsv with a line "file face family" for each. curved_faces --samples FOLDER writes
// those of tests/data/curved. tests/benchmarks/curved_faces meshes and judges them.

#include <fmt/format.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Section.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gp_Ax2.hxx>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace {

using std::numbers::pi;

/// splitmix64: the same numbers with every C++ library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(next() >> 11) * 0x1p-53; }
  bool coin() { return between(0, 1) < 0.5; }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

/// The largest face of a kind of surface.
TopoDS_Face largest(const TopoDS_Shape& shape, std::optional<GeomAbs_SurfaceType> kind = {}) {
  TopoDS_Face best;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
    const TopoDS_Face face = TopoDS::Face(e.Current());
    const GeomAbs_SurfaceType type = BRepAdaptor_Surface(face).GetType();
    if (kind ? type != *kind : type == GeomAbs_Plane) continue;
    if (best.IsNull() || area(face) > area(best)) best = face;
  }
  if (best.IsNull()) throw Standard_Failure("no such face");
  return best;
}

const gp_Ax2 upright(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));

TopoDS_Shape drill(gp_Pnt at, gp_Dir along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(at, along), radius, length).Shape();
}

// Each family makes one face.

TopoDS_Face cylinder_patch(Random& r) {
  return largest(BRepPrimAPI_MakeCylinder(upright, 1, r.between(0.5, 2.5), r.between(0.5, 5)).Shape(),
                 GeomAbs_Cylinder);
}

TopoDS_Face cylinder_hole(Random& r) {
  const double height = r.between(1.5, 3);
  const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(upright, 1, height, r.between(2.5, 4.5)).Shape();
  const double turn = r.between(0.9, 1.5);
  return largest(BRepAlgoAPI_Cut(half, drill({0, 0, height * r.between(0.4, 0.6)}, {std::cos(turn), std::sin(turn), 0},
                                             r.between(0.2, 0.5), 3)),
                 GeomAbs_Cylinder);
}

TopoDS_Face cylinder_oblique(Random& r) {
  const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(upright, 1, 3, r.between(1, 4)).Shape();
  const gp_Dir normal(r.between(-0.5, 0.5), r.between(-0.5, 0.5), 1);
  const TopoDS_Shape above = BRepPrimAPI_MakeBox(gp_Ax2(gp_Pnt(0, 0, 1.5), normal), 20, 20, 20).Shape();
  gp_Trsf back;
  back.SetTranslation(gp_Vec(gp_Ax2(gp_Pnt(0, 0, 1.5), normal).XDirection()) * -10 +
                      gp_Vec(gp_Ax2(gp_Pnt(0, 0, 1.5), normal).YDirection()) * -10);
  return largest(BRepAlgoAPI_Cut(half, BRepBuilderAPI_Transform(above, back).Shape()), GeomAbs_Cylinder);
}

TopoDS_Face tube(Random& r) {
  return largest(BRepPrimAPI_MakeCylinder(upright, 1, r.between(0.3, 1.5)).Shape(), GeomAbs_Cylinder);
}

TopoDS_Face cone_patch(Random& r) {
  return largest(
      BRepPrimAPI_MakeCone(upright, r.between(0.8, 1.5), r.between(0.2, 0.7), r.between(0.5, 2), r.between(0.6, 5))
          .Shape(),
      GeomAbs_Cone);
}

TopoDS_Face cone_tip(Random& r) {
  return largest(BRepPrimAPI_MakeCone(upright, 1, 0, r.between(0.3, 2), r.between(0.7, 4)).Shape(), GeomAbs_Cone);
}

TopoDS_Face sphere_cap(Random& r) {
  return largest(BRepPrimAPI_MakeSphere(upright, 1, r.between(0.1, 1.1), pi / 2, 2 * pi).Shape(), GeomAbs_Sphere);
}

TopoDS_Face sphere_trimmed(Random& r) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(upright, 1).Shape();
  const double x = r.between(-0.3, 0.2), y = r.between(-0.3, 0.2), z = r.between(-0.3, 0.2);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), gp_Pnt(2, 2, 2)).Shape();
  return largest(BRepAlgoAPI_Common(ball, box), GeomAbs_Sphere);
}

TopoDS_Face sphere_hole(Random& r) {
  const TopoDS_Shape cap = BRepPrimAPI_MakeSphere(upright, 1, r.between(0.1, 0.5), pi / 2, 2 * pi).Shape();
  const double lean = r.between(0.1, 0.4);
  return largest(BRepAlgoAPI_Cut(cap, drill({0, 0, 0}, {lean, 0.1, 1}, r.between(0.1, 0.25), 3)), GeomAbs_Sphere);
}

TopoDS_Face torus_patch(Random& r) {
  const double from = r.between(-pi, pi);
  return largest(
      BRepPrimAPI_MakeTorus(upright, 1, r.between(0.2, 0.5), from, from + r.between(0.7, 2.8), r.between(0.5, 2))
          .Shape(),
      GeomAbs_Torus);
}

TopoDS_Face torus_hole(Random& r) {
  const TopoDS_Shape part = BRepPrimAPI_MakeTorus(upright, 1, 0.4, -1.2, 1.2, r.between(1, 2)).Shape();
  return largest(BRepAlgoAPI_Cut(part, drill({0, 0, 0}, {std::cos(0.5), std::sin(0.5), 0}, r.between(0.08, 0.2), 3)),
                 GeomAbs_Torus);
}

TopoDS_Wire closed_spline(Random& r, double z, int n) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, n);
  for (int i = 0; i < n; ++i) {
    const double radius = r.between(0.7, 1.2), angle = 2 * pi * i / n;
    points->SetValue(i + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  GeomAPI_Interpolate smooth(points, Standard_True, 1e-6);
  smooth.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(smooth.Curve()));
}

TopoDS_Edge open_spline(Random& r, double z, int n) {
  TColgp_Array1OfPnt points(1, n);
  for (int i = 0; i < n; ++i) points(i + 1) = gp_Pnt(2.0 * i / (n - 1), r.between(-0.2, 0.2), z + r.between(-0.2, 0.2));
  return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points, 3, 5, GeomAbs_C2, 1e-3).Curve());
}

TopoDS_Face loft(Random& r) {
  BRepOffsetAPI_ThruSections sections(Standard_False, Standard_False);
  for (const double z : {0.0, r.between(0.4, 0.7), r.between(1, 1.5)})
    sections.AddWire(BRepBuilderAPI_MakeWire(open_spline(r, z, 5)));
  return largest(sections.Shape());
}

TopoDS_Face loft_tube(Random& r) {
  BRepOffsetAPI_ThruSections sections(Standard_False, Standard_False);
  for (const double z : {0.0, r.between(0.4, 0.7), r.between(0.8, 1.2)}) sections.AddWire(closed_spline(r, z, 6));
  return largest(sections.Shape());
}

TopoDS_Face sweep(Random& r) {
  const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(open_spline(r, 0, 5));
  const GC_MakeArcOfCircle arc(gp_Pnt(0, -0.4, 0), gp_Pnt(0, 0, r.between(0.1, 0.35)), gp_Pnt(0, 0.4, 0));
  return largest(BRepOffsetAPI_MakePipe(spine, BRepBuilderAPI_MakeEdge(arc.Value()).Shape()).Shape());
}

Handle(Geom_BSplineSurface) hills(Random& r, int n, double height) {
  TColgp_Array2OfPnt points(1, n, 1, n);
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= n; ++j)
      points(i, j) = gp_Pnt(2.0 * (i - 1) / (n - 1), 2.0 * (j - 1) / (n - 1), r.between(-height, height));
  return GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-3).Surface();
}

TopoDS_Face nurbs_patch(Random& r) { return BRepBuilderAPI_MakeFace(hills(r, 5, r.between(0.05, 0.3)), 1e-7); }

TopoDS_Face nurbs_holes(Random& r) {
  TopoDS_Shape face = BRepBuilderAPI_MakeFace(hills(r, 5, r.between(0.05, 0.25)), 1e-7);
  const int num_holes = r.coin() ? 1 : 2;
  for (int i = 0; i < num_holes; ++i)
    face = BRepAlgoAPI_Cut(face, drill({0.5 + i, r.between(0.6, 1.4), -2}, {0, 0, 1}, r.between(0.15, 0.3), 4)).Shape();
  return largest(face, GeomAbs_BSplineSurface);
}

TopoDS_Face nurbs_trimmed(Random& r) {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(hills(r, 5, r.between(0.05, 0.2)), 1e-7);
  return largest(BRepAlgoAPI_Common(face, drill({1, 1, -2}, {r.between(-0.2, 0.2), 0, 1}, r.between(0.5, 0.8), 4)),
                 GeomAbs_BSplineSurface);
}

TopoDS_Shape filleted_box(Random& r, double radius, int num_edges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(r.between(1, 2), r.between(1, 2), r.between(1, 2)).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  for (int i = 1; i <= num_edges; ++i) fillet.Add(radius, TopoDS::Edge(edges(i)));
  return fillet.Shape();
}

TopoDS_Face fillet_edge(Random& r) { return largest(filleted_box(r, r.between(0.1, 0.4), 1), GeomAbs_Cylinder); }

TopoDS_Face fillet_corner(Random& r) { return largest(filleted_box(r, r.between(0.1, 0.4), 12), GeomAbs_Sphere); }

/// Where a cylinder stands on a plate.
TopoDS_Face fillet_foot(Random& r) {
  const double radius = r.between(0.5, 1);
  const TopoDS_Shape can = BRepPrimAPI_MakeCylinder(upright, radius, 2, r.between(1, 3)).Shape();
  BRepFilletAPI_MakeFillet fillet(can);
  for (TopExp_Explorer e(can, TopAbs_EDGE); e.More(); e.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(e.Current());
    GProp_GProps p;
    BRepGProp::LinearProperties(edge, p);
    if (p.CentreOfMass().Z() > 1.99 && std::hypot(p.CentreOfMass().X(), p.CentreOfMass().Y()) > 0.51 * radius) {
      fillet.Add(r.between(0.1, 0.3) * radius, edge);
      break;
    }
  }
  return largest(fillet.Shape(), GeomAbs_Torus);
}

TopoDS_Face revolved(Random& r) {
  TColgp_Array1OfPnt points(1, 4);
  for (int i = 0; i < 4; ++i) points(i + 1) = gp_Pnt(r.between(0.7, 1.3), 0, 0.4 * i);
  const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points, 3, 5, GeomAbs_C2, 1e-3).Curve());
  return TopoDS::Face(
      BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), r.between(0.7, 4)).Shape());
}

TopoDS_Face extruded(Random& r) {
  return TopoDS::Face(
      BRepPrimAPI_MakePrism(open_spline(r, 0, 6), gp_Vec(r.between(-0.3, 0.3), 1, r.between(0, 0.5))).Shape());
}

/// The smaller of two pipes that meet, up to the larger.
TopoDS_Face pipe_branch(Random& r) {
  const double radius = r.between(0.3, 0.8);
  const TopoDS_Shape branch =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, r.between(-0.3, 0.3))), radius, 3, r.between(2, 5))
          .Shape();
  return largest(
      BRepAlgoAPI_Cut(branch, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -4), gp_Dir(0, 0, 1)), 1, 8).Shape()),
      GeomAbs_Cylinder);
}

struct Family {
  const char* name;
  TopoDS_Face (*make)(Random&);
};

constexpr std::array families{Family{"cylinder_patch", cylinder_patch},
                              Family{"cylinder_hole", cylinder_hole},
                              Family{"cylinder_oblique", cylinder_oblique},
                              Family{"tube", tube},
                              Family{"cone_patch", cone_patch},
                              Family{"cone_tip", cone_tip},
                              Family{"sphere_cap", sphere_cap},
                              Family{"sphere_trimmed", sphere_trimmed},
                              Family{"sphere_hole", sphere_hole},
                              Family{"torus_patch", torus_patch},
                              Family{"torus_hole", torus_hole},
                              Family{"loft", loft},
                              Family{"loft_tube", loft_tube},
                              Family{"sweep", sweep},
                              Family{"nurbs_patch", nurbs_patch},
                              Family{"nurbs_holes", nurbs_holes},
                              Family{"nurbs_trimmed", nurbs_trimmed},
                              Family{"fillet_edge", fillet_edge},
                              Family{"fillet_corner", fillet_corner},
                              Family{"fillet_foot", fillet_foot},
                              Family{"revolved", revolved},
                              Family{"extruded", extruded},
                              Family{"pipe_branch", pipe_branch}};

/// Anywhere, and in any direction.
TopoDS_Shape placed(const TopoDS_Shape& shape, Random& r) {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(r.between(-1, 1), r.between(-1, 1), r.between(0.1, 1))),
                   r.between(0, 3));
  move.SetTranslation(gp_Vec(r.between(-3, 3), r.between(-3, 3), r.between(-3, 3)));
  return BRepBuilderAPI_Transform(shape, move * turn, Standard_True).Shape();
}

void write_step(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(path.c_str()) != IFSelect_RetDone)
    throw Standard_Failure("cannot be written");
}

int write_faces(const std::filesystem::path& folder, int count, std::uint64_t seed) {
  std::ofstream list(folder / "faces.tsv");
  for (int i = 0; i < count; ++i) {
    const Family& family = families[i % families.size()];
    // A few families fail for some numbers: the next ones are tried.
    for (std::uint64_t trial = 0;; ++trial) {
      Random r(seed * 1000003 + static_cast<std::uint64_t>(i) * 101 + trial);
      try {
        const std::string name = fmt::format("{:03}_{}.step", i, family.name);
        write_step(placed(family.make(r), r), folder / name);
        list << name << "\t0\t" << family.name << '\n';
        break;
      } catch (const Standard_Failure& e) {
        if (trial > 20) return fmt::print(stderr, "{}: {}\n", family.name, e.GetMessageString()), 1;
      }
    }
  }
  return 0;
}

/// A spiral ramp of one and a half turns, whose chart overlaps itself; and a surface with a kink along its middle.
TopoDS_Face ramp() {
  constexpr int count = 40;
  TColgp_Array2OfPnt points(1, count, 1, 2);
  for (int i = 0; i < count; ++i) {
    const double angle = 3 * pi * i / (count - 1);
    for (int j = 0; j < 2; ++j)
      points(i + 1, j + 1) = gp_Pnt((1 + j) * std::cos(angle), (1 + j) * std::sin(angle), 0.1 * angle);
  }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points, 1, 5, GeomAbs_C2, 1e-3).Surface(), 1e-7);
}

TopoDS_Face roof() {
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(i, 2 * j, i == 1 ? 0.5 : 0);
  TColStd_Array1OfReal u(1, 3), v(1, 2);
  TColStd_Array1OfInteger of_u(1, 3), of_v(1, 2);
  for (int i = 0; i < 3; ++i) u(i + 1) = i, of_u(i + 1) = i == 1 ? 1 : 2;
  for (int j = 0; j < 2; ++j) v(j + 1) = j, of_v(j + 1) = 2;
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, of_u, of_v, 1, 1), 1e-7);
}

/// z = (x^2 - y^2) / 2 over 2 by 1.2.
TopoDS_Face saddle() {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      poles(i + 2, j + 2) = gp_Pnt(i, 0.6 * j, (i == 0 ? -0.5 : 0.5) - 0.36 * (j == 0 ? -0.5 : 0.5));
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
}

/// Small files for the tests, without random numbers but for that of a surface.
int write_samples(const std::filesystem::path& folder) {
  Random r(1);
  const TopoDS_Shape half_cylinder = BRepPrimAPI_MakeCylinder(upright, 1, 2, pi).Shape();
  write_step(half_cylinder, folder / "half_cylinder.step");  // a solid: face 0 is curved
  write_step(largest(BRepPrimAPI_MakeCylinder(upright, 1, 1).Shape(), GeomAbs_Cylinder), folder / "tube.step");
  write_step(largest(BRepPrimAPI_MakeCone(upright, 1, 0, 1, 2.5).Shape(), GeomAbs_Cone), folder / "cone_tip.step");
  write_step(largest(BRepPrimAPI_MakeSphere(upright, 1, 0, pi / 2, 2 * pi).Shape(), GeomAbs_Sphere),
             folder / "half_sphere.step");
  write_step(BRepPrimAPI_MakeSphere(upright, 1).Shape(), folder / "sphere.step");
  // A rim of radius 0.8, about the pole; and 3 by 1.4, with a hole.
  write_step(largest(BRepPrimAPI_MakeSphere(upright, 1, std::asin(0.6), pi / 2, 2 * pi).Shape(), GeomAbs_Sphere),
             folder / "sphere_cap.step");
  write_step(largest(BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(upright, 2, 1, -0.7, 0.7, 1).Shape(),
                                     drill({0, 0, 0}, {std::cos(0.45), std::sin(0.45), 0}, 0.3, 5)),
                     GeomAbs_Torus),
             folder / "torus_patch.step");
  write_step(nurbs_holes(r), folder / "hills_hole.step");
  // Each with two mirror planes.
  write_step(largest(BRepAlgoAPI_Cut(half_cylinder, drill({0, 0, 1}, {0, 1, 0}, 0.35, 3)), GeomAbs_Cylinder),
             folder / "half_cylinder_hole.step");
  write_step(saddle(), folder / "saddle.step");
  write_step(filleted_box(r, 0.3, 12), folder / "filleted_box.step");
  write_step(ramp(), folder / "ramp.step");
  write_step(roof(), folder / "roof.step");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const std::string first = argc > 1 ? argv[1] : "";
  if (first.empty() || (first == "--samples" && argc < 3)) {
    fmt::print(stderr, "usage: curved_faces FOLDER [N] [SEED] | curved_faces --samples FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = first == "--samples" ? argv[2] : argv[1];
  std::filesystem::create_directories(folder);
  try {
    if (first == "--samples") return write_samples(folder);
    return write_faces(folder, argc > 2 ? std::atoi(argv[2]) : 200, argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  } catch (const Standard_Failure& e) {
    fmt::print(stderr, "curved_faces: {}\n", e.GetMessageString());
    return 1;
  }
}
