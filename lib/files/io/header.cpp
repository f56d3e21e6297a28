#include "io/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "io/json_archive.hpp"

namespace quadrille::io {

std::string producer_of(const Provenance& provenance) {
  return provenance.empty() ? "Quadrille" : provenance.back().tool + ' ' + provenance.back().version;
}

void require_version(const std::string& file_name, const StageFormat& expected, const std::string& format,
                     const std::vector<int>& version) {
  if (format != expected.name)
    throw FormatError(
        fmt::format("{}: expected a {} file, found {}", file_name, expected.name,
                    format.empty() ? "a file without a format" : fmt::format("a {} file", clean_name(format))));
  if (version.size() != 2 || version[0] < 0 || version[1] < 0)
    throw FormatError(fmt::format("{}: 'version' must be [major, minor]", file_name));
  if (version[0] > expected.major)
    throw FormatError(fmt::format("{}: {} version {}.{} is newer than this program, which reads version {}; update it",
                                  file_name, format, version[0], version[1], expected.major));
  if (version[0] < expected.major)
    throw FormatError(
        fmt::format("{}: {} version {}.{} is from an older program and no longer read (this one reads version {}); "
                    "create the file again",
                    file_name, format, version[0], version[1], expected.major));
}

namespace {

bool is_plain(const std::string& word) {
  return std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("+-._").find(c) != std::string_view::npos;
  });
}

/// What becomes words of commands (stagecheck --history) and names of files: names of tools, options and formats.
void require_plain_words(Archive& archive, const ProvenanceStep& step) {
  std::vector<std::string> words{step.tool, step.version};
  for (const InputDigest& input : step.inputs) words.insert(words.end(), {input.format, input.sha256});
  const nlohmann::json options = nlohmann::json::parse(step.options, nullptr, false);
  if (options.is_object())
    for (const auto& [name, value] : options.items()) words.push_back(name);
  for (const std::string& word : words)
    if (!is_plain(word))
      archive.fail("tool", fmt::format("must be made, like the names of its options and inputs, of letters, digits and "
                                       "+ - . _, not '{}'",
                                       clean_name(word)));
}

}  // namespace

void describe_provenance(Archive& archive, Provenance& provenance) {
  archive.field("provenance", provenance, [](Archive& a, ProvenanceStep& step) {
    a.field("tool", step.tool);
    a.field("version", step.version);
    a.field("inputs", step.inputs, [](Archive& b, InputDigest& input) {
      b.field("format", input.format);
      b.field("sha256", input.sha256);
    });
    if (!a.is_reading() && step.options.empty()) step.options = "{}";
    a.json("options", step.options, {});
    if (a.is_reading()) require_plain_words(a, step);
  });
}

std::string provenance_text(Provenance provenance) {
  JsonWriter writer;
  describe_provenance(writer.root(), provenance);
  return writer.flat_text();
}

Provenance parse_provenance(const std::string& text, const std::string& file_name) {
  Provenance provenance;
  JsonReader reader(text, file_name + ": attribute 'provenance'");
  describe_provenance(reader.root(), provenance);
  return provenance;
}

}  // namespace quadrille::io
