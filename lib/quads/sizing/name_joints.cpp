#include "sizing/name_joints.hpp"

namespace quadrille::sizing {

std::vector<double> name_joints(const curve::Chain& chain, const CadFace& face) {
  const std::vector<double> joints = chain.joint_fractions();
  std::vector<double> found;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int before = chain.pieces()[i].curve, after = chain.pieces()[i + 1].curve;
    if (face.curve_names[before] != face.curve_names[after] &&
        (face.has_given_name(before) || face.has_given_name(after)))
      found.push_back(joints[i]);
  }
  return found;
}

}  // namespace quadrille::sizing
