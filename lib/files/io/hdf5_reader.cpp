// The reading half of hdf5_file.hpp.

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "base/error.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

namespace {

/// Deflate compresses at most 1032 to 1: a dataset that declares more than its storage can contain is refused.
constexpr hsize_t best_compression = 1040;

/// Whether the link leads to an object in this very file: soft and external links are not part of the formats.
bool is_hard_link(hid_t group, const std::string& name) {
  H5L_info_t info{};
  return H5Lget_info(group, name.c_str(), &info, H5P_DEFAULT) >= 0 && info.type == H5L_TYPE_HARD;
}

/// External storage and virtual datasets have their values in other files.
bool has_values_of_its_own(hid_t dataset) {
  const Hdf5Id properties = Hdf5Id(H5Dget_create_plist(dataset), H5Pclose);
  return properties && H5Pget_external_count(properties.get()) == 0 && H5Pget_layout(properties.get()) != H5D_VIRTUAL;
}

struct Dataset {
  Hdf5Id id, type;
  std::size_t count = 0;  ///< of all values
};

Dataset open_dataset(const Hdf5GroupReader& reader, hid_t group, const std::string& name, std::size_t width) {
  require_memory(own_memory_of_call);
  if (!is_hard_link(group, name)) reader.fail(name, "is missing");
  Dataset data;
  data.id = Hdf5Id(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.id) reader.fail(name, "is not a dataset, or damaged");
  if (!has_values_of_its_own(data.id.get())) reader.fail(name, "has its values in another file, which is not read");
  data.type = Hdf5Id(H5Dget_type(data.id.get()), H5Tclose);
  const Hdf5Id space = Hdf5Id(H5Dget_space(data.id.get()), H5Sclose);
  if (!data.type || !space) reader.fail(name, "is damaged");
  hsize_t sizes[2] = {1, 1};
  const int expected_rank = width == 0 ? 0 : width == 1 ? 1 : 2;
  if (H5Sget_simple_extent_ndims(space.get()) != expected_rank ||
      H5Sget_simple_extent_dims(space.get(), sizes, nullptr) < 0 || (width > 1 && sizes[1] != width))
    reader.fail(name, width == 0   ? "must be one value"
                      : width == 1 ? "must have the shape [n]"
                                   : fmt::format("must have the shape [n, {}]", width));
  const hsize_t stored = H5Dget_storage_size(data.id.get());
  const hsize_t size = H5Tget_size(data.type.get());
  if (sizes[0] > 0 && (size == 0 || sizes[0] > best_compression * stored / size + 1))
    reader.fail(name, "is larger than the file");
  reader.take(name, sizes[0] * sizes[1], std::max<hsize_t>(size, 8));
  data.count = sizes[0] * sizes[1];
  return data;
}

template <typename T>
std::vector<T> read_numbers(const Hdf5GroupReader& reader, hid_t group, const std::string& name, std::size_t width,
                            hid_t memory_type, bool are_integers) {
  const Dataset data = open_dataset(reader, group, name, width);
  const H5T_class_t kind = H5Tget_class(data.type.get());
  if (kind != H5T_INTEGER && (are_integers || kind != H5T_FLOAT))
    reader.fail(name, are_integers ? "must contain integers" : "must contain numbers");
  std::vector<T> values(data.count);
  if (data.count > 0 && H5Dread(data.id.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    reader.fail(name, "cannot be read: damaged");
  return values;
}

/// Strings of variable length, as h5py and other writers store them.
template <typename Read>
std::vector<std::string> variable_texts(std::size_t count, const Hdf5Id& type, hid_t space, const Read& read) {
  std::vector<char*> pointers(count, nullptr);
  if (!read(pointers.data())) return {};
  std::vector<std::string> values;
  for (const char* p : pointers) values.emplace_back(p ? p : "");
  H5Dvlen_reclaim(type.get(), space, H5P_DEFAULT, pointers.data());
  return values;
}

std::vector<std::string> fixed_texts(const std::string& padded, std::size_t width, std::size_t count) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string item = padded.substr(i * width, width);
    values.push_back(item.substr(0, item.find('\0')));
  }
  return values;
}

// The library makes a copy of an image for each of its own objects. These callbacks pass on the image itself, which a
// file opened for reading does not change (HDF5 File Image Operations, sec. 4.3).
H5FD_file_image_callbacks_t sharing(std::string_view& image) {
  H5FD_file_image_callbacks_t callbacks{};
  callbacks.udata = &image;
  callbacks.udata_copy = [](void* udata) { return udata; };
  callbacks.udata_free = [](void*) -> herr_t { return 0; };
  callbacks.image_malloc = [](std::size_t size, H5FD_file_image_op_t, void* udata) -> void* {
    const auto& shared = *static_cast<std::string_view*>(udata);
    return size == shared.size() ? const_cast<char*>(shared.data()) : nullptr;
  };
  callbacks.image_memcpy = [](void* to, const void* from, std::size_t, H5FD_file_image_op_t, void*) -> void* {
    return to == from ? to : nullptr;
  };
  callbacks.image_realloc = [](void*, std::size_t, H5FD_file_image_op_t, void*) -> void* { return nullptr; };
  callbacks.image_free = [](void*, H5FD_file_image_op_t, void*) -> herr_t { return 0; };
  return callbacks;
}

}  // namespace

void Hdf5GroupReader::fail(const std::string& name, const std::string& problem) const {
  if (lacks_memory()) throw std::bad_alloc();
  throw FormatError(fmt::format("{}: '{}{}' {}", file_, path_, name, problem));
}

void Hdf5GroupReader::take(const std::string& name, std::uint64_t count, std::uint64_t size) const {
  if (size > 0 && count > *room_ / size) fail(name, "is larger than the file");
  *room_ -= count * size;
}

