#include "export/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/message_text.hpp"
#include "base/name_text.hpp"

namespace quadrille::exports {

namespace {

/// The number of each name in `distinct`, which grows by the names that are new.
std::vector<int> number(const std::vector<std::string>& names, std::vector<std::string>& distinct) {
  std::map<std::string, int> known;
  std::vector<int> numbers;
  for (const std::string& name : names) {
    const auto [entry, is_new] = known.try_emplace(name, static_cast<int>(distinct.size()));
    if (is_new) distinct.push_back(name);
    numbers.push_back(entry->second);
  }
  return numbers;
}

/// Those on the boundary first.
void number_curves(const std::vector<std::string>& names, const std::vector<bool>& is_inner, Groups& groups) {
  std::vector<std::string> boundaries, inner, all;
  for (std::size_t c = 0; c < names.size(); ++c) (is_inner[c] ? inner : boundaries).push_back(names[c]);
  number(boundaries, groups.boundary_names);
  number(inner, groups.inner_names);
  boundaries = groups.boundary_names;
  boundaries.insert(boundaries.end(), names.begin(), names.end());
  const std::vector<int> numbers = number(boundaries, all);
  groups.curve2boundary.assign(numbers.begin() + groups.num_boundaries(), numbers.end());
  groups.interface_names.assign(all.begin() + groups.num_boundaries(), all.end());
}

/// By curve. A short one may have none: it lies inside an edge, which has the name of one of its curves.
std::vector<bool> curves_with_edges(const QuadMesh& mesh) {
  std::vector<bool> has_edges(mesh.face.curves.size(), false);
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges) has_edges[edge.curve] = true;
  return has_edges;
}

std::string listed(const NameList& names, const NameList& words, int first = 1) {
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k) {
    out += fmt::format("{}    {{\"id\": {}, \"name\": {}", k == 0 ? "\n" : ",\n", first + static_cast<int>(k),
                       json_string(names[k]));
    if (words[k] != names[k]) out += fmt::format(", \"tag\": {}", json_string(words[k]));
    out += '}';
  }
  return out.empty() ? "[]" : fmt::format("[{}\n  ]", out);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_plain(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-'; }

bool continues_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }  // UTF-8

std::string plain(const std::string& name) {
  std::string word;
  for (const char c : name)
    if (!continues_letter(c)) word += is_plain(c) ? c : '_';
  return word.empty() || !is_letter(word[0]) ? "_" + word : word;
}

std::string cut(const std::string& word, std::size_t length, const WordRules& rules) {
  return rules.max_length > 0 && length > rules.max_length ? word.substr(0, word.size() + rules.max_length - length)
                                                           : word;
}

/// What distinguishes a word from others.
std::string key_of(std::string word, const WordRules& rules) {
  if (rules.is_case_ignored)
    for (char& c : word)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return word;
}

std::string numbered(const std::string& name, const std::set<std::string>& used, const WordRules& rules) {
  std::string free = cut(name, name.size(), rules);
  for (int k = 2; used.count(key_of(free, rules)) > 0; ++k) {
    const std::string number = fmt::format("_{}", k);
    free = cut(name, name.size() + number.size(), rules) + number;
  }
  return free;
}

/// "1 name is", "2 names are".
std::string some_are(std::integral auto count, const std::string& noun) {
  return counted(count, noun) + (count == 1 ? " is" : " are");
}

constexpr int num_told = 3;
const char* dots(int count) { return count > num_told ? ", ..." : ""; }

}  // namespace

std::vector<bool> inner_curves(const QuadMesh& mesh) {
  std::vector<bool> is_inner(mesh.face.curves.size(), false);
  for (const QuadBoundaryEdge& edge : mesh.interface_edges) is_inner[edge.curve] = true;
  return is_inner;
}

std::vector<QuadBoundaryEdge> interface_edges_once(const QuadMesh& mesh) {
  std::vector<QuadBoundaryEdge> edges = mesh.interface_edges;
  std::erase_if(edges, [&](const QuadBoundaryEdge& edge) {
    return mesh.face.is_interface(edge.curve) && edge.curve > mesh.face.partners[edge.curve];
  });
  return edges;
}

Groups mesh_groups(const QuadMesh& mesh) {
  const std::vector<bool> is_inner_curve = inner_curves(mesh), has_edges = curves_with_edges(mesh);
  std::vector<std::string> names;
  std::vector<bool> is_inner;
  std::vector<std::size_t> curves;
  for (std::size_t curve = 0; curve < mesh.face.curve_names.size(); ++curve) {
    if (!has_edges[curve]) continue;
    const std::string& given = mesh.face.curve_names[curve];
    names.push_back(given.empty() ? fmt::format("curve_{}", curve) : given);
    is_inner.push_back(is_inner_curve[curve]);
    curves.push_back(curve);
  }
  Groups groups;
  number_curves(names, is_inner, groups);
  std::vector<int> curve2boundary(mesh.face.curve_names.size(), -1);
  for (std::size_t k = 0; k < curves.size(); ++k) curve2boundary[curves[k]] = groups.curve2boundary[k];
  groups.curve2boundary = std::move(curve2boundary);
  groups.block2region = number(region_of_blocks(mesh), groups.region_names);
  groups.is_region_named.assign(groups.region_names.size(), false);
  for (std::size_t block = 0; block < groups.block2region.size(); ++block)
    if (!std::binary_search(mesh.unnamed_blocks.begin(), mesh.unnamed_blocks.end(), static_cast<int>(block)))
      groups.is_region_named[groups.block2region[block]] = true;
  return groups;
}

