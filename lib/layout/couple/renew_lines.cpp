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

void renew_lines(graph::CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added) {
  kinds.resize(layout.graph().splines.size(), added);
  layout.lines = graph::lines_of_arcs(layout.graph(), kinds);
  layout.subdivision.drop_unused_splines();
}

void renew_lines(RegionLayouts& regions, std::vector<std::vector<LineKind>> kinds, LineKind added) {
  for (std::size_t r = 0; r < regions.layouts.size(); ++r) renew_lines(regions.layouts[r], std::move(kinds[r]), added);
}

}  // namespace quadrille::couple
