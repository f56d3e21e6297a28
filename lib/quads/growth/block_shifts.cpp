#include "growth/block_shifts.hpp"

#include <algorithm>

#include "growth/block_vertices.hpp"
#include "growth/straighten_lines.hpp"
#include "mesh/mesh_score.hpp"

namespace quadrille::growth {
namespace {

/// The lines along the normals of the walls cross the rows: columns, if side 0 or 2 is a wall.
VertexRows vertex_rows(const layers::WallPlan& walls, int block, const BlockVertices& vertices, int columns, int rows,
                       int order) {
  const std::array<int, 4>& sides = walls.walls.of_block[block];
  const bool has_columns = sides[0] >= 0 || sides[2] >= 0;
  const int num_rows = has_columns ? rows : columns, num_lines = has_columns ? columns : rows;
  VertexRows result;
  for (int row = 0; row <= num_rows; ++row) {
    result.rows.emplace_back();
    for (int line = 0; line <= num_lines; ++line)
      result.rows.back().push_back(vertices.at(has_columns ? 1 : 0, row * order, line));
  }
  result.fixed_first = 1 + walls.num_fixed_on(block, has_columns ? 3 : 0);
  result.fixed_last = 1 + walls.num_fixed_on(block, has_columns ? 1 : 2);
  return result;
}

}  // namespace

std::vector<layers::RowShifts> block_shifts(const BlockLayout& blocks, const layers::WallPlan& walls,
                                            const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit) {
  const std::vector<double> skewness = mesh::block_skewness(mesh);
  std::vector<layers::RowShifts> shifts(blocks.num_blocks());
  std::size_t first = 0;
  bool any = false;
  for (int block = 0; block < blocks.num_blocks(); ++block) {
    const auto& arcs = blocks.block2arcs[block];
    const int rows = divisions[arcs[1].arc].num_intervals(), columns = divisions[arcs[0].arc].num_intervals();
    const BlockVertices vertices(mesh, first, columns);
    first += static_cast<std::size_t>(rows) * columns;
    if (!walls.has_wall(block) || skewness[block] == 0) continue;
    shifts[block] = straightening_shifts(vertex_rows(walls, block, vertices, columns, rows, mesh.order), limit);
    any = true;
  }
  return any ? shifts : std::vector<layers::RowShifts>();
}

bool drop_useless(const QuadMesh& before, const QuadMesh& straight, std::vector<layers::RowShifts>& shifts) {
  const std::vector<double> was = mesh::block_skewness(before), now = mesh::block_skewness(straight);
  bool any = false;
  for (std::size_t block = 0; block < shifts.size(); ++block) {
    if (shifts[block].empty() || mesh::exceeds(was[block], now[block])) continue;
    shifts[block].clear();
    any = true;
  }
  return any;
}

}  // namespace quadrille::growth
