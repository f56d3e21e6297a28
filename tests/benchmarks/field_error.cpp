// The difference of two fields on the same face, at interior points that depend on the face alone.
//
//   field_error FIELD REFERENCE [POINTS [MARGIN]]     writes one line of JSON
//
// Points (500): the first of a Halton sequence in the box around the face that lie inside both meshes, at least MARGIN
// (0.02) diameters from every corner. There the field has singular derivatives, which fans resolve only as far as the
// rest of the face feels it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"

using namespace quadrille;

namespace {

// The i-th number of van der Corput's sequence.
double radical_inverse(int i, int base) {
  double value = 0, digit = 1.0 / base;
  for (; i > 0; i /= base, digit /= base) value += digit * (i % base);
  return value;
}

bool is_near_corner(const CadFace& face, Vec2 x, double margin) {
  return std::any_of(face.joints.begin(), face.joints.end(), [&](const Joint& joint) {
    return joint.is_corner && distance(joint.position, x) < margin * face.diameter;
  });
}

struct Errors {
  int num_points = 0;
  double greatest = 0, sum_of_squares = 0;
};

Errors compare(const field::FieldEvaluator& field, const field::FieldEvaluator& reference, int num_points,
               double margin) {
  const TriMesh& mesh = reference.field().mesh;
  Vec2 lower = mesh.vertices.front(), upper = lower;
  for (const Vec2 x : mesh.vertices) {
    lower = {std::min(lower.x, x.x), std::min(lower.y, x.y)};
    upper = {std::max(upper.x, x.x), std::max(upper.y, x.y)};
  }
  Errors errors;
  for (int i = 1; errors.num_points < num_points && i < 1000 * num_points; ++i) {
    const Vec2 x{lower.x + (upper.x - lower.x) * radical_inverse(i, 2),
                 lower.y + (upper.y - lower.y) * radical_inverse(i, 3)};
    Vec2 a, b;
    if (is_near_corner(mesh.face, x, margin) || !reference.value_at(x, b) || !field.value_at(x, a)) continue;
    ++errors.num_points;
    errors.greatest = std::max(errors.greatest, distance(a, b));
    errors.sum_of_squares += norm2(a - b);
  }
  return errors;
}

Field load(const char* name) {
  const io::InputFile file = io::read_input(name);
  Field field = io::read_stage<Field>(file);
  check::require_sound(field, file.name);
  return field;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) {
    fmt::print(stderr, "usage: field_error FIELD REFERENCE [POINTS [MARGIN]]\n");
    return 2;
  }
  try {
    const Field field = load(argv[1]), reference = load(argv[2]);
    const int num_points = argc > 3 ? std::atoi(argv[3]) : 500;
    const double margin = argc > 4 ? std::atof(argv[4]) : 0.02;
    const Errors errors = compare(field::FieldEvaluator(field), field::FieldEvaluator(reference), num_points, margin);
    const int num_unknowns =
        galerkin::LaplaceSolver(field.mesh, galerkin::options_of(field)).num_unknowns(field.elem_order);
    int num_interior = 0;
    for (const int order : field.elem_order) num_interior += spectral::num_interior_modes(order);
    fmt::print(
        "{{\"points\": {}, \"max_error\": {:.4g}, \"rms_error\": {:.4g}, \"elements\": {}, \"condensed\": {}, "
        "\"unknowns\": {}, \"coefficients\": {}, \"max_order\": {}}}\n",
        errors.num_points, errors.greatest, std::sqrt(errors.sum_of_squares / std::max(1, errors.num_points)),
        field.mesh.num_elems(), num_unknowns, num_unknowns + (field.method == FieldMethod::cg ? num_interior : 0),
        field.u.size(), *std::max_element(field.elem_order.begin(), field.elem_order.end()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "field_error: {}\n", error.what());
    return 1;
  }
}
