#pragma once
// The methods of computing a layout that can be chosen. Installed for other programs.

#include <array>

#include "base/enum_names.hpp"

namespace quadrille::layout {

/// The method of computing the layout (layout/compute_layout.hpp).
enum class LayoutChoice { traced, quantized, automatic, t_mesh, midpoint };

constexpr auto enum_names(LayoutChoice) { return std::to_array({"traced", "quantized", "auto", "t-mesh", "midpoint"}); }

}  // namespace quadrille::layout
