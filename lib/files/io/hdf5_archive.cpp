#include "io/hdf5_archive.hpp"

#include <fmt/format.h>

#include <deque>
#include <memory>
#include <variant>

#include "base/error.hpp"

namespace quadrille::io {

namespace {

using Shape = Hdf5GroupWriter::Shape;

void write(const Hdf5GroupWriter& group, const std::string& name, const int* values, const Shape& shape, Doc doc) {
  group.integers(name, values, shape, doc.units, doc.long_name);
}
void write(const Hdf5GroupWriter& group, const std::string& name, const double* values, const Shape& shape, Doc doc) {
  group.reals(name, values, shape, doc.units, doc.long_name);
}
void write(const Hdf5GroupWriter& group, const std::string& name, const std::string* values, const Shape& shape,
           Doc doc) {
  const std::size_t count = shape.empty() ? 1 : shape[0];
  group.texts(name, {values, values + count}, shape.empty(), doc.units, doc.long_name);
}

template <typename T>
void write_list(const Hdf5GroupWriter& group, const std::string& name, const std::vector<T>& flat, std::size_t width,
                Doc doc) {
  write(group, name, flat.data(), width == 1 ? Shape{flat.size()} : Shape{flat.size() / width, width}, doc);
}

template <typename T>
std::vector<T> read(const Hdf5GroupReader& group, const std::string& name, std::size_t width) {
  if constexpr (std::is_same_v<T, int>)
    return group.integers(name, width);
  else if constexpr (std::is_same_v<T, double>)
    return group.reals(name, width);
  else
    return group.texts(name, width);
}

/// What writers have in common.
template <typename Derived>
class WritingArchive : public TypedArchive<Derived> {
 public:
  bool is_reading() const override { return false; }
  bool has(const char*) const override { return true; }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw Defect(fmt::format("'{}' {}", name, problem));
  }
};

class GroupWriter : public WritingArchive<GroupWriter> {
 public:
  explicit GroupWriter(const Hdf5GroupWriter& group) : group_(group) {}

  template <typename T>
  void fixed(const char* name, const T* values, std::size_t count, Doc doc) {
    write(group_, name, values, count == 1 ? Shape{} : Shape{count}, doc);
  }
  template <typename T>
  void list(const char* name, const std::vector<T>& flat, std::size_t width, Doc doc) {
    write_list(group_, name, flat, width, doc);
  }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    const Hdf5GroupWriter inner = group_.group(name);
    GroupWriter writer(inner);
    describe(writer);
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>&,
               const Each& each) override {
    write_columns(group_, name, count, each);
  }

 private:
  const Hdf5GroupWriter& group_;
};

class GroupReader : public TypedArchive<GroupReader> {
 public:
  explicit GroupReader(const Hdf5GroupReader& group) : group_(group) {}

  bool is_reading() const override { return true; }
  bool has(const char* name) const override { return group_.has(name); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override { group_.fail(name, problem); }
  template <typename T>
  void fixed(const char* name, T* values, std::size_t count, Doc) {
    const std::vector<T> from = read<T>(group_, name, count == 1 ? 0 : 1);
    if (from.size() != count) fail(name, fmt::format("must have {} values", count));
    std::copy(from.begin(), from.end(), values);
  }
  template <typename T>
  void list(const char* name, std::vector<T>& flat, std::size_t width, Doc) {
    flat = read<T>(group_, name, width);
  }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    const Hdf5GroupReader inner = group_.group(name);
    GroupReader reader(inner);
    describe(reader);
  }
  void records(const char* name, std::size_t, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    read_columns(group_, name, resize, each);
  }

 private:
  const Hdf5GroupReader& group_;
};

/// `Nested`: of records inside records.
template <typename Nested>
struct Column {
  std::string name;
  Doc doc;
  std::size_t width = 1;
  bool is_ragged = false;
  std::variant<std::vector<int>, std::vector<double>, std::vector<std::string>, std::unique_ptr<Nested>> values;
  std::vector<int> offsets{0};  ///< in rows
};

class ColumnWriter : public WritingArchive<ColumnWriter> {
 public:
  template <typename T>
  void fixed(const char* name, const T* values, std::size_t count, Doc doc) {
    append(column<std::vector<T>>(name, count, false, doc), values, count);
  }
  template <typename T>
  void list(const char* name, const std::vector<T>& flat, std::size_t width, Doc doc) {
    OneColumn& c = column<std::vector<T>>(name, width, true, doc);
    append(c, flat.data(), flat.size());
    end_row(c, std::get<std::vector<T>>(c.values).size() / width);
  }
  void object(const char* name, const std::function<void(Archive&)>&) override {
    fail(name, "is an object inside a record");
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>&,
               const Each& each) override {
    OneColumn& c = column<std::unique_ptr<ColumnWriter>>(name, 1, true, {});
    auto& nested = std::get<std::unique_ptr<ColumnWriter>>(c.values);
    if (!nested) nested = std::make_unique<ColumnWriter>();
    if (is_declaring_ || count == 0)
      nested->declare(each);
    else
      for (std::size_t i = 0; i < count; ++i) each(*nested, i);
    end_row(c, static_cast<std::size_t>(c.offsets.back()) + count);
  }

