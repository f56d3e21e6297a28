#include <fmt/format.h>

#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_CurveStyle.hxx>
#include <StepVisual_HArray1OfLayeredItem.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_OverRidingStyledItem.hxx>
#include <StepVisual_PreDefinedColour.hxx>
#include <StepVisual_PreDefinedItem.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_PresentationStyleSelect.hxx>
#include <StepVisual_StyledItem.hxx>
#include <StepVisual_StyledItemTarget.hxx>
#include <TransferBRep.hxx>
#include <algorithm>
#include <cmath>

#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

using Entity = Handle(Standard_Transient);

// The colour as "ff0000"; empty unless it is given by components or is one of the eight predefined colours of ISO
// 10303-46.
std::string hex_of(const Handle(StepVisual_Colour) & colour) {
  if (const auto rgb = Handle(StepVisual_ColourRgb)::DownCast(colour); !rgb.IsNull()) {
    const auto level = [](double component) {
      return std::isfinite(component) ? std::lround(255 * std::clamp(component, 0.0, 1.0)) : 0;
    };
    return fmt::format("{:02x}{:02x}{:02x}", level(rgb->Red()), level(rgb->Green()), level(rgb->Blue()));
  }
  const auto known = Handle(StepVisual_PreDefinedColour)::DownCast(colour);
  if (known.IsNull() || known->GetPreDefinedItem().IsNull()) return {};
  const std::string name = given_name(known->GetPreDefinedItem()->Name());
  for (const auto& [word, hex] : {std::pair{"red", "ff0000"},
                                  {"green", "00ff00"},
                                  {"blue", "0000ff"},
                                  {"yellow", "ffff00"},
                                  {"magenta", "ff00ff"},
                                  {"cyan", "00ffff"},
                                  {"black", "000000"},
                                  {"white", "ffffff"}})
    if (name == word) return hex;
  return {};
}

std::string curve_colour(const StepVisual_StyledItem& item) {
  for (int i = 1; i <= item.NbStyles(); ++i) {
    const Handle(StepVisual_PresentationStyleAssignment)& styles = item.StylesValue(i);
    if (styles.IsNull() || styles->Styles().IsNull()) continue;
    for (int k = 1; k <= styles->NbStyles(); ++k) {
      const auto style = Handle(StepVisual_CurveStyle)::DownCast(styles->StylesValue(k).Value());
      std::string hex = style.IsNull() ? std::string() : hex_of(style->CurveColour());
      if (!hex.empty()) return hex;
    }
  }
  return {};
}

// The entity to which a layer or a style applies if it lists `entity`: styled items and oriented edges are replaced by
// the entity to which they refer.
Entity meant(const Entity& entity) {
  if (const auto styled = Handle(StepVisual_StyledItem)::DownCast(entity); !styled.IsNull())
    return styled->Item().IsNull() ? styled->ItemAP242().Value() : Entity(styled->Item());
  if (const auto use = Handle(StepShape_OrientedEdge)::DownCast(entity); !use.IsNull()) return use->EdgeElement();
  return entity;
}

// Layers and colours by the entity to which they are assigned.
class Marks {
 public:
  explicit Marks(const StepData_StepModel& file) {
    for (int i = 1; i <= file.NbEntities(); ++i) {
      const Entity& entity = file.Value(i);
      if (const auto layer = Handle(StepVisual_PresentationLayerAssignment)::DownCast(entity); !layer.IsNull())
        add_layer(*layer);
      else if (const auto styled = Handle(StepVisual_StyledItem)::DownCast(entity); !styled.IsNull())
        add_colour(styled);
    }
  }

  // Completes the empty parts of `label` from the marks of `entity`.
  void complete(ShapeLabel& label, const Entity& entity) const {
    const auto found = marks_.find(entity.get());
    if (entity.IsNull() || found == marks_.end()) return;
    if (label.layer.empty()) label.layer = found->second.layer;
    if (label.colour.empty()) label.colour = found->second.colour;
  }

 private:
  struct Mark {
    std::string layer, colour;
    bool is_overriding = false;
  };

  void add_layer(const StepVisual_PresentationLayerAssignment& layer) {
    const std::string name = given_name(layer.Name());
    if (name.empty() || layer.AssignedItems().IsNull()) return;
    for (int k = 1; k <= layer.NbAssignedItems(); ++k) {
      const Entity entity = meant(meant(layer.AssignedItemsValue(k).Value()));
      if (entity.IsNull()) continue;
      std::string& known = marks_[entity.get()].layer;
      if (known.empty()) known = name;
    }
  }

