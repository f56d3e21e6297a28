#include "layout/lines_to_fillets.hpp"

#include <algorithm>
#include <vector>

#include "base/angle.hpp"
#include "curve/project.hpp"
#include "simplify/end_on_fillets.hpp"

namespace quadrille::layout {
namespace {

bool is_move_from_fillet(const NodeChange& change) {
  const auto is_inner = [](const std::vector<NodeMark>& nodes) {
    return nodes.size() == 1 && nodes[0].valence == 3 && nodes[0].location == NodeLocation::inside;
  };
  return change.kind == ChangeKind::feature && is_inner(change.before) && is_inner(change.after);
}

simplify::FilletMiddle nearest_boundary_point(const CadFace& face, Vec2 x) {
  simplify::FilletMiddle nearest;
  double least = 0;
  for (int c = 0; c < face.num_curves(); ++c) {
    const curve::Projection p = curve::project(face.curves[c], x);
    if (c > 0 && p.distance >= least) continue;
    least = p.distance;
    nearest = {c, p.t};
  }
  return nearest;
}

}  // namespace

void end_lines_on_fillets(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                          graph::CandidateLayout& layout, Report& report) {
  std::vector<simplify::FilletMiddle> fillets;
  for (const NodeChange& change : points.changes)
    if (is_move_from_fillet(change))
      fillets.push_back(nearest_boundary_point(layout.graph().face, change.before[0].position));
  if (fillets.empty()) return;
  const simplify::FilletEnds ends = simplify::end_lines_on_fillets(evaluator, fillets, layout);
  report.set("fillets.lines_moved", ends.num_moved);
  double& deviation = layout.certificate.largest_deviation_degrees;
  deviation = std::max(deviation, degrees(ends.deviation));
}

}  // namespace quadrille::layout
