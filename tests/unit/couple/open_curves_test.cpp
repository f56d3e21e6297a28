#include "couple/open_curves.hpp"

#include <gtest/gtest.h>

#include "../regions/faces_of_regions.hpp"
#include "base/error.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

CadFace two_squares() {
  CadFace face = face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})});
  face.curve_names[1] = face.curve_names[7] = "wall";
  face.unnamed_curves = {0, 2, 3, 4, 5, 6};
  return face;
}

TEST(OpenCurves, BothSidesLoseTheirPartners) {
  const CadFace face = with_open_curves(two_squares(), {"wall"}, "--open");
  for (int c = 0; c < face.num_curves(); ++c) EXPECT_FALSE(face.is_interface(c));
  EXPECT_TRUE(with_open_curves(two_squares(), {}, "--open").is_interface(1));
}

TEST(OpenCurves, ABoundaryCannotBeOpened) {
  EXPECT_THROW(with_open_curves(two_squares(), {"curve_0"}, "--open"), UsageError);
  EXPECT_THROW(with_open_curves(two_squares(), {"nowhere"}, "--open"), UsageError);
}

TEST(OpenCurves, NonconformingInterfacesAreNamed) {
  EXPECT_EQ(nonconforming_interfaces({"wall=nonconforming", "a=b=nonconforming"}),
            (std::vector<std::string>{"wall", "a=b"}));
  for (const char* option : {"wall", "=nonconforming", "wall=conforming"})
    EXPECT_THROW(nonconforming_interfaces({option}), UsageError) << option;
}

}  // namespace
}  // namespace quadrille::couple
