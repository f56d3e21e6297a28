#include "layers/wall_sags.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "curve/nurbs.hpp"
#include "layers/wall_sides.hpp"

namespace quadrille::layers {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// By chord and end: the least first height of the layers there.
std::vector<std::array<double, 2>> heights_by_chord(const sizing::MeasuredLayout& measured,
                                                    const std::vector<WallSpec>& specs) {
  const WallSides walls =
      find_wall_sides(measured.blocks(), measured.curves(), curve_walls(specs, measured.blocks().face), specs);
  std::vector<std::array<double, 2>> heights(measured.chords().size(), {none, none});
  for (const auto& [arc, end, side] : walls.layered_ends()) {
    const int chord = measured.chord_of(arc);
    const bool is_backwards = measured.chords()[chord].backwards[measured.position_in_chord(arc)];
    double& height = heights[chord][is_backwards ? 1 - end : end];
    height = std::min(height, specs[walls.sides[side].spec].first);
  }
  return heights;
}

/// By arc: the least height of the chords that begin or end on it.
std::vector<double> heights_by_arc(const sizing::MeasuredLayout& measured, const std::vector<WallSpec>& specs) {
  const std::vector<std::array<double, 2>> by_chord = heights_by_chord(measured, specs);
  std::vector<double> heights(measured.num_arcs(), none);
  for (const auto& sides : measured.blocks().block2arcs)
    for (int k = 0; k < 4; ++k) {
      const int chord = measured.chord_of(sides[k].arc);
      const bool is_backwards = measured.chords()[chord].backwards[measured.position_in_chord(sides[k].arc)];
      const bool is_forward = sides[k].is_backwards == is_backwards;  // the chord runs along the side's direction
      for (const int end : {0, 1}) {
        double& height = heights[sides[(k + (is_forward == (end == 0) ? 3 : 1)) % 4].arc];
        height = std::min(height, by_chord[chord][end]);
      }
    }
  return heights;
}

}  // namespace

std::vector<sizing::SagLimit> wall_sags(const sizing::MeasuredLayout& measured, const std::vector<WallSpec>& specs,
                                        double part) {
  const std::vector<double> heights = heights_by_arc(measured, specs);
  std::vector<sizing::SagLimit> sags;
  for (int arc = 0; arc < measured.num_arcs(); ++arc) {
    if (heights[arc] == none) continue;
    for (const ArcPiece& piece : measured.blocks().arcs[arc].pieces) {
      const auto [low, high] = std::minmax(piece.t0, piece.t1);
      sags.push_back({curve::trimmed(measured.curves().curve(piece.curve), low, high), part * heights[arc]});
    }
  }
  return sags;
}

}  // namespace quadrille::layers