  void add_colour(const Handle(StepVisual_StyledItem) & item) {
    const std::string colour = curve_colour(*item);
    const Entity entity = meant(meant(item));
    if (colour.empty() || entity.IsNull()) return;
    Mark& mark = marks_[entity.get()];
    const bool is_overriding = item->IsKind(STANDARD_TYPE(StepVisual_OverRidingStyledItem));
    if (!mark.colour.empty() && (mark.is_overriding || !is_overriding)) return;
    mark.colour = colour, mark.is_overriding = is_overriding;
  }

  std::map<const Standard_Transient*, Mark> marks_;
};

// CAD programs assign an edge to a layer through the edge, its curve, or the curve in space of a surface curve.
void complete_from_curve(ShapeLabel& label, const StepShape_EdgeCurve& edge, const Marks& marks) {
  const Handle(StepGeom_Curve) curve = edge.EdgeGeometry();
  marks.complete(label, curve);
  if (const auto on_surface = Handle(StepGeom_SurfaceCurve)::DownCast(curve); !on_surface.IsNull())
    marks.complete(label, on_surface->Curve3d());
}

std::string product_name(const StepBasic_ProductDefinition& definition) {
  if (definition.Formation().IsNull() || definition.Formation()->OfProduct().IsNull()) return {};
  const Handle(StepBasic_Product) product = definition.Formation()->OfProduct();
  const std::string name = given_name(product->Name());
  return name.empty() ? given_name(product->Id()) : name;
}

enum class PartKind { product, model, shell, none };  // outermost first

PartKind part_kind(const Entity& entity) {
  if (entity->IsKind(STANDARD_TYPE(StepBasic_ProductDefinition))) return PartKind::product;
  if (entity->IsKind(STANDARD_TYPE(StepShape_SolidModel))) return PartKind::model;
  if (entity->IsKind(STANDARD_TYPE(StepShape_ShellBasedSurfaceModel))) return PartKind::model;
  return entity->IsKind(STANDARD_TYPE(StepShape_ConnectedFaceSet)) ? PartKind::shell : PartKind::none;
}

std::string part_name(const Entity& entity) {
  const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity);
  return product.IsNull() ? given_name(Handle(StepRepr_RepresentationItem)::DownCast(entity)->Name())
                          : product_name(*product);
}

void add_part(const Entity& entity, const TopoDS_Shape& shape, const Marks& marks, OccModel& model) {
  if (shape.IsNull()) return;
  ShapeLabel label{part_name(entity), {}, {}};
  marks.complete(label, entity);
  PartLabel& known = model.parts[shape.TShape().get()];
  if (!label.name.empty()) known.names.push_back(label.name);
  if (!label.layer.empty()) known.layer = label.layer;
}

// A product, its only solid and its only shell can be one shape, whose names are added from the outside inwards.
void add_parts(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process, const Marks& marks,
               OccModel& model) {
  for (const PartKind kind : {PartKind::product, PartKind::model, PartKind::shell})
    for (int i = 1; i <= file.NbEntities(); ++i)
      if (part_kind(file.Value(i)) == kind)
        add_part(file.Value(i), TransferBRep::ShapeResult(process, file.Value(i)), marks, model);
}

}  // namespace

void add_step_labels(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model) {
  const Marks marks(file);
  for (int i = 1; i <= file.NbEntities(); ++i) {
    const Entity& entity = file.Value(i);
    const auto edge = Handle(StepShape_EdgeCurve)::DownCast(entity);
    // A curve has a shape only if it belongs to no edge, in a set of curves.
    const bool is_curve = entity->IsKind(STANDARD_TYPE(StepGeom_Curve));
    if (edge.IsNull() && !is_curve && !entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface))) continue;
    ShapeLabel label{given_name(Handle(StepRepr_RepresentationItem)::DownCast(entity)->Name()), {}, {}};
    marks.complete(label, entity);
    if (!edge.IsNull()) complete_from_curve(label, *edge, marks);
    if (label.name.empty() && label.layer.empty() && label.colour.empty()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (!shape.IsNull()) model.labels.try_emplace(shape.TShape().get(), shape, label);
  }
  add_parts(file, process, marks, model);
}

}  // namespace quadrille::occ
