#include "growth/line_correction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille::growth {
namespace {

using Lengths = std::vector<double>;

constexpr double limit = 1.3;

double sum(const Lengths& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

double greatest_ratio(const std::vector<Lengths>& pieces) {
  Lengths all;
  for (const Lengths& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  double worst = 1;
  for (std::size_t k = 1; k < all.size(); ++k) worst = std::max({worst, all[k] / all[k - 1], all[k - 1] / all[k]});
  return worst;
}

TEST(CorrectedLengths, SizesThatFillTheirPiecesStay) {
  const auto lengths = corrected_lengths({{1, Lengths(10, 0.1), {}, {}}, {2, Lengths(20, 0.1), {}, {}}}, false, limit);
  for (const Lengths& piece : lengths)
    for (const double length : piece) EXPECT_NEAR(length, 0.1, 1e-9);
}

TEST(CorrectedLengths, PiecesAreFilledWithoutAJumpBetweenThem) {
  const std::vector<LinePiece> pieces{{1, Lengths(10, 0.1), {}, {}}, {3, Lengths(20, 0.1), {}, {}}};
  const auto lengths = corrected_lengths(pieces, false, limit);
  EXPECT_NEAR(sum(lengths[0]), 1, 1e-8);
  EXPECT_NEAR(sum(lengths[1]), 3, 1e-8);
  EXPECT_LT(greatest_ratio(lengths), 1.1) << "0.1 and 0.15 apart by 10 and 20 intervals";
}

TEST(CorrectedLengths, GrowthOfTheSizesIsKeptFromLayersOn) {
  Lengths sizes;
  for (int k = 0; k < 12; ++k) sizes.push_back(0.01 * std::pow(1.2, k));
  const double whole = sum(sizes);
  const NextLayer layer{0.01 / 1.2, 0};
  const auto same = corrected_lengths({{whole, sizes, layer, {}}}, false, limit);
  for (std::size_t k = 0; k < sizes.size(); ++k) EXPECT_NEAR(same[0][k], sizes[k], 1e-9);
  const auto longer = corrected_lengths({{1.3 * whole, sizes, layer, {}}}, false, limit);
  EXPECT_NEAR(sum(longer[0]), 1.3 * whole, 1e-8);
  EXPECT_NEAR(longer[0][0], sizes[0], 0.08 * sizes[0]) << "it begins like the last layer";
  EXPECT_LT(greatest_ratio(longer), 1.27);
}

TEST(CorrectedLengths, ExcessOverTheLimitIsSharedByMoreIntervals) {
  // Five intervals beside a layer, too short for them: without the limit the first ratio would be 1.41.
  const NextLayer layer{0.00166, 0};
  Lengths beyond;
  for (int k = 0; k < 12; ++k) beyond.push_back(0.0022 * std::pow(1.15, k));
  const std::vector<LinePiece> pieces{{0.0058, Lengths(5, 0.00166), layer, {}}, {sum(beyond), beyond, {}, {}}};
  const auto worst = [&](const std::vector<Lengths>& lengths) {
    return std::max(greatest_ratio(lengths), layer.size / lengths[0].front());
  };
  const auto lengths = corrected_lengths(pieces, false, limit);
  EXPECT_NEAR(sum(lengths[0]), 0.0058, 1e-9);
  EXPECT_NEAR(sum(lengths[1]), sum(beyond), 1e-9);
  EXPECT_LT(worst(lengths), 1.33);
  EXPECT_GT(worst(corrected_lengths(pieces, false, 10)), 1.4);
}

TEST(CorrectedLengths, ALimitThatIsMetChangesNothing) {
  const std::vector<LinePiece> pieces{{1, Lengths(10, 0.1), {}, {}}, {3, Lengths(20, 0.1), {}, {}}};
  EXPECT_EQ(corrected_lengths(pieces, false, limit), corrected_lengths(pieces, false, 2));
}

TEST(CorrectedLengths, ALineFromTheOtherEndIsTheSame) {
  const LinePiece a{1, {0.1, 0.2, 0.3, 0.2}, NextLayer{0.1, 0.1}, {}}, b{2, {0.5, 0.4, 0.5}, {}, NextLayer{0.5, -0.1}};
  const auto forwards = corrected_lengths({a, b}, false, limit);
  const LinePiece a_turned{1, {0.2, 0.3, 0.2, 0.1}, {}, NextLayer{0.1, 0.1}},
      b_turned{2, {0.5, 0.4, 0.5}, NextLayer{0.5, -0.1}, {}};
  auto turned = corrected_lengths({b_turned, a_turned}, false, limit);
  std::reverse(turned.begin(), turned.end());
  for (std::size_t p = 0; p < 2; ++p) {
    std::reverse(turned[p].begin(), turned[p].end());
    for (std::size_t k = 0; k < turned[p].size(); ++k) EXPECT_NEAR(turned[p][k], forwards[p][k], 1e-9);
  }
}

TEST(CorrectedLengths, OnAClosedLineTheLastPieceMeetsTheFirst) {
  const std::vector<LinePiece> pieces{{1, Lengths(8, 0.1), {}, {}}, {1.2, Lengths(8, 0.1), {}, {}}};
  const auto closed = corrected_lengths(pieces, true, limit);
  EXPECT_NEAR(closed[0].front(), closed[0].back(), 1e-9) << "both of its neighbours are the other piece";
  EXPECT_NEAR(closed[1].front(), closed[1].back(), 1e-9);
  EXPECT_LT(closed[1].back() / closed[0].front(), 1.1) << "without corrections 1.2";
}

}  // namespace
}  // namespace quadrille::growth
