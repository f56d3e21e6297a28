#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/netcdf_request.hpp"
#include "export/renode.hpp"
#include "export/serendipity.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// Names in the file have at most this many characters.
constexpr std::size_t longest_exodus_name = 32;

/// Elements of one type; nodes count from 1.
struct ExodusBlock {
  std::string name, type;
  int nodes_per_elem = 0;
  std::vector<std::int32_t> nodes;
};

/// Sides of elements, which count block by block from 1, as sides do.
struct ExodusSideSet {
  std::string name;
  std::vector<std::int32_t> elems, sides;
};

struct ExodusModel {
  std::string title;
  std::vector<std::vector<double>> x;  ///< by coordinate: two or three
  std::vector<ExodusBlock> blocks;     ///< none of them empty
  std::vector<ExodusSideSet> side_sets;
};

constexpr float exodus_version = 8.03F;

/// Names as rows of 33 characters, filled with zeros.
std::string name_rows(const std::vector<std::string>& names) {
  std::string rows;
  for (const std::string& name : names) rows += name + std::string(longest_exodus_name + 1 - name.size(), '\0');
  return rows;
}

std::vector<std::int32_t> counted_up(std::size_t count) {
  std::vector<std::int32_t> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = static_cast<std::int32_t>(k) + 1;
  return numbers;
}

template <typename Part>
std::vector<std::string> names_of(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

class ExodusFile {
 public:
  NetcdfRequest request(ExodusModel&& model) {
    write_globals(model);
    write_coordinates(model);
    write_blocks(model.blocks);
    if (!model.side_sets.empty()) write_side_sets(model.side_sets);
    return std::move(file_);
  }

 private:
  void write_globals(const ExodusModel& model) {
    file_.attributes = {{"api_version", std::vector<float>{exodus_version}},
                        {"version", std::vector<float>{exodus_version}},
                        {"floating_point_word_size", std::vector<std::int32_t>{8}},
                        {"file_size", std::vector<std::int32_t>{1}},
                        {"maximum_name_length", std::vector<std::int32_t>{longest_exodus_name}},
                        {"int64_status", std::vector<std::int32_t>{0}},
                        {"title", model.title}};
    name_length_ = file_.add_dimension("len_name", longest_exodus_name + 1);
    const int time = file_.add_dimension("time_step", 0);
    add("time_whole", {time}, std::vector<double>{});
  }

  void write_coordinates(ExodusModel& model) {
    const int space = file_.add_dimension("num_dim", model.x.size());
    const int nodes = file_.add_dimension("num_nodes", model.x[0].size());
    std::size_t num_elems = 0;
    for (const ExodusBlock& block : model.blocks) num_elems += block.nodes.size() / block.nodes_per_elem;
    file_.add_dimension("num_elem", num_elems);
    std::vector<std::string> names;
    for (std::size_t c = 0; c < model.x.size(); ++c) {
      names.emplace_back(1, static_cast<char>('x' + c));
      add("coord" + names.back(), {nodes}, std::move(model.x[c]));
    }
    add("coor_names", {space, name_length_}, name_rows(names));
  }

  void write_blocks(std::vector<ExodusBlock>& blocks) {
    const int count = file_.add_dimension("num_el_blk", blocks.size());
    add("eb_status", {count}, std::vector<std::int32_t>(blocks.size(), 1));
    add("eb_prop1", {count}, counted_up(blocks.size()), {{"name", std::string("ID")}});
    add("eb_names", {count, name_length_}, name_rows(names_of(blocks)));
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const std::string number = std::to_string(b + 1);
      const int elems =
          file_.add_dimension("num_el_in_blk" + number, blocks[b].nodes.size() / blocks[b].nodes_per_elem);
      const int size = file_.add_dimension("num_nod_per_el" + number, blocks[b].nodes_per_elem);
      add("connect" + number, {elems, size}, std::move(blocks[b].nodes), {{"elem_type", blocks[b].type}});
    }
  }

  /// An empty set has a name, and no more.
  void write_side_sets(std::vector<ExodusSideSet>& sets) {
    const int count = file_.add_dimension("num_side_sets", sets.size());
    add("ss_prop1", {count}, counted_up(sets.size()), {{"name", std::string("ID")}});
    add("ss_names", {count, name_length_}, name_rows(names_of(sets)));
    std::vector<std::int32_t> status;
    for (std::size_t s = 0; s < sets.size(); ++s) {
      status.push_back(sets[s].elems.empty() ? 0 : 1);
      if (sets[s].elems.empty()) continue;
      const std::string number = std::to_string(s + 1);
      const int size = file_.add_dimension("num_side_ss" + number, sets[s].elems.size());
      add("elem_ss" + number, {size}, std::move(sets[s].elems));
      add("side_ss" + number, {size}, std::move(sets[s].sides));
    }
    add("ss_status", {count}, std::move(status));
  }

  void add(std::string name, std::vector<std::int32_t> dimensions, NetcdfValues values,
           std::vector<NetcdfAttribute> attributes = {}) {
    file_.variables.push_back({std::move(name), std::move(dimensions), std::move(values), std::move(attributes)});
  }

  NetcdfRequest file_;
  int name_length_ = 0;
};

/// Elements of order 2 with all nodes, or with those on edges alone.
enum class ExodusNodes { all, on_edges };

