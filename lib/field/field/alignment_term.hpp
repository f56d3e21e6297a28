#pragma once
// The term that aligns crosses with prescribed directions (model/alignment.hpp): mu and f at a point, and the Gaussians
// of what users prescribe.

#include <vector>

#include "base/vec2.hpp"
#include "model/alignment.hpp"

namespace quadrille::field {

/// The Gaussians of a request. With l the width of a feature, mu = (strength / l)^2 along its middle: there
/// crosses turn to its direction over the distance l / strength. `strength`: a factor for that of each feature.
/// `diameter`: of the face.
///
/// A curve is a row of Gaussians of its width, a box a grid of them. Of a metric, the logarithms of the tensors are
/// averaged over a few samples, and with r the ratio of its lengths, at most 10, mu = (strength / l)^2 ((r - 1) / (r +
/// 1))^2, l that distance. Throws FormatError for more than 200,000 Gaussians, or where mu is not finite.
Alignment make_alignment(const AlignmentRequest& request, double strength, double diameter);

/// Evaluates the sums. Cost at a point: linear in the Gaussians that are not negligible there.
class AlignmentTerm {
 public:
  /// `alignment` must outlive the object.
  explicit AlignmentTerm(const Alignment& alignment);

  struct Value {
    double rate = 0;  ///< mu
    Vec2 target;      ///< f
    Vec2 pull;        ///< the sum of f with each term times its width^2: |pull| = strength^2 inside a feature
  };
  Value at(Vec2 x) const;
  /// Whether mu is not negligible somewhere in the disc.
  bool acts_in(Vec2 centre, double radius) const;
  bool empty() const { return alignment_.empty(); }

 private:
  /// visit(k) for each Gaussian that is not negligible somewhere in the disc.
  template <class Visit>
  void near(Vec2 centre, double radius, const Visit& visit) const;

  const Alignment& alignment_;
  std::vector<Vec2> direction_;          ///< e^(4 i angle)
  std::vector<std::vector<int>> cells_;  ///< of a grid over the points
  Vec2 low_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
};

}  // namespace quadrille::field
