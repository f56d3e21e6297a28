#include "layers/align_divisions.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <utility>

#include "layers/layer_rules.hpp"

namespace quadrille::layers {
namespace {

/// The chord's parameters at which the layers of arc i end.
std::pair<double, double> free_range(const LayeredChord& chord, int i, const std::vector<double>& ends) {
  const int count = static_cast<int>(ends.size());
  const int low = chord.at_end(i, 0).layers(), high = chord.at_end(i, 1).layers();
  return {chord.parameter(i, ends[chord.own_step(i, low, count)]),
          chord.parameter(i, ends[chord.own_step(i, count - 1 - high, count)])};
}

/// 0 between arcs with different layers: their intervals of equal number lie at different heights.
double alignment_weight(const LayeredChord& chord, const OppositeArcs& pair) {
  const auto [a, b, distance] = pair;
  for (const int end : {0, 1})
    if (chord.at_end(a, end).layers() != chord.at_end(b, end).layers()) return 0;
  const bool is_layered = chord.at_end(a, 0).layers() + chord.at_end(a, 1).layers() > 0;
  const bool is_free = !is_layered || chord.is_aligned(a) || chord.is_aligned(b);
  const double factor = 4 * (is_free ? 1 : layer_constants.layered_distance_factor);
  const double slenderness = (chord.length(a) + chord.length(b)) / (factor * distance);
  return std::min(layer_constants.greatest_weight, std::pow(slenderness, layer_constants.alignment_power));
}

Eigen::SparseMatrix<double> alignment_matrix(const LayeredChord& chord) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(chord.num_arcs() + 4 * chord.opposite_arcs().size());
  for (int i = 0; i < chord.num_arcs(); ++i) entries.emplace_back(i, i, 1.0);
  for (const OppositeArcs& pair : chord.opposite_arcs()) {
    const double weight = alignment_weight(chord, pair);
    if (weight == 0) continue;
    for (const int i : {pair.a, pair.b}) {
      entries.emplace_back(i, i, weight);
      entries.emplace_back(i, pair.a + pair.b - i, -weight);
    }
  }
  Eigen::SparseMatrix<double> matrix(chord.num_arcs(), chord.num_arcs());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

void align_divisions(const LayeredChord& chord, std::vector<sizing::ArcDivision>& divisions) {
  const int count = static_cast<int>(divisions.front().ends.size());
  Eigen::MatrixXd own(chord.num_arcs(), count);
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const auto [low, high] = free_range(chord, i, divisions[i].ends);
    for (int k = 0; k < count; ++k)
      own(i, k) = (chord.parameter(i, divisions[i].ends[chord.own_step(i, k, count)]) - low) / (high - low);
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(alignment_matrix(chord));
  const Eigen::MatrixXd aligned = solver.solve(own);
  for (int i = 0; i < chord.num_arcs(); ++i) {
    const auto [low, high] = free_range(chord, i, divisions[i].ends);
    for (int k = chord.at_end(i, 0).layers() + 1; k + 1 < count - chord.at_end(i, 1).layers(); ++k)
      divisions[i].ends[chord.own_step(i, k, count)] = chord.fraction(i, low + aligned(i, k) * (high - low));
  }
}

}  // namespace quadrille::layers
