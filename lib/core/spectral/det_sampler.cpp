#include "spectral/det_sampler.hpp"

#include <cstddef>

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

/// A tensor of values at nodes, with the matrix of each coordinate applied, the first coordinate fastest.
template <typename Point>
std::vector<Point> transformed(const std::vector<const Eigen::MatrixXd*>& matrices, std::vector<Point> values) {
  std::size_t inner = 1;  // values between neighbours along the coordinate
  for (const Eigen::MatrixXd* matrix : matrices) {
    const std::size_t from = matrix->cols(), to = matrix->rows(), outer = values.size() / (inner * from);
    std::vector<Point> next(outer * to * inner);
    for (std::size_t o = 0; o < outer; ++o)
      for (std::size_t p = 0; p < to; ++p)
        for (std::size_t k = 0; k < from; ++k)
          for (std::size_t i = 0; i < inner; ++i)
            next[(o * to + p) * inner + i] += (*matrix)(p, k) * values[(o * from + k) * inner + i];
    values = std::move(next);
    inner *= to;
  }
  return values;
}

/// Differences from the first node, which rounding does not spoil far from the origin.
template <typename Point>
std::vector<Point> relative(const Point* nodes, std::size_t count) {
  std::vector<Point> values(nodes, nodes + count);
  for (Point& value : values) value = value - nodes[0];
  return values;
}

}  // namespace

DetSampler::DetSampler(int order, const std::vector<double>& points)
    : value_(interpolation_matrix(gll_points(order), points)),
      slope_(value_ * differentiation_matrix(gll_points(order))) {}

std::vector<double> DetSampler::of_quad(const Vec2* nodes) const {
  const std::vector<Vec2> x = relative(nodes, value_.cols() * value_.cols());
  const std::vector<Vec2> a = transformed({&slope_, &value_}, x), b = transformed({&value_, &slope_}, x);
  std::vector<double> dets;
  for (std::size_t k = 0; k < a.size(); ++k) dets.push_back(cross(a[k], b[k]));
  return dets;
}

std::vector<double> DetSampler::of_hex(const Vec3* nodes) const {
  const std::vector<Vec3> x = relative(nodes, value_.cols() * value_.cols() * value_.cols());
  const std::vector<Vec3> a = transformed({&slope_, &value_, &value_}, x),
                          b = transformed({&value_, &slope_, &value_}, x),
                          c = transformed({&value_, &value_, &slope_}, x);
  std::vector<double> dets;
  for (std::size_t k = 0; k < a.size(); ++k) dets.push_back(dot(a[k], cross(b[k], c[k])));
  return dets;
}

}  // namespace quadrille::spectral
