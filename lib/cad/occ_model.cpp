#include "cad/occ_model.hpp"

namespace quadrille::cad {

ShapeLabel OccModel::label_of(const TopoDS_Shape& wanted) const {
  const auto found = labels.find(wanted.TShape().get());
  return found == labels.end() ? ShapeLabel() : found->second.second;
}

}  // namespace quadrille::cad
