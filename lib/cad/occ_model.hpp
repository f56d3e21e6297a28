#pragma once
// What a CAD file holds, as an OpenCASCADE shape with labels, in the numbers of the file.

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>
#include <utility>

namespace quadrille::cad {

/// What a file says about a face or an edge beside its shape; empty where it says nothing.
struct ShapeLabel {
  std::string name;
  std::string layer;
  std::string colour;  ///< "ff0000" for red
};

struct OccModel {
  TopoDS_Shape shape;                   ///< everything that the file holds
  std::string length_unit = "unknown";  ///< lower case
  double metres_per_unit = 0;
  double tolerance = 1e-7;  ///< the file's own, in its unit
  int num_faces = 0;        ///< faces that the file describes, also those that could not be built
  int num_solids = 0;
  int num_face_edges = -1;  ///< uses of edges by the loops of the only face, as the file says; -1 where unknown
  /// Of faces and edges, by what OpenCASCADE shares among all uses of a shape; the shape keeps that alive.
  std::map<const TopoDS_TShape*, std::pair<TopoDS_Shape, ShapeLabel>> labels;

  /// The label of `wanted`, whatever its orientation and place.
  ShapeLabel label_of(const TopoDS_Shape& wanted) const {
    const auto found = labels.find(wanted.TShape().get());
    return found == labels.end() ? ShapeLabel() : found->second.second;
  }
};

}  // namespace quadrille::cad
