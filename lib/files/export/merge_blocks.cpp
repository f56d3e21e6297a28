#include "export/merge_blocks.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/name_text.hpp"
#include "export/groups.hpp"
#include "export/layer_quads.hpp"
#include "export/vertex_stars.hpp"

namespace quadrille::exports {

namespace {

constexpr int greatest_search = 100'000;  ///< steps

/// A straight line of edges from one irregular vertex to another.
struct DoubleChord {
  std::vector<int> edges;
  std::vector<int> inner;  ///< stars between its ends
  int from = 0, to = 0;    ///< stars
};

/// The double chords of which no two cross that spare most lines: chosen or not, one after another, with the gain
/// that is still possible as a bound.
class ChordChoice {
 public:
  ChordChoice(const VertexStars& stars, const std::vector<DoubleChord>& chords, std::vector<bool> is_line)
      : stars_(stars), chords_(chords), is_line_(std::move(is_line)) {}

  std::vector<bool> best() {
    is_chosen_.assign(chords_.size(), false);
    best_ = is_chosen_;
    search(0, 0);
    return best_;
  }

 private:
  int deficits(const DoubleChord& c) const {
    return stars_.deficit(c.from, is_line_) + (c.to == c.from ? 0 : stars_.deficit(c.to, is_line_));
  }
  bool is_free(const DoubleChord& c) const {
    return std::none_of(c.inner.begin(), c.inner.end(), [&](int star) { return crossed_.count(star) > 0; });
  }
  void mark(const DoubleChord& c, bool is_line) {
    for (const int edge : c.edges) is_line_[edge] = is_line;
    for (const int star : c.inner) is_line ? void(crossed_.insert(star)) : void(crossed_.erase(star));
  }

  void search(std::size_t at, int gain) {
    if (gain > best_gain_) best_gain_ = gain, best_ = is_chosen_;
    if (at == chords_.size() || gain + static_cast<int>(chords_.size() - at) <= best_gain_) return;
    if (++steps_ > greatest_search) return;
    const DoubleChord& chord = chords_[at];
    if (is_free(chord)) {
      const int before = deficits(chord);
      mark(chord, true);
      if (const int spared = before - deficits(chord) - 1; spared > 0) {
        is_chosen_[at] = true;
        search(at + 1, gain + spared);
        is_chosen_[at] = false;
      }
      mark(chord, false);
    }
    search(at + 1, gain);
  }

  const VertexStars& stars_;
  const std::vector<DoubleChord>& chords_;
  std::vector<bool> is_line_, is_chosen_, best_;
  std::set<int> crossed_;
  int best_gain_ = 0, steps_ = 0;
};

/// An element of a grid, by column, row and the side that is its lower one.
struct GridCell {
  int elem = 0, below = 0, i = 0, j = 0;
};

/// Whole numbers that meet all intervals, as few as possible; each in the middle of those that it meets first.
std::vector<int> stabbing(std::vector<std::array<int, 2>> intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  std::vector<int> cuts;
  for (std::size_t k = 0; k < intervals.size();) {
    int low = intervals[k][0];
    const int high = intervals[k][1];
    for (; k < intervals.size() && intervals[k][0] <= high; ++k) low = std::max(low, intervals[k][0]);
    cuts.push_back((low + high) / 2);
  }
  return cuts;
}

class BlockMerger {
 public:
  explicit BlockMerger(const QuadMesh& mesh) : mesh_(mesh), stars_(mesh) {
    const Groups groups = mesh_groups(mesh);
    for (std::size_t block = 0; block < mesh.block_names.size(); ++block)
      block_class_.push_back({groups.block2region[block], mesh.block_region.empty() ? 0 : mesh.block_region[block]});
    find_first_lines();
  }

  std::vector<int> merged() {
    add_chords();
    std::vector<int> all(stars_.stars().size());
    std::iota(all.begin(), all.end(), 0);
    repair(std::move(all));
    find_grids();
    while (cut_rings()) find_grids();
    if (cut_where_touching()) find_grids();
    return grid_;
  }

