#include "stiffness/element_matrices.hpp"

#include <utility>

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"

namespace quadrille::stiffness {
namespace {

// The factors of the modified basis at a collapsed Gauss rule, and their products, on which sum factorisation works.
struct FactorTable {
  spectral::FactoredModes modes;
  // Points eta1 x pairs of factors, (a, b) in column a + b num_factors: f_a f_b, f_a' f_b, f_a' f_b'.
  Eigen::MatrixXd products, mixed_products, slope_products;
};

FactorTable make_factor_table(int order, int num_points) {
  FactorTable table{spectral::factored_modes(order, num_points), {}, {}, {}};
  const Eigen::MatrixXd &f = table.modes.f, &df = table.modes.df;
  const int num_factors = table.modes.num_factors();
  for (Eigen::MatrixXd* products : {&table.products, &table.mixed_products, &table.slope_products})
    products->resize(num_points, num_factors * num_factors);
  for (int a = 0; a < num_factors; ++a) {
    for (int b = 0; b < num_factors; ++b) {
      const int pair = a + b * num_factors;
      table.products.col(pair) = f.col(a).cwiseProduct(f.col(b));
      table.mixed_products.col(pair) = df.col(a).cwiseProduct(f.col(b));
      table.slope_products.col(pair) = df.col(a).cwiseProduct(df.col(b));
    }
  }
  return table;
}

const FactorTable& factor_table(int order, int num_points) {
  static spectral::PerOrder<FactorTable> tables([](int key) { return make_factor_table(key / 1000, key % 1000); });
  return tables[1000 * order + num_points];
}

// A symmetric metric: the stiffness matrix is the integral of g11 d1 d1 + g12 (d1 d2 + d2 d1) + g22 d2 d2 over the
// reference triangle, d1 and d2 the reference derivatives of the two modes.
struct Metric {
  double g11 = 0, g12 = 0, g22 = 0;
};

// |J| J^-1 J^-T.
Metric metric_of(const Mat2& j) {
  const double d = det(j);
  return {(j.xy * j.xy + j.yy * j.yy) / d, -(j.xx * j.xy + j.yx * j.yy) / d, (j.xx * j.xx + j.yx * j.yx) / d};
}

// The same for the derivatives with respect to eta1 and eta2, times the weights: points eta1 x points eta2.
struct CollapsedMetric {
  Eigen::MatrixXd h11, h12, h22;
};

Vec2 collapsed_point(const spectral::FactoredModes& modes, int i, int j) {
  const double t = (1 - modes.eta2.points[j]) / 2, s = (1 + modes.eta1.points[i]) / 2;
  return {2 * s * t - 1, modes.eta2.points[j]};
}

// `metric_at(i, j)`: at the points eta1[i] and eta2[j].
template <class MetricAt>
CollapsedMetric collapsed_metric(const spectral::FactoredModes& modes, const MetricAt& metric_at) {
  const int n = static_cast<int>(modes.eta1.points.size());
  CollapsedMetric h{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n)};
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double t = (1 - modes.eta2.points[j]) / 2, s = (1 + modes.eta1.points[i]) / 2;
      const Metric g = metric_at(i, j);
      // d1 = (1 / t) d/deta1, d2 = (s / t) d/deta1 + d/deta2
      const double weight = modes.eta1.weights[i] * modes.eta2.weights[j] / 2;
      h.h11(i, j) = weight * (g.g11 + 2 * s * g.g12 + s * s * g.g22) / (t * t);
      h.h12(i, j) = weight * (g.g12 + s * g.g22) / t;
      h.h22(i, j) = weight * g.g22;
    }
  }
  return h;
}

// The modes at the points eta2, weighted by the integrals along eta1 of the metric times two factors.
class ScaledModes {
 public:
  ScaledModes(const FactorTable& table, const CollapsedMetric& h)
      : modes_(table.modes),
        slopes_(h.h11.transpose() * table.slope_products),
        mixed_(h.h12.transpose() * table.mixed_products),
        values_(h.h22.transpose() * table.products) {}

