#include "refine/match_periodic.hpp"

namespace quadrille::refine {

void match_fractions(const PeriodicArcs& arcs, std::vector<double>& first, std::vector<double>& second) {
  if (first.size() != second.size()) return;
  // With the face on the left of both, the image of the first runs against the second.
  const bool is_mirrored = arcs[0].is_backwards == arcs[1].is_backwards;
  const std::size_t count = first.size();
  for (std::size_t k = 1; k + 1 < count; ++k) {
    double& other = second[is_mirrored ? count - 1 - k : k];
    const double mean = (first[k] + (is_mirrored ? 1 - other : other)) / 2;
    first[k] = mean;
    other = is_mirrored ? 1 - mean : mean;
  }
}

void match_periodic(const std::vector<PeriodicArcs>& pairs, sizing::ArcDivisions& divisions,
                    std::vector<std::vector<double>>& layered_nodes) {
  for (const PeriodicArcs& arcs : pairs) {
    match_fractions(arcs, divisions[arcs[0].arc].ends, divisions[arcs[1].arc].ends);
    if (layered_nodes.empty()) continue;
    std::vector<double>&first = layered_nodes[arcs[0].arc], &second = layered_nodes[arcs[1].arc];
    if (first.size() == second.size())
      match_fractions(arcs, first, second);
    else
      first.clear(), second.clear();  // they follow from the divisions
  }
}

}  // namespace quadrille::refine
