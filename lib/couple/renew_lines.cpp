#include "couple/renew_lines.hpp"

#include <utility>

#include "graph/separatrix_lines.hpp"

namespace quadrille::couple {

std::vector<std::vector<LineKind>> kinds_of_lines(const RegionLayouts& regions) {
  std::vector<std::vector<LineKind>> kinds;
  for (const graph::CandidateLayout& layout : regions.layouts)
    kinds.push_back(graph::spline_kinds(layout.graph(), layout.lines));
  return kinds;
}

void renew_lines(RegionLayouts& regions, std::vector<std::vector<LineKind>> kinds, LineKind added) {
  for (std::size_t r = 0; r < regions.layouts.size(); ++r) {
    graph::CandidateLayout& layout = regions.layouts[r];
    kinds[r].resize(layout.graph().splines.size(), added);
    layout.lines = graph::lines_of_arcs(layout.graph(), kinds[r]);
    layout.subdivision.drop_unused_splines();
  }
}

}  // namespace quadrille::couple
