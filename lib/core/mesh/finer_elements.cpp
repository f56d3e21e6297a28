#include "mesh/finer_elements.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/disjoint_sets.hpp"

namespace quadrille::mesh {

namespace {

constexpr int power = 2 * resolution_power;

/// An element's lengths along xi1 and xi2, means of the power 2q, in units of the prescribed length.
std::array<double, 2> lengths_of(const ElementPowers& powers) {
  return {std::pow(powers.along[0] / powers.area, 1.0 / power), std::pow(powers.along[1] / powers.area, 1.0 / power)};
}

/// By row: the parts into which its elements are split.
std::vector<double> parts_of_rows(const std::vector<std::array<int, 2>>& rows,
                                  const std::vector<std::array<double, 2>>& lengths) {
  std::vector<double> weights(2 * rows.size()), sums(2 * rows.size()), parts(2 * rows.size(), 1);
  for (std::size_t elem = 0; elem < rows.size(); ++elem)
    for (int along = 0; along < 2; ++along) {
      const double width = lengths[elem][1 - along];
      weights[rows[elem][along]] += width;
      sums[rows[elem][along]] += width * std::pow(lengths[elem][along], power);
    }
  for (std::size_t row = 0; row < parts.size(); ++row)
    if (sums[row] > 0) parts[row] = std::max(1.0, std::pow(sums[row] / weights[row], 1.0 / power));
  return parts;
}

}  // namespace

std::vector<std::array<int, 2>> element_rows(const QuadMesh& mesh) {
  // A side by its ends and an inner node, since two sides may have the same ends, with the number of the row along it.
  std::vector<std::tuple<int, int, int, int>> sides;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const int from = side_start(mesh, elem, side), to = side_node(mesh, elem, side, mesh.order);
      sides.emplace_back(std::min(from, to), std::max(from, to),
                         side_node(mesh, elem, side, from < to ? 1 : mesh.order - 1), 2 * elem + side % 2);
    }
  std::sort(sides.begin(), sides.end());
  DisjointSets rows(2 * static_cast<std::size_t>(mesh.num_elems()));
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto& [low, high, inner, row] = sides[i];
    const auto& [low0, high0, inner0, row0] = sides[i - 1];
    if (std::tie(low, high, inner) == std::tie(low0, high0, inner0)) rows.unite(row, row0);
  }
  std::vector<std::array<int, 2>> result;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) result.push_back({rows.find(2 * elem), rows.find(2 * elem + 1)});
  return result;
}

ExpectedMesh expected_mesh(const std::vector<std::array<int, 2>>& rows, const std::vector<ElementPowers>& powers,
                           const std::vector<double>& factors) {
  std::vector<std::array<double, 2>> lengths(powers.size());
  for (std::size_t elem = 0; elem < powers.size(); ++elem)
    if (powers[elem].area > 0)
      for (int along = 0; along < 2; ++along) lengths[elem][along] = factors[elem] * lengths_of(powers[elem])[along];
  const std::vector<double> parts = parts_of_rows(rows, lengths);
  double error = 0, area = 0;
  ExpectedMesh expected;
  for (std::size_t elem = 0; elem < powers.size(); ++elem) {
    if (!(powers[elem].area > 0)) continue;
    const double k = parts[rows[elem][0]], l = parts[rows[elem][1]];
    const double own_area = powers[elem].area * factors[elem] * factors[elem];
    error += own_area * (std::pow(lengths[elem][0] / k, power) + std::pow(lengths[elem][1] / l, power));
    area += own_area;
    expected.num_elems += k * l;
  }
  if (area > 0) expected.resolution = error / (2 * area * std::pow(area / expected.num_elems, resolution_power));
  return expected;
}

}  // namespace quadrille::mesh