  // For products with a mode of factor c: rows are the points eta2, for its g and then for its dg; columns are the
  // modes of the factors c, c + 1, ...
  Eigen::MatrixXd against(int c) const {
    const int num_factors = modes_.num_factors(), n = static_cast<int>(modes_.g.rows()), begin = modes_.first[c];
    Eigen::MatrixXd scaled(2 * n, modes_.g.cols() - begin);
    for (int b = c; b < num_factors; ++b) {
      const int pair = b + c * num_factors, swapped = c + b * num_factors;
      for (int m = modes_.first[b]; m < modes_.first[b + 1]; ++m) {
        const auto g = modes_.g.col(m).array(), dg = modes_.dg.col(m).array();
        auto column = scaled.col(m - begin).array();
        column.head(n) = slopes_.col(pair).array() * g + mixed_.col(swapped).array() * dg;
        column.tail(n) = mixed_.col(pair).array() * g + values_.col(pair).array() * dg;
      }
    }
    return scaled;
  }

 private:
  const spectral::FactoredModes& modes_;
  Eigen::MatrixXd slopes_, mixed_, values_;  // points eta2 x pairs of factors
};

template <class MetricAt>
Eigen::MatrixXd integrate_stiffness(int order, int num_points, const MetricAt& metric_at) {
  const FactorTable& table = factor_table(order, num_points);
  const spectral::FactoredModes& modes = table.modes;
  const ScaledModes scaled(table, collapsed_metric(modes, metric_at));
  Eigen::MatrixXd stiffness(modes.g.cols(), modes.g.cols()), others;
  for (int c = 0; c < modes.num_factors(); ++c) {
    const int begin = modes.first[c], num = modes.num_modes(c);
    others.resize(2 * num_points, num);
    others << modes.g.middleCols(begin, num), modes.dg.middleCols(begin, num);
    const Eigen::MatrixXd block = scaled.against(c).transpose() * others;
    for (int column = 0; column < num; ++column) {
      for (int row = column; row < block.rows(); ++row) {
        const int a = modes.position[begin + row], b = modes.position[begin + column];
        stiffness(a, b) = stiffness(b, a) = block(row, column);
      }
    }
  }
  return stiffness;
}

// The three reference matrices; the stiffness matrix of an affine element is a linear combination of them.
struct ReferenceMatrices {
  Eigen::MatrixXd k11, k12, k22;  // k12 contains both mixed products
};

ReferenceMatrices make_reference_matrices(int order) {
  const auto integrate = [&](const Metric& metric) {
    return integrate_stiffness(order, order + 1, [&](int, int) { return metric; });
  };
  return {integrate({1, 0, 0}), integrate({0, 1, 0}), integrate({0, 0, 1})};
}

const ReferenceMatrices& reference_matrices(int order) {
  static spectral::PerOrder<ReferenceMatrices> tables([](int n) {
    static spectral::PerOrder<ReferenceMatrices> large(make_reference_matrices);
    const int higher = spectral::table_order(n);
    const ReferenceMatrices& all = large[higher];
    return ReferenceMatrices{cut_down(all.k11, higher, n), cut_down(all.k12, higher, n), cut_down(all.k22, higher, n)};
  });
  return tables[order];
}

Eigen::MatrixXd affine_stiffness(const spectral::TriMap& map, int order) {
  Vec2 x;
  Mat2 j;
  map.evaluate({0, 0}, x, j);
  const Metric g = metric_of(j);
  const ReferenceMatrices& reference = reference_matrices(order);
  return g.g11 * reference.k11 + g.g12 * reference.k12 + g.g22 * reference.k22;
}

// The derivatives of the modes of maps of one order at a collapsed Gauss rule: a column per point, eta1 fastest.
struct MapSlopes {
  Eigen::MatrixXd by_xi1, by_xi2;
};

