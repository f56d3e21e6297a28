#include "guide/corner_override.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::guide {
namespace {

TEST(ParseCornerOverride, reads_two_curves_and_a_valence) {
  const CornerOverride o = parse_corner_override("3:14=2");
  EXPECT_EQ(o.curve_a, 3);
  EXPECT_EQ(o.curve_b, 14);
  EXPECT_EQ(o.valence, 2);
  for (const char* text :
       {"", "3", "3:4", "3=4:2", "3:4=", ":4=2", "a:4=2", "3:4=2x", "-3:4=2", "3:4=-1", "3: 4=2", "3:4=99999999999"})
    EXPECT_THROW(parse_corner_override(text), UsageError) << text;
}

}  // namespace
}  // namespace quadrille::guide
