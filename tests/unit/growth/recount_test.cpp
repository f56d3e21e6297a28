#include "growth/recount.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "growth/smooth_divisions.hpp"
#include "refine/divide_arcs.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::growth {
namespace {

TEST(RecountChord, BreaksRemainEndsAndAllArcsGetOneCount) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::elbow(), report);
  const sizing::MeasuredLayout measured(layout);
  const auto plans = sizing::grade_chords(measured, sizing::SizeField(0.3), sizing::SizeRule::nearest, {});
  sizing::ArcDivisions divisions = refine::divide_arcs(measured, plans, {4, 1e-6});
  const GrowthInput input{measured, 1.3, 4, 1e-6};
  for (int chord = 0; chord < static_cast<int>(measured.chords().size()); ++chord) {
    const std::vector<int>& arcs = measured.chords()[chord].arcs;
    const int before = divisions[arcs[0]].num_intervals();
    std::vector<std::vector<double>> kept;  // by arc: breaks at which intervals end
    for (const int arc : arcs) {
      kept.emplace_back();
      for (const double f : fixed_fractions(input, arc))
        for (const double end : divisions[arc].ends)
          if (std::abs(f - end) < 1e-9) kept.back().push_back(end);
    }
    const int count = recount_chord(input, chord, before + 3, divisions);
    EXPECT_GE(count, before + 3);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const std::vector<double>& ends = divisions[arcs[i]].ends;
      EXPECT_EQ(static_cast<int>(ends.size()), count + 1);
      EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
      for (const double f : kept[i]) EXPECT_EQ(std::count(ends.begin(), ends.end(), f), 1);
    }
  }
}

}  // namespace
}  // namespace quadrille::growth
