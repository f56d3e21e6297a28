#include "refine/tip_patch.hpp"

#include <algorithm>
#include <utility>

#include "mesh/side_key.hpp"

namespace quadrille::refine {
namespace {

constexpr QuadSide no_side{-1, 0};

/// The other element at each side.
class Neighbours {
 public:
  explicit Neighbours(const QuadMesh& mesh) {
    std::map<std::pair<int, int>, QuadSide> open;
    for (int elem = 0; elem < mesh.num_elems(); ++elem)
      for (int side = 0; side < 4; ++side) {
        const auto [at, is_new] = open.try_emplace(mesh::side_key(mesh, elem, side), elem, side);
        if (!is_new) beyond_[{elem, side}] = at->second, beyond_[at->second] = {elem, side};
      }
  }
  QuadSide beyond(int elem, int side) const {
    const auto at = beyond_.find({elem, side % 4});
    return at == beyond_.end() ? no_side : at->second;
  }

 private:
  std::map<QuadSide, QuadSide> beyond_;
};

using Cell = TipPatch::Cell;

/// The cell across side 1 (of greater i) or 2 (of greater j), sides counted from the cell's corner.
Cell beside(const Neighbours& neighbours, Cell cell, int side) {
  const auto [elem, there] = neighbours.beyond(cell.elem, cell.corner + side);
  return {elem, (there + (side == 1 ? 1 : 0)) % 4};
}

/// The m x m cells from the first one on; none where one, or one around them, is missing, or they are no grid.
std::optional<std::vector<Cell>> grid_from(const Neighbours& neighbours, Cell first, int width) {
  std::map<std::pair<int, int>, Cell> cells{{{0, 0}, first}};
  std::vector<Cell> inside;
  for (int j = 0; j <= width; ++j)
    for (int i = 0; i <= width; ++i) {
      if (i == width && j == width) continue;
      if (i > 0 || j > 0) {
        const Cell cell = i > 0 ? beside(neighbours, cells[{i - 1, j}], 1) : beside(neighbours, cells[{i, j - 1}], 2);
        if (cell.elem < 0) return std::nullopt;
        if (i > 0 && j > 0 && i < width && beside(neighbours, cells[{i, j - 1}], 2).elem != cell.elem)
          return std::nullopt;
        cells[{i, j}] = cell;
      }
      if (i < width && j < width) inside.push_back(cells[{i, j}]);
    }
  return inside;
}

/// Whether the edges along both sides are on one curve each, or inside.
bool has_whole_sides(const TipPatch& patch, const std::map<QuadSide, int>& curves) {
  const auto curve = [&](bool is_at_start, int k) {
    const auto at = curves.find(patch.wall_edge(is_at_start, k));
    return at == curves.end() ? -1 : at->second;
  };
  for (int k = 1; k < patch.width(); ++k)
    if (curve(true, k) != curve(true, 0) || curve(false, k) != curve(false, 0)) return false;
  return true;
}

}  // namespace

TipPatch::TipPatch(const QuadMesh& mesh, int width, std::vector<Cell> cells)
    : mesh_(mesh), width_(width), cells_(std::move(cells)) {}

bool TipPatch::contains_any(const std::set<int>& elems) const {
  return std::ranges::any_of(cells_, [&](const Cell& cell) { return elems.contains(cell.elem); });
}

int TipPatch::vertex(int i, int j) const {
  const int a = std::min(i, width_ - 1), b = std::min(j, width_ - 1);
  const int corner = i > a ? (j > b ? 2 : 1) : (j > b ? 3 : 0);
  return side_start(mesh_, cell(a, b).elem, (cell(a, b).corner + corner) % 4);
}

QuadSide TipPatch::outer_edge(int k) const {
  const Cell& at = k < width_ ? cell(width_ - 1, k) : cell(2 * width_ - 1 - k, width_ - 1);
  return {at.elem, (at.corner + (k < width_ ? 1 : 2)) % 4};
}

QuadSide TipPatch::wall_edge(bool is_at_start, int k) const {
  const Cell& at = is_at_start ? cell(k, 0) : cell(0, k);
  return {at.elem, (at.corner + (is_at_start ? 0 : 3)) % 4};
}

std::vector<TipPatch> tip_patches(const QuadMesh& mesh, int tip, int width, const std::map<QuadSide, int>& curves) {
  std::vector<TipPatch> patches;
  std::set<int> at_interfaces;
  for (const QuadBoundaryEdge& e : mesh.interface_edges) at_interfaces.insert(e.elem);
  const Neighbours neighbours(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int corner = 0; corner < 4; ++corner) {
      if (side_start(mesh, elem, corner) != tip) continue;
      std::optional<std::vector<Cell>> cells = grid_from(neighbours, {elem, corner}, width);
      if (!cells) return {};
      patches.emplace_back(mesh, width, std::move(*cells));
      if (patches.back().contains_any(at_interfaces) || !has_whole_sides(patches.back(), curves)) return {};
    }
  return patches;
}

}  // namespace quadrille::refine