Hdf5GroupReader Hdf5GroupReader::group(const std::string& name) const {
  if (!is_hard_link(group_.get(), name)) fail(name, "is missing");
  Hdf5Id id = Hdf5Id(H5Gopen2(group_.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id) fail(name, "is not a group, or damaged");
  return {std::move(id), file_, path_ + name + '/', room_};
}

std::vector<int> Hdf5GroupReader::integers(const std::string& name, std::size_t width) const {
  return read_numbers<int>(*this, group_.get(), name, width, H5T_NATIVE_INT, true);
}

std::vector<double> Hdf5GroupReader::reals(const std::string& name, std::size_t width) const {
  return read_numbers<double>(*this, group_.get(), name, width, H5T_NATIVE_DOUBLE, false);
}

std::vector<std::string> Hdf5GroupReader::texts(const std::string& name, std::size_t width) const {
  const Dataset data = open_dataset(*this, group_.get(), name, width);
  if (H5Tget_class(data.type.get()) != H5T_STRING) fail(name, "must contain strings");
  const auto read = [&](void* to) {
    return H5Dread(data.id.get(), data.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, to) >= 0;
  };
  if (data.count == 0) return {};
  if (H5Tis_variable_str(data.type.get()) > 0) {
    const Hdf5Id space = Hdf5Id(H5Dget_space(data.id.get()), H5Sclose);
    auto values = variable_texts(data.count, data.type, space.get(), read);
    if (values.empty()) fail(name, "cannot be read: damaged");
    return values;
  }
  const std::size_t width_of_one = H5Tget_size(data.type.get());
  std::string padded(width_of_one * data.count, '\0');
  if (!read(padded.data())) fail(name, "cannot be read: damaged");
  return fixed_texts(padded, width_of_one, data.count);
}

bool Hdf5GroupReader::has(const std::string& name) const {
  return H5Lexists(group_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5GroupReader::has_attribute(const std::string& name) const { return H5Aexists(group_.get(), name.c_str()) > 0; }

std::string Hdf5GroupReader::text_attribute(const std::string& name) const {
  if (!has_attribute(name)) fail(name, "is missing (an attribute)");
  const Hdf5Id id = Hdf5Id(H5Aopen(group_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Id type = Hdf5Id(id ? H5Aget_type(id.get()) : -1, H5Tclose);
  const Hdf5Id space = Hdf5Id(id ? H5Aget_space(id.get()) : -1, H5Sclose);
  if (!type || !space || H5Tget_class(type.get()) != H5T_STRING || H5Sget_simple_extent_npoints(space.get()) != 1)
    fail(name, "must be a string (an attribute)");
  const auto read = [&](void* to) { return H5Aread(id.get(), type.get(), to) >= 0; };
  std::vector<std::string> values;
  if (H5Tis_variable_str(type.get()) > 0) {
    values = variable_texts(1, type, space.get(), read);
  } else {
    const std::size_t size = H5Tget_size(type.get());
    take(name, 1, size);
    std::string padded(size, '\0');
    if (H5Aget_storage_size(id.get()) >= size && read(padded.data())) values = fixed_texts(padded, size, 1);
  }
  if (values.empty()) fail(name, "cannot be read: damaged (an attribute)");
  return values.front();
}

std::vector<int> Hdf5GroupReader::integer_attribute(const std::string& name) const {
  if (!has_attribute(name)) fail(name, "is missing (an attribute)");
  const Hdf5Id id = Hdf5Id(H5Aopen(group_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Id type = Hdf5Id(id ? H5Aget_type(id.get()) : -1, H5Tclose);
  const Hdf5Id space = Hdf5Id(id ? H5Aget_space(id.get()) : -1, H5Sclose);
  const hssize_t count = space ? H5Sget_simple_extent_npoints(space.get()) : -1;
  if (!type || H5Tget_class(type.get()) != H5T_INTEGER || count < 0 || count > 16)
    fail(name, "must contain integers (an attribute)");
  std::vector<int> values(static_cast<std::size_t>(count));
  if (count > 0 && H5Aread(id.get(), H5T_NATIVE_INT, values.data()) < 0) fail(name, "cannot be read: damaged");
  return values;
}

bool looks_like_hdf5(const std::string& bytes) { return bytes.compare(0, 8, "\x89HDF\r\n\x1a\n") == 0; }

Hdf5Reader::Hdf5Reader(std::string_view bytes, const std::string& file_name)
    : image_(std::make_unique<std::string_view>(bytes)) {
  require_memory(own_memory_of_file);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Id access = Hdf5Id(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.get(), 1 << 18, false);
  H5FD_file_image_callbacks_t callbacks = sharing(*image_);
  H5Pset_file_image_callbacks(access.get(), &callbacks);
  H5Pset_file_image(access.get(), const_cast<char*>(bytes.data()), bytes.size());
  file_ = Hdf5Id(H5Fopen(image_name, H5F_ACC_RDONLY, access.get()), H5Fclose);
  Hdf5Id root = Hdf5Id(file_ ? H5Gopen2(file_.get(), "/", H5P_DEFAULT) : -1, H5Gclose);
  if (!root && lacks_memory()) throw std::bad_alloc();
  if (!root) throw FormatError(fmt::format("{}: truncated or damaged: HDF5 cannot open it", file_name));
  // Any file of ours, and compressed ones as other programs write them, but no bomb.
  const std::uint64_t room = (std::uint64_t{64} << 20) + 16 * bytes.size();
  root_ = std::make_unique<Hdf5GroupReader>(std::move(root), file_name, "", std::make_shared<std::uint64_t>(room));
}

}  // namespace quadrille::io
