#include "io/step_origin.hpp"

#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "io/describe.hpp"

namespace quadrille::io {
namespace {

constexpr std::string_view begin_of_list = "FILE_DESCRIPTION((";
constexpr std::string_view mark = "Quadrille provenance";

/// The next string in quotes, in which two quotes or backslashes stand for one; nothing if another character comes
/// first.
std::optional<std::string> next_string(std::string_view& text) {
  if (!text.starts_with('\'')) return std::nullopt;
  std::string out;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '\'' && !text.substr(i + 1).starts_with('\'')) {
      text.remove_prefix(i + 1);
      return out;
    }
    if (text[i] == '\'' || (text[i] == '\\' && text.substr(i + 1).starts_with('\\'))) ++i;
    out += text[i];
  }
  return std::nullopt;
}

/// The strings of the list, joined, but for the mark; empty if the list does not begin with it.
std::string described_provenance(const std::string& bytes) {
  const std::size_t at = bytes.find(begin_of_list);
  if (at == std::string::npos) return {};
  std::string_view text = std::string_view(bytes).substr(at + begin_of_list.size());
  if (next_string(text) != mark) return {};
  std::string joined;
  while (text.starts_with(',')) {
    while (!text.empty() && (text.front() == ',' || text.front() == '\n')) text.remove_prefix(1);
    const std::optional<std::string> part = next_string(text);
    if (!part) return {};
    joined += *part;
  }
  return joined;
}

}  // namespace

Provenance step_origin(const std::string& bytes) {
  const std::string text = described_provenance(bytes);
  if (text.empty()) return {};
  try {
    Provenance provenance = parse_provenance(text, "STEP file");
    if (provenance.size() == 1 && converts_shapes(provenance[0].tool)) return provenance;
  } catch (const FormatError&) {  // somebody wrote it by hand: how the file was made is unknown
  }
  return {};
}

}  // namespace quadrille::io
