#include "io/json_archive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/json_text.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

class ObjectWriter : public Archive {
 public:
  explicit ObjectWriter(Json& object) : object_(object) { object_ = Json::object(); }

  bool is_reading() const override { return false; }
  bool has(const char*) const override { return true; }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw Defect(fmt::format("'{}' {}", name, problem));
  }
  void integers(const char* name, int* values, std::size_t count, Doc) override { object_[name] = row(values, count); }
  void reals(const char* name, double* values, std::size_t count, Doc) override {
    require_finite(name, values, count);
    object_[name] = row(values, count);
  }
  void text(const char* name, std::string& value, Doc) override { object_[name] = value; }
  void json(const char* name, std::string& value, Doc) override { object_[name] = Json::parse(value); }
  void flag(const char* name, bool& value, Doc) override { object_[name] = value; }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc) override {
    object_[name] = rows(flat, width);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc) override {
    require_finite(name, flat.data(), flat.size());
    object_[name] = rows(flat, width);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc) override { object_[name] = values; }
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
  static Json row(const T* values, std::size_t count) {
    if (count == 1) return *values;
    return std::vector<T>(values, values + count);
  }
  template <typename T>
  static Json rows(const std::vector<T>& flat, std::size_t width) {
    Json list = Json::array();
    for (std::size_t i = 0; i < flat.size(); i += width) list.push_back(row(&flat[i], width));
    return list;
  }
  void require_finite(const char* name, const double* values, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(values[i])) fail(name, "contains a number that is not finite");
  }

  Json& object_;
};

class ObjectReader : public Archive {
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
  void integers(const char* name, int* values, std::size_t count, Doc) override {
    const Json& json = row(name, get(name), count);
    for (std::size_t i = 0; i < count; ++i) values[i] = integer(name, count == 1 ? json : json[i]);
  }
  void reals(const char* name, double* values, std::size_t count, Doc) override {
    const Json& json = row(name, get(name), count);
    for (std::size_t i = 0; i < count; ++i) values[i] = real(name, count == 1 ? json : json[i]);
  }
  void text(const char* name, std::string& value, Doc) override { value = string(name, get(name)); }
  void json(const char* name, std::string& value, Doc) override {
    value = get(name).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  void flag(const char* name, bool& value, Doc) override {
    const Json& json = get(name);
    if (!json.is_boolean()) fail(name, "must be true or false");
    value = json.get<bool>();
  }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc) override {
    rows(name, flat, width, [&](const Json& json) { return integer(name, json); });
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc) override {
    rows(name, flat, width, [&](const Json& json) { return real(name, json); });
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc) override {
    rows(name, values, 1, [&](const Json& json) { return string(name, json); });
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
  const Json& row(const char* name, const Json& json, std::size_t count) const {
    if (count != 1 && (!json.is_array() || json.size() != count))
      fail(name, fmt::format("must be an array of {} numbers", count));
    return json;
  }
  int integer(const char* name, const Json& json) const {
    if (!json.is_number_integer()) fail(name, "must be an integer");
    const bool too_large =
        json.is_number_unsigned() && json.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<int>::max()};
    const auto value = json.get<std::int64_t>();
    if (too_large || value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
      fail(name, "is an integer out of range");
    return static_cast<int>(value);
  }
  double real(const char* name, const Json& json) const {
    if (!json.is_number()) fail(name, "must be a number");
    return json.get<double>();
  }
  std::string string(const char* name, const Json& json) const {
    if (!json.is_string()) fail(name, "must be a string");
    return json.get<std::string>();
  }
  template <typename T, typename Convert>
  void rows(const char* name, std::vector<T>& flat, std::size_t width, const Convert& convert) const {
    const Json& list = array(name);
    flat.clear();
    flat.reserve(list.size() * width);
    for (const Json& item : list) {
      row(name, item, width);
      for (std::size_t k = 0; k < width; ++k) flat.push_back(convert(width == 1 ? item : item[k]));
    }
  }

  const Json& object_;
  std::string file_, path_;
};

/// Printing a value recurses: a file that consists of brackets must not exhaust the stack.
void require_shallow(const std::string& bytes, const std::string& file_name) {
  constexpr int limit = 100;
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (in_text && c == '\\')
      ++i;
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{') && ++depth > limit)
      throw FormatError(fmt::format("{}: not valid: nested deeper than {} levels", file_name, limit));
    else if (!in_text && (c == ']' || c == '}'))
      --depth;
  }
}

}  // namespace

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
bool JsonReader::has(const char* name) const { return impl_->json.contains(name); }

}  // namespace quadrille::io
