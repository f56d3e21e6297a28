#include "heal/short_edges.hpp"

#include <algorithm>

namespace quadrille::heal {
namespace {

using Wire = std::vector<MeasuredEdge>;

// Whether edge `in` can be joined with edge `out` when the `count` edges between them are removed.
bool can_be_joined(const Wire& wire, size_t in, size_t count, const JointLimit& limit) {
  const size_t n = wire.size();
  std::vector<const RawEdge*> near;
  for (size_t k = 0; k < count + 4; ++k) near.push_back(wire[(in + n - 1 + k) % n].raw);
  const LimitedJoint joint = limit.joint(wire[in], wire[(in + count + 1) % n], near);
  return joint_target(joint.in, joint.out).has_value();
}

}  // namespace

std::vector<bool> short_edges(const Wire& wire, double length, const JointLimit& limit) {
  const size_t n = wire.size();
  std::vector<bool> removed(n, false);
  const auto is_short = [&](size_t i) { return wire[i % n].length <= length * (1 + 1e-6); };
  for (size_t in = 0; in < n; ++in) {
    if (is_short(in)) continue;
    size_t count = 0;
    double sum = 0;
    while (is_short(in + 1 + count)) sum += wire[(in + 1 + count++) % n].length;
    if (count == 0 || sum > length * (1 + 1e-6) || !can_be_joined(wire, in, count, limit)) continue;
    for (size_t k = 1; k <= count; ++k) removed[(in + k) % n] = true;
  }
  return removed;
}

}  // namespace quadrille::heal
