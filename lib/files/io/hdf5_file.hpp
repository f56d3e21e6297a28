#pragma once
// HDF5 files as images in memory, over the C API: groups, datasets and attributes of the few types that the formats
// use. Private to io; no HDF5 type is exposed. Readers throw FormatError naming file and dataset, writers OutputError.
//
// The same content results in the same bytes: no time stamps, fixed library version bounds, contiguous datasets.
//
// First what readers and writers know of libhdf5: where it keeps an image, and what happens without memory.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille::io {

/// The library looks for a file of this name, although all of it is in memory: there can be none.
constexpr const char* image_name = "/dev/null/image";

/// Bytes that libhdf5 needs beside the data: its tables and the cache of a file; in one call, buffers.
constexpr std::size_t own_memory_of_file = 8 << 20, own_memory_of_call = 4 << 20;

/// Throws std::bad_alloc if there is no such memory: libhdf5 crashes where it gets none.
void require_memory(std::size_t bytes);

/// Whether the last call of the library failed for want of memory.
bool lacks_memory();

/// An HDF5 identifier that is closed when it goes out of scope.
class Hdf5Id {
 public:
  using Close = int (*)(std::int64_t);
  Hdf5Id() = default;
  Hdf5Id(std::int64_t id, Close close) : id_(id), close_(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Hdf5Id& operator=(Hdf5Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Id() {
    if (id_ >= 0 && close_) close_(id_);
  }
  std::int64_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// A group being written. `shape` of a dataset: {} for one value, {n}, or {n, width}.
class Hdf5GroupWriter {
 public:
  using Shape = std::vector<std::size_t>;
  Hdf5GroupWriter(Hdf5Id group, std::string path) : group_(std::move(group)), path_(std::move(path)) {}

  Hdf5GroupWriter group(const std::string& name) const;
  void integers(const std::string& name, const int* values, const Shape& shape, const char* units,
                const char* long_name) const;
  void reals(const std::string& name, const double* values, const Shape& shape, const char* units,
             const char* long_name) const;
  void texts(const std::string& name, const std::vector<std::string>& values, bool is_scalar, const char* units,
             const char* long_name) const;
  void text_attribute(const std::string& name, const std::string& value) const;
  void integer_attribute(const std::string& name, const std::vector<int>& values) const;

 private:
  Hdf5Id group_;
  std::string path_;
};

class Hdf5Writer {
 public:
  Hdf5Writer();
  const Hdf5GroupWriter& root() const { return *root_; }
  /// Closes the file and returns its bytes.
  std::string image();

 private:
  Hdf5Id file_;
  std::unique_ptr<Hdf5GroupWriter> root_;
};

/// A group being read. Lists are checked for their class (integer, number, string) and shape [n] or [n, width].
class Hdf5GroupReader {
 public:
  /// `room`: bytes that may still be read of the file, all groups together.
  Hdf5GroupReader(Hdf5Id group, std::string file, std::string path, std::shared_ptr<std::uint64_t> room)
      : group_(std::move(group)), file_(std::move(file)), path_(std::move(path)), room_(std::move(room)) {}

  [[noreturn]] void fail(const std::string& name, const std::string& problem) const;
  Hdf5GroupReader group(const std::string& name) const;
  /// width 0: one value; 1: [n]; else [n, width].
  std::vector<int> integers(const std::string& name, std::size_t width) const;
  std::vector<double> reals(const std::string& name, std::size_t width) const;
  std::vector<std::string> texts(const std::string& name, std::size_t width) const;
  bool has(const std::string& name) const;  ///< a dataset or group of that name
  bool has_attribute(const std::string& name) const;
  std::string text_attribute(const std::string& name) const;
  std::vector<int> integer_attribute(const std::string& name) const;
  /// Fails if `count` values of `size` bytes are more than such a file can hold; before memory for them is allocated.
  void take(const std::string& name, std::uint64_t count, std::uint64_t size) const;

 private:
  Hdf5Id group_;
  std::string file_, path_;
  std::shared_ptr<std::uint64_t> room_;
};

/// Reads from `bytes`, which must outlive it.
class Hdf5Reader {
 public:
  Hdf5Reader(std::string_view bytes, const std::string& file_name);
  const Hdf5GroupReader& root() const { return *root_; }

 private:
  std::unique_ptr<std::string_view> image_;  ///< what the library's callbacks refer to
  Hdf5Id file_;
  std::unique_ptr<Hdf5GroupReader> root_;
};

/// Whether the bytes begin with the signature of an HDF5 file.
bool looks_like_hdf5(const std::string& bytes);

}  // namespace quadrille::io