  /// Declares the columns from one empty record.
  void declare(const Each& each) {
    is_declaring_ = true;
    each(*this, declared);
    is_declaring_ = false;
  }
  void write_to(const Hdf5GroupWriter& group) const {
    for (const OneColumn& c : columns_) {
      if (c.is_ragged) write_list(group, c.name + "_offsets", c.offsets, 1, {});
      std::visit(
          [&]<typename Values>(const Values& values) {
            if constexpr (std::is_same_v<Values, std::unique_ptr<ColumnWriter>>)
              values->write_to(group.group(c.name));
            else
              write_list(group, c.name, values, c.width, c.doc);
          },
          c.values);
    }
  }

 private:
  using OneColumn = Column<ColumnWriter>;

  template <typename Values>
  OneColumn& column(const char* name, std::size_t width, bool is_ragged, Doc doc) {
    for (OneColumn& c : columns_)
      if (c.name == name) return c;
    return columns_.emplace_back(OneColumn{name, doc, width, is_ragged, Values(), {0}});
  }
  template <typename T>
  void append(OneColumn& c, const T* from, std::size_t count) const {
    auto& values = std::get<std::vector<T>>(c.values);
    if (!is_declaring_) values.insert(values.end(), from, from + count);
  }
  void end_row(OneColumn& c, std::size_t rows) const {
    if (!is_declaring_) c.offsets.push_back(static_cast<int>(rows));
  }

  std::deque<OneColumn> columns_;
  bool is_declaring_ = false;
};

class ColumnReader : public TypedArchive<ColumnReader> {
 public:
  /// Sets the number of records; every column must have `count` rows.
  ColumnReader(Hdf5GroupReader group, std::size_t count) : group_(std::move(group)), count_(count) {}

  void set_row(std::size_t row) { row_ = row; }

  bool is_reading() const override { return true; }
  bool has(const char* name) const override { return group_.has(name); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override { group_.fail(name, problem); }
  template <typename T>
  void fixed(const char* name, T* values, std::size_t count, Doc) {
    const auto& all = std::get<std::vector<T>>(column<T>(name, count, false).values);
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(row_ * count), count, values);
  }
  template <typename T>
  void list(const char* name, std::vector<T>& flat, std::size_t width, Doc) {
    const OneColumn& c = column<T>(name, width, true);
    const auto [begin, end] = range(c);
    const auto first = std::get<std::vector<T>>(c.values).begin();
    flat.assign(first + static_cast<std::ptrdiff_t>(begin * width), first + static_cast<std::ptrdiff_t>(end * width));
  }
  void object(const char* name, const std::function<void(Archive&)>&) override {
    fail(name, "is an object inside a record");
  }
  void records(const char* name, std::size_t, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    OneColumn& c = nested(name);
    ColumnReader& reader = *std::get<std::unique_ptr<ColumnReader>>(c.values);
    const auto [begin, end] = range(c);
    resize(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      reader.set_row(i);
      each(reader, i - begin);
    }
  }

  static std::size_t count_of(const Hdf5GroupReader& group) {
    const std::vector<int> count = group.integer_attribute("count");
    if (count.size() != 1 || count[0] < 0) group.fail("count", "must be one number, not negative (an attribute)");
    return static_cast<std::size_t>(count[0]);
  }

 private:
  using OneColumn = Column<ColumnReader>;

  OneColumn* known(const char* name) {
    for (OneColumn& c : columns_)
      if (c.name == name) return &c;
    return nullptr;
  }
  template <typename T>
  OneColumn& column(const char* name, std::size_t width, bool is_ragged) {
    if (OneColumn* c = known(name)) return *c;
    std::vector<T> values = read<T>(group_, name, width);
    const std::size_t rows = values.size() / width;
    if (!is_ragged && rows != count_)
      fail(name, fmt::format("has {} rows where the group's count is {}", rows, count_));
    std::vector<int> offsets = is_ragged ? offsets_of(name, rows) : std::vector<int>();
    return columns_.emplace_back(OneColumn{name, {}, width, is_ragged, std::move(values), std::move(offsets)});
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
  OneColumn& nested(const char* name) {
    if (OneColumn* c = known(name)) return *c;
    Hdf5GroupReader inner = group_.group(name);
    const std::vector<int> offsets = group_.integers(std::string(name) + "_offsets", 1);
    const std::size_t rows = offsets.empty() || offsets.back() < 0 ? 0 : static_cast<std::size_t>(offsets.back());
    auto reader = std::make_unique<ColumnReader>(std::move(inner), rows);
    return columns_.emplace_back(OneColumn{name, {}, 1, true, std::move(reader), offsets_of(name, rows)});
  }
  std::pair<std::size_t, std::size_t> range(const OneColumn& c) const {
    return {static_cast<std::size_t>(c.offsets[row_]), static_cast<std::size_t>(c.offsets[row_ + 1])};
  }

  Hdf5GroupReader group_;
  std::size_t count_ = 0, row_ = 0;
  std::deque<OneColumn> columns_;
};

}  // namespace

std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupWriter& group) { return std::make_unique<GroupWriter>(group); }
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupReader& group) { return std::make_unique<GroupReader>(group); }

void write_columns(const Hdf5GroupWriter& parent, const char* name, std::size_t count, const Archive::Each& each) {
  ColumnWriter columns;
  if (count == 0) columns.declare(each);
  for (std::size_t i = 0; i < count; ++i) each(columns, i);
  const Hdf5GroupWriter group = parent.group(name);
  group.integer_attribute("count", {static_cast<int>(count)});
  columns.write_to(group);
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
