#include "mesh/chords.hpp"

#include <algorithm>
#include <numeric>

namespace quadrille {

std::vector<int> arc_chords(const std::vector<std::array<int, 4>>& block2arcs, int num_arcs) {
  std::vector<int> lowest(num_arcs);  // a forest in which every tree's root is its lowest arc
  std::iota(lowest.begin(), lowest.end(), 0);
  const auto root = [&](int arc) {
    while (lowest[arc] != arc) arc = lowest[arc] = lowest[lowest[arc]];
    return arc;
  };
  for (const std::array<int, 4>& arcs : block2arcs)
    for (int k = 0; k < 2; ++k) {
      const int a = root(arc_of(arcs[k])), b = root(arc_of(arcs[k + 2]));
      lowest[std::max(a, b)] = std::min(a, b);
    }
  std::vector<int> chord(num_arcs);
  int num_chords = 0;
  for (int arc = 0; arc < num_arcs; ++arc) chord[arc] = root(arc) == arc ? num_chords++ : chord[root(arc)];
  return chord;
}

}  // namespace quadrille
