#include "heal/heal_scale.hpp"

#include <fmt/format.h>

#include <cmath>

#include "heal/heal_rules.hpp"

namespace quadrille::heal {

std::string remedy(const HealScale& scale, double size) {
  const double fraction = size / scale.diameter;
  if (fraction * 1.1 > heal_rules.most_tolerance)
    return fmt::format(" ({:.2g} diameters; healing moves nothing further than {}): draw it anew", fraction,
                       heal_rules.most_tolerance);
  // Two digits, rounded up.
  const double unit = std::pow(10, std::floor(std::log10(fraction)) - 1);
  return fmt::format(" ({:.2g} diameters; the tolerance is {:.2g}): give --heal-tolerance {:.2g}", fraction,
                     scale.tolerance / scale.diameter, unit * std::ceil(fraction / unit * (1 + 1e-6)));
}

}  // namespace quadrille::heal
