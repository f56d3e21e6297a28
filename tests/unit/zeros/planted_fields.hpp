#pragma once
// Harmonic polynomial fields with zeros at known places, on random meshes of the square [-1, 1]^2.
//
// Left multiplication by a matrix M keeps a field harmonic and its zeros, and turns signs with det M, so that all
// zeros are known of
//   product   M prod (z - z_k) or its conjugate: one sign
//   line      M (Re P(s + i t), t), P(s) = prod (s - s_k) real: zeros on the line t = 0, signs in turn
// and for the third the planted ones, the others being sought independently, by Newton's method from a grid:
//   sum       p(z) + conj(q(z)), coefficients at random but for the linear conditions that it vanish at the z_k

#include <complex>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "../support/square_field.hpp"

namespace quadrille::zeros {

struct PlantedZero {
  Vec2 x;
  int index = 0;
  double stiffness = 0;  ///< least singular value of J
};

struct PlantedField {
  Field field;
  std::vector<PlantedZero> zeros;  ///< all that lie in the square
  double size = 0;                 ///< greatest |v| on the square
  double jump = 0;                 ///< between elements, at most
  std::string description;
};

inline constexpr double near_by = 1e-6 * 2.8284271247461903;  // a millionth of the diameter

class Planter {
 public:
  explicit Planter(unsigned seed) : random_(seed) {}

  PlantedField plant();

 private:
  using Complex = std::complex<double>;
  struct Function {
    std::function<Vec2(Vec2)> value;
    std::function<Mat2(Vec2)> jacobian;
    int degree = 1;
  };

  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  int integer(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
  bool coin(double share = 0.5) { return uniform(0, 1) < share; }
  Complex normal() {
    return {std::normal_distribution<double>()(random_), std::normal_distribution<double>()(random_)};
  }

  TriMesh mesh();
  Vec2 place(const TriMesh& mesh, const std::vector<spectral::TriMap>& maps);
  Mat2 matrix();
  Function product(const std::vector<Vec2>& roots, bool is_conjugate, const Mat2& m);
  Function line(Vec2 start, Vec2 direction, const std::vector<double>& roots, const Mat2& m);
  Function sum(const std::vector<Vec2>& roots);
  std::optional<PlantedField> attempt();

  std::mt19937 random_;
};

}  // namespace quadrille::zeros
