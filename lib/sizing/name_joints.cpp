#include "sizing/name_joints.hpp"

#include <fmt/format.h>

namespace quadrille::sizing {

std::vector<double> name_joints(const curve::Chain& chain, const CadFace& face) {
  const auto is_given = [&](int c) { return face.curve_names[c] != fmt::format("curve_{}", c); };
  const std::vector<double> joints = chain.joint_fractions();
  std::vector<double> found;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int before = chain.pieces()[i].curve, after = chain.pieces()[i + 1].curve;
    if (face.curve_names[before] != face.curve_names[after] && (is_given(before) || is_given(after)))
      found.push_back(joints[i]);
  }
  return found;
}

}  // namespace quadrille::sizing
