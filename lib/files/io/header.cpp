#include "io/header.hpp"

#include <fmt/format.h>

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
