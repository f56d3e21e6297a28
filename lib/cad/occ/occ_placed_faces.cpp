#include "occ/occ_placed_faces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace quadrille::occ {
namespace {

class FaceCollector {
 public:
  explicit FaceCollector(const OccModel& model) : model_(model) {}

  void collect(const TopoDS_Shape& shape, PlacedFace around) {
    if (shape.ShapeType() > TopAbs_FACE) return;
    if (shape.ShapeType() == TopAbs_FACE) return add(TopoDS::Face(shape), std::move(around));
    const auto part = model_.parts.find(shape.TShape().get());
    if (part != model_.parts.end()) enter(part->second, around);
    for (TopoDS_Iterator i(shape); i.More(); i.Next()) collect(i.Value(), around);
  }

  std::vector<PlacedFace> faces;

 private:
  // CAD programs give a product and its solid the same name: it is listed once.
  static void enter(const PartLabel& part, PlacedFace& around) {
    for (const std::string& name : part.names)
      if (around.parts.empty() || around.parts.back() != name) around.parts.push_back(name);
    if (!part.layer.empty()) around.layer = part.layer;
  }

  void add(const TopoDS_Face& face, PlacedFace placed) {
    if (!seen_.Add(face)) return;
    const std::string own_layer = model_.label_of(face).layer;
    if (!own_layer.empty()) placed.layer = own_layer;
    placed.face = face;
    faces.push_back(std::move(placed));
  }

  const OccModel& model_;
  TopTools_MapOfShape seen_;  ///< keys: shape and place, without orientation
};

}  // namespace

std::string PlacedFace::part_path() const { return fmt::format("{}", fmt::join(parts, "/")); }

std::vector<PlacedFace> placed_faces(const OccModel& model) {
  FaceCollector collector(model);
  collector.collect(model.shape, {});
  return std::move(collector.faces);
}

}  // namespace quadrille::occ
