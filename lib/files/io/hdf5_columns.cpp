#include "io/hdf5_columns.hpp"

#include <fmt/format.h>

#include <memory>
#include <string_view>

#include "base/error.hpp"

namespace quadrille::io {

namespace {

/// Members that writing and reading columns have in common.
struct Column {
  std::string name;
  Doc doc;
  std::size_t width = 1;
  bool is_ragged = false;
  std::vector<int> integers;
  std::vector<double> reals;
  std::vector<std::string> texts;
  std::vector<int> offsets{0};  ///< in rows
};

class ColumnWriter : public Archive {
 public:
  bool is_reading() const override { return false; }
  bool has(const char*) const override { return true; }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw Defect(fmt::format("'{}' {}", name, problem));
  }
  void integers(const char* name, int* values, std::size_t count, Doc doc) override {
    append(column(name, Kind::integer, count, false, doc).integers, values, count);
  }
  void reals(const char* name, double* values, std::size_t count, Doc doc) override {
    append(column(name, Kind::real, count, false, doc).reals, values, count);
  }
  void text(const char* name, std::string& value, Doc doc) override {
    append(column(name, Kind::text, 1, false, doc).texts, &value, 1);
  }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc doc) override {
    Column& c = column(name, Kind::integer, width, true, doc);
    append(c.integers, flat.data(), flat.size());
    end_row(c, c.integers.size() / width);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc doc) override {
    Column& c = column(name, Kind::real, width, true, doc);
    append(c.reals, flat.data(), flat.size());
    end_row(c, c.reals.size() / width);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc doc) override {
    Column& c = column(name, Kind::text, 1, true, doc);
    append(c.texts, values.data(), values.size());
    end_row(c, c.texts.size());
  }
  void object(const char* name, const std::function<void(Archive&)>&) override {
    fail(name, "is an object inside a record");
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>&,
               const Each& each) override {
    OneColumn& c = column(name, Kind::nested, 1, true, {});
    if (!c.nested) c.nested = std::make_unique<ColumnWriter>();
    if (is_declaring_ || count == 0)
      c.nested->declare(each);
    else
      for (std::size_t i = 0; i < count; ++i) each(*c.nested, i);
    if (!is_declaring_) end_row(c, static_cast<std::size_t>(c.offsets.back()) + count);
  }

  /// Declares the columns from one empty record.
  void declare(const Each& each) {
    is_declaring_ = true;
    each(*this, declared);
    is_declaring_ = false;
  }
  void write(const Hdf5GroupWriter& group) const {
    for (const auto& c : columns_) c->write(group);
  }

 private:
  enum class Kind { integer, real, text, nested };
  struct OneColumn : Column {
    Kind kind = Kind::integer;
    std::unique_ptr<ColumnWriter> nested;

    void write(const Hdf5GroupWriter& group) const {
      const std::size_t size = kind == Kind::integer ? integers.size() : reals.size();
      const Hdf5GroupWriter::Shape shape =
          width == 1 ? Hdf5GroupWriter::Shape{size} : Hdf5GroupWriter::Shape{size / width, width};
      if (is_ragged) group.integers(name + "_offsets", offsets.data(), {offsets.size()}, "", "");
      if (kind == Kind::integer) group.integers(name, integers.data(), shape, doc.units, doc.long_name);
      if (kind == Kind::real) group.reals(name, reals.data(), shape, doc.units, doc.long_name);
      if (kind == Kind::text) group.texts(name, texts, false, doc.units, doc.long_name);
      if (kind == Kind::nested) nested->write(group.group(name));
    }
  };

  OneColumn& column(const char* name, Kind kind, std::size_t width, bool is_ragged, Doc doc) {
    for (const auto& c : columns_)
      if (c->name == name) return *c;
    columns_.push_back(std::make_unique<OneColumn>());
    OneColumn& c = *columns_.back();
    static_cast<Column&>(c) = {name, doc, width, is_ragged, {}, {}, {}, {0}};
    c.kind = kind;
    return c;
  }
  template <typename T>
  void append(std::vector<T>& values, const T* from, std::size_t count) const {
    if (!is_declaring_) values.insert(values.end(), from, from + count);
  }
  void end_row(Column& c, std::size_t rows) const {
    if (!is_declaring_) c.offsets.push_back(static_cast<int>(rows));
  }

  std::vector<std::unique_ptr<OneColumn>> columns_;
  bool is_declaring_ = false;
};

class ColumnReader : public Archive {
 public:
  /// Sets the number of records; every column must have `count` rows.
  ColumnReader(Hdf5GroupReader group, std::size_t count) : group_(std::move(group)), count_(count) {}

  void set_row(std::size_t row) { row_ = row; }

