#include "trace/line_fitter.hpp"

#include <gtest/gtest.h>

#include "../support/two_nodes.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::trace {
namespace {

Vec2 first(const Nurbs& spline) { return curve::point(spline, spline.begin()); }
Vec2 last(const Nurbs& spline) { return curve::point(spline, spline.end()); }

TEST_F(TwoNodes, ASingleLineIsFittedFromItsNodeToItsEnd) {
  make(0.2);
  LineFitter fitter(*evaluator, lines);
  for (int k = 0; k < static_cast<int>(lines.size()); ++k) {
    const MergedLine line = fitter.single(k);
    EXPECT_EQ(line.streamline, k);
    EXPECT_EQ(line.merge, -1);
    EXPECT_EQ(line.length, lines[k].length());
    EXPECT_EQ(line.line.kind, LineKind::traced);
    EXPECT_EQ(line.line.start.node, lines[k].launch.start.node);
    EXPECT_EQ(line.line.end.curve, lines[k].reached.curve);
    EXPECT_EQ(line.line.end.t, lines[k].reached.t);
    EXPECT_EQ(first(line.line.spline), nodes[lines[k].launch.start.node]);
    EXPECT_EQ(last(line.line.spline), lines[k].end_position);
  }
}

TEST_F(TwoNodes, SplinesFollowTheirLines) {
  make(0.2);
  LineFitter fitter(*evaluator, lines);
  const Nurbs spline = fitter.single(0).line.spline;
  for (int i = 0; i <= 50; ++i) {
    const double s = lines[0].length() * i / 50;
    EXPECT_LT(distance(curve::point(spline, s), lines[0].at(*evaluator, s)),
              2 * relative_fit_tol * field.mesh.face.diameter);
  }
}

TEST_F(TwoNodes, ALineFromTheBoundaryIsACut) {
  make(0);
  lines.push_back(advance(*evaluator, launch_from_boundary(*evaluator, 0, 0.5), PointGrid({}), {1e-11, 0.1, 10, 1e-7}));
  LineFitter fitter(*evaluator, lines);
  const MergedLine cut = fitter.single(static_cast<int>(lines.size()) - 1);
  EXPECT_EQ(cut.line.kind, LineKind::cut);
  EXPECT_EQ(cut.line.start.node, -1);
  EXPECT_EQ(cut.line.start.curve, 0);
  EXPECT_EQ(cut.line.start.t, 0.5);
}

TEST_F(TwoNodes, AMergedPairLeadsFromNodeToNode) {
  make(0.2);
  const MergeCandidate pair = candidates(20).at(0);
  LineFitter fitter(*evaluator, lines);
  const MergedLine merged = fitter.pair(pair, 7);
  EXPECT_EQ(merged.line.kind, LineKind::merged);
  EXPECT_EQ(merged.merge, 7);
  EXPECT_EQ(merged.streamline, pair.a);
  EXPECT_NEAR(merged.length, pair.length(), 1e-15);
  EXPECT_EQ(merged.line.start.node, lines[pair.a].launch.start.node);
  EXPECT_EQ(merged.line.end.node, lines[pair.b].launch.start.node);
  EXPECT_EQ(first(merged.line.spline), nodes[lines[pair.a].launch.start.node]);
  EXPECT_EQ(last(merged.line.spline), nodes[lines[pair.b].launch.start.node]);
}

TEST_F(TwoNodes, EqualKeysMeanTheSameCurveAndOthersDoNot) {
  make(0.2);
  const MergeCandidate pair = candidates(20).at(0);
  MergeCandidate join = pair;
  join.is_join = true;
  LineFitter fitter(*evaluator, lines);
  EXPECT_EQ(fitter.single(0).key, fitter.single(0).key);
  EXPECT_NE(fitter.single(0).key, fitter.single(1).key);
  EXPECT_EQ(fitter.pair(pair, 0).key, fitter.pair(pair, 3).key);
  EXPECT_NE(fitter.pair(pair, 0).key, fitter.single(pair.a).key);
  EXPECT_NE(fitter.pair(pair, 0).key, fitter.pair(join, 0).key);
  EXPECT_EQ(fitter.single(0).line.spline.knots, fitter.single(0).line.spline.knots);
}

TEST_F(TwoNodes, ALineThatWasContinuedIsFittedAgain) {
  make(0);
  LineFitter fitter(*evaluator, lines);
  lines[0] = advance(*evaluator, lines[0].launch, PointGrid(nodes), {1e-11, 0.1, 0.2, 1e-7});
  const MergedLine brief = fitter.single(0);
  EXPECT_EQ(brief.line.end.node, -1);
  EXPECT_EQ(brief.line.end.curve, -1);
  follow(*evaluator, lines[0], PointGrid(nodes), {1e-11, 0.1, 10, 1e-7});
  const MergedLine whole = fitter.single(0);
  EXPECT_NE(brief.key, whole.key);
  EXPECT_GT(whole.line.spline.end(), brief.line.spline.end());
}

}  // namespace
}  // namespace quadrille::trace
