#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESBasic_SingularSubfigure.hxx>
#include <IGESBasic_SubfigureDef.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_CircularArc.hxx>
#include <IGESGeom_CompositeCurve.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESGeom_Line.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESGraph_Color.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TransferBRep.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

using Entity = Handle(IGESData_IGESEntity);

std::string name_of(const IGESData_IGESEntity& entity) {
  if (entity.NbTypedProperties(STANDARD_TYPE(IGESBasic_Name)) != 1) return {};
  const auto name = Handle(IGESBasic_Name)::DownCast(entity.TypedProperty(STANDARD_TYPE(IGESBasic_Name)));
  return name.IsNull() ? std::string() : given_name(name->Value());
}

// An instance of a subfigure without a name of its own has that of the subfigure.
std::string part_name(const Entity& entity) {
  const auto instance = Handle(IGESBasic_SingularSubfigure)::DownCast(entity);
  std::string own = name_of(*entity);
  if (!own.empty() || instance.IsNull() || instance->Subfigure().IsNull()) return own;
  return given_name(instance->Subfigure()->Name());
}

// One of the eight colour numbers of IGES 5.3, table 4, or a colour entity with components in percent.
std::string colour_of(const IGESData_IGESEntity& entity) {
  if (const auto own = Handle(IGESGraph_Color)::DownCast(entity.Color()); !own.IsNull()) {
    std::array<double, 3> rgb{};
    own->RGBIntensity(rgb[0], rgb[1], rgb[2]);
    const auto level = [](double percent) {
      return std::isfinite(percent) ? std::lround(255 * std::clamp(percent / 100, 0.0, 1.0)) : 0;
    };
    return fmt::format("{:02x}{:02x}{:02x}", level(rgb[0]), level(rgb[1]), level(rgb[2]));
  }
  constexpr std::array<const char*, 9> known{"",       "000000", "ff0000", "00ff00", "0000ff",
                                             "ffff00", "ff00ff", "00ffff", "ffffff"};
  const int rank = entity.RankColor();
  return 0 <= rank && rank < static_cast<int>(known.size()) ? known[rank] : "";
}

std::string layer_of(const IGESData_IGESEntity& entity) {
  const int level = entity.Level();
  return level > 0 ? fmt::format("level_{}", level) : "";
}

ShapeLabel label_of(const IGESData_IGESEntity& entity) {
  return {name_of(entity), layer_of(entity), colour_of(entity)};
}

using Ends = std::array<gp_Pnt, 2>;

// The ends of a curve entity in space; std::nullopt for other kinds of entities.
std::optional<Ends> ends_of(const Entity& curve) {
  if (const auto line = Handle(IGESGeom_Line)::DownCast(curve); !line.IsNull())
    return Ends{line->TransformedStartPoint(), line->TransformedEndPoint()};
  if (const auto arc = Handle(IGESGeom_CircularArc)::DownCast(curve); !arc.IsNull())
    return Ends{arc->TransformedStartPoint(), arc->TransformedEndPoint()};
  if (const auto spline = Handle(IGESGeom_BSplineCurve)::DownCast(curve); !spline.IsNull() && spline->NbPoles() > 1)
    return Ends{spline->TransformedPole(0), spline->TransformedPole(spline->UpperIndex())};
  return std::nullopt;
}

bool has_ends(const TopoDS_Edge& edge, const Ends& ends, double tolerance) {
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (first.IsNull() || last.IsNull()) return false;
  const gp_Pnt a = BRep_Tool::Pnt(first), b = BRep_Tool::Pnt(last);
  const auto near = [&](const gp_Pnt& p, const gp_Pnt& q) { return p.Distance(q) <= tolerance; };
  return (near(a, ends[0]) && near(b, ends[1])) || (near(a, ends[1]) && near(b, ends[0]));
}

std::vector<Entity> curves_of(const IGESGeom_CurveOnSurface& boundary) {
  const Entity curve = boundary.Curve3D();
  const auto composite = Handle(IGESGeom_CompositeCurve)::DownCast(curve);
  if (composite.IsNull()) return {curve};
  std::vector<Entity> curves;
  for (int i = 1; i <= composite->NbCurves(); ++i) curves.push_back(composite->Curve(i));
  return curves;
}

// The edges of the wire are in the order of the curves. If their number or ends do not match, no labels are added.
void add_boundary(const Handle(IGESGeom_CurveOnSurface) & boundary, const Handle(Transfer_TransientProcess) & process,
                  OccModel& model) {
  if (boundary.IsNull()) return;
  const TopoDS_Shape wire = TransferBRep::ShapeResult(process, boundary);
  if (wire.IsNull()) return;
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer e(wire, TopAbs_EDGE); e.More(); e.Next()) edges.push_back(TopoDS::Edge(e.Current()));
  const std::vector<Entity> curves = curves_of(*boundary);
  if (curves.size() != edges.size()) return;
  for (size_t i = 0; i < edges.size(); ++i) {
    const std::optional<Ends> ends = curves[i].IsNull() ? std::nullopt : ends_of(curves[i]);
    if (ends && has_ends(edges[i], *ends, 10 * model.tolerance))
      model.labels.try_emplace(edges[i].TShape().get(), edges[i], label_of(*curves[i]));
  }
}

void add_boundaries(const IGESGeom_TrimmedSurface& surface, const Handle(Transfer_TransientProcess) & process,
                    OccModel& model) {
  add_boundary(surface.OuterContour(), process, model);
  for (int k = 1; k <= surface.NbInnerContours(); ++k) add_boundary(surface.InnerContour(k), process, model);
}

void add_part(const Entity& entity, PartLabel& part) {
  const std::string name = part_name(entity), layer = layer_of(*entity);
  if (!name.empty()) part.names.push_back(name);
  if (!layer.empty()) part.layer = layer;
}

// Faces, curves of no face, and what holds faces: solids, shells, groups, instances of subfigures, surfaces that are
// several faces.
void add_holder(const Entity& entity, const TopoDS_Shape& shape, OccModel& model) {
  if (shape.IsNull() || shape.ShapeType() == TopAbs_WIRE || shape.ShapeType() == TopAbs_VERTEX) return;
  const TopoDS_TShape* key = shape.TShape().get();
  if (shape.ShapeType() == TopAbs_FACE || shape.ShapeType() == TopAbs_EDGE)
    model.labels.try_emplace(key, shape, label_of(*entity));
  else
    add_part(entity, model.parts[key]);
}

bool is_face(const Entity& entity) {
  return entity->TypeNumber() == 143 || entity->TypeNumber() == 144 || entity->TypeNumber() == 510;
}

// "D7 'lid'", with the number of its first line in the directory.
std::string text_of(const IGESData_IGESModel& file, const Entity& entity) {
  const std::string name = part_name(entity);
  return fmt::format("D{}{}", file.DNum(entity), name.empty() ? "" : " '" + name + "'");
}

}  // namespace

void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model) {
  for (int i = 1; i <= file.NbEntities(); ++i) {
    const Entity entity = file.Entity(i);
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    add_holder(entity, shape, model);
    const bool is_instance = entity->IsKind(STANDARD_TYPE(IGESBasic_SingularSubfigure));
    if (shape.IsNull() && (is_face(entity) || is_instance)) model.not_built.push_back(text_of(file, entity));
    const auto surface = Handle(IGESGeom_TrimmedSurface)::DownCast(entity);
    if (!surface.IsNull()) add_boundaries(*surface, process, model);
  }
}

}  // namespace quadrille::occ
