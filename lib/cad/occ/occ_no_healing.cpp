#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>

#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

// Replaces OpenCASCADE's shape healing: every shape stays as the file describes it.
class NoHealing : public XSAlgo_AlgoContainer {
 public:
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real, const Standard_Real, const Standard_CString,
                            const Standard_CString, Handle(Standard_Transient) &, const Message_ProgressRange&,
                            const Standard_Boolean) const override {
    return shape;
  }
  void MergeTransferInfo(const Handle(Transfer_TransientProcess) &, const Handle(Standard_Transient) &,
                         const Standard_Integer) const override {}
};

}  // namespace

void switch_healing_off() {
  XSAlgo::Init();
  XSAlgo::SetAlgoContainer(new NoHealing);
}

}  // namespace quadrille::occ
