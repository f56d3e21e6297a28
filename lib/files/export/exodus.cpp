#include <array>
#include <string>

#include "export/groups.hpp"
#include "export/netcdf.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

constexpr std::size_t longest_exodus_name = 32;
constexpr float exodus_version = 8.03F;

/// Names as rows of 33 characters, filled with zeros.
std::string name_rows(const NameList& names) {
  std::string rows;
  for (const std::string& name : names) rows += name + std::string(longest_exodus_name + 1 - name.size(), '\0');
  return rows;
}

std::vector<std::int32_t> counted_up(std::size_t count) {
  std::vector<std::int32_t> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = static_cast<std::int32_t>(k) + 1;
  return numbers;
}

class ExodusWriter {
 public:
  ExodusWriter(const QuadMesh& quads, const Frame& frame, const Groups& lines)
      : quads_(quads), frame_(frame), lines_(lines), numbers_(quads.num_elems()) {}

  std::string bytes(const PlainNames& words) {
    write_globals();
    write_coordinates();
    write_blocks(words.regions);
    write_side_sets(words.boundaries);
    return file_.bytes();
  }

 private:
  void write_globals() {
    file_.attribute("api_version", std::vector<float>{exodus_version});
    file_.attribute("version", std::vector<float>{exodus_version});
    file_.attribute("floating_point_word_size", std::vector<std::int32_t>{8});
    file_.attribute("file_size", std::vector<std::int32_t>{1});
    file_.attribute("maximum_name_length", std::vector<std::int32_t>{longest_exodus_name});
    file_.attribute("int64_status", std::vector<std::int32_t>{0});
    file_.attribute("title", std::string("quadrilaterals of order ") + std::to_string(quads_.order));
    name_length_ = file_.dimension("len_name", longest_exodus_name + 1);
    const int time = file_.dimension("time_step", 0);
    file_.variable("time_whole", {time}, std::vector<double>{});
  }

  void write_coordinates() {
    const int space = file_.dimension("num_dim", 2), nodes = file_.dimension("num_nodes", quads_.nodes.size());
    file_.dimension("num_elem", quads_.num_elems());
    std::array<std::vector<double>, 2> x;
    for (const Vec2 node : quads_.nodes)
      for (int c = 0; c < 2; ++c) x[c].push_back(frame_.at(node)[c]);
    file_.variable("coordx", {nodes}, std::move(x[0]));
    file_.variable("coordy", {nodes}, std::move(x[1]));
    file_.variable("coor_names", {space, name_length_}, name_rows({"x", "y"}));
  }

  /// Corners, middles of the sides after them, middle of the element.
  std::vector<std::int32_t> element(int elem) const {
    std::vector<std::int32_t> nodes;
    for (int k = 0; k < quads_.order; ++k)
      for (int side = 0; side < 4; ++side) nodes.push_back(side_node(quads_, elem, side, k) + 1);
    if (quads_.order == 2) nodes.push_back(quads_.elem_nodes[elem * 9 + 4] + 1);
    return nodes;
  }

  void write_blocks(const NameList& names) {
    const int count = file_.dimension("num_el_blk", names.size());
    file_.variable("eb_status", {count}, std::vector<std::int32_t>(names.size(), 1));
    file_.variable("eb_prop1", {count}, counted_up(names.size()), {{"name", std::string("ID")}});
    file_.variable("eb_names", {count, name_length_}, name_rows(names));
    std::int32_t next = 0;
    for (std::size_t block = 0; block < names.size(); ++block) {
      std::vector<std::int32_t> nodes;
      const std::int32_t first = next;
      for (int elem = 0; elem < quads_.num_elems(); ++elem) {
        if (lines_.block2region[quads_.elem_block[elem]] != static_cast<int>(block)) continue;
        numbers_[elem] = ++next;
        const std::vector<std::int32_t> own = element(elem);
        nodes.insert(nodes.end(), own.begin(), own.end());
      }
      const std::string number = std::to_string(block + 1);
      const int elems = file_.dimension("num_el_in_blk" + number, next - first);
      const int size = file_.dimension("num_nod_per_el" + number, quads_.order == 1 ? 4 : 9);
      file_.variable("connect" + number, {elems, size}, std::move(nodes),
                     {{"elem_type", std::string(quads_.order == 1 ? "QUAD4" : "QUAD9")}});
    }
  }

  void write_side_sets(const NameList& names) {
    if (names.empty()) return;
    const int count = file_.dimension("num_side_sets", names.size());
    file_.variable("ss_prop1", {count}, counted_up(names.size()), {{"name", std::string("ID")}});
    file_.variable("ss_names", {count, name_length_}, name_rows(names));
    std::vector<std::int32_t> status;
    std::vector<QuadBoundaryEdge> edges = quads_.boundary_edges;
    const std::vector<QuadBoundaryEdge> inner = interface_edges_once(quads_);
    edges.insert(edges.end(), inner.begin(), inner.end());
    for (std::size_t set = 0; set < names.size(); ++set) {
      std::vector<std::int32_t> elems, sides;
      for (const QuadBoundaryEdge& e : edges) {
        if (lines_.curve2boundary[e.curve] != static_cast<int>(set)) continue;
        elems.push_back(numbers_[e.elem]);
        sides.push_back(e.side + 1);
      }
      status.push_back(elems.empty() ? 0 : 1);
      if (elems.empty()) continue;
      const std::string number = std::to_string(set + 1);
      const int size = file_.dimension("num_side_ss" + number, elems.size());
      file_.variable("elem_ss" + number, {size}, std::move(elems));
      file_.variable("side_ss" + number, {size}, std::move(sides));
    }
    file_.variable("ss_status", {count}, std::move(status));
  }

  const QuadMesh& quads_;
  const Frame& frame_;
  const Groups& lines_;
  std::vector<std::int32_t> numbers_;  ///< of the elements in the file, block by block, from 1
  NetcdfFile file_;
  int name_length_ = 0;
};

}  // namespace

Exported exodus(const QuadMesh& mesh, const Frame& frame) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Elements of Exodus");
  const Groups lines = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(split_loss(mesh, quads));
  const PlainNames words = add_plain_names(lines, true, {{}, longest_exodus_name, false}, exported);
  exported.bytes = ExodusWriter(quads, frame, lines).bytes(words);
  return exported;
}

}  // namespace quadrille::exports
