#include "occ/occ_inner_edges.hpp"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "occ/occ_one_surface.hpp"
#include "occ/occ_parts_beside.hpp"
#include "occ/occ_space_edges.hpp"

namespace quadrille::occ {

namespace {

constexpr int num_samples = 16;

/// Whether all of the edge is on the face, and some of it is not on its boundary.
bool lies_inside(const TopoDS_Edge& edge, const TopoDS_Face& face, double tolerance) {
  if (BRep_Tool::Degenerated(edge)) return false;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return false;
  const Handle(ShapeAnalysis_Surface) surface = new ShapeAnalysis_Surface(BRep_Tool::Surface(face));
  bool is_inside = false;
  for (int i = 0; i <= num_samples; ++i) {
    const gp_Pnt p = curve.Value(first + (last - first) * i / num_samples);
    if (distance_from(surface, p) > tolerance) return false;
    const TopAbs_State state = BRepClass_FaceClassifier(face, p, tolerance).State();
    if (state != TopAbs_IN && state != TopAbs_ON) return false;
    is_inside = is_inside || state == TopAbs_IN;
  }
  return is_inside;
}

int next_number(const UnitedFace& united) {
  int last = -1;
  for (const auto* edges : {&united.outer, &united.inner})
    for (const LabelledEdge& e : *edges) last = std::max(last, e.labels.cad_edge);
  return last + 1;
}

}  // namespace

void add_edges_inside(const OccModel& model, const std::vector<FaceChoice>& choices, const std::string& file,
                      double tolerance, UnitedFace& united, Report& report) {
  int num_ignored = 0, number = next_number(united);
  std::vector<TopoDS_Face> faces;
  for (const FaceChoice& choice : choices) faces.push_back(choice.face);
  for (const TopoDS_Shape& shape : parts_beside(model.shape, TopAbs_EDGE, TopAbs_FACE, faces)) {
    const TopoDS_Edge edge = TopoDS::Edge(shape.Oriented(TopAbs_FORWARD));
    if (lies_inside(edge, united.face, tolerance))
      united.inner.push_back({edge, labels_of(model, edge, number++), {-1, -1}});
    else
      ++num_ignored;
  }
  if (num_ignored > 0)
    report.warn(warning::curves_ignored,
                fmt::format("{}: ignored {} beside the face", file, counted(num_ignored, "curve")));
}

}  // namespace quadrille::occ
