#include "io/boundary_names.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille {
namespace {

CadFace face_with_names(std::vector<std::string> names) {
  CadFace face;
  face.curves.resize(names.size());
  face.curve_names = std::move(names);
  return face;
}

using Names = std::vector<std::string>;

Names renamed(Names names, const std::string& json) {
  CadFace face = face_with_names(std::move(names));
  rename_boundary(face, {"names.json", json, ""});
  return face.curve_names;
}

TEST(BoundaryNames, ByNameAndByNumber) {
  EXPECT_EQ(renamed({"a", "b", "c"}, R"({"a": "inlet", "2": "wall"})"), (Names{"inlet", "b", "wall"}));
}

TEST(BoundaryNames, ANameMeansAllCurvesThatHaveIt) {
  EXPECT_EQ(renamed({"a", "b", "a"}, R"({"a": "wall", "b": "wall"})"), (Names{"wall", "wall", "wall"}));
}

TEST(BoundaryNames, OldNamesAreThoseBeforeTheFirstChange) {
  EXPECT_EQ(renamed({"a", "b"}, R"({"a": "b", "b": "a"})"), (Names{"b", "a"}));
}

TEST(BoundaryNames, ANameThatIsANumberGoesBeforeTheNumber) {
  EXPECT_EQ(renamed({"1", "b"}, R"({"1": "x"})"), (Names{"x", "b"}));
}

TEST(BoundaryNames, WhatMeetsNoCurveOrIsNoNameIsRefused) {
  for (const char* json :
       {"", "[]", "{\"z\": \"x\"}", "{\"2\": \"x\"}", "{\"-1\": \"x\"}", "{\"a\": \"\"}", "{\"a\": 3}"})
    EXPECT_THROW(renamed({"a", "b"}, json), FormatError) << json;
}

}  // namespace
}  // namespace quadrille
