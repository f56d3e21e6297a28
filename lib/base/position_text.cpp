#include "base/position_text.hpp"

#include <fmt/format.h>

namespace quadrille {

std::string position_text(Vec2 x) { return fmt::format("({:.6g}, {:.6g})", x.x, x.y); }

}  // namespace quadrille
