#include "io/json_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

class ObjectWriter : public TypedArchive<ObjectWriter> {
 public:
  explicit ObjectWriter(Json& object) : object_(object) { object_ = Json::object(); }

  bool is_reading() const override { return false; }
  bool has(const char*) const override { return true; }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw Defect(fmt::format("'{}' {}", name, problem));
  }
  template <typename T>
  void fixed(const char* name, const T* values, std::size_t count, Doc) {
    object_[name] = row(name, values, count);
  }
  template <typename T>
  void list(const char* name, const std::vector<T>& flat, std::size_t width, Doc) {
    Json& list = object_[name] = Json::array();
    for (std::size_t i = 0; i < flat.size(); i += width) list.push_back(row(name, &flat[i], width));
  }
  void json(const char* name, std::string& value, Doc) override { object_[name] = Json::parse(value); }
  void flag(const char* name, bool& value, Doc) override { object_[name] = value; }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    ObjectWriter inner(object_[name]);
    describe(inner);
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>&,
               const Each& each) override {
    Json& list = object_[name] = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
      ObjectWriter inner(list.emplace_back());
      each(inner, i);
    }
  }

 private:
  template <typename T>
  Json row(const char* name, const T* values, std::size_t count) const {
    if constexpr (std::is_same_v<T, double>)
      if (!std::all_of(values, values + count, [](double x) { return std::isfinite(x); }))
        fail(name, "contains a number that is not finite");
    if (count == 1) return *values;
    return std::vector<T>(values, values + count);
  }

  Json& object_;
};

class ObjectReader : public TypedArchive<ObjectReader> {
 public:
  ObjectReader(const Json& object, std::string file, std::string path)
      : object_(object), file_(std::move(file)), path_(std::move(path)) {
    if (!object_.is_object()) throw FormatError(fmt::format("{}: {} must be an object", file_, here()));
  }

  bool is_reading() const override { return true; }
  bool has(const char* name) const override { return object_.contains(name); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw FormatError(fmt::format("{}: '{}{}' {}", file_, path_, name, problem));
  }
  template <typename T>
  void fixed(const char* name, T* values, std::size_t count, Doc) {
    convert_row(name, get(name), count, values);
  }
  template <typename T>
  void list(const char* name, std::vector<T>& flat, std::size_t width, Doc) {
    const Json& rows = array(name);
    flat.resize(rows.size() * width);
    for (std::size_t i = 0; i < rows.size(); ++i) convert_row(name, rows[i], width, &flat[i * width]);
  }
  void json(const char* name, std::string& value, Doc) override {
    value = get(name).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  void flag(const char* name, bool& value, Doc) override {
    const Json& json = get(name);
    if (!json.is_boolean()) fail(name, "must be true or false");
    value = json.get<bool>();
  }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    ObjectReader inner(get(name), file_, fmt::format("{}{}.", path_, name));
    describe(inner);
  }
  void records(const char* name, std::size_t, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    const Json& list = array(name);
    resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      ObjectReader inner(list[i], file_, fmt::format("{}{}[{}].", path_, name, i));
      each(inner, i);
    }
  }

 private:
  std::string here() const {
    return path_.empty() ? "the top level" : fmt::format("'{}'", path_.substr(0, path_.size() - 1));
  }
  const Json& get(const char* name) const {
    const auto found = object_.find(name);
    if (found == object_.end()) fail(name, "is missing");
    return *found;
  }
  const Json& array(const char* name) const {
    const Json& json = get(name);
    if (!json.is_array()) fail(name, "must be an array");
    return json;
  }
  template <typename T>
  void convert_row(const char* name, const Json& json, std::size_t count, T* values) const {
    if (count != 1 && (!json.is_array() || json.size() != count))
      fail(name, fmt::format("must be an array of {} numbers", count));
    for (std::size_t i = 0; i < count; ++i) convert(name, count == 1 ? json : json[i], values[i]);
  }
  void convert(const char* name, const Json& json, int& value) const {
    if (!json.is_number_integer()) fail(name, "must be an integer");
    const bool too_large =
        json.is_number_unsigned() && json.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<int>::max()};
    const auto number = json.get<std::int64_t>();
    if (too_large || number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
      fail(name, "is an integer out of range");
    value = static_cast<int>(number);
  }
  void convert(const char* name, const Json& json, double& value) const {
    if (!json.is_number()) fail(name, "must be a number");
    value = json.get<double>();
  }
  void convert(const char* name, const Json& json, std::string& value) const {
    if (!json.is_string()) fail(name, "must be a string");
    value = json.get<std::string>();
  }

  const Json& object_;
  std::string file_, path_;
};

constexpr int depth_limit = 100, key_limit = 10000;

constexpr std::size_t line_width = 110;

constexpr std::size_t unlimited = std::string::npos;

