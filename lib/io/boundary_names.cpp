#include "io/boundary_names.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace quadrille {

namespace {

using Json = nlohmann::ordered_json;

Json parsed_object(const InputFile& file) {
  Json json;
  try {
    json = Json::parse(file.bytes);
  } catch (const Json::parse_error& e) {
    throw FormatError(fmt::format("{}: not JSON (byte {})", file.name, e.byte));
  }
  if (!json.is_object())
    throw FormatError(fmt::format("{}: must be one object, {{\"old name or number\": \"new name\"}}", file.name));
  return json;
}

/// The curves that `key` means: those of that name, else the one of that number.
std::vector<int> curves_of(const CadFace& face, const std::string& key) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.curve_names[c] == key) curves.push_back(c);
  int number = -1;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  const bool is_number = error == std::errc() && end == key.data() + key.size();
  if (curves.empty() && is_number && number >= 0 && number < face.num_curves()) curves.push_back(number);
  return curves;
}

}  // namespace

void rename_boundary(CadFace& face, const InputFile& file) {
  std::vector<std::string> names = face.curve_names;
  const Json new_names = parsed_object(file);
  for (const auto& [key, value] : new_names.items()) {
    if (!value.is_string() || value.get<std::string>().empty())
      throw FormatError(fmt::format("{}: the new name of \"{}\" must be a text that is not empty", file.name, key));
    const std::vector<int> curves = curves_of(face, key);
    if (curves.empty())
      throw FormatError(fmt::format("{}: no boundary curve has the name or number \"{}\" (the numbers go from 0 to {})",
                                    file.name, key, face.num_curves() - 1));
    for (const int curve : curves) names[curve] = value.get<std::string>();
  }
  face.curve_names = names;
}

}  // namespace quadrille
