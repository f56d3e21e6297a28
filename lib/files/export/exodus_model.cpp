#include "export/exodus_model.hpp"

#include <utility>

namespace quadrille::exports {
namespace {

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

}  // namespace

NetcdfRequest exodus_request(ExodusModel model) { return ExodusFile().request(std::move(model)); }

}  // namespace quadrille::exports
