#include <algorithm>

#include "export/groups.hpp"
#include "export/multi_block.hpp"
#include "export/renode.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

constexpr int numbers_a_line = 4;

class Plot3dWriter : TextWriter {
 public:
  Plot3dWriter(const MultiBlock& blocks, const Frame& frame) : blocks_(blocks), frame_(frame) {}

  std::string text() {
    print("{}\n", blocks_.grids.size());
    for (const BlockGrid& grid : blocks_.grids) print("{} {} 1\n", grid.num_i + 1, grid.num_j + 1);
    for (const BlockGrid& grid : blocks_.grids) {
      const std::vector<int> nodes = grid.vertices(blocks_.quads);
      for (int coordinate = 0; coordinate < 3; ++coordinate) write_coordinate(nodes, coordinate);
    }
    return std::move(out_);
  }

 private:
  void write_coordinate(const std::vector<int>& nodes, int coordinate) {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      print("{}{}", position(blocks_.quads, frame_, nodes[k])[coordinate],
            (k + 1) % numbers_a_line == 0 || k + 1 == nodes.size() ? '\n' : ' ');
  }

  const MultiBlock& blocks_;
  const Frame& frame_;
};

/// NASA's neutral map file. Faces 3 and 4 are the first and last i, with ranges of j and k; 5 and 6 the first and last
/// j, with ranges of k and i. Blocks and points count from 1.
class NeutralMapWriter : TextWriter {
 public:
  explicit NeutralMapWriter(const MultiBlock& blocks) : blocks_(blocks) {}

  std::string text(const NameList& words) {
    print("# Block IDIM JDIM KDIM\n{}\n", blocks_.grids.size());
    for (std::size_t g = 0; g < blocks_.grids.size(); ++g)
      print("{} {} {} 1\n", g + 1, blocks_.grids[g].num_i + 1, blocks_.grids[g].num_j + 1);
    print("# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap\n");
    for (const BoundaryRange& b : blocks_.boundaries) {
      print("{} ", words[b.boundary]);
      write_range(rising(b.range) ? b.range.begin : b.range.end, rising(b.range) ? b.range.end : b.range.begin,
                  b.range);
      print("\n");
    }
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
      print("{} {} 1 1", start, end);
    else
      print("1 1 {} {}", start, end);
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

}  // namespace

Exported plot3d(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh);
  const MultiBlock blocks = multi_block(mesh, groups);
  Exported exported;
  exported.add_loss(split_loss(mesh, blocks.quads));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  const PlainNames words = add_plain_names(groups, false, {{"ONE_TO_ONE"}, 0, true}, exported);
  exported.bytes = Plot3dWriter(blocks, frame).text();
  exported.side_files.insert(exported.side_files.begin(),
                             {neutral_map_name, NeutralMapWriter(blocks).text(words.boundaries)});
  return exported;
}

}  // namespace quadrille::exports
