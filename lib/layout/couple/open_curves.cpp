#include "couple/open_curves.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "curve/named_curves.hpp"

namespace quadrille::couple {

CadFace with_open_curves(CadFace face, const std::vector<std::string>& names, const std::string& option) {
  const CadFace closed = face;
  for (const std::string& name : names)
    for (const int curve : curve::named_curves(face, name, option)) {
      if (!closed.is_interface(curve))
        throw UsageError(fmt::format("{} {}: the curve {} is a boundary, not between two regions or inside one", option,
                                     name, curve));
      face.partners[closed.partners[curve]] = -1;
      face.partners[curve] = -1;
    }
  return face;
}

std::vector<std::string> nonconforming_interfaces(const std::vector<std::string>& options) {
  std::vector<std::string> names;
  for (const std::string& option : options) {
    const std::size_t end = option.rfind('=');
    if (end == std::string::npos || end == 0 || option.substr(end + 1) != "nonconforming")
      throw UsageError(fmt::format("--interface {}: expected NAME=nonconforming", option));
    names.push_back(option.substr(0, end));
  }
  return names;
}

}  // namespace quadrille::couple
