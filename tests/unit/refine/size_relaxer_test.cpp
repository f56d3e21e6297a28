#include "refine/size_relaxer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

/// The unit square in equal squares, with smaller sizes near a part of a side.
struct Sample {
  QuadMesh mesh = refined(
      hand_made::unit_square(),
      {.size = 0.125, .order = 1, .geometry_tol = 1e-3, .inner_edges = InnerEdges::curved, .relax = Relax::none});
  sizing::SizeField sizes = sizing::SizeField(0.125).with({{{0, 0, 0}, {0.1, 0, 0}, 0.03, 0.03}});
  SizeRelaxation options{.sizes = sizes, .tolerance = 1e-3};
  RelaxProblem problem{mesh, {}};
  std::vector<Vec2> once = std::vector<Vec2>(mesh.num_elems(), Vec2{1, 1});
};

double greatest_difference(const VertexMoves& a, const VertexMoves& b) {
  double greatest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) greatest = std::max(greatest, distance(a[v], b[v]));
  return greatest;
}

TEST(SizeRelaxer, SizesAreThoseWhereARunBegins) {
  const Sample on;
  SizeRelaxer relaxer(on.problem, on.mesh, on.options);
  relaxer.least_progress = 1e-5;  // sizes are set again every ten sweeps, of which there are fewer then
  const VertexMoves start = relaxer.moves;
  relaxer.set_counts(on.once);
  relaxer.run();
  const VertexMoves first = relaxer.moves;
  relaxer.set_counts(on.once);
  relaxer.run();
  EXPECT_GT(greatest_difference(relaxer.moves, first), 0);
  EXPECT_LT(greatest_difference(relaxer.moves, first), 1e-3);
  // As one that knows no sizes yet, and from the same vertices again.
  SizeRelaxer other(on.problem, on.mesh, on.options);
  other.least_progress = relaxer.least_progress;
  other.moves = first;
  other.set_counts(on.once);
  other.run();
  EXPECT_EQ(relaxer.moves, other.moves);
  relaxer.moves = start;
  relaxer.set_counts(on.once);
  relaxer.run();
  EXPECT_EQ(relaxer.moves, first);
}

}  // namespace
}  // namespace quadrille::refine
