#include "stage/padapt.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "stage/fieldsolve.hpp"
#include "two_squares.hpp"

namespace quadrille::stage {
namespace {

using namespace testing_stages;

struct Padapt : testing::Test {
  PadaptOptions options;
  quadrille::Run run;

  Field adapted(const Field& start) { return padapt(as_input(start, "x.solve.h5"), options, run); }
};

/// Of two squares, whose field is constant.
TEST_F(Padapt, FieldsThatAreGoodEnoughAreKept) {
  const Field start = fieldsolve({as_input(two_squares(), "x.tri.h5"), {}, {}, {}}, {}, run);
  const Field field = adapted(start);
  EXPECT_EQ(field.elem_order, start.elem_order);
  ASSERT_EQ(field.provenance.size(), start.provenance.size() + 1);
  EXPECT_EQ(field.provenance.back().tool, "padapt");
  EXPECT_EQ(field.provenance.back().inputs.at(0).sha256, "digest of x.solve.h5");
}

TEST_F(Padapt, ElementsAreCountedByTheirOrder) {
  FieldsolveOptions solve;
  solve.order = 5;
  const TriMesh mesh = two_squares();
  options.policy = adapt::AdaptPolicy::paper, options.min_order = 3;
  const Field field = adapted(fieldsolve({as_input(mesh, "x.tri.h5"), {}, {}, {}}, solve, run));
  EXPECT_EQ(field.elem_order, std::vector<int>(mesh.num_elems(), 3)) << "lowered by one in each round";
  const auto& entries = run.report().entries();
  const auto reported =
      std::ranges::find(entries, "adapt.num_elements_by_order", [](const auto& e) { return e.first; });
  ASSERT_NE(reported, entries.end());
  EXPECT_EQ(std::get<std::vector<double>>(reported->second),
            (std::vector<double>{0, 0, 0, static_cast<double>(mesh.num_elems())}));
}

TEST_F(Padapt, WrongOptionsAndBrokenFieldsAreRefused) {
  Field start = samples::two_regions_field();
  options.max_order = 21;
  EXPECT_EQ(message_of<UsageError>([&] { adapted(start); }), "--max-order: 21 is outside its interval (1 to 20)");
  options = {};
  options.min_order = 5, options.max_order = 4;
  EXPECT_THROW(adapted(start), UsageError);
  options = {};
  start.elem_order[0] = 3;
  expect_contains(message_of<FormatError>([&] { adapted(start); }), "x.solve.h5: FLD-R");
}

}  // namespace
}  // namespace quadrille::stage