 private:
  /// The boundary, interfaces, and the edges between blocks of different names or regions.
  void find_first_lines() {
    is_line_.assign(stars_.numbering().edges.size(), false);
    for (const QuadBoundaryEdge& e : mesh_.interface_edges) is_line_[stars_.edge(e.elem, e.side)] = true;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int side = 0; side < 4; ++side) {
        const int beyond = stars_.across(elem, side);
        if (beyond < 0 || block_class_[mesh_.elem_block[elem]] != block_class_[mesh_.elem_block[beyond / 4]])
          is_line_[stars_.edge(elem, side)] = true;
      }
  }

  void add_chords() {
    const std::vector<DoubleChord> chords = double_chords();
    const std::vector<bool> chosen = ChordChoice(stars_, chords, is_line_).best();
    for (std::size_t c = 0; c < chords.size(); ++c)
      for (const int edge : chords[c].edges)
        if (chosen[c]) is_line_[edge] = true;
  }

  /// Each once: by its end at which the first edge has the lower number.
  std::vector<DoubleChord> double_chords() const {
    std::vector<DoubleChord> chords;
    for (int star = 0; star < static_cast<int>(stars_.stars().size()); ++star) {
      if (stars_.deficit(star, is_line_) == 0) continue;
      for (const int edge : stars_.stars()[star].edges) {
        if (is_line_[edge]) continue;
        DoubleChord chord = chord_from(star, edge);
        std::vector<int> inner = chord.inner;
        std::sort(inner.begin(), inner.end());
        const bool crosses_itself = std::adjacent_find(inner.begin(), inner.end()) != inner.end();
        if (!crosses_itself && stars_.deficit(chord.to, is_line_) > 0 && is_first_end(chord))
          chords.push_back(std::move(chord));
      }
    }
    return chords;
  }

  static bool is_first_end(const DoubleChord& chord) {
    return std::pair{chord.edges.front(), chord.from} <= std::pair{chord.edges.back(), chord.to};
  }

  DoubleChord chord_from(int star, int edge) const {
    DoubleChord chord;
    chord.from = star;
    for (;;) {
      chord.edges.push_back(edge);
      star = stars_.other_end(edge, star);
      edge = stars_.straight_on(star, edge, is_line_);
      if (edge < 0) break;
      chord.inner.push_back(star);
    }
    chord.to = star;
    return chord;
  }

  /// Adds lines until no star misses any, and follows them.
  void repair(std::vector<int> stars) {
    for (std::size_t at = 0; at < stars.size(); ++at)
      for (const int edge : stars_.missing_lines(stars[at], is_line_)) {
        is_line_[edge] = true;
        stars.push_back(stars_.other_end(edge, stars[at]));
      }
  }

  /// The elements between lines, from that of the lowest number on.
  void find_grids() {
    grid_.assign(mesh_.num_elems(), -1);
    cells_.clear();
    for (int first = 0; first < mesh_.num_elems(); ++first) {
      if (grid_[first] >= 0) continue;
      std::vector<GridCell> cells{{first, 0, 0, 0}};
      grid_[first] = static_cast<int>(cells_.size());
      for (std::size_t at = 0; at < cells.size(); ++at)
        for (int turn = 0; turn < 4; ++turn) add_neighbour(cells[at], turn, cells);
      cells_.push_back(std::move(cells));
    }
  }

  /// The cell below, to the right, above or to the left.
  void add_neighbour(GridCell cell, int turn, std::vector<GridCell>& cells) {
    const int side = (cell.below + turn) % 4, beyond = stars_.across(cell.elem, side);
    if (beyond < 0 || is_line_[stars_.edge(cell.elem, side)] || grid_[beyond / 4] >= 0) return;
    constexpr std::array<int, 4> di{0, 1, 0, -1}, dj{-1, 0, 1, 0};
    grid_[beyond / 4] = grid_[cell.elem];
    // The common side is the neighbour's opposite one: its upper side if it lies below.
    cells.push_back({beyond / 4, (beyond % 4 + 2 - turn + 4) % 4, cell.i + di[turn], cell.j + dj[turn]});
  }

  bool is_line_at(int elem, int side) const { return is_line_[stars_.edge(elem, side)]; }

