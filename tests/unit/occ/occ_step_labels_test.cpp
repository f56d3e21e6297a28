#include <gtest/gtest.h>

#include <TopExp_Explorer.hxx>
#include <set>

#include "../support/test_data.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from);
  return text.substr(0, at) + to + text.substr(at + from.size());
}

using Label = std::array<std::string, 3>;  // name, layer, colour

Label of(const OccModel& model, const TopoDS_Shape& shape) {
  const ShapeLabel label = model.label_of(shape);
  return {label.name, label.layer, label.colour};
}

std::set<Label> labels(const std::string& bytes, TopAbs_ShapeEnum kind) {
  const OccModel model = occ_load(step_format(), bytes, "a.step");
  std::set<Label> found;
  for (TopExp_Explorer e(model.shape, kind); e.More(); e.Next()) found.insert(of(model, e.Current()));
  return found;
}

TEST(StepLabels, names_layers_and_colours_of_edges_and_faces) {
  const std::string bytes = test_bytes("labels.step");
  EXPECT_EQ(labels(bytes, TopAbs_FACE).size(), 1U);
  EXPECT_EQ((*labels(bytes, TopAbs_FACE).begin())[1], "part");
  EXPECT_EQ(labels(bytes, TopAbs_EDGE), (std::set<Label>{{"Zufluß", "walls", "00ff00"},
                                                         {"", "outlet", "00ff00"},
                                                         {"", "walls", ""},  // through its curve
                                                         {"", "", "ff8000"},
                                                         {"", "part", "0000ff"}}))
      << "an overriding style counts, whatever else there is";
}

TEST(StepLabels, colours_that_are_not_known_are_none) {
  const std::string bytes = test_bytes("labels.step");
  const auto has = [&](const std::string& from, const std::string& to, const Label& label) {
    return labels(replaced(bytes, from, to), TopAbs_EDGE).contains(label);
  };
  EXPECT_TRUE(has("COLOUR('blue')", "COLOUR('cyan')", {"", "part", "00ffff"}));
  EXPECT_TRUE(has("COLOUR('blue')", "COLOUR('mauve')", {"", "part", "ff0000"})) << "the style that it would override";
  EXPECT_TRUE(has("COLOUR_RGB('',1.0,0.5,0.0)", "COLOUR_RGB('',2.0,-1.0,0.0)", {"", "", "ff0000"}));
}

/// A product, its solid and its shell can be one shape.
TEST(StepLabels, names_of_parts_come_from_the_outside_inwards) {
  const OccModel model = occ_load(step_format(), test_bytes("assemblies/parts.step"), "a.step");
  std::set<std::vector<std::string>> names;
  std::set<std::string> layers;
  for (const auto& [key, part] : model.parts) names.insert(part.names), layers.insert(part.layer);
  EXPECT_TRUE(names.contains({"bolt", "shank"}));
  EXPECT_TRUE(names.contains({"inlet"}) && names.contains({"outlet"}));
  EXPECT_TRUE(layers.contains("steel") && layers.contains("wet"));
}

}  // namespace
}  // namespace quadrille::occ
