#include "export/patch_types.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

using Types = std::vector<std::string>;

/// The types of the boundaries of two_quads(), whose curves below, right, above (bent) and left have these names.
Types types_of(const std::vector<std::string>& names, const std::vector<std::string>& options = {}) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = names;
  return patch_types(mesh, mesh_groups(mesh), patch_type_options(options));
}

TEST(PatchTypes, FollowFromTheBeginningOfTheName) {
  EXPECT_EQ(types_of({"wall", "Wall_2", "WALLS", "outer wall"}), (Types{"wall", "wall", "wall", "patch"}));
  EXPECT_EQ(types_of({"symmetry", "Symmetry_2", "symmetry top", "empty"}),
            (Types{"symmetryPlane", "symmetryPlane", "symmetry", "empty"}));
  EXPECT_EQ(types_of({"symmetry", "symmetry", "inlet", "wal"}), (Types{"symmetry", "patch", "patch"})) << "two lines";
}

TEST(PatchTypes, AnOptionDecides) {
  EXPECT_EQ(types_of({"inlet", "outlet", "wall", "wall"}, {"*let=wall", "inlet=symmetryPlane", "wall=patch"}),
            (Types{"symmetryPlane", "wall", "patch"}));
  EXPECT_EQ(types_of({"a=b", "c", "c", "c"}, {"a=b=wedge"}), (Types{"wedge", "patch"}));
}

TEST(PatchTypes, MistakesAreRefused) {
  const auto message = [](const std::string& option) {
    return message_of<UsageError>([&] { types_of({"inlet", "wall", "wall", "wall"}, {option}); });
  };
  EXPECT_EQ(message("lid=wall"), "--patch-type lid=wall: no boundary has this name; the boundaries are inlet, wall");
  EXPECT_EQ(message("inlet=cyclic"),
            "--patch-type inlet=cyclic: the type must be one of patch, wall, symmetryPlane, symmetry, empty, wedge");
  EXPECT_EQ(message("inlet"), "--patch-type inlet: expected NAME=TYPE, such as inlet=patch");
  EXPECT_NE(message("=wall"), "");
}

}  // namespace
}  // namespace quadrille::exports