  /// A grid that closes on itself, a ring, has no corner: adds a line across each, between two blocks where it can.
  /// Returns whether there was a ring.
  bool cut_rings() {
    bool was_cut = false;
    for (const std::vector<GridCell>& cells : cells_) {
      int cut = -1;
      bool has_corner = false, is_between_blocks = false;
      for (const GridCell& cell : cells)
        for (int side = 0; side < 4; ++side) {
          if (!is_line_at(cell.elem, side)) continue;
          const int next = (side + 1) % 4, beyond = stars_.across(cell.elem, next);
          has_corner = has_corner || is_line_at(cell.elem, next);
          if (is_line_at(cell.elem, next)) continue;
          const bool is_between = mesh_.elem_block[beyond / 4] != mesh_.elem_block[cell.elem];
          if (cut < 0 || (is_between && !is_between_blocks))
            cut = stars_.edge(cell.elem, next), is_between_blocks = is_between;
        }
      if (has_corner || cut < 0) continue;
      add_line(cut);
      was_cut = true;
    }
    return was_cut;
  }

  void add_line(int edge) {
    is_line_[edge] = true;
    repair({stars_.ends(edge)[0], stars_.ends(edge)[1]});
  }

  /// Cuts each grid that is its own neighbour between the two cells.
  bool cut_where_touching() {
    bool was_cut = false;
    for (const std::vector<GridCell>& cells : cells_) {
      std::map<int, const GridCell*> cell_of;
      for (const GridCell& cell : cells) cell_of[cell.elem] = &cell;
      std::array<std::vector<std::array<int, 2>>, 2> intervals;
      for (const GridCell& cell : cells)
        for (int side = 0; side < 4; ++side) {
          const int beyond = stars_.across(cell.elem, side);
          if (!is_line_at(cell.elem, side) || beyond < 0 || grid_[beyond / 4] != grid_[cell.elem]) continue;
          const GridCell& other = *cell_of.at(beyond / 4);
          const auto [low_i, high_i] = std::minmax(cell.i, other.i);
          const auto [low_j, high_j] = std::minmax(cell.j, other.j);
          if (low_i < high_i)
            intervals[0].push_back({low_i + 1, high_i});
          else
            intervals[1].push_back({low_j + 1, high_j});
        }
      for (const int cut : stabbing(intervals[0])) cut_before(cells, true, cut);
      for (const int cut : stabbing(intervals[1])) cut_before(cells, false, cut);
      was_cut = was_cut || !intervals[0].empty() || !intervals[1].empty();
    }
    return was_cut;
  }

  /// The line before a column or row.
  void cut_before(const std::vector<GridCell>& cells, bool is_column, int number) {
    for (const GridCell& cell : cells)
      if ((is_column ? cell.i : cell.j) == number)
        is_line_[stars_.edge(cell.elem, (cell.below + (is_column ? 3 : 0)) % 4)] = true;
  }

  const QuadMesh& mesh_;
  VertexStars stars_;
  std::vector<std::array<int, 2>> block_class_;  ///< blocks of one class may be joined
  std::vector<bool> is_line_;                    ///< by edge
  std::vector<int> grid_;                        ///< by element
  std::vector<std::vector<GridCell>> cells_;     ///< by grid
};

}  // namespace

QuadMesh merge_blocks(QuadMesh mesh) {
  const std::vector<int> grids = BlockMerger(mesh).merged();
  std::vector<std::string> names;
  std::vector<int> regions;
  for (std::size_t elem = 0; elem < grids.size(); ++elem) {
    if (grids[elem] < static_cast<int>(names.size())) continue;
    const int block = mesh.elem_block[elem];
    const bool is_unnamed = std::binary_search(mesh.unnamed_blocks.begin(), mesh.unnamed_blocks.end(), block);
    names.push_back(is_unnamed ? "" : mesh.block_names[block]);
    if (!mesh.block_region.empty()) regions.push_back(mesh.block_region[block]);
  }
  mesh.elem_block = grids;
  mesh.unnamed_blocks = replace_empty_names(names, "block");
  mesh.block_names = std::move(names);
  mesh.block_region = std::move(regions);
  return mesh;
}

HexMesh merge_blocks(HexMesh mesh) {
  const std::vector<int> grids = BlockMerger(quads_of_layer(mesh)).merged();
  std::vector<int> regions;
  for (int quad = 0; quad < mesh.num_quads; ++quad)
    if (grids[quad] == static_cast<int>(regions.size())) regions.push_back(mesh.region_of(quad));
  mesh.quad_block = grids;
  mesh.block_region = std::move(regions);
  return mesh;
}

}  // namespace quadrille::exports
