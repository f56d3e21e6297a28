#include "base/name_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace quadrille {

namespace {

int byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// C0 and DEL are one byte, C1 is C2 80 to C2 9F.
bool is_control(std::string_view text, int length) {
  const int first = byte(text, 0);
  return (length == 1 && (first < 0x20 || first == 0x7F)) || (length == 2 && first == 0xC2 && byte(text, 1) < 0xA0);
}

/// Bytes of the first character of `text`, which is not empty; a byte that is not UTF-8 is a character.
std::size_t character_length(std::string_view text) { return static_cast<std::size_t>(std::max(1, utf8_length(text))); }

constexpr std::size_t least_beginning = 5;

/// Edit distance in which the exchange of two neighbours is one error.
std::size_t num_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + wrong});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::size_t num_errors_or_beginning(const std::string& word, const std::string& other) {
  const std::size_t errors = num_errors(word, other);
  return word.size() >= least_beginning && other.starts_with(word) ? std::min<std::size_t>(errors, 1) : errors;
}

}  // namespace

int utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const int first = byte(text, 0);
  if (first < 0x80) return 1;
  const int length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length == 0 || text.size() < static_cast<std::size_t>(length)) return 0;
  for (int i = 1; i < length; ++i)
    if ((byte(text, i) & 0xC0) != 0x80) return 0;
  // Rejects overlong forms, surrogates and code points above U+10FFFF.
  const int second = byte(text, 1);
  const bool is_wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return is_wrong ? 0 : length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const int length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(static_cast<std::size_t>(length));
  }
  return true;
}

std::string utf8_or_latin1(const std::string& text) {
  if (is_utf8(text)) return text;
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const int code = static_cast<unsigned char>(c);
    if (code >= 0x80) result += static_cast<char>(0xC0 | code >> 6);
    result += code < 0x80 ? c : static_cast<char>(0x80 | (code & 0x3F));
  }
  return result;
}

std::string printable_text(std::string_view text) {
  std::string printable;
  while (!text.empty()) {
    const int length = utf8_length(text);
    const std::string_view character = text.substr(0, static_cast<std::size_t>(std::max(length, 1)));
    const bool is_kept = character == "\n" || (length > 0 && !is_control(text, length));
    printable += is_kept ? character : "\xEF\xBF\xBD";
    text.remove_prefix(character.size());
  }
  return printable;
}

std::string clean_name(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const int length = utf8_length(text);
    if (length == 0)
      name += "\xEF\xBF\xBD";
    else if (is_control(text, length))
      name += ' ';
    else
      name += text.substr(0, static_cast<std::size_t>(length));
    text.remove_prefix(static_cast<std::size_t>(std::max(length, 1)));
  }
  const std::size_t first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
  return first == std::string::npos ? std::string() : name.substr(first, last - first + 1);
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts{""};
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (c == ',' && depth <= 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

bool matches_wildcard(std::string_view text, std::string_view pattern) {
  std::size_t t = 0, p = 0;
  std::size_t star = std::string_view::npos, resume = 0;  // the last star, and the text behind what it has taken
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++, resume = t;
    } else if (p < pattern.size() && pattern[p] == '?') {
      t += character_length(text.substr(t)), ++p;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++t, ++p;
    } else if (star != std::string_view::npos) {
      resume += character_length(text.substr(resume));  // the star takes one character more
      t = resume, p = star + 1;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t fewest = (word.size() + 2) / 4 + 1;
  for (const std::string& other : words) {
    const std::size_t errors = num_errors_or_beginning(word, other);
    if (errors >= fewest) continue;
    fewest = errors;
    nearest = other;
  }
  return nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& words) {
  const std::string nearest = nearest_word(word, words);
  return nearest.empty() ? std::string() : " (did you mean " + nearest + "?)";
}

std::vector<int> assign_names(std::vector<std::string>& names, const std::vector<GivenName>& given,
                              const std::string& kind) {
  std::vector<const GivenName*> by_target(names.size(), nullptr);
  std::vector<const GivenName*> rest(names.size(), nullptr);
  const auto claim = [](const GivenName*& owner, const GivenName& claimant, const std::string& what) {
    if (owner != nullptr)
      throw FormatError(fmt::format("{} names {}, as {} does: \"{}\" or \"{}\"?", claimant.where, what, owner->where,
                                    claimant.name, owner->name));
    owner = &claimant;
  };
  for (const GivenName& g : given) {
    for (const int target : g.targets)
      if (g.is_for_rest)
        claim(rest[target], g, fmt::format("every other {}", kind));
      else
        claim(by_target[target], g, fmt::format("{} {}", kind, target));
  }
  std::vector<int> named;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const GivenName* owner = by_target[i] != nullptr ? by_target[i] : rest[i]) {
      names[i] = owner->name;
      named.push_back(static_cast<int>(i));
    }
  return named;
}

namespace {

using NameCounts = std::map<std::string, int>;

NameCounts counts_of(const std::vector<std::string>& names) {
  NameCounts counts;
  for (const std::string& name : names) ++counts[name];
  return counts;
}

std::string numbered_name(const std::string& kind, std::size_t number, const NameCounts& taken) {
  const auto is_taken = [&](const std::string& name) {
    const auto entry = taken.find(name);
    return entry != taken.end() && entry->second > 0;
  };
  std::string name = fmt::format("{}_{}", kind, number);
  while (is_taken(name)) name += "_";
  return name;
}

}  // namespace

std::vector<int> replace_empty_names(std::vector<std::string>& names, const std::string& kind) {
  const NameCounts given = counts_of(names);
  std::vector<int> replaced;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) continue;
    names[i] = numbered_name(kind, i, given);
    replaced.push_back(static_cast<int>(i));
  }
  return replaced;
}

std::vector<int> presumed_numbered_names(const std::vector<std::string>& names, const std::string& kind) {
  NameCounts others = counts_of(names);
  std::vector<int> presumed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    --others[names[i]];
    if (names[i] == numbered_name(kind, i, others)) presumed.push_back(static_cast<int>(i));
    ++others[names[i]];
  }
  return presumed;
}

}  // namespace quadrille
