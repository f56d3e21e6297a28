#include "mesh/mirrored_mesh.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/report.hpp"
#include "check/check.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::mesh {
namespace {

using namespace testing_faces;

TEST(MirroredMesh, SatisfiesAllRulesOfItsFormat) {
  Loop loop{curve::segment({-3, 0}, {-1, 0}), curve::circular_arc({0, 0}, 1, pi, 0), curve::segment({1, 0}, {3, 0}),
            curve::circular_arc({0, 0}, 3, 0, pi)};
  const CadFace face = make_face({loop, hole({0, 2}, 0.3)});
  Report report;
  const TriMesh half = triangulate::triangulate(face, {}, report);
  const curve::SymmetryLine line = curve::symmetry_lines(face, {0, 2}).lines[0];
  const TriMesh whole = mirrored_mesh(half, curve::mirrored_face(face, line), line);
  EXPECT_EQ(whole.num_elems(), 2 * half.num_elems());
  EXPECT_EQ(whole.face.num_loops(), 4);
  for (const check::Violation& violation : check::check_stage(whole, check::CheckDepth::full))
    ADD_FAILURE() << violation.rule << " " << violation.text;
}

}  // namespace
}  // namespace quadrille::mesh
