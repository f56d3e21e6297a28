#pragma once
// The edges of a curved OpenCASCADE face: their numbers in the file, and their curves in space.

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <utility>
#include <vector>

#include "heal/raw_face.hpp"
#include "model/chart.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {

/// A part of an edge of the file, or the whole, between two parameters of the kernel's curve.
struct EdgePart {
  TopoDS_Edge edge;
  int number = 0;  ///< index into the edges of the file
  double first = 0, last = 0;
};

/// Number, name, layer and colour of an edge.
heal::RawEdge labels_of(const OccModel& model, const TopoDS_Edge& edge, int number);

/// Makes the curve of an edge that the file describes in the parameters of its surface alone.
void require_curve(const TopoDS_Edge& edge);

/// The edges of a face as the file has them.
class FaceEdges {
 public:
  explicit FaceEdges(std::vector<TopoDS_Edge> edges) : edges_(std::move(edges)) {}

  /// The edge of the file of which `edge`, of the same face after the kernel changed its topology, is a part; -1 for
  /// an edge that the kernel added, such as a seam.
  int number_of(const TopoDS_Edge& edge) const;
  int size() const { return static_cast<int>(edges_.size()); }

 private:
  std::vector<TopoDS_Edge> edges_;
};

/// A curve in space, and how its parameters come from those of the kernel.
class ConvertedCurve {
 public:
  /// The curve of `edge` from `first` to `last`. `tolerance`: as in occ_curves.hpp, plane_curve. Throws FormatError.
  ConvertedCurve(const TopoDS_Edge& edge, double first, double last, double tolerance);

  const SpaceCurve& curve() const { return curve_; }
  double error() const { return error_; }  ///< of the approximation, a length
  double parameter(double t) const;        ///< of the point that the kernel has at t

 private:
  Handle(Geom_Curve) exact_;
  double first_ = 0, last_ = 1;
  SpaceCurve curve_;
  double error_ = 0;
};

}  // namespace quadrille::occ
