#include "io/json_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/base64.hpp"
#include "base/error.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "packed doubles are written as they lie in memory");

class ObjectWriter : public TypedArchive<ObjectWriter> {
 public:
  explicit ObjectWriter(Json& object, bool is_packed = false) : object_(object), is_packed_(is_packed) {
    object_ = Json::object();
  }

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
    if constexpr (std::is_same_v<T, double>)
      if (is_packed_) {
        require_finite(name, flat.data(), flat.size());
        object_[name] = base64({reinterpret_cast<const char*>(flat.data()), flat.size() * sizeof(double)});
        return;
      }
    Json& list = object_[name] = Json::array();
    for (std::size_t i = 0; i < flat.size(); i += width) list.push_back(row(name, &flat[i], width));
  }
  void json(const char* name, std::string& value, Doc) override { object_[name] = Json::parse(value); }
  void flag(const char* name, bool& value, Doc) override { object_[name] = value; }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    ObjectWriter inner(object_[name]);
    describe(inner);
  }
  void packed_object(const char* name, const std::function<void(Archive&)>& describe) override {
    ObjectWriter inner(object_[name], true);
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
    if constexpr (std::is_same_v<T, double>) require_finite(name, values, count);
    if (count == 1) return *values;
    return std::vector<T>(values, values + count);
  }
  void require_finite(const char* name, const double* values, std::size_t count) const {
    if (!std::all_of(values, values + count, [](double x) { return std::isfinite(x); }))
      fail(name, "contains a number that is not finite");
  }

  Json& object_;
  bool is_packed_;
};

class ObjectReader : public TypedArchive<ObjectReader> {
 public:
  ObjectReader(const Json& object, std::string file, std::string path, bool is_packed = false)
      : object_(object), file_(std::move(file)), path_(std::move(path)), is_packed_(is_packed) {
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
    if constexpr (std::is_same_v<T, double>)
      if (is_packed_) return unpack(name, flat, width);
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
  void packed_object(const char* name, const std::function<void(Archive&)>& describe) override {
    ObjectReader inner(get(name), file_, fmt::format("{}{}.", path_, name), true);
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
  void unpack(const char* name, std::vector<double>& flat, std::size_t width) const {
    const Json& json = get(name);
    const auto bytes = bytes_of_base64(json.is_string() ? json.get_ref<const std::string&>() : "-");
    if (!bytes || bytes->size() % (width * sizeof(double)) != 0)
      fail(name, fmt::format("must be the base64 of doubles, {} for each entry", width));
    flat.resize(bytes->size() / sizeof(double));
    std::copy(bytes->begin(), bytes->end(), reinterpret_cast<char*>(flat.data()));
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
  bool is_packed_;
};

constexpr int depth_limit = 100, key_limit = 10000;

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

}  // namespace quadrille::io
