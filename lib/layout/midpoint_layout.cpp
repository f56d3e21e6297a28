#include "layout/midpoint_layout.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "graph/face_corners.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "midpoint/midpoint_graph.hpp"

namespace quadrille::layout {

graph::CandidateLayout midpoint_layout(const TriMesh& mesh, Report& report) {
  graph::CandidateLayout layout = graph::candidate_layout(midpoint::midpoint_graph(mesh, report));
  report.set("midpoint.blocks", graph::require_four_corners(layout.subdivision));
  return layout;
}

SeparatrixGraph layout_without_field(const TriMesh& mesh, LayoutChoice choice, Report& report) {
  if (choice != LayoutChoice::midpoint && choice != LayoutChoice::automatic)
    throw UsageError("--layout " + std::string(enum_name(choice)) + " needs a field, not a triangle mesh");
  graph::CandidateLayout layout = midpoint_layout(mesh, report);
  if (choice == LayoutChoice::automatic) {
    layout.certificate.reason = "there is no field that separatrices could follow";
    report.warn(warning::midpoint_instead_of_separatrices, midpoint_warning(layout.certificate.reason));
  }
  certify(LayoutMethod::midpoint, layout, report);
  report.set("subdivision.built", layout.num_built);
  return graph::separatrix_graph(std::move(layout));
}

}  // namespace quadrille::layout
