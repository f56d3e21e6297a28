#include "io/hdf5_archive.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/hdf5_columns.hpp"

namespace quadrille::io {

namespace {

class Writer : public Archive {
 public:
  explicit Writer(const Hdf5GroupWriter& group) : group_(group) {}

  bool is_reading() const override { return false; }
  bool has(const char*) const override { return true; }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    throw Defect(fmt::format("'{}' {}", name, problem));
  }
  void integers(const char* name, int* values, std::size_t count, Doc doc) override {
    group_.integers(name, values, fixed_shape(count), doc.units, doc.long_name);
  }
  void reals(const char* name, double* values, std::size_t count, Doc doc) override {
    group_.reals(name, values, fixed_shape(count), doc.units, doc.long_name);
  }
  void text(const char* name, std::string& value, Doc doc) override {
    group_.texts(name, {value}, true, doc.units, doc.long_name);
  }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc doc) override {
    group_.integers(name, flat.data(), list_shape(flat.size(), width), doc.units, doc.long_name);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc doc) override {
    group_.reals(name, flat.data(), list_shape(flat.size(), width), doc.units, doc.long_name);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc doc) override {
    group_.texts(name, values, false, doc.units, doc.long_name);
  }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    const Hdf5GroupWriter inner = group_.group(name);
    Writer writer(inner);
    describe(writer);
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>&,
               const Each& each) override {
    write_columns(group_, name, count, each);
  }

 private:
  static Hdf5GroupWriter::Shape fixed_shape(std::size_t count) {
    return count == 1 ? Hdf5GroupWriter::Shape{} : Hdf5GroupWriter::Shape{count};
  }
  static Hdf5GroupWriter::Shape list_shape(std::size_t count, std::size_t width) {
    return width == 1 ? Hdf5GroupWriter::Shape{count} : Hdf5GroupWriter::Shape{count / width, width};
  }

  const Hdf5GroupWriter& group_;
};

class Reader : public Archive {
 public:
  explicit Reader(const Hdf5GroupReader& group) : group_(group) {}

  bool is_reading() const override { return true; }
  bool has(const char* name) const override { return group_.has(name); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override { group_.fail(name, problem); }
  void integers(const char* name, int* values, std::size_t count, Doc) override {
    copy_fixed(name, group_.integers(name, count == 1 ? 0 : 1), values, count);
  }
  void reals(const char* name, double* values, std::size_t count, Doc) override {
    copy_fixed(name, group_.reals(name, count == 1 ? 0 : 1), values, count);
  }
  void text(const char* name, std::string& value, Doc) override { value = group_.texts(name, 0).front(); }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc) override {
    flat = group_.integers(name, width);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc) override {
    flat = group_.reals(name, width);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc) override { values = group_.texts(name, 1); }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    const Hdf5GroupReader inner = group_.group(name);
    Reader reader(inner);
    describe(reader);
  }
  void records(const char* name, std::size_t, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    read_columns(group_, name, resize, each);
  }

 private:
  template <typename T>
  void copy_fixed(const char* name, const std::vector<T>& from, T* to, std::size_t count) const {
    if (from.size() != count) fail(name, fmt::format("must have {} values", count));
    std::copy(from.begin(), from.end(), to);
  }

  const Hdf5GroupReader& group_;
};

}  // namespace

std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupWriter& group) { return std::make_unique<Writer>(group); }
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupReader& group) { return std::make_unique<Reader>(group); }

}  // namespace quadrille::io
