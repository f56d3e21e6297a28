#include "io/stage_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "io/describe.hpp"
#include "io/digest.hpp"
#include "io/hdf5_archive.hpp"
#include "io/hdf5_layout.hpp"
#include "io/json_archive.hpp"
#include "io/whole_file.hpp"

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

void require_format(Archive& root, const StageFormat& expected, const std::string& file_name, const char* what) {
  std::string format;
  if (root.has("format")) root.field("format", format);
  if (format != expected.name)
    throw FormatError(fmt::format("{}: not {}: the key \"format\" must be \"{}\"", file_name, what, expected.name));
  std::vector<int> version;
  root.field("version", version);
  require_version(file_name, expected, format, version);
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

namespace {

struct Hdf5Header {
  std::string format;
  std::vector<int> version;
};

Hdf5Header read_header(const Hdf5GroupReader& root, const std::string& file_name) {
  if (!root.has_attribute("format"))
    throw FormatError(
        fmt::format("{}: an HDF5 file, but not a stage file: the root has no attribute 'format'", file_name));
  return {root.text_attribute("format"), root.integer_attribute("version")};
}

/// Every later stage writes it into an attribute, which holds at most 64 KiB in the files that any HDF5 library reads.
constexpr std::size_t longest_provenance = 60000;

void require_short(const Provenance& provenance, const std::string& file_name) {
  if (provenance_text(provenance).size() > longest_provenance)
    throw FormatError(fmt::format("{}: 'provenance' is longer than {} characters, which no stage file can hold",
                                  file_name, longest_provenance));
}

std::string hdf5_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe) {
  Hdf5Writer writer;
  writer.root().text_attribute("format", format.name);
  writer.root().integer_attribute("version", {format.major, format.minor});
  writer.root().text_attribute("producer", producer_of(provenance));
  writer.root().text_attribute("provenance", provenance_text(provenance));
  describe(*hdf5_archive(writer.root()));
  std::string bytes = writer.image();
  append_checksum(bytes);
  return bytes;
}

/// The struct of the format, of the alternative `I` or of a later one.
template <std::size_t I = 0>
StageModel empty_stage(const std::string& format) {
  if constexpr (I + 1 < stage_formats.size())
    if (format != stage_formats[I].name) return empty_stage<I + 1>(format);
  return StageModel(std::in_place_index<I>);
}

void read_model(const Hdf5Reader& reader, const std::string& file_name, const StageFormat& format,
                Provenance& provenance, const Describe& describe) {
  const Hdf5Header header = read_header(reader.root(), file_name);
  require_version(file_name, format, header.format, header.version);
  provenance = parse_provenance(reader.root().text_attribute("provenance"), file_name);
  require_short(provenance, file_name);
  describe(*hdf5_archive(reader.root()));
}

/// The content of an HDF5 file, or the name of its format alone where that is not one of HDF5 files.
std::pair<std::optional<StageModel>, std::string> any_model(std::string_view image, const std::string& file_name) {
  const Hdf5Reader reader(image, file_name);
  const std::string name = read_header(reader.root(), file_name).format;
  const auto* const format = std::find_if(stage_formats.begin(), stage_formats.end(),
                                          [&](const StageFormat& known) { return name == known.name; });
  if (format == stage_formats.end() || format->storage != Storage::hdf5) return {std::nullopt, name};
  StageModel stage = empty_stage(name);
  std::visit(
      [&](auto& model) {
        read_model(reader, file_name, *format, model.provenance, [&](Archive& a) { describe(a, model); });
      },
      stage);
  return {std::move(stage), name};
}

/// The file as our writer writes it. Of an unknown format it has the name, by which it is refused.
std::string rewritten_bytes(std::string_view image, const std::string& file_name) {
  auto [stage, format] = any_model(image, file_name);
  if (!stage) return hdf5_bytes({format.c_str(), 1, 0, Storage::hdf5}, {}, [](Archive&) {});
  return stage_bytes(std::move(*stage));
}

/// An HDF5 file of another program as our writer writes it, made in a child process: libhdf5, which some bytes make
/// crash, reads them nowhere else. Nothing for a file of our own writer.
std::optional<InputFile> rewritten(const InputFile& file) {
  if (!looks_like_hdf5(file.bytes)) return std::nullopt;
  std::string_view image;
  const Checksum checksum = verify_checksum(file.bytes, image);
  if (checksum == Checksum::wrong)
    throw FormatError(fmt::format("{}: damaged: its checksum does not match its data", file.name));
  if (checksum == Checksum::right && has_own_layout(image)) return std::nullopt;
  // Enough for the data of a sound file, even a compressed one; a file that needs more is damaged.
  const ChildLimits limits{10 + static_cast<int>(file.bytes.size() / 10'000'000),
                           (128ULL << 20) + 16 * file.bytes.size()};
  return InputFile{
      {file.name, file.sha256},
      run_in_child([&] { return rewritten_bytes(image, file.name); },
                   fmt::format("{}: truncated or damaged: the HDF5 reader fails on it", file.name), limits)};
}

/// Runs `read` on the file.
template <typename Read>
void read_safely(const InputFile& file, const Read& read) {
  if (!looks_like_hdf5(file.bytes)) throw FormatError(fmt::format("{}: not an HDF5 file", file.name));
  const std::optional<InputFile> own = rewritten(file);
  std::string_view image;
  verify_checksum(own ? own->bytes : file.bytes, image);
  read(Hdf5Reader(image, file.name));
}

void read_hdf5(const InputFile& file, const StageFormat& format, Provenance& provenance, const Describe& describe) {
  read_safely(file, [&](const Hdf5Reader& reader) { read_model(reader, file.name, format, provenance, describe); });
}

std::string json_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe) {
  JsonWriter writer;
  std::string name = format.name, producer = producer_of(provenance);
  std::vector<int> numbers{format.major, format.minor};
  Provenance chain = provenance;
  writer.root().field("format", name);
  writer.root().field("version", numbers);
  writer.root().field("producer", producer);
  describe_provenance(writer.root(), chain);
  describe(writer.root());
  return writer.text();
}

