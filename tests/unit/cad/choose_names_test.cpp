#include "cad/choose_names.hpp"

#include <gtest/gtest.h>

namespace quadrille::cad {
namespace {

heal::RawEdge edge(const std::string& name, const std::string& layer, const std::string& colour) {
  heal::RawEdge e;
  e.name = name, e.layer = layer, e.colour = colour;
  return e;
}

using Names = std::vector<std::string>;

/// The names of the edges, and that of the face at the end.
Names chosen(std::vector<heal::RawEdge> edges, const std::string& face_name = "", const std::string& face_layer = "") {
  heal::RawFace raw;
  raw.name = face_name, raw.layer = face_layer;
  for (heal::RawEdge& e : edges) raw.wires.push_back({std::move(e)});
  choose_names(raw);
  Names names;
  for (const auto& wire : raw.wires) names.push_back(wire.front().name);
  names.push_back(raw.name);
  return names;
}

TEST(ChooseNames, name_before_layer_before_colour) {
  EXPECT_EQ(chosen({edge("inlet", "walls", "ff0000"), edge("", "walls", "ff0000"), edge("", "", "ff0000"),
                    edge("", "", "0000ff"), edge("", "", "")}),
            (Names{"inlet", "walls", "colour_ff0000", "colour_0000ff", "", ""}));
}

TEST(ChooseNames, the_layer_of_the_part_names_neither_edges_nor_face) {
  EXPECT_EQ(chosen({edge("", "1", ""), edge("", "wall", "")}, "", "1"), (Names{"", "wall", ""}));
}

TEST(ChooseNames, one_layer_for_all_edges_is_their_name) {
  EXPECT_EQ(chosen({edge("", "wall", ""), edge("", "wall", "")}, "", "fluid"), (Names{"wall", "wall", "fluid"}));
  EXPECT_EQ(chosen({edge("", "wall", ""), edge("", "wall", "")}, "air", "fluid"), (Names{"wall", "wall", "air"}));
}

TEST(ChooseNames, one_colour_for_all_of_several_edges_says_nothing) {
  EXPECT_EQ(chosen({edge("", "", "000000"), edge("", "", "000000")}), (Names{"", "", ""}));
  EXPECT_EQ(chosen({edge("", "", "000000")}), (Names{"colour_000000", ""}));
  EXPECT_EQ(chosen({edge("", "", "000000"), edge("", "", "")}), (Names{"colour_000000", "", ""}));
}

}  // namespace
}  // namespace quadrille::cad
