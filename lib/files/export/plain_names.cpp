#include "export/plain_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "export/names_table.hpp"

namespace quadrille::exports {
namespace {

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

}  // namespace

std::vector<std::string> plain_names(const std::vector<std::string>& names, const std::vector<std::string>& taken) {
  std::set<std::string> used(taken.begin(), taken.end());
  std::vector<std::string> words(names.size());
  for (const bool as_it_is : {true, false})  // names that need no change take precedence
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string word = plain(names[k]);
      if (!words[k].empty() || (as_it_is && (word != names[k] || used.count(word) > 0))) continue;
      used.insert(words[k] = numbered(word, used));
    }
  return words;
}

std::string renamed_loss(const std::vector<std::string>& names, const std::vector<std::string>& plain) {
  constexpr int num_told = 3;
  int count = 0;
  std::string list;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == plain[k]) continue;
    if (++count <= num_told) list += fmt::format("{}\"{}\" as {}", count == 1 ? "" : ", ", names[k], plain[k]);
  }
  if (count == 0) return {};
  return fmt::format("{} written in plain letters: {}{}", count == 1 ? "1 name is" : fmt::format("{} names are", count),
                     list, count > num_told ? ", ..." : "");
}

SideFile plain_names_table(const Groups& groups, const std::vector<std::string>& boundaries,
                           const std::vector<std::string>& zones) {
  const auto listed = [](const std::vector<std::string>& names, const std::vector<std::string>& words) {
    std::vector<NamedGroup> list;
    for (std::size_t k = 0; k < names.size(); ++k)
      list.push_back({static_cast<int>(k) + 1, names[k], words[k] == names[k] ? "" : words[k]});
    return list;
  };
  return names_table(listed(groups.boundary_names, boundaries),
                     zones.empty() ? std::vector<NamedGroup>{} : listed(groups.region_names, zones));
}

std::string interface_loss(const Groups& groups) {
  constexpr int num_told = 3;
  const int count = groups.num_interfaces();
  if (count == 0) return {};
  std::string list;
  for (int k = 0; k < std::min(count, num_told); ++k)
    list += fmt::format("{}\"{}\"", k == 0 ? "" : ", ", groups.interface_names[k]);
  return fmt::format("{} not stored: {}{}", count == 1 ? "1 interface is" : fmt::format("{} interfaces are", count),
                     list, count > num_told ? ", ..." : "");
}

std::string region_loss(const Groups& groups) {
  const auto count = std::count(groups.is_region_named.begin(), groups.is_region_named.end(), true);
  if (count == 0 || groups.num_regions() == 1) return {};
  return fmt::format("{} not stored", count == 1 ? "1 region name is" : fmt::format("{} region names are", count));
}

}  // namespace quadrille::exports
