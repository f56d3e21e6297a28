#include "draw/contour_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/tri_map.hpp"

namespace quadrille::draw {

namespace {

constexpr double lattice_step = 4;  // pixels
constexpr int neighbourhood = 4;    // steps of the lattice
constexpr double noise = 1e-7;
constexpr double least_value = 1e-13;

bool is_finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// One element as the contour needs it.
struct Element {
  const Picture& picture;
  const field::FieldEvaluator& evaluator;
  const Component& component;
  int elem;

  /// The component, never zero; slightly inside, as a lifting has no value at its apex.
  double value(Vec2 xi) const {
    Vec2 x;
    Mat2 dx_dxi;
    const double f = component(evaluator.value(elem, xi + 1e-7 * (Vec2{-1.0 / 3, -1.0 / 3} - xi), x, dx_dxi));
    return std::abs(f) < least_value ? least_value : f;
  }

  Vec2 pixel(Vec2 xi) const { return picture.at(evaluator.maps()[elem].position(xi)); }

  /// Whether it lies beyond one side of the drawing: judged by points of its sides.
  bool is_outside() const {
    PictureBox box = empty_box();
    for (int side = 0; side < 3; ++side)
      for (int k = 0; k < 8; ++k) box.include(pixel(spectral::tri_edge_point(side, k / 8.0)));
    const Vec2 end = picture.size(), margin = 0.1 * (box.upper - box.lower);
    return box.upper.x + margin.x < 0 || box.upper.y + margin.y < 0 || box.lower.x - margin.x > end.x ||
           box.lower.y - margin.y > end.y;
  }

  double size() const {
    const Vec2 a = pixel({-1, -1}), b = pixel({1, -1}), c = pixel({-1, 1});
    return std::max({distance(a, b), distance(b, c), distance(c, a)});
  }

  /// Where the component vanishes between two points with values of different sign, as a part of the way from a to b:
  /// regula falsi (Illinois), to far less than a pixel.
  double root(Vec2 a, double at_a, Vec2 b, double at_b) const {
    double low = 0, high = 1, t = 0.5;
    for (int i = 0, last_side = 0; i < 8; ++i) {
      t = (low * at_b - high * at_a) / (at_b - at_a);
      if (!(t >= 0 && t <= 1)) return 0.5;  // values that are not finite
      const double at_t = value(a + t * (b - a));
      if (std::abs(at_t) <= least_value) break;
      const int side = (at_t > 0) == (at_a > 0) ? 1 : -1;
      (side > 0 ? low : high) = t;
      (side > 0 ? at_a : at_b) = at_t;
      if (side == last_side) (side > 0 ? at_b : at_a) *= 0.5;
      last_side = side;
    }
    return t;
  }
};

/// Values on a lattice of n x n cells on the reference triangle.
class Lattice {
 public:
  explicit Lattice(const Element& element) : element_(element) {
    n_ = static_cast<int>(std::clamp(std::ceil(element.size() / lattice_step), 1.0, 200.0));
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) {
        points_.push_back({2.0 * i / n_ - 1, 2.0 * j / n_ - 1});
        values_.push_back(element.value(points_.back()));
      }
    mark_significant();
  }

  std::vector<ContourSegment> segments() const {
    std::vector<ContourSegment> segments;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        add_cell({id(i, j), id(i + 1, j), id(i, j + 1)}, segments);
        if (i + j + 1 < n_) add_cell({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}, segments);
      }
    return segments;
  }

  SideSigns side(int side) const {
    SideSigns signs;
    signs.is_positive = values_[side_id(side, 0)] > 0;
    for (int k = 0; k < n_; ++k) {
      const int a = side_id(side, k), b = side_id(side, k + 1);
      signs.is_significant.push_back(is_significant_[a] || is_significant_[b]);
      if (!changes_sign(a, b)) continue;
      const double t = root(std::min(a, b), std::max(a, b));
      signs.roots.push_back((k + (a < b ? t : 1 - t)) / n_);
    }
    return signs;
  }

