#include "export/cgns_words.hpp"

#include <gtest/gtest.h>

#include <set>

namespace quadrille::exports {
namespace {

Groups groups(NameList boundaries, NameList regions) {
  Groups g;
  g.boundary_names = std::move(boundaries), g.region_names = std::move(regions);
  return g;
}

TEST(CgnsWords, BoundariesAndRegionsHaveDifferentWordsOfAtMost32Letters) {
  const std::string same(33, 'x');
  Exported exported;
  const PlainNames words = family_names(groups({"wall", same}, {"wall", same + 'y'}), exported);
  EXPECT_EQ(words.boundaries[0], "wall");
  std::set<std::string> all(words.boundaries.begin(), words.boundaries.end());
  all.insert(words.regions.begin(), words.regions.end());
  EXPECT_EQ(all.size(), 4u);
  for (const std::string& word : all) EXPECT_LE(word.size(), 32u);
  EXPECT_EQ(exported.losses.size(), 1u);
  EXPECT_EQ(exported.side_files.size(), 1u) << "the table of the names";
}

TEST(CgnsWords, PlainNamesStayWithoutALoss) {
  Exported exported;
  const PlainNames words = family_names(groups({"inlet"}, {"fluid"}), exported);
  EXPECT_EQ(words.boundaries, NameList{"inlet"});
  EXPECT_EQ(words.regions, NameList{"fluid"});
  EXPECT_TRUE(exported.losses.empty() && exported.side_files.empty());
}

TEST(CgnsWords, TypesFollowFromTheBeginningOfTheName) {
  const NameList names{"Wall_upper", "SYMMETRY", "farfield", "inlet", "Inflow2", "outlet", "outflow", "my wall", ""};
  const std::vector<CgnsFamily> all =
      families(groups(names, {"fluid"}), {names, {"fluid"}}, static_cast<int>(names.size()));
  std::vector<std::string> types;
  for (const CgnsFamily& family : all) types.push_back(family.boundary);
  EXPECT_EQ(types, (std::vector<std::string>{"BCWall", "BCSymmetryPlane", "BCFarfield", "BCInflow", "BCInflow",
                                             "BCOutflow", "BCOutflow", "UserDefined", "UserDefined", ""}));
  EXPECT_EQ(all.back().name, "fluid");
}

}  // namespace
}  // namespace quadrille::exports
