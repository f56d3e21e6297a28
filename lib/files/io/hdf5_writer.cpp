// The writing half of hdf5_file.hpp, and what it has in common with the other one.

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "base/error.hpp"
#include "io/digest.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

void require_memory(std::size_t bytes) {
  void* const volatile memory = std::malloc(bytes);  // volatile: a compiler may leave out what is not used
  if (memory == nullptr) throw std::bad_alloc();
  std::free(memory);
}

bool lacks_memory() {
  bool is_found = false;
  const auto look = [](unsigned, const H5E_error2_t* error, void* found) -> herr_t {
    *static_cast<bool*>(found) |= error->maj_num == H5E_RESOURCE && error->min_num == H5E_NOSPACE;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &is_found);
  return is_found;
}

namespace {

Hdf5Id checked(hid_t id, Hdf5Id::Close close, const std::string& what) {
  if (id < 0 && lacks_memory()) throw std::bad_alloc();
  if (id < 0) throw OutputError(fmt::format("HDF5 cannot create {}", what));
  return {id, close};
}

void check(herr_t status, const std::string& what) {
  if (status < 0 && lacks_memory()) throw std::bad_alloc();
  if (status < 0) throw OutputError(fmt::format("HDF5 cannot write {}", what));
}

// A data set is written into an image in memory: what fails there is an allocation, which the library does not report.
void check_data(herr_t status) {
  if (status < 0) throw std::bad_alloc();
}

Hdf5Id space_of(const Hdf5GroupWriter::Shape& shape) {
  if (shape.empty()) return checked(H5Screate(H5S_SCALAR), H5Sclose, "a data space");
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  return checked(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose, "a data space");
}

/// Fixed-length UTF-8, padded with zeros: h5dump, Fortran and MATLAB read these without conversion.
Hdf5Id text_type(std::size_t size) {
  Hdf5Id type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "a string type");
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

void write_attribute(hid_t owner, const std::string& name, hid_t file_type, hid_t memory_type, const Hdf5Id& space,
                     const void* data) {
  const Hdf5Id attribute = checked(H5Acreate2(owner, name.c_str(), file_type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                                   H5Aclose, "attribute " + name);
  check(H5Awrite(attribute.get(), memory_type, data), "attribute " + name);
}

void write_text_attribute(hid_t owner, const std::string& name, const std::string& value) {
  const Hdf5Id type = text_type(value.size());
  write_attribute(owner, name, type.get(), type.get(), space_of({}), value.empty() ? "\0" : value.data());
}

/// Small data live in the object header: no block of their own, and one read less.
constexpr std::size_t compact_limit = 8192;

void write_dataset(hid_t group, const std::string& path, const std::string& name, hid_t file_type, hid_t memory_type,
                   const Hdf5GroupWriter::Shape& shape, const void* data, const char* units, const char* long_name) {
  const Hdf5Id properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
  H5Pset_obj_track_times(properties.get(), false);
  std::size_t bytes = H5Tget_size(file_type);
  for (const std::size_t n : shape) bytes *= n;
  require_memory(bytes + own_memory_of_call);
  if (bytes > 0 && bytes <= compact_limit) H5Pset_layout(properties.get(), H5D_COMPACT);
  const Hdf5Id space = space_of(shape);
  const Hdf5Id dataset =
      checked(H5Dcreate2(group, name.c_str(), file_type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
              H5Dclose, "dataset " + path + name);
  if (bytes > 0) check_data(H5Dwrite(dataset.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  if (*units) write_text_attribute(dataset.get(), "units", units);
  if (*long_name) write_text_attribute(dataset.get(), "long_name", long_name);
}

/// All links of a group stay in its header; the default would move more than eight into a heap.
void keep_compact(hid_t properties) {
  H5Pset_obj_track_times(properties, false);
  H5Pset_link_phase_change(properties, 64, 32);
}

}  // namespace

Hdf5GroupWriter Hdf5GroupWriter::group(const std::string& name) const {
  const Hdf5Id properties = checked(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "properties");
  keep_compact(properties.get());
  return {checked(H5Gcreate2(group_.get(), name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Gclose,
                  "group " + path_ + name),
          path_ + name + '/'};
}

void Hdf5GroupWriter::integers(const std::string& name, const int* values, const Shape& shape, const char* units,
                               const char* long_name) const {
  write_dataset(group_.get(), path_, name, H5T_STD_I32LE, H5T_NATIVE_INT, shape, values, units, long_name);
}

void Hdf5GroupWriter::reals(const std::string& name, const double* values, const Shape& shape, const char* units,
                            const char* long_name) const {
  write_dataset(group_.get(), path_, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, shape, values, units, long_name);
}

void Hdf5GroupWriter::texts(const std::string& name, const std::vector<std::string>& values, bool is_scalar,
                            const char* units, const char* long_name) const {
  std::size_t width = 1;
  for (const std::string& value : values) width = std::max(width, value.size());
  std::string padded;
  for (const std::string& value : values) padded += value + std::string(width - value.size(), '\0');
  const Hdf5Id type = text_type(width);
  const Shape shape = is_scalar ? Shape{} : Shape{values.size()};
  write_dataset(group_.get(), path_, name, type.get(), type.get(), shape, padded.data(), units, long_name);
}

void Hdf5GroupWriter::text_attribute(const std::string& name, const std::string& value) const {
  write_text_attribute(group_.get(), name, value);
}

void Hdf5GroupWriter::integer_attribute(const std::string& name, const std::vector<int>& values) const {
  write_attribute(group_.get(), name, H5T_STD_I32LE, H5T_NATIVE_INT, space_of({values.size()}), values.data());
}

Hdf5Writer::Hdf5Writer() {
  require_memory(own_memory_of_file);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Id access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "properties");
  H5Pset_fapl_core(access.get(), 1 << 18, false);
  // The earliest layout: H5Fget_file_image spoils the checksum that later superblocks carry.
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
  const Hdf5Id creation = checked(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "properties");
  keep_compact(creation.get());
  file_ = checked(H5Fcreate(image_name, H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose, "a file image");
  root_ = std::make_unique<Hdf5GroupWriter>(checked(H5Gopen2(file_.get(), "/", H5P_DEFAULT), H5Gclose, "/"), "");
}

std::string Hdf5Writer::image() {
  root_.reset();
  check_data(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  if (size <= 0) throw OutputError("HDF5 cannot write a file image");
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(size) + checksum_size);
  bytes.resize(static_cast<std::size_t>(size));
  if (H5Fget_file_image(file_.get(), bytes.data(), bytes.size()) != size)
    throw OutputError("HDF5 cannot write a file image");
  file_ = {};
  return bytes;
}

}  // namespace quadrille::io
