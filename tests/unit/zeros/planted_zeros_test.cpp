#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

#include "guide/find_critical_points.hpp"
#include "planted_fields.hpp"

namespace quadrille::zeros {
namespace {

double smallest_stretch(const Mat2& m) {
  const double a = m.xx * m.xx + m.xy * m.xy + m.yx * m.yx + m.yy * m.yy, d = std::abs(det(m));
  const double greatest = std::sqrt(0.5 * (a + std::sqrt(std::max(a * a - 4 * d * d, 0.0))));
  return greatest > 0 ? d / greatest : 0;
}

const Eigen::MatrixXd& to_modes(int order) {
  static std::map<int, Eigen::MatrixXd> known;
  auto& matrix = known[order];
  if (matrix.size() == 0) matrix = spectral::orthogonal_vandermonde(order, spectral::tri_nodes(order)).inverse();
  return matrix;
}

bool is_in_square(Vec2 x) { return std::max(std::abs(x.x), std::abs(x.y)) <= 1; }

}  // namespace

/// Regular pattern with moved inner vertices; half of the meshes with curved inner edges of degree 2.
TriMesh Planter::mesh() {
  const int n = integer(1, 3);
  TriMesh mesh = square_mesh({-1, -1}, 2, n);
  const double h = 2.0 / n;
  for (Vec2& v : mesh.vertices)
    if (std::abs(v.x) < 1 - 1e-9 && std::abs(v.y) < 1 - 1e-9) v += {uniform(-0.2, 0.2) * h, uniform(-0.2, 0.2) * h};
  if (coin()) return mesh;
  mesh.order = 2;
  std::map<std::array<int, 2>, Vec2> middles;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const std::array<int, 3>& elem = mesh.elem2vertices[e];
    mesh.curved_elems.push_back(e);
    for (const int v : elem) mesh.curved_nodes.push_back(mesh.vertices[v]);
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 2> edge{std::min(elem[k], elem[(k + 1) % 3]), std::max(elem[k], elem[(k + 1) % 3])};
      const Vec2 a = mesh.vertices[edge[0]], b = mesh.vertices[edge[1]], middle = 0.5 * (a + b);
      const bool is_outer = std::max(std::abs(middle.x), std::abs(middle.y)) > 1 - 1e-9;
      const Vec2 off = is_outer ? Vec2{} : uniform(-0.08, 0.08) * left_of(b - a);
      mesh.curved_nodes.push_back(middles.try_emplace(edge, middle + off).first->second);
    }
  }
  return mesh;
}

/// Anywhere, on an edge, at a vertex, a millionth inside or outside the boundary, near a corner.
Vec2 Planter::place(const TriMesh& mesh, const std::vector<spectral::TriMap>& maps) {
  const double along = uniform(-0.98, 0.98);
  switch (integer(0, 6)) {
    case 0: {
      const double t = uniform(-1, 1);
      const int k = integer(0, 2);
      const Vec2 xi = k == 0 ? Vec2{t, -1} : k == 1 ? Vec2{t, -t} : Vec2{-1, t};
      const Vec2 x = maps[integer(0, mesh.num_elems() - 1)].position(xi);
      if (std::max(std::abs(x.x), std::abs(x.y)) < 1 - 1e-9) return x;
      break;
    }
    case 1: {
      const Vec2 x = mesh.vertices[integer(0, static_cast<int>(mesh.vertices.size()) - 1)];
      if (std::max(std::abs(x.x), std::abs(x.y)) < 1 - 1e-9) return x;
      break;
    }
    case 2: {
      const double off = coin(0.75) ? 1 - near_by : 1 + near_by;
      const double side = coin() ? off : -off;
      return coin() ? Vec2{side, along} : Vec2{along, side};
    }
    case 3:
      return {(coin() ? 1 : -1) * (1 - 1e-4), (coin() ? 1 : -1) * (1 - uniform(1, 5) * 1e-4)};
    default:
      break;
  }
  return {along, uniform(-0.98, 0.98)};
}

