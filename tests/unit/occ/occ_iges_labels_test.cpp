#include <gtest/gtest.h>

#include <TopExp_Explorer.hxx>
#include <set>

#include "../support/test_data.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || from.size() != to.size()) throw std::runtime_error("no " + from);
  return text.substr(0, at) + to + text.substr(at + from.size());
}

using Label = std::array<std::string, 3>;  // name, layer, colour

std::multiset<Label> labels(const std::string& bytes, TopAbs_ShapeEnum kind) {
  const OccModel model = occ_load(iges_format(), bytes, "a.iges");
  std::multiset<Label> found;
  for (TopExp_Explorer e(model.shape, kind); e.More(); e.Next()) {
    const ShapeLabel label = model.label_of(e.Current());
    found.insert({label.name, label.layer, label.colour});
  }
  return found;
}

/// A rectangle with a round hole.
const std::string file() { return test_bytes("labels.iges"); }

TEST(IgesLabels, names_levels_and_colours_of_the_boundary) {
  EXPECT_EQ(labels(file(), TopAbs_EDGE), (std::multiset<Label>{{"the wall", "level_5", ""},
                                                               {"", "level_5", ""},
                                                               {"", "", "ff0000"},
                                                               {"", "level_1", ""},
                                                               {"", "", "ff8000"}}));
  EXPECT_EQ(labels(file(), TopAbs_FACE), (std::multiset<Label>{{"", "level_1", ""}}));
}

TEST(IgesLabels, components_of_colours_are_percent) {
  EXPECT_TRUE(
      labels(replaced(file(), "314,100.0,50.0,0.0", "314,900.0,-9.0,0.0"), TopAbs_EDGE).contains({"", "", "ff0000"}));
}

TEST(IgesLabels, what_nobody_named_has_no_name) {
  for (const Label& label : labels(replaced(file(), "8Hthe wall", "4HNONE    "), TopAbs_EDGE)) EXPECT_EQ(label[0], "");
}

}  // namespace
}  // namespace quadrille::occ