std::string dumped(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Numbers and names are most of a file, and dump() allocates a buffer for each.
void append_leaf(const Json& value, std::string& out) {
  std::array<char, 64> text{};
  char* end = nullptr;
  if (value.is_number_float() && std::isfinite(value.get<double>())) {
    end = nlohmann::detail::to_chars(text.data(), text.data() + text.size(), value.get<double>());
  } else if (value.is_number_unsigned()) {
    end = std::to_chars(text.data(), text.data() + text.size(), value.get<std::uint64_t>()).ptr;
  } else if (value.is_number_integer()) {
    end = std::to_chars(text.data(), text.data() + text.size(), value.get<std::int64_t>()).ptr;
  } else {
    out += dumped(value);
    return;
  }
  out.append(text.data(), end);
}

bool needs_no_escape(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void append_key(const std::string& key, std::string& out) {
  if (std::all_of(key.begin(), key.end(), needs_no_escape)) {
    (out += '"') += key;
    out += "\": ";
  } else {
    out += dumped(Json(key)) + ": ";
  }
}

/// Appends the value on one line, with blanks after commas and colons. Stops as soon as `out` is longer than `limit`.
void append_line(const Json& value, std::string& out, std::size_t limit = unlimited) {
  if (!value.is_structured()) {
    append_leaf(value, out);
    return;
  }
  out += value.is_object() ? '{' : '[';
  for (auto it = value.begin(); it != value.end() && out.size() <= limit; ++it) {
    if (it != value.begin()) out += ", ";
    if (value.is_object()) append_key(it.key(), out);
    append_line(it.value(), out, limit);
  }
  out += value.is_object() ? '}' : ']';
}

/// Appends the value if it fits on the line.
bool append_if_short(const Json& value, std::size_t indent, std::string& out) {
  const std::size_t before = out.size(), limit = before + line_width;
  append_line(value, out, limit);
  if (out.size() + indent <= limit) return true;
  out.resize(before);
  return false;
}

/// Short items, as many on a line as fit.
void append_wrapped(const Json& value, std::size_t indent, std::string& out) {
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  out += "[" + margin;
  std::size_t column = indent + 2;
  std::string item;
  for (std::size_t i = 0; i < value.size(); ++i) {
    item.clear();
    append_line(value[i], item);
    if (i > 0 && column + item.size() + 2 > line_width) {
      out += ',' + margin;
      column = indent + 2;
    } else if (i > 0) {
      out += ", ";
      column += 2;
    }
    out += item;
    column += item.size();
  }
  out += '\n' + std::string(indent, ' ') + ']';
}

bool is_point_or_number(const Json& value) {
  return !value.is_structured() ||
         (value.is_array() && value.size() <= 4 &&
          std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); }));
}

void append_pretty(const Json& value, std::size_t indent, std::string& out) {
  if (!value.is_structured() || value.empty()) return append_line(value, out);
  // Only a leaf or a shallow structure can be short; testing the size first keeps this linear.
  if (value.size() <= 12 && append_if_short(value, indent, out)) return;
  if (value.is_array() && std::all_of(value.begin(), value.end(), is_point_or_number))
    return append_wrapped(value, indent, out);
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  out += value.is_object() ? '{' : '[';
  for (auto it = value.begin(); it != value.end(); ++it) {
    out += it == value.begin() ? margin : ',' + margin;
    if (value.is_object()) append_key(it.key(), out);
    append_pretty(it.value(), indent + 2, out);
  }
  out += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

namespace {

/// What is too much of the text; empty if nothing is.
std::string excess_of(const std::string& json) {
  int depth = 0;
  std::array<int, depth_limit + 1> num_keys{};  // of the objects that are open
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (!in_text && (c == '[' || c == '{')) {
      if (++depth > depth_limit) return fmt::format("nested deeper than {} levels", depth_limit);
      if (depth > 0) num_keys[depth] = 0;
    } else if (!in_text && (c == ']' || c == '}')) {
      --depth;
    } else if (!in_text && c == ':' && depth > 0 && ++num_keys[depth] > key_limit) {
      return fmt::format("an object has more than {} keys", key_limit);
    }
  }
  return {};
}

}  // namespace

bool is_shallow(const std::string& json) { return excess_of(json).empty(); }

void require_shallow(const std::string& json, const std::string& file_name) {
  if (const std::string excess = excess_of(json); !excess.empty())
    throw FormatError(fmt::format("{}: not valid: {}", file_name, excess));
}

struct JsonWriter::Impl {
  Json json;
  ObjectWriter writer{json};
};

JsonWriter::JsonWriter() : impl_(std::make_unique<Impl>()) {}
JsonWriter::~JsonWriter() = default;
Archive& JsonWriter::root() { return impl_->writer; }
std::string JsonWriter::text() const { return json_text(impl_->json); }
std::string JsonWriter::flat_text() const { return impl_->json.dump(); }

struct JsonReader::Impl {
  Impl(Json parsed, const std::string& file_name) : json(std::move(parsed)), reader(json, file_name, "") {}
  Json json;
  ObjectReader reader;
};

JsonReader::JsonReader(const std::string& bytes, const std::string& file_name) {
  require_shallow(bytes, file_name);
  try {
    impl_ = std::make_unique<Impl>(Json::parse(bytes), file_name);
  } catch (const Json::exception& e) {
    // The library's own prefix ("[json.exception.parse_error.101] ") does not help a user.
    const std::string what = e.what();
    const std::size_t prefix = what.find("] ");
    throw FormatError(
        fmt::format("{}: not valid JSON: {}", file_name, prefix == std::string::npos ? what : what.substr(prefix + 2)));
  }
}
JsonReader::~JsonReader() = default;
Archive& JsonReader::root() { return impl_->reader; }

std::string json_text(const nlohmann::ordered_json& value) {
  std::string out;
  if (!value.is_object()) {
    append_pretty(value, 0, out);
    return out + '\n';
  }
  // The top level always has a line for each key.
  out = "{";
  for (auto it = value.begin(); it != value.end(); ++it) {
    out += it == value.begin() ? "\n  " : ",\n  ";
    append_key(it.key(), out);
    append_pretty(it.value(), 2, out);
  }
  return out + "\n}\n";
}

}  // namespace quadrille::io
