#include "layout/midpoint_layout.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "graph/face_corners.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"

namespace quadrille::layout {

graph::CandidateLayout midpoint_layout(const TriMesh& mesh, const midpoint::CoarseMesher& mesher, Report& report) {
  graph::CandidateLayout layout = graph::candidate_layout(midpoint::midpoint_graph(mesh, mesher, report));
  report.set("midpoint.blocks", graph::require_four_corners(layout.subdivision));
  return layout;
}

std::string reason_without_field(LayoutChoice choice) {
  if (choice == LayoutChoice::midpoint) return "";
  if (choice == LayoutChoice::automatic) return "there is no field that separatrices could follow";
  throw UsageError("--layout " + std::string(enum_name(choice)) + " needs a field, not a triangle mesh");
}

void certify_midpoint(graph::CandidateLayout& layout, const std::string& reason, Report& report) {
  layout.certificate.reason = reason;
  if (!reason.empty()) report.warn(warning::midpoint_instead_of_separatrices, midpoint_warning(reason));
  certify(LayoutMethod::midpoint, layout, report);
  report.set("subdivision.built", layout.num_built);
}

}  // namespace quadrille::layout
