#include <gtest/gtest.h>

#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

std::string specfem_file(const Exported& exported, const std::string& ending) {
  for (const SideFile& side : exported.side_files)
    if (side.name.ending == ending) return side.bytes;
  return "no " + ending;
}

TEST(Specfem, TwoQuadsInFull) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = {"absorbing", "Free", "Abso", "axis"};
  const Exported exported = specfem2d(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, "2\n1 2 3 4 7 8 9 10 14\n2 5 6 3 11 12 13 8 15\n");
  EXPECT_EQ(specfem_file(exported, ".nodes"),
            "15\n0 0\n2 0\n2 2\n0 2\n4 0\n4 2\n1 0\n2 1\n1 2\n0 1\n3 0\n4 1\n3 2.5\n1 1\n3 1.25\n");
  EXPECT_EQ(specfem_file(exported, ".materials"), "1\n2\n");
  EXPECT_EQ(specfem_file(exported, ".free_surface"), "1\n2 2 5 6\n");
  EXPECT_EQ(specfem_file(exported, ".absorbing_surface"), "4\n1 2 1 2 1\n2 2 2 5 1\n2 2 6 3 3\n1 2 3 4 3\n");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0], "1 boundary name begins with neither free nor abso: these sides are in no file");
  EXPECT_EQ(exported.losses[1], "regions are stored as numbers, which *.names.json lists");
}

TEST(Specfem, AbsorbingSidesFaceFourWays) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = {"abso", "abso", "abso", "abso"};
  const Exported exported = specfem2d(mesh, plane_frame(mesh.face));
  EXPECT_EQ(specfem_file(exported, ".absorbing_surface"),
            "6\n1 2 1 2 1\n2 2 2 5 1\n2 2 5 6 2\n2 2 6 3 3\n1 2 3 4 3\n1 2 4 1 4\n");
}

TEST(Specfem, ThePageShowsWhatIsWritten) {
  QuadMesh mesh = two_quads_of_the_pages();
  mesh.face.curve_names = {"abso", "outlet", "free", "abso"};
  const Exported exported = specfem2d(mesh, plane_frame(mesh.face));
  for (const std::string& bytes :
       {exported.bytes, specfem_file(exported, ".nodes"), specfem_file(exported, ".free_surface"),
        specfem_file(exported, ".absorbing_surface")})
    EXPECT_NE(page("specfem2d.md").find("```\n" + bytes + "```\n"), std::string::npos) << bytes;
}

}  // namespace
}  // namespace quadrille::exports
