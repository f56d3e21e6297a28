#include "layers/layered_chord.hpp"

#include "mesh/block_sides.hpp"

namespace quadrille::layers {
namespace {

std::vector<OppositeArcs> find_opposite_arcs(const WallInput& input, const mesh::Chord& chord) {
  std::vector<int> position(input.measured.num_arcs(), -1);
  for (std::size_t i = 0; i < chord.arcs.size(); ++i) position[chord.arcs[i]] = static_cast<int>(i);
  std::vector<OppositeArcs> pairs;
  for (int block = 0; block < input.blocks().num_blocks(); ++block)
    for (int k = 0; k < 2; ++k) {
      const auto arc = [&](int side) { return mesh::half_edge(input.blocks(), block, side).arc; };
      const int a = position[arc(k)], b = position[arc(k + 2)];
      if (a < 0 || b < 0 || a == b) continue;
      pairs.push_back({a, b, (input.measured.length(arc(k + 1)) + input.measured.length(arc(k + 3))) / 2});
    }
  return pairs;
}

}  // namespace

LayeredChord::LayeredChord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings,
                           const ArcSizes& sizes)
    : input_(input),
      chord_(input.measured.chords()[chord]),
      spacings_(spacings),
      growth_(least_growth(chord_, spacings)),
      opposite_arcs_(find_opposite_arcs(input, chord_)) {
  for (const int a : chord_.arcs) sizes_.push_back(sizes.at(a));
}

}  // namespace quadrille::layers