Groups mesh_groups(const HexMesh& mesh) {
  Groups groups;
  std::vector<std::string> names;
  std::vector<bool> is_inner;
  for (const HexFaceGroup& group : mesh.face_groups) {
    names.push_back(group.name);
    is_inner.push_back(group.is_interface);
  }
  number_curves(names, is_inner, groups);
  const std::vector<int> region_numbers = number(mesh.region_names, groups.region_names);
  for (const int region : mesh.block_region) groups.block2region.push_back(region_numbers[region]);
  groups.is_region_named.assign(groups.region_names.size(), true);
  return groups;
}

std::vector<std::string> boundary_and_interface_names(const Groups& groups) {
  std::vector<std::string> names = groups.boundary_names;
  names.insert(names.end(), groups.interface_names.begin(), groups.interface_names.end());
  return names;
}

Groups lines_as_boundaries(Groups groups) {
  groups.boundary_names = boundary_and_interface_names(groups);
  groups.interface_names.clear();
  return groups;
}

void separate_blocks(const CadFace& face, const std::vector<int>& block_region, std::vector<std::string>& block_names,
                     std::vector<int>& unnamed_blocks) {
  for (const int block : unnamed_blocks) block_names[block].clear();
  for (std::size_t block = 0; block < block_names.size(); ++block) {
    const std::string& common = block_region.empty() ? face.name : face.region_names[block_region[block]];
    if (block_names[block] == common) block_names[block].clear();
  }
  replace_empty_names(block_names, "block");
  unnamed_blocks.clear();
}

SideFile names_table(const Groups& groups, const NameList& boundaries, const NameList& regions, bool with_interfaces) {
  const NameList& inner = groups.interface_names;
  const std::string between =
      with_interfaces && !inner.empty()
          ? fmt::format("  \"interfaces\": {},\n", listed(inner, inner, 1 + groups.num_boundaries()))
          : "";
  return {names_table_name,
          fmt::format("{{\n  \"boundaries\": {},\n{}  \"regions\": {}\n}}\n", listed(groups.boundary_names, boundaries),
                      between, regions.empty() ? "[]" : listed(groups.region_names, regions))};
}

NameList plain_names(const NameList& names, const WordRules& rules) {
  std::set<std::string> used;
  for (const std::string& word : rules.taken) used.insert(key_of(word, rules));
  NameList words(names.size());
  for (const bool as_it_is : {true, false})  // names that need no change take precedence
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string word = plain(names[k]);
      const bool needs_change =
          word != names[k] || cut(word, word.size(), rules) != word || used.count(key_of(word, rules)) > 0;
      if (!words[k].empty() || (as_it_is && needs_change)) continue;
      words[k] = numbered(word, used, rules);
      used.insert(key_of(words[k], rules));
    }
  return words;
}

std::string renamed_loss(const NameList& names, const NameList& plain, const WordRules& rules) {
  int count = 0;
  std::string list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == plain[k]) continue;
    if (++count <= num_told) list += fmt::format("{}\"{}\" as {}", count == 1 ? "" : ", ", names[k], plain[k]);
  }
  if (count == 0) return {};
  const std::string limit = rules.max_length > 0 ? fmt::format("at most {} ", rules.max_length) : "";
  return fmt::format("{} written in {}plain letters: {}{}", some_are(count, "name"), limit, list, dots(count));
}

PlainNames add_plain_names(const Groups& groups, bool with_regions, const WordRules& rules, Exported& exported) {
  PlainNames plain{plain_names(groups.boundary_names, rules), {}};
  if (with_regions) plain.regions = plain_names(groups.region_names, rules);
  const std::string boundary_loss = renamed_loss(groups.boundary_names, plain.boundaries, rules);
  const std::string region_loss = with_regions ? renamed_loss(groups.region_names, plain.regions, rules) : "";
  exported.add_loss(boundary_loss);
  exported.add_loss(region_loss);
  if (!boundary_loss.empty() || !region_loss.empty())
    exported.side_files.push_back(names_table(groups, plain.boundaries, plain.regions));
  return plain;
}

std::string interface_loss(const Groups& groups) {
  const int count = static_cast<int>(groups.inner_names.size());
  if (count == 0) return {};
  std::string list;
  for (int k = 0; k < std::min(count, num_told); ++k)
    list += fmt::format("{}\"{}\"", k == 0 ? "" : ", ", groups.inner_names[k]);
  return fmt::format("{} not stored: {}{}", some_are(count, "interface"), list, dots(count));
}

std::string region_loss(const Groups& groups) {
  const auto count = std::count(groups.is_region_named.begin(), groups.is_region_named.end(), true);
  if (count == 0 || groups.num_regions() == 1) return {};
  return some_are(count, "region name") + " not stored";
}

}  // namespace quadrille::exports
