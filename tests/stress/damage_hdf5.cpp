// Damages one value, shape, type or name of an HDF5 stage file, for tests/stress/damaged_files.
//
//     damage_hdf5 FILE SEED OUT
//
// Prints what was done. The same seed damages the same file in the same way. The output has the right checksum, so that
// the damage is seen by whoever reads the values, not by the checksum.

#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/digest.hpp"
#include "io/hdf5_file.hpp"

namespace {

using quadrille::io::Hdf5Id;
using Names = std::vector<std::string>;

Hdf5Id checked(hid_t id, Hdf5Id::Close close, const std::string& what) {
  if (id < 0) throw std::runtime_error("cannot open or create " + what);
  return {id, close};
}

void check(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error("cannot change " + what);
}

/// Whole numbers from a fixed sequence; not std::uniform_int_distribution, which differs between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  template <typename T>
  T one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

 private:
  std::mt19937_64 engine_;
};

struct Dataset {
  std::string name;
  Hdf5Id id, type, space;
  std::vector<hsize_t> sizes;
  std::size_t count = 0;  ///< of all values
  H5T_class_t kind() const { return H5Tget_class(type.get()); }
};

Dataset open_dataset(hid_t file, const std::string& name) {
  Dataset data;
  data.name = name;
  data.id = checked(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name);
  data.type = checked(H5Dget_type(data.id.get()), H5Tclose, name);
  data.space = checked(H5Dget_space(data.id.get()), H5Sclose, name);
  data.sizes.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(data.space.get())));
  if (!data.sizes.empty()) H5Sget_simple_extent_dims(data.space.get(), data.sizes.data(), nullptr);
  data.count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(data.space.get()));
  return data;
}

std::vector<double> numbers_of(const Dataset& data) {
  std::vector<double> values(data.count);
  if (data.count > 0)
    check(H5Dread(data.id.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), data.name);
  return values;
}