/// The places of the nodes among those of an element of order 1 or 2. Of a quad: corners, middles of the sides after
/// them, the middle; of a hexahedron: corners, middles of the edges below, upright and above, the middle of the
/// element, middles of the faces: below, above, then low and high first and second coordinate.
std::vector<int> exodus_places(const QuadMesh& mesh) {
  if (mesh.order == 1) return {0, 1, 3, 2};
  return {0, 2, 8, 6, 1, 5, 7, 3, 4};
}
std::vector<int> exodus_places(const HexMesh& mesh) {
  if (mesh.order == 1) return {0, 1, 3, 2, 4, 5, 7, 6};
  return {0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 9, 11, 17, 15, 19, 23, 25, 21, 13, 4, 22, 12, 14, 10, 16};
}

template <typename Mesh>
class ExodusParts {
 public:
  /// `groups` with interfaces as boundaries.
  ExodusParts(const Mesh& mesh, const Groups& groups, ExodusNodes nodes)
      : mesh_(mesh), groups_(groups), places_(exodus_places(mesh)) {
    if (nodes == ExodusNodes::on_edges) {
      node2number_ = serendipity_numbers(mesh);
    } else {
      node2number_.resize(mesh.nodes.size());
      std::iota(node2number_.begin(), node2number_.end(), 1);
    }
  }

  ExodusModel model(const std::vector<std::array<double, 3>>& positions, const PlainNames& words) {
    model_.title =
        (mesh_dimension<Mesh> == 2 ? "quadrilaterals of order " : "hexahedra of order ") + std::to_string(mesh_.order);
    model_.x.resize(mesh_dimension<Mesh>);
    for (std::size_t node = 0; node < positions.size(); ++node)
      for (std::size_t c = 0; c < model_.x.size() && node2number_[node] > 0; ++c)
        model_.x[c].push_back(positions[node][c]);
    add_blocks(words.regions);
    for (const std::string& name : words.boundaries) model_.side_sets.push_back({name, {}, {}});
    for (const GroupSide& at : group_sides(mesh_, groups_)) {
      ExodusSideSet& set = model_.side_sets[at.group];
      set.elems.push_back(elem2number_[at.elem]), set.sides.push_back(at.side + 1);
    }
    return std::move(model_);
  }

 private:
  /// Elements by region, numbered block by block from 1.
  void add_blocks(const NameList& names) {
    elem2number_.resize(mesh_.num_elems());
    std::int32_t next = 0;
    const std::vector<std::vector<int>> elems = elements_by_region(mesh_, groups_);
    for (std::size_t b = 0; b < names.size(); ++b) {
      if (elems[b].empty()) continue;
      ExodusBlock block{names[b], mesh_dimension<Mesh> == 2 ? "QUAD" : "HEX", 0, {}};
      for (const int elem : elems[b]) {
        add_nodes(elem, block);
        elem2number_[elem] = ++next;
      }
      block.nodes_per_elem = static_cast<int>(block.nodes.size() / elems[b].size());
      block.type += std::to_string(block.nodes_per_elem);
      model_.blocks.push_back(std::move(block));
    }
  }

  void add_nodes(int elem, ExodusBlock& block) const {
    for (const int local : places_)
      if (const int number = node2number_[element_nodes(mesh_, elem)[local]]; number > 0) block.nodes.push_back(number);
  }

  const Mesh& mesh_;
  const Groups& groups_;
  std::vector<int> places_;
  std::vector<int> node2number_;           ///< by mesh node, from 1; 0: it is not written
  std::vector<std::int32_t> elem2number_;  ///< by element
  ExodusModel model_;
};

template <typename Mesh>
void write_exodus(const Mesh& mesh, const std::vector<std::array<double, 3>>& positions, ExodusNodes nodes,
                  Exported& exported) {
  exported.is_binary = true;
  if (nodes == ExodusNodes::on_edges) exported.add_loss(serendipity_loss(mesh, "Exodus"));
  if constexpr (mesh_dimension<Mesh> == 3) exported.add_loss(periodic_loss(mesh));
  const Groups groups = lines_as_boundaries(mesh_groups(mesh));
  const PlainNames words = add_plain_names(groups, true, {{}, longest_exodus_name, false}, exported);
  ExodusModel model = ExodusParts(mesh, groups, nodes).model(positions, words);
  exported.bytes = to_bytes(ExodusFile().request(std::move(model)));
}

Exported exodus_of(const QuadMesh& mesh, const Frame& frame, ExodusNodes nodes) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Elements of Exodus");
  Exported exported;
  exported.add_loss(split_loss(mesh, quads));
  write_exodus(quads, positions(quads, frame, ElementPoints::nodes), nodes, exported);
  return exported;
}

/// Faces have the numbers of HexMesh: the sides of the quad, bottom, top.
Exported exodus_of(const HexMesh& mesh, ExodusNodes nodes) {
  Exported exported;
  write_exodus(mesh, positions(mesh, ElementPoints::nodes), nodes, exported);
  return exported;
}

}  // namespace

Exported exodus(const QuadMesh& mesh, const Frame& frame) { return exodus_of(mesh, frame, ExodusNodes::all); }
Exported exodus(const HexMesh& mesh) { return exodus_of(mesh, ExodusNodes::all); }

Exported exodus_serendipity(const QuadMesh& mesh, const Frame& frame) {
  return exodus_of(mesh, frame, ExodusNodes::on_edges);
}
Exported exodus_serendipity(const HexMesh& mesh) { return exodus_of(mesh, ExodusNodes::on_edges); }

}  // namespace quadrille::exports