  bool is_reading() const override { return true; }
  bool has(const char* name) const override { return group_.has(name); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override { group_.fail(name, problem); }
  void integers(const char* name, int* values, std::size_t count, Doc) override {
    const std::vector<int>& all = column(name, count, false, &Column::integers, &Hdf5GroupReader::integers).integers;
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(row_ * count), count, values);
  }
  void reals(const char* name, double* values, std::size_t count, Doc) override {
    const std::vector<double>& all = column(name, count, false, &Column::reals, &Hdf5GroupReader::reals).reals;
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(row_ * count), count, values);
  }
  void text(const char* name, std::string& value, Doc) override {
    value = column(name, 1, false, &Column::texts, &Hdf5GroupReader::texts).texts[row_];
  }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc) override {
    flat = slice(column(name, width, true, &Column::integers, &Hdf5GroupReader::integers), &Column::integers);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc) override {
    flat = slice(column(name, width, true, &Column::reals, &Hdf5GroupReader::reals), &Column::reals);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc) override {
    values = slice(column(name, 1, true, &Column::texts, &Hdf5GroupReader::texts), &Column::texts);
  }
  void object(const char* name, const std::function<void(Archive&)>&) override {
    fail(name, "is an object inside a record");
  }
  void records(const char* name, std::size_t, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    Nested& n = nested(name);
    const auto [begin, end] = range(n.offsets);
    resize(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      n.reader->set_row(i);
      each(*n.reader, i - begin);
    }
  }

  static std::size_t count_of(const Hdf5GroupReader& group) {
    const std::vector<int> count = group.integer_attribute("count");
    if (count.size() != 1 || count[0] < 0) group.fail("count", "must be one number, not negative (an attribute)");
    return static_cast<std::size_t>(count[0]);
  }

 private:
  struct Nested {
    std::string name;
    std::vector<int> offsets;
    std::unique_ptr<ColumnReader> reader;
  };

  template <typename T>
  Column& column(const char* name, std::size_t width, bool is_ragged, std::vector<T> Column::*values,
                 std::vector<T> (Hdf5GroupReader::*read)(const std::string&, std::size_t) const) {
    for (const auto& c : columns_)
      if (c->name == name) return *c;
    auto fresh = std::make_unique<Column>();
    fresh->name = name;
    fresh->width = width;
    (*fresh).*values = (group_.*read)(name, width);
    const std::size_t rows = ((*fresh).*values).size() / width;
    if (is_ragged) fresh->offsets = offsets_of(name, rows);
    if (!is_ragged && rows != count_)
      fail(name, fmt::format("has {} rows where the group's count is {}", rows, count_));
    columns_.push_back(std::move(fresh));
    return *columns_.back();
  }
  /// The count + 1 offsets of a ragged member: ascending from 0 to `rows`.
  std::vector<int> offsets_of(const char* name, std::size_t rows) const {
    const std::string offsets_name = std::string(name) + "_offsets";
    std::vector<int> offsets = group_.integers(offsets_name, 1);
    bool is_sound = offsets.size() == count_ + 1 && offsets.front() == 0;
    for (std::size_t i = 0; is_sound && i + 1 < offsets.size(); ++i) is_sound = offsets[i] <= offsets[i + 1];
    if (!is_sound || static_cast<std::size_t>(offsets.back()) != rows)
      group_.fail(offsets_name, fmt::format("must increase from 0 to {} in {} entries", rows, count_ + 1));
    return offsets;
  }
  Nested& nested(const char* name) {
    for (const auto& n : nested_)
      if (n->name == name) return *n;
    Hdf5GroupReader inner = group_.group(name);
    const std::vector<int> offsets = group_.integers(std::string(name) + "_offsets", 1);
    const std::size_t rows = offsets.empty() || offsets.back() < 0 ? 0 : static_cast<std::size_t>(offsets.back());
    nested_.push_back(std::make_unique<Nested>(
        Nested{name, offsets_of(name, rows), std::make_unique<ColumnReader>(std::move(inner), rows)}));
    return *nested_.back();
  }
  std::pair<std::size_t, std::size_t> range(const std::vector<int>& offsets) const {
    return {static_cast<std::size_t>(offsets[row_]), static_cast<std::size_t>(offsets[row_ + 1])};
  }
  template <typename T>
  std::vector<T> slice(const Column& c, std::vector<T> Column::*values) const {
    const auto [begin, end] = range(c.offsets);
    const auto first = (c.*values).begin();
    return {first + static_cast<std::ptrdiff_t>(begin * c.width), first + static_cast<std::ptrdiff_t>(end * c.width)};
  }

  Hdf5GroupReader group_;
  std::size_t count_ = 0, row_ = 0;
  std::vector<std::unique_ptr<Column>> columns_;
  std::vector<std::unique_ptr<Nested>> nested_;
};

}  // namespace

void write_columns(const Hdf5GroupWriter& parent, const char* name, std::size_t count, const Archive::Each& each) {
  ColumnWriter columns;
  if (count == 0) columns.declare(each);
  for (std::size_t i = 0; i < count; ++i) each(columns, i);
  const Hdf5GroupWriter group = parent.group(name);
  group.integer_attribute("count", {static_cast<int>(count)});
  columns.write(group);
}

void read_columns(const Hdf5GroupReader& parent, const char* name, const std::function<void(std::size_t)>& resize,
                  const Archive::Each& each) {
  Hdf5GroupReader group = parent.group(name);
  const std::size_t count = ColumnReader::count_of(group);
  ColumnReader columns(std::move(group), count);
  // The first record reads the columns and so proves that `count` rows exist before memory for them is allocated.
  if (count > 0) {
    resize(1);
    columns.set_row(0);
    each(columns, 0);
  }
  resize(count);
  for (std::size_t i = 1; i < count; ++i) {
    columns.set_row(i);
    each(columns, i);
  }
}

}  // namespace quadrille::io
