#include "export/netcdf.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "base/error.hpp"

namespace quadrille::exports {

namespace {

/// Numbers of the format: its lists, and types by the index in NetcdfValues.
constexpr std::int32_t dimension_list = 10, variable_list = 11, attribute_list = 12;
constexpr std::array<std::int32_t, 4> netcdf_types{2, 4, 5, 6};
constexpr std::array<std::uint32_t, 4> netcdf_sizes{1, 4, 4, 8};

template <typename Number>
void append_big_endian(Number number, std::string& out) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  const auto bits = std::bit_cast<Bits>(number);
  for (int byte = static_cast<int>(sizeof bits) - 1; byte >= 0; --byte)
    out += static_cast<char>((bits >> (8 * byte)) & 0xFF);
}

void append_padding(std::string& out) { out.append((4 - out.size() % 4) % 4, '\0'); }

/// All parts begin at multiples of four bytes, so that padding may look at the whole.
void append_values(const NetcdfValues& values, std::string& out) {
  std::visit(
      [&](const auto& all) {
        if constexpr (std::is_same_v<std::decay_t<decltype(all)>, std::string>)
          out += all;
        else
          for (const auto number : all) append_big_endian(number, out);
      },
      values);
  append_padding(out);
}

std::size_t size_of(const NetcdfValues& values) {
  return std::visit([](const auto& all) { return all.size(); }, values);
}

void append_name(const std::string& name, std::string& out) {
  append_big_endian(static_cast<std::int32_t>(name.size()), out);
  out += name;
  append_padding(out);
}

/// The number of the list and of its members; twice 0 for none.
void append_list(std::int32_t list, std::size_t count, std::string& out) {
  append_big_endian(count == 0 ? 0 : list, out);
  append_big_endian(static_cast<std::int32_t>(count), out);
}

void append_attributes(const std::vector<NetcdfAttribute>& attributes, std::string& out) {
  append_list(attribute_list, attributes.size(), out);
  for (const NetcdfAttribute& attribute : attributes) {
    append_name(attribute.name, out);
    append_big_endian(netcdf_types[attribute.values.index()], out);
    append_big_endian(static_cast<std::int32_t>(size_of(attribute.values)), out);
    append_values(attribute.values, out);
  }
}

std::uint64_t padded(std::uint64_t size) { return (size + 3) / 4 * 4; }

}  // namespace

int NetcdfFile::dimension(const std::string& name, std::size_t size) {
  dimensions_.emplace_back(name, size);
  return static_cast<int>(dimensions_.size()) - 1;
}

void NetcdfFile::attribute(const std::string& name, NetcdfValues values) {
  attributes_.push_back({name, std::move(values)});
}

void NetcdfFile::variable(const std::string& name, const std::vector<int>& dimensions, NetcdfValues values,
                          std::vector<NetcdfAttribute> attributes) {
  std::size_t count = 1;
  for (const int dimension : dimensions) count *= dimensions_[dimension].second;
  if (count != size_of(values)) throw Defect("NetcdfFile: wrong number of values of " + name);
  variables_.push_back({name, dimensions, std::move(values), std::move(attributes)});
}

bool NetcdfFile::has_records(const std::vector<int>& dimensions) const {
  return std::any_of(dimensions.begin(), dimensions.end(), [&](int d) { return dimensions_[d].second == 0; });
}

std::string NetcdfFile::header(const std::vector<std::uint64_t>& begins) const {
  std::string out{'C', 'D', 'F', '\2'};
  append_big_endian(std::int32_t{0}, out);  // no records
  append_list(dimension_list, dimensions_.size(), out);
  for (const auto& [name, size] : dimensions_) {
    append_name(name, out);
    append_big_endian(static_cast<std::int32_t>(size), out);
  }
  append_attributes(attributes_, out);
  append_list(variable_list, variables_.size(), out);
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    const Variable& variable = variables_[v];
    append_name(variable.name, out);
    append_big_endian(static_cast<std::int32_t>(variable.dimensions.size()), out);
    std::uint64_t size = netcdf_sizes[variable.values.index()];
    for (const int dimension : variable.dimensions) {
      append_big_endian(static_cast<std::int32_t>(dimension), out);
      size *= std::max<std::size_t>(dimensions_[dimension].second, 1);  // of one record
    }
    append_attributes(variable.attributes, out);
    append_big_endian(netcdf_types[variable.values.index()], out);
    append_big_endian(static_cast<std::uint32_t>(padded(size)), out);
    append_big_endian(begins[v], out);
  }
  return out;
}

std::string NetcdfFile::bytes() const {
  std::vector<std::uint64_t> begins(variables_.size(), 0);
  std::uint64_t at = header(begins).size();
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    begins[v] = at;
    at += padded(size_of(variables_[v].values) * netcdf_sizes[variables_[v].values.index()]);
  }
  for (std::size_t v = 0; v < variables_.size(); ++v)  // records follow all other data, and there are none
    if (has_records(variables_[v].dimensions)) begins[v] = at;
  std::string out = header(begins);
  out.reserve(at);
  for (const Variable& variable : variables_) append_values(variable.values, out);
  return out;
}

}  // namespace quadrille::exports
