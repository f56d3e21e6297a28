#include <functional>
#include <utility>

#include "export/groups.hpp"
#include "export/hex_periodic.hpp"
#include "export/multi_block.hpp"
#include "export/renode.hpp"
#include "export/split_elements.hpp"
#include "export/split_hexes.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

constexpr int numbers_a_line = 4;

using Point = std::array<double, 3>;

class Plot3dWriter : TextWriter {
 public:
  /// `x`: the position of a mesh node.
  Plot3dWriter(const MultiBlock& blocks, std::function<Point(int)> x) : blocks_(blocks), x_(std::move(x)) {}

  std::string text() {
    print("{}\n", blocks_.grids.size());
    for (const BlockGrid& grid : blocks_.grids) print("{} {} {}\n", grid.num_i + 1, grid.num_j + 1, blocks_.num_levels);
    for (const BlockGrid& grid : blocks_.grids) {
      const std::vector<int> nodes = blocks_.points(grid);
      for (int coordinate = 0; coordinate < 3; ++coordinate) write_coordinate(nodes, coordinate);
    }
    return std::move(out_);
  }

 private:
  void write_coordinate(const std::vector<int>& nodes, int coordinate) {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      print("{}{}", x_(nodes[k])[coordinate], (k + 1) % numbers_a_line == 0 || k + 1 == nodes.size() ? '\n' : ' ');
  }

  const MultiBlock& blocks_;
  std::function<Point(int)> x_;
};

/// NASA's neutral map file. Faces 1 and 2 are the first and last k, with ranges of i and j; 3 and 4 are the first and
/// last i, with ranges of j and k; 5 and 6 the first and last j, with ranges of k and i. Blocks and points count
/// from 1.
class NeutralMapWriter : TextWriter {
 public:
  explicit NeutralMapWriter(const MultiBlock& blocks) : blocks_(blocks) {}

  std::string text(const NameList& words) {
    print("# Block IDIM JDIM KDIM\n{}\n", blocks_.grids.size());
    for (std::size_t g = 0; g < blocks_.grids.size(); ++g)
      print("{} {} {} {}\n", g + 1, blocks_.grids[g].num_i + 1, blocks_.grids[g].num_j + 1, blocks_.num_levels);
    print("# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap\n");
    for (const BoundaryRange& b : blocks_.boundaries) {
      print("{} ", words[b.boundary]);
      write_range(rising(b.range) ? b.range.begin : b.range.end, rising(b.range) ? b.range.end : b.range.begin,
                  b.range);
      print("\n");
    }
    for (int g = 0; g < static_cast<int>(blocks_.ends.size()); ++g) write_ends(g, words);
    for (const GridConnection& c : blocks_.connections) write_connection(c);
    return std::move(out_);
  }

 private:
  static bool is_i_face(const SideRange& range) { return range.side % 2 == 1; }
  /// Whether i or j rises along the side.
  static bool rising(const SideRange& range) { return range.side < 2; }

  void write_range(int from, int to, const SideRange& range) {
    constexpr std::array<int, 4> faces{5, 4, 6, 3};
    const int index = is_i_face(range) ? 1 : 0;
    const int start = blocks_.point(range, from)[index] + 1, end = blocks_.point(range, to)[index] + 1;
    print("{} {} ", range.grid + 1, faces[range.side]);
    if (is_i_face(range))
      print("{} {} 1 {}", start, end, blocks_.num_levels);
    else
      print("1 {} {} {}", blocks_.num_levels, start, end);
  }

  /// Bottom and top; of a full turn each is the other.
  void write_ends(int g, const NameList& words) {
    const BlockGrid& grid = blocks_.grids[g];
    const auto face = [&](int number) { print(" {} {} 1 {} 1 {}", g + 1, number, grid.num_i + 1, grid.num_j + 1); };
    for (int end = 0; end < 2; ++end) {
      const int boundary = blocks_.ends[g][end];
      if (boundary < 0 && end == 1) continue;
      print("{}", boundary < 0 ? "ONE_TO_ONE" : words[boundary]);
      face(end + 1);
      if (boundary < 0) face(2), print(" FALSE");
      print("\n");
    }
  }

  void write_connection(const GridConnection& c) {
    print("ONE_TO_ONE ");
    const bool is_forward = rising(c.first);
    write_range(is_forward ? c.first.begin : c.first.end, is_forward ? c.first.end : c.first.begin, c.first);
    print(" ");
    write_range(is_forward ? c.second.end : c.second.begin, is_forward ? c.second.begin : c.second.end, c.second);
    print(" {}\n", is_i_face(c.first) == is_i_face(c.second) ? "FALSE" : "TRUE");
  }

  const MultiBlock& blocks_;
};

/// The grids and the map beside them.
void write(const MultiBlock& blocks, const Groups& groups, std::function<Point(int)> x, Exported& exported) {
  const PlainNames words = add_plain_names(groups, false, {{"ONE_TO_ONE"}, 0, true}, exported);
  exported.bytes = Plot3dWriter(blocks, std::move(x)).text();
  exported.side_files.insert(exported.side_files.begin(),
                             {neutral_map_name, NeutralMapWriter(blocks).text(words.boundaries)});
}

}  // namespace

Exported plot3d(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh);
  const MultiBlock blocks = multi_block(mesh, groups);
  Exported exported;
  exported.add_loss(split_loss(mesh, blocks.quads));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  write(
      blocks, groups, [&](int node) { return position(blocks.quads, frame, node); }, exported);
  return exported;
}

Exported plot3d(const HexMesh& mesh) {
  const HexMesh cells = split_at_nodes(mesh);
  require_valid_pieces(cells, "Cells");
  const Groups groups = mesh_groups(cells);
  Exported exported;
  exported.add_loss(split_loss(mesh));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  exported.add_loss(periodic_loss(mesh));
  const auto x = [&](int node) { return Point{cells.nodes[node].x, cells.nodes[node].y, cells.nodes[node].z}; };
  write(multi_block(cells, groups), groups, x, exported);
  return exported;
}

}  // namespace quadrille::exports
