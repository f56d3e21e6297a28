#include "quantize/integer_program.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/parallel.hpp"

namespace quadrille::quantize {
namespace {

TEST(IntegerProgram, FindsWholeNumbersWhereTheRealOptimumHasNone) {
  // Maximise x + y with 2 x + 2 y + slack = 5.
  IntegerProgram program;
  const int x = program.add_variable(0, 10, -1, true), y = program.add_variable(0, 10, -1, true);
  const int slack = program.add_variable(0, 10, 0, false);
  program.add_equation({{x, 2}, {y, 2}, {slack, 1}}, 5);
  const std::vector<double> solution = program.solve();
  ASSERT_EQ(solution.size(), 3u);
  EXPECT_EQ(solution[x] + solution[y], 2);
  EXPECT_NEAR(solution[slack], 1, 1e-9);
}

TEST(IntegerProgram, FindsTheBestOfAKnapsack) {
  // Values 8, 11, 6, 4 and weights 5, 7, 4, 3 of at most 14: the best are the last three, worth 21. By value over
  // weight the first two would be taken, then nothing fits.
  IntegerProgram program;
  const std::vector<double> values{8, 11, 6, 4}, weights{5, 7, 4, 3};
  std::vector<IntegerProgram::Term> terms;
  for (int i = 0; i < 4; ++i) terms.push_back({program.add_variable(0, 1, -values[i], true), weights[i]});
  terms.push_back({program.add_variable(0, 14, 0, false), 1});
  program.add_equation(terms, 14);
  const std::vector<double> solution = program.solve();
  ASSERT_EQ(solution.size(), 5u);
  EXPECT_EQ(std::vector<double>(solution.begin(), solution.end() - 1), (std::vector<double>{0, 1, 1, 1}));
}

TEST(IntegerProgram, VariablesThatNeedNotBeIntegerKeepTheirFractions) {
  IntegerProgram program;
  const int x = program.add_variable(0, 10, 1, false), n = program.add_variable(0, 10, 1.5, true);
  program.add_equation({{x, 2}, {n, 1}}, 5);
  const std::vector<double> solution = program.solve();
  ASSERT_EQ(solution.size(), 2u);
  EXPECT_NEAR(solution[x], 2.5, 1e-9);
  EXPECT_EQ(solution[n], 0);
}

TEST(IntegerProgram, TermsOfOneVariableInARowAreAdded) {
  // 2 x - x + y = 3, as where a face of a T-mesh meets itself.
  IntegerProgram program;
  const int x = program.add_variable(0, 10, 1, true), y = program.add_variable(0, 1, 5, true);
  program.add_equation({{x, 2}, {x, -1}, {y, 1}}, 3);
  EXPECT_EQ(program.solve(), (std::vector<double>{3, 0}));
}

TEST(IntegerProgram, BoundsHold) {
  IntegerProgram program;
  const int x = program.add_variable(2, 10, 1, true), y = program.add_variable(0, 3, 2, true);
  program.add_equation({{x, 1}, {y, -1}}, 0);
  EXPECT_EQ(program.solve(), (std::vector<double>{2, 2}));
  IntegerProgram none;
  const int a = none.add_variable(4, 10, 1, true), b = none.add_variable(0, 3, 1, true);
  none.add_equation({{a, 1}, {b, -1}}, 0);
  EXPECT_TRUE(none.solve().empty());
}

TEST(IntegerProgram, ReturnsNothingWhereOnlyFractionsSolveIt) {
  IntegerProgram program;
  const int x = program.add_variable(0, 10, 1, true);
  program.add_equation({{x, 2}}, 5);
  EXPECT_TRUE(program.solve().empty());
}

TEST(IntegerProgram, SeveralThreadsMaySolveAtATime) {
  std::vector<double> found(400, -1);
  parallel_for(static_cast<int>(found.size()), 4, [&](int i) {
    IntegerProgram program;
    const int x = program.add_variable(0, 1000, 1, true), y = program.add_variable(0, 1000, 3, true);
    program.add_equation({{x, 2}, {y, 5}}, 2 * i + 1);
    const std::vector<double> solution = program.solve();
    if (solution.size() == 2) found[i] = 2 * solution[x] + 5 * solution[y];
  });
  for (int i = 2; i < static_cast<int>(found.size()); ++i) EXPECT_EQ(found[i], 2 * i + 1);
}

}  // namespace
}  // namespace quadrille::quantize
