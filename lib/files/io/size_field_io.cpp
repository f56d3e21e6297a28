#include "io/size_field_io.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/describe.hpp"
#include "io/json_archive.hpp"

namespace quadrille::io {

namespace {

constexpr StageFormat size_field_version{"size-field", 1, 0, Storage::json};

void require(Archive& archive, const char* name, bool holds, const char* problem) {
  if (!holds) archive.fail(name, problem);
}

void require_header(Archive& root, const std::string& file_name) {
  std::string format;
  if (root.has("format")) root.field("format", format);
  if (format != size_field_version.name)
    throw FormatError(fmt::format("{}: not a size field: the key \"format\" must be \"size-field\"", file_name));
  std::vector<int> version;
  root.field("version", version);
  require_version(file_name, size_field_version, format, version);
}

void read_size(Archive& archive, double& size) {
  archive.field("size", size);
  require(archive, "size", size > 0 && std::isfinite(size), "must be a length greater than 0 (SIZ-R01)");
}

void read_position(Archive& archive, const char* name, Vec2& position, Vec2 origin) {
  archive.field(name, position);
  require(archive, name, std::isfinite(position.x) && std::isfinite(position.y), "must be two numbers");
  position -= origin;
}

void read_point(Archive& archive, SizePoint& point, Vec2 origin) {
  read_position(archive, "position", point.position, origin);
  read_size(archive, point.size);
  if (!archive.has("radius")) return;
  archive.field("radius", point.radius);
  require(archive, "radius", point.radius >= 0 && std::isfinite(point.radius),
          "must be a length of at least 0 (SIZ-R01)");
}

void read_box(Archive& archive, SizeBox& box, Vec2 origin) {
  read_position(archive, "low", box.low, origin);
  read_position(archive, "high", box.high, origin);
  require(archive, "high", box.low.x <= box.high.x && box.low.y <= box.high.y, "must not lie below 'low' (SIZ-R02)");
  read_size(archive, box.size);
}

constexpr std::string_view separators = ",; \t\r\"";

/// Words between commas, semicolons and blanks; quotation marks are no part of them.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

std::optional<double> number_of(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional<double>(value) : std::nullopt;
}

/// A table of points (formats/size-field.md, "As a table"); errors name the line.
class TableReader {
 public:
  TableReader(const InputFile& file, Vec2 origin) : file_(file), origin_(origin) {}

  SizeSources read() {
    const std::string_view bytes = file_.bytes;
    for (std::size_t begin = 0; begin < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      ++line_;
      read_line(bytes.substr(begin, end - begin));
      begin = end + 1;
    }
    if (sources_.points.empty()) throw FormatError(fmt::format("{}: there are no points", file_.name));
    sources_.is_table = true;
    return std::move(sources_);
  }

 private:
  void read_line(std::string_view line) {
    const std::vector<std::string> words = words_of(line.substr(0, line.find('#')));
    if (words.empty()) return;
    if (sources_.points.empty() && !has_header_ && !number_of(words[0])) return read_header(words);
    const std::size_t needed = *std::max_element(columns_.begin(), columns_.end()) + 1;
    if (words.size() < needed || (!has_header_ && words.size() != needed))
      fail(fmt::format("expected {} numbers, found {}", needed, words.size()));
    std::array<double, 3> values{};
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::optional<double> value = number_of(words[columns_[k]]);
      if (!value || !std::isfinite(*value)) fail(fmt::format("'{}' is not a number", words[columns_[k]]));
      values[k] = *value;
    }
    if (!(values[2] > 0)) fail(fmt::format("the size {:g} must be greater than 0 (SIZ-R01)", values[2]));
    sources_.points.push_back({Vec2{values[0], values[1]} - origin_, values[2], 0});
  }

  void read_header(const std::vector<std::string>& words) {
    has_header_ = true;
    const std::array<std::vector<std::string>, 3> names{
        std::vector<std::string>{"x", "points:0"}, {"y", "points:1"}, {"size"}};
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto at = std::find_if(words.begin(), words.end(), [&](std::string word) {
        std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
        return std::find(names[k].begin(), names[k].end(), word) != names[k].end();
      });
      if (at == words.end())
        fail(fmt::format("there is no column {}, only {}", fmt::join(names[k], " or "), fmt::join(words, ", ")));
      columns_[k] = at - words.begin();
    }
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw FormatError(fmt::format("{}:{}: {}", file_.name, line_, why));
  }

  const InputFile& file_;
  Vec2 origin_;
  SizeSources sources_;
  std::array<std::size_t, 3> columns_{0, 1, 2};
  bool has_header_ = false;
  int line_ = 0;
};

/// Neither JSON nor XML.
bool is_size_table(const InputFile& file) {
  const std::size_t first = file.bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && file.bytes[first] != '{' && file.bytes[first] != '<';
}

}  // namespace

SizeSources read_size_field(const InputFile& file, Vec2 origin) {
  if (is_size_table(file)) return TableReader(file, origin).read();
  if (file.bytes.find("<VTKFile") != std::string::npos)
    throw FormatError(fmt::format(
        "{0}: a VTU file: convert it first, by python3 -m quadrille.vtu_sizes {0} -o sizes.csv", file.name));
  JsonReader reader(file.bytes, file.name);
  Archive& root = reader.root();
  require_header(root, file.name);
  if (!root.has("points") && !root.has("boxes"))
    throw FormatError(fmt::format("SIZ-R03: {}: there are neither 'points' nor 'boxes'", file.name));
  SizeSources sources;
  if (root.has("growth")) {
    root.field("growth", sources.growth);
    require(root, "growth", sources.growth > 1 && std::isfinite(sources.growth), "must be greater than 1 (SIZ-R01)");
  }
  if (root.has("points"))
    root.field("points", sources.points, [&](Archive& a, SizePoint& point) { read_point(a, point, origin); });
  if (root.has("boxes"))
    root.field("boxes", sources.boxes, [&](Archive& a, SizeBox& box) { read_box(a, box, origin); });
  return sources;
}

}  // namespace quadrille::io
