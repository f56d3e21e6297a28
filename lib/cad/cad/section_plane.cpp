#include <fmt/format.h>

#include <string_view>

#include "base/error.hpp"
#include "base/number_list.hpp"
#include "cad/load_face.hpp"

namespace quadrille::cad {

SectionPlane section_plane(const std::string& text) {
  if (text.empty()) return {};
  const std::string_view view = text;
  const std::size_t at = view.find('@'), axis = std::string_view("xyz").find(view.front());
  const auto vec = [](const std::vector<double>& x) { return Vec3{x[0], x[1], x[2]}; };
  if (at != std::string_view::npos) {
    const std::vector<double> normal = numbers_of(view.substr(0, at)), point = numbers_of(view.substr(at + 1));
    if (normal.size() == 3 && point.size() == 3 && norm(vec(normal)) > 0) return {vec(point), normalized(vec(normal))};
  } else if (axis < 3 && view.substr(1, 1) == "=") {
    if (const std::vector<double> value = numbers_of(view.substr(2)); value.size() == 1) {
      const Vec3 normal{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      return {value[0] * normal, normal};
    }
  }
  throw UsageError(fmt::format(
      "--section {}: expected x=VALUE, y=VALUE, z=VALUE or NX,NY,NZ@X,Y,Z: a normal and a point of the plane", text));
}

}  // namespace quadrille::cad
