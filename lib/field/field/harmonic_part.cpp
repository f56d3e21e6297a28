#include "field/harmonic_part.hpp"

#include <algorithm>

namespace quadrille::field {

void add(const HarmonicPart& part, double factor, Field& field) {
  std::size_t next = 0;
  for (const int e : part.elems)
    for (int i = field.coef_offsets[e]; i < field.coef_offsets[e + 1]; ++i, ++next) {
      field.u[i] += factor * part.u[next];
      field.v[i] += factor * part.v[next];
    }
  for (const Lifting& lifting : part.liftings) {
    const auto same = std::find_if(field.liftings.begin(), field.liftings.end(),
                                   [&](const Lifting& other) { return other.joint == lifting.joint; });
    if (same != field.liftings.end()) {
      same->jump += factor * lifting.jump;
    } else {
      field.liftings.push_back(lifting);
      field.liftings.back().jump = factor * lifting.jump;
    }
  }
}

}  // namespace quadrille::field
