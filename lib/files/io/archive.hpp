#pragma once
// One description of a format's fields, used in both directions: describe(Archive&, Struct&) names each member once,
// and the same walk writes or reads it, as HDF5 or as JSON. So reading and writing cannot disagree. Private to io.
//
// HDF5: a list is a dataset, records become a group with one dataset per member, ragged members get `<name>_offsets`
// beside the values. JSON: records are an array of objects. Readers throw FormatError naming the field.

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/name_text.hpp"
#include "base/vec2.hpp"
#include "base/vec3.hpp"

namespace quadrille::io {

/// The attributes of a dataset: `units` ("length", "radian", "1", ...) and `long_name`.
struct Doc {
  const char* units = "";
  const char* long_name = "";
};

class Archive {
 public:
  using Each = std::function<void(Archive&, std::size_t)>;
  virtual ~Archive() = default;

  virtual bool is_reading() const = 0;
  /// Whether the member exists in the file (members that a later minor version added may be missing); true on writing.
  virtual bool has(const char* name) const = 0;
  /// Throws FormatError (reading) or Defect (writing): "<file>: <position of the field `name`> <problem>".
  [[noreturn]] virtual void fail(const char* name, const std::string& problem) const = 0;

  /// Fails unless the condition holds.
  void require(const char* name, bool holds, const char* problem) const {
    if (!holds) fail(name, problem);
  }

