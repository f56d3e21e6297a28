#pragma once
// The contents of a CAD file as an OpenCASCADE shape with labels, in the length unit of the file.

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::occ {

/// The labels of a face or an edge; empty if the file states none.
struct ShapeLabel {
  std::string name;
  std::string layer;
  std::string colour;  ///< "ff0000" for red
};

/// The labels of a shape that holds faces: a shell, a solid, a part of an assembly.
struct PartLabel {
  std::vector<std::string> names;  ///< outermost first: a product and its only solid are one shape
  std::string layer;               ///< empty if the file assigns none
};

struct OccModel {
  TopoDS_Shape shape;                   ///< all entities of the file
  std::string length_unit = "unknown";  ///< lower case
  double metres_per_unit = 0;
  double tolerance = 1e-7;  ///< tolerance stated by the file, in its length unit
  int num_faces = 0;        ///< faces that the file describes, including those that could not be built
  int num_solids = 0;
  std::vector<std::string> not_built;  ///< faces, or what holds them, that could not be built: "#40 'lid'"
  /// Uses of edges by the loops of each face, as stated by the file, with the keys of `labels`; empty if unknown.
  std::map<const TopoDS_TShape*, int> num_edges;
  /// Labels of faces and edges. The key is the TShape that OpenCASCADE shares among all uses of a shape; the stored
  /// shape keeps it alive.
  std::map<const TopoDS_TShape*, std::pair<TopoDS_Shape, ShapeLabel>> labels;

  /// Labels of shells, solids and assembled parts that have any, with keys as above.
  std::map<const TopoDS_TShape*, PartLabel> parts;

  /// The label of `part`, independent of its orientation and location.
  ShapeLabel label_of(const TopoDS_Shape& part) const {
    const auto found = labels.find(part.TShape().get());
    return found == labels.end() ? ShapeLabel() : found->second.second;
  }
};

}  // namespace quadrille::occ
