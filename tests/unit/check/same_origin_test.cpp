#include "check/same_origin.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::check {
namespace {

TEST(SameOrigin, OneChainMustHoldTheOthersDigest) {
  const FileIdentity field{"a.field.h5", "f1"}, points{"a.crit.json", "c1"}, other{"b.crit.json", "c2"};
  const Provenance before{{"padapt", "1", {{"field", "f0"}}, "{}"}};
  const Provenance after{{"padapt", "1", {{"field", "f0"}}, "{}"}, {"critpoints", "1", {{"field", "f1"}}, "{}"}};
  EXPECT_NO_THROW(require_same_origin(field, before, points, after));
  EXPECT_NO_THROW(require_same_origin(points, after, field, before));
  EXPECT_THROW(require_same_origin(field, before, other, before), FormatError);
}

}  // namespace
}  // namespace quadrille::check