 private:
  int id(int i, int j) const { return j * (n_ + 1) - j * (j - 1) / 2 + i; }
  int side_id(int side, int k) const { return side == 0 ? id(k, 0) : side == 1 ? id(n_ - k, k) : id(0, n_ - k); }
  bool changes_sign(int a, int b) const { return (values_[a] > 0) != (values_[b] > 0); }
  double root(int a, int b) const { return element_.root(points_[a], values_[a], points_[b], values_[b]); }

  /// Also the neighbours of significant points: a zero of high order has a small neighbourhood below the noise.
  void mark_significant() {
    is_significant_.assign(values_.size(), false);
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) {
        if (std::abs(values_[id(i, j)]) < noise) continue;
        for (int l = std::max(0, j - neighbourhood); l <= std::min(n_, j + neighbourhood); ++l)
          for (int k = std::max(0, i - neighbourhood); k <= std::min(n_ - l, i + neighbourhood); ++k)
            is_significant_[id(k, l)] = true;
      }
  }

  void add_cell(const std::array<int, 3>& corners, std::vector<ContourSegment>& segments) const {
    if (std::none_of(corners.begin(), corners.end(), [&](int i) { return is_significant_[i]; })) return;
    std::array<Vec2, 2> ends;
    int num_ends = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(corners[k], corners[(k + 1) % 3]), b = std::max(corners[k], corners[(k + 1) % 3]);
      if (changes_sign(a, b)) ends[num_ends++] = element_.pixel(points_[a] + root(a, b) * (points_[b] - points_[a]));
    }
    if (num_ends == 2 && is_finite(ends[0]) && is_finite(ends[1])) segments.push_back({ends});
  }

  const Element& element_;
  int n_ = 1;
  std::vector<Vec2> points_;
  std::vector<double> values_;
  std::vector<bool> is_significant_;
};

}  // namespace

bool SideSigns::is_positive_at(double s) const {
  const auto num_roots = std::lower_bound(roots.begin(), roots.end(), s) - roots.begin();
  return is_positive == (num_roots % 2 == 0);
}

bool SideSigns::is_significant_at(double s) const {
  const double piece = std::floor(s * static_cast<double>(is_significant.size()));
  return is_significant[std::min(static_cast<std::size_t>(std::max(piece, 0.0)), is_significant.size() - 1)];
}

ElementContour element_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                               const Component& component) {
  const Element element{picture, evaluator, component, elem};
  if (picture.is_window() && element.is_outside()) return {};
  const Lattice lattice(element);
  return {lattice.segments(), {lattice.side(0), lattice.side(1), lattice.side(2)}};
}

std::vector<ContourSegment> side_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                                         int side, const SideSigns& own, const SideSigns& other) {
  if (own.is_significant.empty() || other.is_significant.empty()) return {};  // outside the picture
  std::vector<double> cuts = own.roots;
  for (const double s : other.roots) cuts.push_back(1 - s);
  for (std::size_t k = 0; k <= own.is_significant.size(); ++k)
    cuts.push_back(static_cast<double>(k) / static_cast<double>(own.is_significant.size()));
  std::sort(cuts.begin(), cuts.end());
  const auto pixel = [&](double s) {
    return picture.at(evaluator.maps()[elem].position(spectral::tri_edge_point(side, s)));
  };
  std::vector<ContourSegment> segments;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (!(cuts[i] < cuts[i + 1]) || own.is_positive_at(middle) == other.is_positive_at(1 - middle)) continue;
    if (!own.is_significant_at(middle) || !other.is_significant_at(1 - middle)) continue;
    const ContourSegment segment{{pixel(cuts[i]), pixel(cuts[i + 1])}};
    if (is_finite(segment.ends[0]) && is_finite(segment.ends[1])) segments.push_back(segment);
  }
  return segments;
}

}  // namespace quadrille::draw
