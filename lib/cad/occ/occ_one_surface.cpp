#include "occ/occ_one_surface.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "occ/occ_surface.hpp"

namespace quadrille::occ {

namespace {

constexpr int samples_per_edge = 8;

std::vector<gp_Pnt> samples_on_edges(const TopoDS_Face& face) {
  std::vector<gp_Pnt> samples;
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(e.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    for (int i = 0; i <= samples_per_edge; ++i)
      samples.push_back(curve.Value(first + (last - first) * i / samples_per_edge));
  }
  return samples;
}

}  // namespace

double distance_from(const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p) {
  return surface->Value(surface->ValueOfUV(p, 0)).Distance(p);
}

// Two surfaces may meet in all edges of a face. Between the parameters of its boundary they differ, and, where all
// edges are at one distance from a pole, at the points nearest to the middles of chords.
SurfaceGap gap_from_surface(const TopoDS_Face& face, const TopoDS_Face& of_surface) {
  const Handle(ShapeAnalysis_Surface) own = new ShapeAnalysis_Surface(basis_surface(face)),
                                      other = new ShapeAnalysis_Surface(basis_surface(of_surface));
  std::vector<gp_Pnt> samples = samples_on_edges(face);
  const std::size_t num_on_edges = samples.size();
  for (std::size_t i = 0; i < num_on_edges; ++i) {
    const gp_Pnt p = samples[i], q = samples[(i + num_on_edges / 2) % num_on_edges];
    const gp_Pnt2d a = own->ValueOfUV(p, 0), b = own->ValueOfUV(q, 0);
    samples.push_back(own->Value((a.X() + b.X()) / 2, (a.Y() + b.Y()) / 2));
    samples.push_back(own->Value(own->ValueOfUV(gp_Pnt((p.XYZ() + q.XYZ()) / 2), 0)));
  }
  SurfaceGap greatest;
  for (const gp_Pnt& p : samples)
    if (const double gap = distance_from(other, p); gap > greatest.distance) greatest = {gap, {p.X(), p.Y(), p.Z()}};
  return greatest;
}

bool has_opposite_normal(const TopoDS_Face& face, const TopoDS_Face& of_surface) {
  const Handle(ShapeAnalysis_Surface) own = new ShapeAnalysis_Surface(basis_surface(face)),
                                      other = new ShapeAnalysis_Surface(basis_surface(of_surface));
  const auto normal = [](const Handle(ShapeAnalysis_Surface) & surface, const gp_Pnt& p) {
    const gp_Pnt2d uv = surface->ValueOfUV(p, 0);
    gp_Pnt x;
    gp_Vec u, v;
    surface->Surface()->D1(uv.X(), uv.Y(), x, u, v);
    const gp_Vec n = u.Crossed(v);
    return n.Magnitude() > 0 ? n.Normalized() : n;  // 0 at a pole
  };
  double sum = 0;
  for (const gp_Pnt& p : samples_on_edges(face)) sum += normal(own, p).Dot(normal(other, p));
  return sum < 0;
}

double extent_of_edges(const TopoDS_Face& face) {
  Bnd_Box box;
  for (const gp_Pnt& p : samples_on_edges(face)) box.Add(p);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

double same_surface_tolerance(const TopoDS_Face& face, double file_tolerance) {
  return std::max(file_tolerance, 1e-7 * extent_of_edges(face));
}

}  // namespace quadrille::occ