void read_model(Archive& root, const std::string& file_name, const StageFormat& format, Provenance& provenance,
                const Describe& describe) {
  std::string name;
  std::vector<int> numbers;
  root.field("format", name);
  root.field("version", numbers);
  require_version(file_name, format, name, numbers);
  describe_provenance(root, provenance);
  require_short(provenance, file_name);
  describe(root);
}

std::string require_stage_format(const std::string& file_name, std::string format) {
  if (std::none_of(stage_formats.begin(), stage_formats.end(), [&](const auto& known) { return format == known.name; }))
    throw FormatError(fmt::format("{}: '{}' is not the format of a stage file", file_name, clean_name(format)));
  return format;
}

const std::string& json_object_in(const InputFile& file) {
  const std::size_t first = file.bytes.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || file.bytes[first] != '{')
    throw FormatError(fmt::format("{}: neither HDF5 nor a JSON object: not a stage file", file.name));
  return file.bytes;
}

std::string format_in(JsonReader& reader, const std::string& file_name) {
  std::string format;
  reader.root().field("format", format);
  return require_stage_format(file_name, std::move(format));
}

void read_json(const InputFile& file, const StageFormat& format, Provenance& provenance, const Describe& describe) {
  if (looks_like_hdf5(file.bytes))
    throw FormatError(fmt::format("{}: expected a {} file (JSON), found an HDF5 file", file.name, format.name));
  JsonReader reader(file.bytes, file.name);
  read_model(reader.root(), file.name, format, provenance, describe);
}

}  // namespace

std::string described_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe) {
  if (!provenance.empty() && provenance_text(provenance).size() > longest_provenance)
    throw UsageError(
        fmt::format("the options of this run and of those before have more than {} characters, which no "
                    "stage file can hold: give shorter ones",
                    longest_provenance));
  const auto bytes = format.storage == Storage::hdf5 ? hdf5_bytes : json_bytes;
  return bytes(format, provenance, describe);
}

void read_described(const InputFile& file, const StageFormat& format, Provenance& provenance,
                    const Describe& describe) {
  const auto read = format.storage == Storage::hdf5 ? read_hdf5 : read_json;
  read(file, format, provenance, describe);
}

void read_into(const InputFile& file, StageModel& stage) {
  std::visit(
      [&]<typename Model>(Model& model) {
        read_described(file, format_of<Model>(), model.provenance, [&](Archive& archive) { describe(archive, model); });
      },
      stage);
}

StageModel read_any_stage(const InputFile& file) {
  if (!looks_like_hdf5(file.bytes)) {
    JsonReader reader(json_object_in(file), file.name);  // once, for the format and for the content
    StageModel stage = empty_stage(format_in(reader, file.name));
    std::visit(
        [&]<typename Model>(Model& model) {
          if (format_of<Model>().storage == Storage::hdf5) return read_into(file, stage);  // which refuses it
          read_model(reader.root(), file.name, format_of<Model>(), model.provenance,
                     [&](Archive& archive) { describe(archive, model); });
        },
        stage);
    return stage;
  }
  const std::optional<InputFile> own = rewritten(file);  // once, not for the format and for the content
  const InputFile& known = own ? *own : file;
  StageModel stage = empty_stage(stage_format(known));
  read_into(known, stage);
  return stage;
}

std::string stage_bytes(StageModel stage) {
  return std::visit(
      [&]<typename Model>(Model& model) {
        return described_bytes(format_of<Model>(), model.provenance,
                               [&](Archive& archive) { describe(archive, model); });
      },
      stage);
}

void write_stage(const std::string& path, const StageModel& stage) { write_stage_bytes(path, stage_bytes(stage)); }

void write_stage_bytes(const std::string& path, const std::string& bytes, Lasting lasting) {
  write_output(path, bytes, looks_like_hdf5(bytes), lasting);
}

FileIdentity identity_of(const std::string& name, const std::string& bytes) { return {name, sha256_hex(bytes)}; }

std::string stage_format(const InputFile& file) {
  if (!looks_like_hdf5(file.bytes)) {
    JsonReader reader(json_object_in(file), file.name);
    return format_in(reader, file.name);
  }
  std::string format;
  read_safely(file, [&](const Hdf5Reader& reader) { format = read_header(reader.root(), file.name).format; });
  return require_stage_format(file.name, std::move(format));
}

bool is_chart(const InputFile& file) {
  return looks_like_hdf5(file.bytes) && stage_format(file) == format_of<ChartedFace>().name;
}

CadFace read_face(const InputFile& file) {
  CadFace face;
  if (looks_like_hdf5(file.bytes))
    read_safely(file, [&](const Hdf5Reader& reader) { describe_face(*hdf5_archive(reader.root()), face); });
  else
    describe_face(JsonReader(file.bytes, file.name).root(), face);
  return face;
}

}  // namespace quadrille::io
