#include "features/automatic_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "curve/face_boundary.hpp"
#include "curve/pole_box.hpp"
#include "model/special_names.hpp"

namespace quadrille::features {
namespace {

constexpr double of_diameter = 1.0 / 500;

/// The diameter of the face; in a far field, that of the box around the bodies, which a far field may exceed at will.
/// Around layers with blocks of their own it is that of the face: the curves above layers are smooth, and between two
/// of them fewer nodes are better (two elements of an aerofoil in a box: 56 blocks in place of 64).
double reference_length(const CadFace& face) {
  if (!has_far_field(face)) return face.diameter;
  std::vector<Nurbs> bodies;
  for (int curve = 0; curve < face.num_curves(); ++curve) {
    if (is_offset_name(face.curve_names[curve])) return face.diameter;
    if (!is_far_field(face, curve) && !face.is_interface(curve)) bodies.push_back(face.curves[curve]);
  }
  return bodies.empty() ? face.diameter : std::min(face.diameter, curve::pole_box(bodies).diagonal());
}

}  // namespace

double automatic_feature_size(const CadFace& face) {
  return std::min(of_diameter * reference_length(face), curve::mean_width(face) / 2);
}

std::optional<double> parse_feature_size(const std::string& text) {
  if (text == "auto") return std::nullopt;
  double size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size() || !(size >= 0) || !std::isfinite(size))
    throw UsageError(fmt::format("--feature-size {}: expected \"auto\" or a length in file units, 0 or above", text));
  return size;
}

}  // namespace quadrille::features
