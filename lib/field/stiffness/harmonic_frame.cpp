#include "stiffness/harmonic_frame.hpp"

#include <array>
#include <cmath>

namespace quadrille::stiffness {

// The affine map of the equilateral triangle 1, e^(2 pi i / 3), e^(-2 pi i / 3) is w -> alpha w + beta conj(w). The
// outside of that triangle is the image of |w| > capacity.
HarmonicFrame::HarmonicFrame(const spectral::TriMap& map) {
  constexpr double capacity = 0.7303;
  const std::array vertices{map.position({-1, -1}), map.position({1, -1}), map.position({-1, 1})};
  centre = (vertices[0] + vertices[1] + vertices[2]) / 3;
  std::complex<double> alpha = 0, beta = 0;
  const std::array<std::complex<double>, 3> roots{{{1, 0}, {-0.5, std::sqrt(0.75)}, {-0.5, -std::sqrt(0.75)}}};
  for (int k = 0; k < 3; ++k) {
    const std::complex z(vertices[k].x - centre.x, vertices[k].y - centre.y);
    alpha += z * std::conj(roots[k]) / 3.0;
    beta += z * roots[k] / 3.0;
  }
  scale = 1.0 / (capacity * alpha);
  b = beta / alpha;
}

}  // namespace quadrille::stiffness