/// A dataset of that name in the place of the one that is there.
void replace(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& sizes,
             const std::vector<double>& values) {
  check(H5Ldelete(file, name.c_str(), H5P_DEFAULT), name);
  const Hdf5Id space = checked(
      sizes.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
      H5Sclose, "a data space");
  const Hdf5Id data =
      checked(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose, name);
  if (!values.empty())
    check(H5Dwrite(data.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

// -------------------------------------------------------------------------------------------- kinds of damage
// Each returns what it did, empty when the file has nothing for it.

struct Target {
  hid_t file;
  Names datasets, groups;
  Dice dice;
};

bool is_number(const Dataset& data) { return data.kind() == H5T_INTEGER || data.kind() == H5T_FLOAT; }

Dataset any_dataset(Target& t) { return open_dataset(t.file, t.dice.one_of(t.datasets)); }

double extreme_value(Dice& dice, bool is_integer, double old, std::size_t count) {
  using Real = std::numeric_limits<double>;
  const auto n = static_cast<double>(count);
  const std::vector<double> integers{-1, -2, 0, 1, 2, 1e9, 2147483647, -2147483648.0, n - 1, n, old + 1, old - 1, -old};
  const std::vector<double> reals{Real::quiet_NaN(),
                                  Real::infinity(),
                                  -Real::infinity(),
                                  Real::max(),
                                  Real::denorm_min(),
                                  0,
                                  -0.0,
                                  -1,
                                  1e9,
                                  1e-9,
                                  1e150,
                                  -1e150,
                                  -old,
                                  2 * old,
                                  old * (1 + 1e-6),
                                  old + 1e-3};
  return dice.one_of(is_integer ? integers : reals);
}

/// Values overwritten, exchanged, moved by one place, all equal, reversed or changed everywhere.
std::string change_values(Target& t) {
  const Dataset data = any_dataset(t);
  if (!is_number(data) || data.count == 0) return {};
  const bool is_integer = data.kind() == H5T_INTEGER;
  const std::vector<double> before = numbers_of(data);
  std::vector<double> values = before;
  const auto any = [&]() -> double& { return values[t.dice.below(values.size())]; };
  const auto overwrite = [&](double& value) { value = extreme_value(t.dice, is_integer, value, data.count); };
  const Names actions{"one value overwritten",
                      "one value overwritten",
                      "one value overwritten",
                      "three overwritten",
                      "two exchanged",
                      "moved by one place",
                      "all equal",
                      "reversed",
                      "all overwritten"};
  const std::string action = t.dice.one_of(actions);
  if (action == "one value overwritten") overwrite(any());
  if (action == "three overwritten")
    for (int i = 0; i < 3; ++i) overwrite(any());
  if (action == "two exchanged") std::swap(any(), any());
  if (action == "moved by one place") std::rotate(values.begin(), values.begin() + 1, values.end());
  if (action == "all equal") std::fill(values.begin(), values.end(), any());
  if (action == "reversed") std::reverse(values.begin(), values.end());
  if (action == "all overwritten") std::fill(values.begin(), values.end(), extreme_value(t.dice, is_integer, 1, 4));
  if (values == before) return {};
  check(H5Dwrite(data.id.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), data.name);
  return data.name + ": " + action;
}

/// One dimension more or less, rows dropped or repeated, none at all, or far more than the file holds.
std::string change_shape(Target& t) {
  const Dataset data = any_dataset(t);
  if (!is_number(data)) return {};
  std::vector<hsize_t> sizes = data.sizes;
  std::vector<double> values = numbers_of(data);
  const Names actions{"last row dropped", "first row repeated", "empty",      "flat",
                      "one wider",        "a scalar",           "transposed", "two billion rows"};
  const std::string action = t.dice.one_of(actions);
  const std::size_t width = sizes.size() == 2 ? sizes[1] : 1;
  if (sizes.empty() != (action == "first row repeated" && sizes.empty()) || values.empty()) return {};
  if (action == "last row dropped") --sizes[0], values.resize(values.size() - width);
  if (action == "first row repeated" && !sizes.empty())
    ++sizes[0], values.insert(values.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
  if (action == "first row repeated" && sizes.empty()) sizes = {1};
  if (action == "empty") sizes[0] = 0, values.clear();
  if (action == "flat") sizes = {data.count};
  if (action == "one wider") sizes = {sizes[0], width + 1}, values.resize(sizes[0] * (width + 1), 0.0);
  if (action == "a scalar") sizes.clear(), values.resize(1);
  if (action == "transposed") std::reverse(sizes.begin(), sizes.end());
  if (action == "two billion rows") sizes[0] = 2000000000, values.clear();
  replace(t.file, data.name, data.type.get(), sizes, values);
  return data.name + ": " + action;
}

/// A type of texts of any length, as other programs use.
Hdf5Id text_of_any_length() {
  Hdf5Id type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "a string type");
  H5Tset_size(type.get(), H5T_VARIABLE);
  return type;
}

/// Texts of any length, of which one is long, in the place of those of one length.
std::string free_texts(Target& t, const Dataset& data) {
  if (data.count == 0) return {};
  const std::string text(t.dice.one_of(std::vector<std::size_t>{0, 3, 70000}), 'x');
  const std::vector<const char*> texts(data.count, text.c_str());
  check(H5Ldelete(t.file, data.name.c_str(), H5P_DEFAULT), data.name);
  const Hdf5Id type = text_of_any_length();
  const Hdf5Id fresh = checked(
      H5Dcreate2(t.file, data.name.c_str(), type.get(), data.space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, data.name);
  check(H5Dwrite(fresh.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()), data.name);
  return data.name + ": texts of any length";
}

/// Numbers of another type, or texts; texts of another kind.
std::string change_type(Target& t) {
  const Dataset data = any_dataset(t);
  if (data.kind() == H5T_STRING) return free_texts(t, data);
  if (!is_number(data)) return {};
  const bool is_integer = data.kind() == H5T_INTEGER;
  const std::vector<double> values = numbers_of(data);
  const Names integer_types{"64-bit integers", "unsigned integers", "8-bit integers", "reals", "texts"};
  const Names real_types{"single precision", "integers", "big-endian reals", "texts"};
  const std::string type = t.dice.one_of(is_integer ? integer_types : real_types);
  if (type == "texts") {
    replace(t.file, data.name, H5T_C_S1, data.sizes, {});
    return data.name + ": " + type;
  }
  const hid_t id = type == "64-bit integers"     ? H5T_STD_I64LE
                   : type == "unsigned integers" ? H5T_STD_U32LE
                   : type == "8-bit integers"    ? H5T_STD_I8LE
                   : type == "reals"             ? H5T_IEEE_F64LE
                   : type == "single precision"  ? H5T_IEEE_F32LE
                   : type == "big-endian reals"  ? H5T_IEEE_F64BE
                                                 : H5T_STD_I32LE;
  replace(t.file, data.name, id, data.sizes, values);
  return data.name + ": " + type;
}

std::string change_text(Target& t) {
  const Dataset data = any_dataset(t);
  if (data.kind() != H5T_STRING || data.count == 0) return {};
  const std::size_t width = H5Tget_size(data.type.get());
  std::string bytes(width * data.count, '\0');
  check(H5Dread(data.id.get(), data.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), data.name);
  const std::size_t first = width * t.dice.below(data.count), length = std::min(width, std::size_t{6});
  const std::string& text =
      t.dice.one_of(Names{"\xff\xfe<&\"\n", "      ", std::string(6, '\0'), "../../", "wall\t\x01"});
  bytes.replace(first, length, text.substr(0, length));
  check(H5Dwrite(data.id.get(), data.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), data.name);
  return data.name + ": a text overwritten";
}

std::string folder_of(const std::string& name) { return name.substr(0, name.rfind('/') + 1); }

/// Two datasets of one group take each other's names.
std::string exchange_datasets(Target& t) {
  const std::string a = t.dice.one_of(t.datasets);
  Names others;
  const H5T_class_t kind = open_dataset(t.file, a).kind();
  for (const std::string& b : t.datasets)
    if (b != a && folder_of(b) == folder_of(a) && open_dataset(t.file, b).kind() == kind) others.push_back(b);
  if (others.empty()) return {};
  const std::string b = t.dice.one_of(others);
  const auto move = [&](const std::string& from, const std::string& to) {
    check(H5Lmove(t.file, from.c_str(), t.file, to.c_str(), H5P_DEFAULT, H5P_DEFAULT), from);
  };
  move(a, "exchanged");
  move(b, a);
  move("exchanged", b);
  return a + " and " + b + ": exchanged";
}

std::string remove_or_rename(Target& t) {
  Names all = t.datasets;
  all.insert(all.end(), t.groups.begin(), t.groups.end());
  const std::string name = t.dice.one_of(all);
  if (t.dice.below(3) > 0) {
    check(H5Ldelete(t.file, name.c_str(), H5P_DEFAULT), name);
    return name + ": removed";
  }
  check(H5Lmove(t.file, name.c_str(), t.file, (name + "x").c_str(), H5P_DEFAULT, H5P_DEFAULT), name);
  return name + ": renamed";
}

/// Written anew: libhdf5 1.10 does not find every attribute again that it has opened.
void replace_attribute(hid_t file, const std::string& owner, const std::string& name, const Hdf5Id& attribute,
                       hid_t memory_type, const void* values) {
  const Hdf5Id type = checked(H5Aget_type(attribute.get()), H5Tclose, name);
  const Hdf5Id space = checked(H5Aget_space(attribute.get()), H5Sclose, name);
  check(H5Adelete_by_name(file, owner.c_str(), name.c_str(), H5P_DEFAULT), name);
  const Hdf5Id fresh = checked(H5Acreate_by_name(file, owner.c_str(), name.c_str(), type.get(), space.get(),
                                                 H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose, name);
  check(H5Awrite(fresh.get(), memory_type, values), name);
}

/// `count` of a list of records, or `version` of the file.
std::string change_integer_attribute(Target& t) {
  Names owners{"/"};
  for (const std::string& group : t.groups)
    if (H5Aexists_by_name(t.file, group.c_str(), "count", H5P_DEFAULT) > 0) owners.push_back(group);
  const std::string& owner = t.dice.one_of(owners);
  const char* name = owner == "/" ? "version" : "count";
  const Hdf5Id attribute =
      checked(H5Aopen_by_name(t.file, owner.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, owner);
  std::vector<int> values(2);
  check(H5Aread(attribute.get(), H5T_NATIVE_INT, values.data()), owner);
  const std::size_t which = owner == "/" ? t.dice.below(2) : 0;
  values[which] = static_cast<int>(extreme_value(t.dice, true, values[which], 3));
  replace_attribute(t.file, owner, name, attribute, H5T_NATIVE_INT, values.data());
  return owner + ": " + name + " " + std::to_string(values[which]);
}

/// `format`, `producer` or `provenance`: overwritten in the middle, or removed.
std::string change_header_text(Target& t) {
  const std::string name = t.dice.one_of(Names{"format", "producer", "provenance"});
  if (t.dice.below(4) == 0) {
    check(H5Adelete(t.file, name.c_str()), name);
    return name + ": removed";
  }
  const Hdf5Id attribute = checked(H5Aopen(t.file, name.c_str(), H5P_DEFAULT), H5Aclose, name);
  const Hdf5Id type = checked(H5Aget_type(attribute.get()), H5Tclose, name);
  std::string text(H5Tget_size(type.get()), '\0');
  check(H5Aread(attribute.get(), type.get(), text.data()), name);
  text[t.dice.below(text.size())] = t.dice.one_of(std::vector<char>{'x', '[', '}', '\0', '"', '\xff', '9'});
  replace_attribute(t.file, "/", name, attribute, type.get(), text.data());
  return name + ": a character overwritten";
}

/// An attribute of the header of another type: text of any length, an array of numbers, a list of texts.
std::string change_attribute_type(Target& t) {
  const std::string name = t.dice.one_of(Names{"format", "version", "producer", "provenance"});
  const std::string type = t.dice.one_of(Names{"text of any length", "numbers", "many texts"});
  check(H5Adelete(t.file, name.c_str()), name);
  const std::vector<hsize_t> sizes{type == "text of any length" ? 1U : 100U};
  const Hdf5Id space = checked(H5Screate_simple(1, sizes.data(), nullptr), H5Sclose, "a data space");
  const Hdf5Id texts = text_of_any_length();
  const hid_t id = type == "numbers" ? H5T_NATIVE_DOUBLE : texts.get();
  const Hdf5Id fresh =
      checked(H5Acreate2(t.file, name.c_str(), id, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  const std::vector<double> numbers(100, 1e300);
  const std::vector<const char*> words(100, name == "format" ? "tri-mesh" : "[]");
  check(H5Awrite(fresh.get(), id, type == "numbers" ? static_cast<const void*>(numbers.data()) : words.data()), name);
  return name + ": " + type;
}

using Damage = std::string (*)(Target&);
const std::vector<Damage> damages{change_values,      change_values,
                                  change_values,      change_values,
                                  change_values,      change_shape,
                                  change_shape,       change_type,
                                  change_text,        exchange_datasets,
                                  exchange_datasets,  remove_or_rename,
                                  remove_or_rename,   change_integer_attribute,
                                  change_header_text, change_attribute_type};

// -------------------------------------------------------------------------------------------- the file

herr_t list_object(hid_t, const char* name, const H5O_info_t* info, void* target) {
  auto& t = *static_cast<Target*>(target);
  if (info->type == H5O_TYPE_DATASET) t.datasets.emplace_back(name);
  if (info->type == H5O_TYPE_GROUP && std::string(name) != ".") t.groups.emplace_back(name);
  return 0;
}

std::string damage_file(const std::string& path, std::uint64_t seed) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Id file = checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path);
  Target target{file.get(), {}, {}, Dice(seed)};
  check(H5Ovisit(file.get(), H5_INDEX_NAME, H5_ITER_INC, list_object, &target), path);
  std::string done;
  while (done.empty()) done = target.dice.one_of(damages)(target);
  return done;
}

/// Another program's changes cut the checksum off.
void seal(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  in.close();
  quadrille::io::append_checksum(bytes);
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::cerr << "usage: damage_hdf5 FILE SEED OUT\n";
    return 2;
  }
  const std::filesystem::path output = argv[3];
  std::filesystem::copy_file(argv[1], output, std::filesystem::copy_options::overwrite_existing);
  const std::string done = damage_file(output, std::strtoull(argv[2], nullptr, 10));
  seal(output);
  std::cout << done << '\n';
  return 0;
} catch (const std::exception& e) {
  std::cerr << "damage_hdf5: " << e.what() << '\n';
  return 1;
}
