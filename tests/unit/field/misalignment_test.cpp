#include "field/misalignment.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/angle.hpp"

namespace quadrille::field {
namespace {

/// v = (1, 0) on the unit square: crosses along the axes.
Field along_axes() {
  Field field;
  field.mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 2);
  field.coef_offsets = {0};
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    field.elem_order.push_back(1);
    field.u.insert(field.u.end(), {std::sqrt(2.0), 0, 0});
    field.v.insert(field.v.end(), {0, 0, 0});
    field.coef_offsets.push_back(static_cast<int>(field.u.size()));
  }
  return field;
}

Misalignment of(const Alignment& alignment) {
  const Field field = along_axes();
  return misalignment(FieldEvaluator(field), alignment);
}

TEST(Misalignment, ACrossHasFourDirections) {
  for (int k = -4; k <= 4; ++k) EXPECT_NEAR(of({{{0.5, 0.5}, 1, 1, k * half_pi}}).rms_degrees(), 0, 1e-6);
  EXPECT_NEAR(of({{{0.5, 0.5}, 1, 1, pi / 6}}).rms_degrees(), 30, 1e-9);
  EXPECT_NEAR(of({{{0.5, 0.5}, 1, 1, pi / 3}}).rms_degrees(), 30, 1e-9);
  EXPECT_NEAR(of({{{0.5, 0.5}, 1, 1, pi / 4}}).mean_cosine_loss(), 2, 1e-12);
}

TEST(Misalignment, GaussiansCountByTheirIntegrals) {
  const Misalignment sum = of({{{0.25, 0.5}, 0.1, 3, 0}, {{0.75, 0.5}, 0.2, 1, pi / 6}});
  EXPECT_NEAR(sum.weight, 0.07, 1e-15);
  EXPECT_NEAR(sum.rms_degrees(), 30 * std::sqrt(4.0 / 7), 1e-9);
}

TEST(Misalignment, ThoseOutsideTheMeshDoNotCount) {
  EXPECT_NEAR(of({{{0.5, 0.5}, 1, 1, 0}, {{2, 0.5}, 1, 1, 0.3}}).rms_degrees(), 0, 1e-6);
  EXPECT_EQ(of({{{2, 0.5}, 1, 1, 0.3}}).rms_degrees(), 0);
}

TEST(Misalignment, RegionsAddUp) {
  Misalignment sum = of({{{0.25, 0.5}, 0.1, 3, 0}});
  sum += of({{{0.75, 0.5}, 0.2, 1, pi / 6}});
  EXPECT_NEAR(sum.rms_degrees(), 30 * std::sqrt(4.0 / 7), 1e-9);
}

}  // namespace
}  // namespace quadrille::field