  // Members of fixed size.
  virtual void integers(const char* name, int* values, std::size_t count, Doc doc) = 0;
  virtual void reals(const char* name, double* values, std::size_t count, Doc doc) = 0;
  virtual void text(const char* name, std::string& value, Doc doc) = 0;
  /// A JSON text: embedded as it is in JSON, a string elsewhere.
  virtual void json(const char* name, std::string& value, Doc doc) { text(name, value, doc); }
  /// As the integer 0 or 1, unless the format has values for it.
  virtual void flag(const char* name, bool& value, Doc doc) {
    int number = value ? 1 : 0;
    integers(name, &number, 1, doc);
    if (number != 0 && number != 1) fail(name, "must be 0 or 1");
    value = number == 1;
  }
  // Lists; width 1: [n], else [n, width].
  virtual void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc doc) = 0;
  virtual void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc doc) = 0;
  virtual void text_list(const char* name, std::vector<std::string>& values, Doc doc) = 0;
  // Nesting.
  virtual void object(const char* name, const std::function<void(Archive&)>& describe) = 0;
  /// An object whose own lists of reals are long and for programs alone: base64 of little-endian doubles in JSON.
  virtual void packed_object(const char* name, const std::function<void(Archive&)>& describe) {
    object(name, describe);
  }
  /// `count` records on writing; on reading `resize` is called with their number first. Without records, `each` is
  /// still called once, with index `declared`, so that empty columns are written with their names.
  virtual void records(const char* name, std::size_t count, const std::function<void(std::size_t)>& resize,
                       const Each& each) = 0;
  static constexpr std::size_t declared = static_cast<std::size_t>(-1);

  // The typed forms that descriptions use.
  void field(const char* name, int& value, Doc doc = {}) { integers(name, &value, 1, doc); }
  void field(const char* name, double& value, Doc doc = {}) { reals(name, &value, 1, doc); }
  void field(const char* name, bool& value, Doc doc = {}) { flag(name, value, doc); }
  void field(const char* name, std::string& value, Doc doc = {}) { text(name, value, doc); }
  void field(const char* name, Vec2& value, Doc doc = {}) {
    std::array<double, 2> xy{value.x, value.y};
    reals(name, xy.data(), 2, doc);
    value = {xy[0], xy[1]};
  }
  template <std::size_t N>
  void field(const char* name, std::array<double, N>& value, Doc doc = {}) {
    reals(name, value.data(), N, doc);
  }
  template <std::size_t N>
  void field(const char* name, std::array<int, N>& value, Doc doc = {}) {
    integers(name, value.data(), N, doc);
  }
  void field(const char* name, std::vector<int>& values, Doc doc = {}) { integer_list(name, values, 1, doc); }
  void field(const char* name, std::vector<double>& values, Doc doc = {}) { real_list(name, values, 1, doc); }
  void field(const char* name, std::vector<std::string>& values, Doc doc = {}) { text_list(name, values, doc); }
  void field(const char* name, std::vector<Vec2>& values, Doc doc = {}) {
    std::vector<double> flat;
    if (!is_reading()) {
      flat.reserve(2 * values.size());
      for (const Vec2& p : values) flat.insert(flat.end(), {p.x, p.y});
    }
    real_list(name, flat, 2, doc);
    if (!is_reading()) return;
    values.resize(flat.size() / 2);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {flat[2 * i], flat[2 * i + 1]};
  }
  void field(const char* name, std::vector<Vec3>& values, Doc doc = {}) {
    std::vector<double> flat;
    if (!is_reading()) {
      flat.reserve(3 * values.size());
      for (const Vec3& p : values) flat.insert(flat.end(), {p.x, p.y, p.z});
    }
    real_list(name, flat, 3, doc);
    if (!is_reading()) return;
    values.resize(flat.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
  }
  template <std::size_t N>
  void field(const char* name, std::vector<std::array<int, N>>& values, Doc doc = {}) {
    std::vector<int> flat;
    if (!is_reading())
      for (const auto& row : values) flat.insert(flat.end(), row.begin(), row.end());
    integer_list(name, flat, N, doc);
    if (!is_reading()) return;
    values.resize(flat.size() / N);
    for (std::size_t i = 0; i < flat.size(); ++i) values[i / N][i % N] = flat[i];
  }
  /// An enum by the name of its value. Reading any other text throws FormatError with the allowed names and, if it is
  /// not empty, the numbered rule `rule`.
  template <NamedEnum Enum>
  void field(const char* name, Enum& value, Doc doc = {}, const std::string& rule = {}) {
    const std::string given = enum_field(name, value, doc);
    if (enum_value<Enum>(given)) return;
    fail(name, "must be " + alternatives(all_enum_names<Enum>()) + ", not '" + clean_name(given) + "'" +
                   (rule.empty() ? "" : " (" + rule + ")"));
  }
  /// The same for enums to which later minor versions may add: an unknown name is read as `unknown`.
  template <NamedEnum Enum>
  void extensible_field(const char* name, Enum& value, Enum unknown, Doc doc = {}) {
    if (!enum_value<Enum>(enum_field(name, value, doc))) value = unknown;
  }
  /// describe(Archive&, Record&) for each record.
  template <typename Record, typename Describe>
  void field(const char* name, std::vector<Record>& values, const Describe& describe) {
    Record empty;
    records(
        name, values.size(), [&](std::size_t count) { values.resize(count); },
        [&](Archive& archive, std::size_t i) { describe(archive, i == declared ? empty : values[i]); });
  }

  // Members that files may lack: those that a later minor version added, and lists that are written only where they are
  // not empty.
  template <typename Value>
  void later_field(const char* name, Value& value, Doc doc = {}) {
    if (has(name)) field(name, value, doc);
  }
  template <typename Member, typename Describe>
  void nonempty_field(const char* name, std::vector<Member>& values, const Describe& describe) {
    if (is_reading() ? has(name) : !values.empty()) field(name, values, describe);
  }
  template <typename Member>
  void nonempty_field(const char* name, std::vector<Member>& values, Doc doc) {
    nonempty_field<Member, Doc>(name, values, doc);
  }

 private:
  /// Writes the value's name, or reads the value if its name is known; returns the text.
  template <NamedEnum Enum>
  std::string enum_field(const char* name, Enum& value, Doc doc) {
    std::string text_of_value = is_reading() ? std::string() : enum_name(value);
    text(name, text_of_value, doc);
    value = enum_value<Enum>(text_of_value).value_or(value);
    return text_of_value;
  }
};

/// An archive whose values of all types go through two templates of `Derived`: fixed(name, values, count, doc) for
/// members of fixed size, list(name, flat, width, doc) for lists.
template <typename Derived>
class TypedArchive : public Archive {
 public:
  void integers(const char* name, int* values, std::size_t count, Doc doc) override {
    self().fixed(name, values, count, doc);
  }
  void reals(const char* name, double* values, std::size_t count, Doc doc) override {
    self().fixed(name, values, count, doc);
  }
  void text(const char* name, std::string& value, Doc doc) override { self().fixed(name, &value, 1, doc); }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc doc) override {
    self().list(name, flat, width, doc);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc doc) override {
    self().list(name, flat, width, doc);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc doc) override {
    self().list(name, values, 1, doc);
  }

 private:
  Derived& self() { return static_cast<Derived&>(*this); }
};

}  // namespace quadrille::io