Mat2 Planter::matrix() {
  for (;;) {
    const Mat2 m{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    if (smallest_stretch(m) > 0.2) return m;
  }
}

Planter::Function Planter::product(const std::vector<Vec2>& roots, bool is_conjugate, const Mat2& m) {
  const double sign = is_conjugate ? -1 : 1;
  const auto value = [=](Vec2 x) {
    Complex w = 1;
    for (const Vec2 r : roots) w *= Complex(x.x - r.x, x.y - r.y);
    return m * Vec2{w.real(), sign * w.imag()};
  };
  const auto jacobian = [=](Vec2 x) {
    Complex slope = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      Complex w = 1;
      for (std::size_t j = 0; j < roots.size(); ++j)
        if (j != k) w *= Complex(x.x - roots[j].x, x.y - roots[j].y);
      slope += w;
    }
    return m * Mat2{slope.real(), -slope.imag(), sign * slope.imag(), sign * slope.real()};
  };
  return {value, jacobian, static_cast<int>(roots.size())};
}

Planter::Function Planter::line(Vec2 start, Vec2 direction, const std::vector<double>& roots, const Mat2& m) {
  const auto polynomial = [=](Complex z) {
    Complex w = 1;
    for (const double r : roots) w *= z - r;
    return w;
  };
  const auto value = [=](Vec2 x) {
    const double s = dot(direction, x - start), t = cross(direction, x - start);
    return m * Vec2{polynomial({s, t}).real(), t};
  };
  const auto jacobian = [=](Vec2 x) {
    const Complex z{dot(direction, x - start), cross(direction, x - start)};
    Complex slope = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      Complex w = 1;
      for (std::size_t j = 0; j < roots.size(); ++j)
        if (j != k) w *= z - roots[j];
      slope += w;
    }
    const Mat2 turn{direction.x, direction.y, -direction.y, direction.x};
    return m * (Mat2{slope.real(), -slope.imag(), 0, 1} * turn);
  };
  return {value, jacobian, static_cast<int>(roots.size())};
}

Planter::Function Planter::sum(const std::vector<Vec2>& roots) {
  const int degree = integer(2, 5), n = degree + 1;
  const auto count = static_cast<Eigen::Index>(roots.size());
  // Unknowns: real and imaginary parts of p's coefficients, then of q's without the constant.
  Eigen::MatrixXd conditions(2 * count, 2 * n + 2 * degree);
  for (Eigen::Index i = 0; i < count; ++i) {
    Complex power = 1;
    for (int k = 0; k < n; ++k, power *= Complex(roots[i].x, roots[i].y)) {
      const double a = power.real(), b = power.imag();
      conditions(2 * i, 2 * k) = a, conditions(2 * i, 2 * k + 1) = -b;
      conditions(2 * i + 1, 2 * k) = b, conditions(2 * i + 1, 2 * k + 1) = a;
      if (k == 0) continue;
      const int at = 2 * n + 2 * (k - 1);
      conditions(2 * i, at) = a, conditions(2 * i, at + 1) = -b;
      conditions(2 * i + 1, at) = -b, conditions(2 * i + 1, at + 1) = -a;
    }
  }
  Eigen::VectorXd c(conditions.cols());
  for (double& entry : c) entry = normal().real();
  const Eigen::MatrixXd transposed = conditions.transpose();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(transposed);
  const Eigen::MatrixXd range = qr.householderQ() * Eigen::MatrixXd::Identity(conditions.cols(), conditions.rows());
  for (int round = 0; round < 2; ++round) c -= range * (range.transpose() * c);
  std::vector<Complex> p(n), q(n);
  for (int k = 0; k < n; ++k) p[k] = {c[2 * k], c[2 * k + 1]};
  for (int k = 1; k < n; ++k) q[k] = {c[2 * n + 2 * k - 2], c[2 * n + 2 * k - 1]};
  const auto horner = [](const std::vector<Complex>& a, Complex z) {
    Complex w = 0;
    for (std::size_t k = a.size(); k-- > 0;) w = w * z + a[k];
    return w;
  };
  const auto slope = [](const std::vector<Complex>& a, Complex z) {
    Complex w = 0;
    for (std::size_t k = a.size(); k-- > 1;) w = w * z + static_cast<double>(k) * a[k];
    return w;
  };
  const auto value = [=](Vec2 x) {
    const Complex z{x.x, x.y}, w = horner(p, z) + std::conj(horner(q, z));
    return Vec2{w.real(), w.imag()};
  };
  const auto jacobian = [=](Vec2 x) {
    const Complex z{x.x, x.y}, a = slope(p, z), b = slope(q, z);
    return Mat2{a.real() + b.real(), -a.imag() - b.imag(), a.imag() - b.imag(), a.real() - b.real()};
  };
  return {value, jacobian, degree};
}