MapSlopes make_map_slopes(const spectral::FactoredModes& modes, int map_order) {
  const int n = static_cast<int>(modes.eta1.points.size()), num_modes = spectral::num_tri_modes(map_order);
  MapSlopes slopes{Eigen::MatrixXd(num_modes, n * n), Eigen::MatrixXd(num_modes, n * n)};
  Eigen::VectorXd values(num_modes);
  for (int k = 0; k < n * n; ++k)
    spectral::orthogonal_gradients(map_order, collapsed_point(modes, k % n, k / n), values.data(),
                                   slopes.by_xi1.col(k).data(), slopes.by_xi2.col(k).data());
  return slopes;
}

const MapSlopes& map_slopes(int order, int num_points, int map_order) {
  static spectral::PerOrder<MapSlopes> tables(
      [](int key) { return make_map_slopes(factor_table(key / 100000, key / 100 % 1000).modes, key % 100); });
  return tables[100 * (1000 * order + num_points) + map_order];
}

Eigen::MatrixXd curved_stiffness(const spectral::TriMap& map, int order, int num_points) {
  const MapSlopes& slopes = map_slopes(order, num_points, map.order());
  const Eigen::Map<const Eigen::VectorXd> x(map.coefs_x().data(), slopes.by_xi1.rows()),
      y(map.coefs_y().data(), x.size());
  return integrate_stiffness(order, num_points, [&](int i, int j) {
    const auto by_xi1 = slopes.by_xi1.col(i + num_points * j), by_xi2 = slopes.by_xi2.col(i + num_points * j);
    return metric_of({x.dot(by_xi1), x.dot(by_xi2), y.dot(by_xi1), y.dot(by_xi2)});
  });
}

}  // namespace

Eigen::MatrixXd stiffness_matrix(const spectral::TriMap& map, int order, int extra_points) {
  return map.is_affine() ? affine_stiffness(map, order) : curved_stiffness(map, order, order + extra_points);
}

Eigen::MatrixXd cut_down(const Eigen::MatrixXd& stiffness, int higher_order, int order) {
  if (order == higher_order) return stiffness;
  const std::vector<int>& modes = spectral::modified_subset(order, higher_order);
  return stiffness(modes, modes);
}

SymmetricMatrix::SymmetricMatrix(const Eigen::MatrixXd& lower)
    : rows_(lower.rows()), columns_(lower.rows() * (lower.rows() + 1) / 2) {
  for (Eigen::Index j = 0, first = 0; j < rows_; first += rows_ - j, ++j)
    columns_.segment(first, rows_ - j) = lower.col(j).tail(rows_ - j);
}

Eigen::MatrixXd SymmetricMatrix::dense() const {
  Eigen::MatrixXd all(rows_, rows_);
  for (Eigen::Index j = 0, first = 0; j < rows_; first += rows_ - j, ++j) {
    all.col(j).tail(rows_ - j) = columns_.segment(first, rows_ - j);
    all.row(j).tail(rows_ - j) = columns_.segment(first, rows_ - j).transpose();
  }
  return all;
}

Eigen::MatrixXd SymmetricMatrix::operator*(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(rows_, x.cols());
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    for (Eigen::Index j = 0, first = 0; j < rows_; first += rows_ - j, ++j) {
      const auto below = columns_.segment(first + 1, rows_ - j - 1);
      product(j, k) += columns_[first] * x(j, k) + below.dot(x.col(k).tail(below.size()));
      product.col(k).tail(below.size()) += x(j, k) * below;
    }
  return product;
}

CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure) {
  const Eigen::LLT<Eigen::MatrixXd> factored(k_ii);  // L L^T
  if (factored.info() != Eigen::Success) throw ComputeError(failure);
  Eigen::MatrixXd interior = -k_ib, schur = k_bb;
  factored.matrixL().solveInPlace(interior);
  schur.selfadjointView<Eigen::Lower>().rankUpdate(interior.transpose(), -1);
  factored.matrixU().solveInPlace(interior);
  return {SymmetricMatrix(schur), std::move(interior), {}};
}

CondensedElement condense(int order, const Eigen::MatrixXd& stiffness) {
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  return eliminate_interior(stiffness.bottomRightCorner(ni, ni), stiffness.bottomLeftCorner(ni, nb),
                            stiffness.topLeftCorner(nb, nb), "an element's stiffness matrix is not positive definite");
}

}  // namespace quadrille::stiffness
