// cad_distances FILE FACE <points: reads lines "e x y z" and "f x y z" and writes for each the distance of the point
// from the nearest edge of the face, or from its surface, in the unit of the file: by the CAD kernel's projections
// alone, so that tests/stress/curved_judge.py uses none of our code. The first line is the diameter of the face's box
// and the gap of its edges: the greatest distance between ends of two of them at one vertex.

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPC.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

TopoDS_Face read_face(const std::string& file, int index) {
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw Standard_Failure("the file cannot be read");
  reader.TransferRoots();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(reader.OneShape(), TopAbs_FACE, faces);
  if (index < 0 || index >= faces.Extent()) throw Standard_Failure("there is no such face");
  return TopoDS::Face(faces(index + 1));
}

/// Seams and poles included: a point of them is a point of the surface, and none of the mesh's boundary.
std::vector<BRepAdaptor_Curve> edges_of(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(face, TopAbs_EDGE, edges);
  std::vector<BRepAdaptor_Curve> curves;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face)) curves.emplace_back(edge);
  }
  return curves;
}

double gap_of(const TopoDS_Face& face) {
  TopTools_IndexedDataMapOfShapeListOfShape at_vertices;
  TopExp::MapShapesAndAncestors(face, TopAbs_VERTEX, TopAbs_EDGE, at_vertices);
  double most = 0;
  for (int i = 1; i <= at_vertices.Extent(); ++i) {
    std::vector<gp_Pnt> ends;
    for (const TopoDS_Shape& shape : at_vertices(i)) {
      const TopoDS_Edge edge = TopoDS::Edge(shape);
      if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
      const TopoDS_Vertex vertex = TopoDS::Vertex(at_vertices.FindKey(i));
      ends.push_back(BRepAdaptor_Curve(edge).Value(BRep_Tool::Parameter(vertex, edge)));
    }
    for (const gp_Pnt& a : ends)
      for (const gp_Pnt& b : ends) most = std::max(most, a.Distance(b));
  }
  return most;
}

double distance_from(const std::vector<BRepAdaptor_Curve>& curves, const gp_Pnt& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const BRepAdaptor_Curve& curve : curves) {
    for (const double end : {curve.FirstParameter(), curve.LastParameter()})
      least = std::min(least, point.Distance(curve.Value(end)));
    const Extrema_ExtPC nearest(point, curve, 1e-12);
    if (!nearest.IsDone()) continue;
    for (int i = 1; i <= nearest.NbExt(); ++i) least = std::min(least, std::sqrt(nearest.SquareDistance(i)));
  }
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  if (argc != 3) return fmt::print(stderr, "usage: cad_distances FILE FACE <points\n"), 2;
  try {
    const TopoDS_Face face = read_face(argv[1], std::atoi(argv[2]));
    const std::vector<BRepAdaptor_Curve> edges = edges_of(face);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    Bnd_Box box;
    BRepBndLib::AddOptimal(face, box, false, false);
    fmt::print("{:.17g} {:.6g}\n", std::sqrt(box.SquareExtent()), gap_of(face));
    GeomAPI_ProjectPointOnSurf nearest;
    // The projection starts at samples of its range, and finds nothing near where they are far apart: as on a surface
    // without end, of which the face is a small part.
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0, low_u = 0, high_u = 0, low_v = 0, high_v = 0;
    surface->Bounds(low_u, high_u, low_v, high_v);
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const double more_u = (u1 - u0) / 20, more_v = (v1 - v0) / 20;
    u0 -= more_u, u1 += more_u, v0 -= more_v, v1 += more_v;
    if (!surface->IsUPeriodic()) u0 = std::max(u0, low_u), u1 = std::min(u1, high_u);
    if (!surface->IsVPeriodic()) v0 = std::max(v0, low_v), v1 = std::min(v1, high_v);
    nearest.Init(surface, u0, u1, v0, v1, 1e-12);
    std::string kind;
    for (double x = 0, y = 0, z = 0; std::cin >> kind >> x >> y >> z;) {
      const gp_Pnt point(x, y, z);
      if (kind == "e") {
        fmt::print("{:.6g}\n", distance_from(edges, point));
        continue;
      }
      nearest.Perform(point);
      fmt::print("{:.6g}\n",
                 nearest.NbPoints() > 0 ? nearest.LowerDistance() : std::numeric_limits<double>::infinity());
    }
  } catch (const Standard_Failure& e) {
    fmt::print(stderr, "cad_distances: {}: {}\n", argv[1], e.GetMessageString());
    return 1;
  }
  return 0;
}