namespace {

/// Newton's method; nothing where it does not converge near the square.
std::optional<Vec2> newton(const std::function<Vec2(Vec2)>& value, const std::function<Mat2(Vec2)>& jacobian, Vec2 x) {
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Mat2 j = jacobian(x);
    if (!(std::abs(det(j)) > 1e-12)) return {};
    const Vec2 step = inverse(j) * value(x);
    x = x - step;
    if (!(norm(x) < 10)) return {};
    if (norm(step) < 1e-14) return x;
  }
  return {};
}

}  // namespace

/// Nothing where some zero is worse conditioned than double precision can represent.
std::optional<PlantedField> Planter::attempt() {
  PlantedField planted;
  TriMesh base = mesh();
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(base);
  const int kind = integer(0, 2);
  const bool has_jumps = coin(0.3);
  std::vector<Vec2> roots;
  const int count = integer(1, 4);
  for (int i = 0; i < count; ++i) roots.push_back(place(base, maps));
  for (std::size_t i = 0; i < roots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (distance(roots[i], roots[j]) < 0.15) return {};
  const bool has_pair = !has_jumps && kind != 2 && coin(0.4);
  Function f;
  if (kind == 0) {
    if (has_pair) roots.push_back(roots[0] + near_by * unit(uniform(0, 2 * pi)));
    f = product(roots, coin(), matrix());
  } else if (kind == 1) {
    const Vec2 start = roots[0], direction = count > 1 ? normalized(roots[1] - roots[0]) : unit(uniform(0, 2 * pi));
    std::vector<double> s{0};
    if (count > 1) s.push_back(distance(roots[0], roots[1]));
    if (has_pair) s.push_back(near_by);
    for (int extra = integer(0, 2); extra > 0; --extra) s.push_back(uniform(-2, 2));
    for (std::size_t i = has_pair ? 3 : 2; i < s.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (std::abs(s[i] - s[j]) < 0.1) return {};
    f = line(start, direction, s, matrix());
    roots.clear();
    for (const double r : s) roots.push_back(start + r * direction);
  } else {
    f = sum(roots);
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j) {
        const auto x = newton(f.value, f.jacobian, {-1 + (i + 0.5) / 15, -1 + (j + 0.5) / 15});
        if (x && std::none_of(roots.begin(), roots.end(), [&](Vec2 r) { return distance(r, *x) < 1e-9; }))
          roots.push_back(*x);
      }
  }
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) planted.size = std::max(planted.size, norm(f.value({-1 + i / 10.0, -1 + j / 10.0})));
  planted.jump = has_jumps ? std::pow(10.0, uniform(-9, -4)) * planted.size : 0;
  for (const Vec2 x : roots) {
    const Mat2 j = f.jacobian(x);
    const double stiffness = smallest_stretch(j);
    const double uncertain = (1e-13 * planted.size + 20 * planted.jump) / stiffness;
    double nearest = 1e-2;
    for (const Vec2 other : roots)
      if (!(other == x)) nearest = std::min(nearest, distance(x, other));
    const double rim = std::max(std::abs(x.x), std::abs(x.y)) - 1;
    if (uncertain > 0.1 * nearest || uncertain > 0.5 * std::abs(rim)) return {};
    if (is_in_square(x)) planted.zeros.push_back({x, det(j) > 0 ? 1 : -1, stiffness});
  }

  Field& field = planted.field;
  field.method = has_jumps ? FieldMethod::dg : FieldMethod::cg;
  field.coef_offsets = {0};
  for (int e = 0; e < base.num_elems(); ++e) {
    const int order = f.degree * base.order + integer(0, 3);
    Eigen::MatrixX2d values(spectral::num_tri_modes(order), 2);
    for (int i = 0; i < values.rows(); ++i) {
      const Vec2 v = f.value(maps[e].position(spectral::tri_nodes(order)[i]));
      values.row(i) << v.x, v.y;
    }
    Eigen::MatrixX2d coefs = to_modes(order) * values;
    for (int i = 0; i < std::min<int>(6, static_cast<int>(coefs.rows())); ++i)
      coefs.row(i) += planted.jump / 20 * Eigen::RowVector2d(uniform(-1, 1), uniform(-1, 1));
    field.u.insert(field.u.end(), coefs.col(0).begin(), coefs.col(0).end());
    field.v.insert(field.v.end(), coefs.col(1).begin(), coefs.col(1).end());
    field.elem_order.push_back(order);
    field.coef_offsets.push_back(static_cast<int>(field.u.size()));
  }
  field.mesh = std::move(base);
  const char* names[] = {"product", "line", "sum"};
  planted.description = std::string(names[kind]) + (has_jumps ? ", jumps" : "") + (has_pair ? ", pair" : "") +
                        (field.mesh.order > 1 ? ", curved" : "");
  return planted;
}

