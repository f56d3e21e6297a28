#include "base/message_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quadrille {

constexpr double rounding_error = 1e-12;  ///< of a coordinate, relative to the greatest

std::string position_text(Vec2 x) {
  if (!std::isfinite(x.x) || !std::isfinite(x.y))
    return "an unknown place (its coordinates are no numbers: an internal error, please report it)";
  return fmt::format("({:.6g}, {:.6g})", x.x, x.y);
}

std::string rounded_position_text(Vec2 x) {
  const double rounding = rounding_error * std::max({std::abs(x.x), std::abs(x.y), 1e-3});
  const auto shown = [&](double c) { return std::abs(c) < rounding ? 0.0 : c; };
  return position_text(Vec2{shown(x.x), shown(x.y)});
}

std::string position_text(Vec3 x) {
  const double rounding = rounding_error * std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z), 1e-3});
  const auto shown = [&](double c) { return std::abs(c) < rounding ? 0.0 : c; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", shown(x.x), shown(x.y), shown(x.z));
}

std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

}  // namespace quadrille
