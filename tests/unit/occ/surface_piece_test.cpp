#include "occ/surface_piece.hpp"

#include <gtest/gtest.h>

#include "curve/nurbs.hpp"
#include "surface_samples.hpp"

namespace quadrille::occ {
namespace {

TEST(SurfacePiece, CurvesInSpaceAndInTheParametersAreTheSame) {
  for (const bool is_whole : {false, true}) {
    const BlockLayout layout = samples::blocks_on_sphere(0.1, is_whole, false);
    const SurfacePieces pieces(layout);
    EXPECT_TRUE(pieces.keeps_orientation());
    for (const GraphArc& arc : layout.arcs) {
      const SurfacePiece piece = pieces.piece(arc.pieces[0], pieces.node(arc.from), pieces.node(arc.to));
      EXPECT_LT(piece.distance, 1e-7);
      EXPECT_NEAR(distance(piece.space.poles.front(), samples::on_sphere(layout.nodes[arc.from].position)), 0, 1e-7);
      EXPECT_NEAR(distance(piece.space.poles.back(), samples::on_sphere(layout.nodes[arc.to].position)), 0, 1e-7);
      EXPECT_EQ(piece.space.begin(), piece.uv.begin());
      EXPECT_NEAR(piece.space.end(), piece.uv.end(), 1e-15);
    }
  }
}

TEST(SurfacePiece, ThePoleDoesNotDetermineOneParameter) {
  const BlockLayout layout = samples::blocks_on_sphere(0, true, true);
  const SurfacePieces pieces(layout);
  EXPECT_EQ(pieces.node(0).free, Parameter::u);
  EXPECT_EQ(pieces.node(1).free, Parameter::none);
  const SurfacePiece piece = pieces.piece(layout.arcs[0].pieces[0], pieces.node(0), pieces.node(1));
  EXPECT_NEAR(piece.uv.poles.front().x, piece.uv.poles.back().x, 1e-7) << "a meridian";
  EXPECT_NEAR(period(pieces.surface(), Parameter::u), 2 * M_PI, 1e-12);
  EXPECT_EQ(period(pieces.surface(), Parameter::v), 0);
}

}  // namespace
}  // namespace quadrille::occ