PlantedField Planter::plant() {
  for (;;)
    if (auto planted = attempt()) return std::move(*planted);
}

namespace {

/// What is wrong with the zeros found; empty: nothing.
std::string fault(const PlantedField& planted, const CriticalPoints& points) {
  if (!points.clusters.empty()) return "a cluster";
  std::vector<int> taken(planted.zeros.size(), 0);
  for (const CriticalPoint& p : points.critical_points) {
    int nearest = -1;
    double least = 1e300;
    for (std::size_t i = 0; i < planted.zeros.size(); ++i)
      if (distance(planted.zeros[i].x, p.position) < least)
        least = distance(planted.zeros[i].x, p.position), nearest = static_cast<int>(i);
    if (nearest < 0 || least > 1e-11 + (1e-13 * planted.size + 5 * planted.jump) / planted.zeros[nearest].stiffness)
      return "one too many, " + std::to_string(least * 1e9) + "e-9 from the nearest";
    if (++taken[nearest] > 1) return "one is doubled";
    if (planted.zeros[nearest].index != p.index) return "an index is wrong";
  }
  return points.critical_points.size() == planted.zeros.size() ? "" : "one is missed";
}

/// 2000 fields; QUADRILLE_PLANTED_FIELDS=10000 asks for more.
int num_fields() {
  const char* asked = std::getenv("QUADRILLE_PLANTED_FIELDS");
  return asked ? std::atoi(asked) : 2000;
}

TEST(PlantedZeros, none_is_missed_none_doubled_and_each_has_its_index) {
  int num_zeros = 0, num_faults = 0;
  for (int seed = 0; seed < num_fields(); ++seed) {
    const PlantedField planted = Planter(static_cast<unsigned>(seed)).plant();
    num_zeros += static_cast<int>(planted.zeros.size());
    std::string what;
    try {
      Report report;
      what = fault(planted, guide::find_critical_points(field::FieldEvaluator(planted.field), {0, 0, 1e-14}, report));
    } catch (const std::exception& e) {
      what = e.what();
    }
    EXPECT_EQ(what, "") << "field " << seed << " (" << planted.description << ")";
    num_faults += !what.empty();
    if (num_faults > 20) break;
  }
  EXPECT_GT(num_zeros, num_fields());
  RecordProperty("fields", num_fields());
  RecordProperty("zeros", num_zeros);
}

}  // namespace
}  // namespace quadrille::zeros
