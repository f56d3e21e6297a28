#include "io/order_map_io.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.hpp"
#include "io/describe.hpp"
#include "io/hdf5_file.hpp"
#include "io/json_archive.hpp"
#include "io/stage_files.hpp"

namespace quadrille::io {

namespace {

constexpr StageFormat order_map_version{"order-map", 1, 0, Storage::json};

std::vector<int> version_of(const nlohmann::json& json) {
  std::vector<int> version;
  const auto found = json.find("version");
  if (found != json.end() && found->is_array())
    for (const auto& number : *found)
      if (number.is_number_integer()) version.push_back(number.get<int>());
  return version;
}

std::vector<int> parsed_orders(const InputFile& file) {
  require_shallow(file.bytes, file.name);
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(file.bytes);
  } catch (const nlohmann::json::parse_error& e) {
    throw FormatError(fmt::format("{}: neither a field nor JSON (byte {})", file.name, e.byte));
  } catch (const nlohmann::json::out_of_range&) {
    throw FormatError(fmt::format("{}: a number is larger than the largest of double precision", file.name));
  }
  if (!json.is_object() || json.value("format", nlohmann::json()) != "order-map")
    throw FormatError(fmt::format("{}: not an order map: the key \"format\" must be \"order-map\"", file.name));
  require_version(file.name, order_map_version, order_map_version.name, version_of(json));
  const auto orders = json.find("elem_order");
  if (orders == json.end() || !orders->is_array())
    throw FormatError(fmt::format("{}: the key \"elem_order\" must be an array of integers", file.name));
  std::vector<int> elem_order;
  for (const auto& order : *orders) {
    if (!order.is_number_integer() || order < 0 || order > 1000)
      throw FormatError(fmt::format("{}: elem_order[{}] is not an order", file.name, elem_order.size()));
    elem_order.push_back(order.get<int>());
  }
  return elem_order;
}

}  // namespace

std::string order_map_format(const InputFile& file) {
  return looks_like_hdf5(file.bytes) ? "field" : order_map_version.name;
}

OrderMap read_order_map(const InputFile& file, int num_elems, int max_order) {
  OrderMap map;
  if (order_map_format(file) == "field") {
    Field field = read_stage<Field>(file);
    map = {std::move(field.elem_order), field.kind == FieldKind::harmonic};
  } else {
    map.elem_order = parsed_orders(file);
  }
  const std::vector<int>& elem_order = map.elem_order;
  if (static_cast<int>(elem_order.size()) != num_elems)
    throw FormatError(
        fmt::format("{}: {} orders, but the mesh has {} elements", file.name, elem_order.size(), num_elems), "ORD-R01");
  for (std::size_t e = 0; e < elem_order.size(); ++e) {
    if (elem_order[e] < 1 || elem_order[e] > max_order)
      throw FormatError(
          fmt::format("{}: order {} of element {} is outside 1..{}", file.name, elem_order[e], e, max_order),
          "ORD-R02");
  }
  return map;
}

}  // namespace quadrille::io
