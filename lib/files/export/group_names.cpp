#include "export/group_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/counted.hpp"
#include "base/json_string.hpp"

namespace quadrille::exports {

namespace {

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

std::string numbered(const std::string& name, const std::set<std::string>& used) {
  std::string free = name;
  for (int k = 2; used.count(free) > 0; ++k) free = fmt::format("{}_{}", name, k);
  return free;
}

/// "1 name is", "2 names are".
std::string some_are(std::integral auto count, const std::string& noun) {
  return counted(count, noun) + (count == 1 ? " is" : " are");
}

constexpr int num_told = 3;
const char* dots(int count) { return count > num_told ? ", ..." : ""; }

}  // namespace

SideFile names_table(const Groups& groups, const NameList& boundaries, const NameList& regions, bool with_interfaces) {
  const NameList& inner = groups.interface_names;
  const std::string between =
      with_interfaces && !inner.empty()
          ? fmt::format("  \"interfaces\": {},\n", listed(inner, inner, 1 + groups.num_boundaries()))
          : "";
  return {".names.json",
          fmt::format("{{\n  \"boundaries\": {},\n{}  \"regions\": {}\n}}\n", listed(groups.boundary_names, boundaries),
                      between, regions.empty() ? "[]" : listed(groups.region_names, regions)),
          false, true};
}

NameList plain_names(const NameList& names, const NameList& taken) {
  std::set<std::string> used(taken.begin(), taken.end());
  NameList words(names.size());
  for (const bool as_it_is : {true, false})  // names that need no change take precedence
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string word = plain(names[k]);
      if (!words[k].empty() || (as_it_is && (word != names[k] || used.count(word) > 0))) continue;
      used.insert(words[k] = numbered(word, used));
    }
  return words;
}

std::string renamed_loss(const NameList& names, const NameList& plain) {
  int count = 0;
  std::string list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == plain[k]) continue;
    if (++count <= num_told) list += fmt::format("{}\"{}\" as {}", count == 1 ? "" : ", ", names[k], plain[k]);
  }
  if (count == 0) return {};
  return fmt::format("{} written in plain letters: {}{}", some_are(count, "name"), list, dots(count));
}

PlainNames add_plain_names(const Groups& groups, bool with_regions, const NameList& taken, Exported& exported) {
  PlainNames plain{plain_names(groups.boundary_names, taken), {}};
  if (with_regions) plain.regions = plain_names(groups.region_names);
  const std::string boundary_loss = renamed_loss(groups.boundary_names, plain.boundaries);
  const std::string region_loss = with_regions ? renamed_loss(groups.region_names, plain.regions) : "";
  exported.add_loss(boundary_loss);
  exported.add_loss(region_loss);
  if (!boundary_loss.empty() || !region_loss.empty())
    exported.side_files.push_back(names_table(groups, plain.boundaries, plain.regions));
  return plain;
}

std::string interface_loss(const Groups& groups) {
  const int count = groups.num_interfaces();
  if (count == 0) return {};
  std::string list;
  for (int k = 0; k < std::min(count, num_told); ++k)
    list += fmt::format("{}\"{}\"", k == 0 ? "" : ", ", groups.interface_names[k]);
  return fmt::format("{} not stored: {}{}", some_are(count, "interface"), list, dots(count));
}

std::string region_loss(const Groups& groups) {
  const auto count = std::count(groups.is_region_named.begin(), groups.is_region_named.end(), true);
  if (count == 0 || groups.num_regions() == 1) return {};
  return some_are(count, "region name") + " not stored";
}

}  // namespace quadrille::exports
