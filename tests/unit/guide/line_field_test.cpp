#include "guide/line_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/symmetry.hpp"
#include "field/boundary_values.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;

LineCorners corners_of(const CadFace& face) { return line_corners(face, curve::symmetries(face)); }

std::vector<int> valences(const LineCorners& chosen) {
  std::vector<int> list;
  for (const Corner& c : chosen.corners) list.push_back(c.valence);
  return list;
}

int index_of(const LineCorners& chosen) {
  int sum = 0;
  for (const Corner& c : chosen.corners) sum += 2 - c.valence;
  return sum;
}

TEST(LineCorners, OfARectangleAreRightAnglesAndNoTies) {
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}})}));
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(chosen.missing_index, 0);
  for (const Corner& c : chosen.corners) EXPECT_EQ(c.source, NodeSource::angle);
}

TEST(LineCorners, OfOneChamferTakeOneOfBothAtItsEnds) {
  // Three right angles leave index 1 for the two corners of 135 degrees: one takes valence 1, where sides are longest.
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {4, 0}, {4, 0.5}, {3.5, 1}, {0, 1}})}));
  EXPECT_EQ(chosen.missing_index, 0);
  EXPECT_EQ(index_of(chosen), 4);
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 2, 1, 1}));  // at (3.5, 1): the side of length 3.5 is longer
  EXPECT_EQ(chosen.corners[3].source, NodeSource::line);
}

TEST(LineCorners, DecideMirrorImagesTogetherAndReportWhatIsMissing) {
  // The mirror image of the first chamfer's end is its other end: both or none.
  const LineCorners both = corners_of(make_face({polygon({{0, 0}, {1, 0}, {1, 0.7}, {0.7, 1}, {0, 1}})}));
  EXPECT_EQ(both.missing_index, 1);
  EXPECT_EQ(valences(both), (std::vector<int>{1, 1, 2, 2, 1}));
}

TEST(LineCorners, TakeTheLargerValenceAt45Degrees) {
  const LineCorners chosen = corners_of(make_face({polygon({{0, 0}, {2, 0}, {0, 2}})}));
  EXPECT_EQ(valences(chosen), (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(chosen.missing_index, 1);  // a node of valence 3 inside
}

using namespace testing_faces;

/// Corners cut off at 45 degrees: a at (0, 0), b at (w, 0), c at (w, h), d at (0, h); 0: not cut.
CadFace chamfered(double w, double h, double a, double b, double c, double d) {
  std::vector<Vec2> points;
  const auto add = [&](Vec2 corner, double cut, Vec2 in, Vec2 out) {
    if (cut > 0) points.push_back(corner - cut * in);
    points.push_back(corner + cut * out);
  };
  add({0, 0}, a, {0, -1}, {1, 0});
  add({w, 0}, b, {1, 0}, {0, 1});
  add({w, h}, c, {0, 1}, {-1, 0});
  add({0, h}, d, {-1, 0}, {0, -1});
  return make_face({polygon(points)});
}

CadFace octagon() {
  std::vector<Vec2> points;
  for (int k = 0; k < 8; ++k) points.push_back(unit(pi / 8 + k * pi / 4));
  return make_face({polygon(points)});
}

Loop diamond_hole(Vec2 centre, double r) {
  return polygon({centre + Vec2{r, 0}, centre - Vec2{0, r}, centre - Vec2{r, 0}, centre + Vec2{0, r}});
}

int valence_at(const CriticalPoints& points, Vec2 x) {
  for (const Corner& c : points.corners)
    if (distance(c.position, x) < 1e-9) return c.valence;
  return -1;
}

/// What every answer must be.
void expect_sound(const CadFace& face, const CriticalPoints& points) {
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.index_sum_expected, 4 * face.euler_characteristic());
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  EXPECT_EQ(index_sum_of(points), points.index_sum);
  std::size_t next = 0;
  for (int j = 0; j < face.num_curves(); ++j) {
    if (!face.joints[j].is_corner) continue;
    ASSERT_LT(next, points.corners.size());
    const Corner& c = points.corners[next++];
    EXPECT_EQ(c.joint, j);
    EXPECT_TRUE(is_admissible_valence(c.angle_degrees, c.valence)) << c.angle_degrees << " " << c.valence;
    EXPECT_LE(std::abs(c.angle_degrees / 90 - c.valence), 0.5 + 1e-9);
  }
  EXPECT_EQ(next, points.corners.size());
}

bool is_invariant(const CriticalPoints& points, const curve::Isometry& g) {
  const bool corners = std::all_of(points.corners.begin(), points.corners.end(),
                                   [&](const Corner& c) { return valence_at(points, g(c.position)) == c.valence; });
  return corners && std::all_of(points.critical_points.begin(), points.critical_points.end(), [&](const auto& p) {
           return std::any_of(points.critical_points.begin(), points.critical_points.end(), [&](const auto& q) {
             return q.valence == p.valence && distance(g(p.position), q.position) < 1e-9;
           });
         });
}

std::size_t num_invariant(const CadFace& face, const CriticalPoints& points) {
  std::size_t n = 0;
  for (const curve::Isometry& g : curve::symmetries(face)) n += is_invariant(points, g);
  return n;
}

TEST(LineField, chamfered_plate_is_three_quads) {
  const CadFace face = chamfered(4, 3, 0.6, 0.4, 0, 0);
  ASSERT_TRUE(field::is_line_field(face));
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(valence_at(points, {0.6, 0}), 1);
  EXPECT_EQ(valence_at(points, {3.6, 0}), 1);
  EXPECT_EQ(valence_at(points, {4, 0.4}), 2);
  EXPECT_EQ(valence_at(points, {0, 0.6}), 2);
  EXPECT_EQ(valence_at(points, {0, 3}), 1);
  EXPECT_EQ(points.changes.size(), 4u);
  for (const NodeChange& change : points.changes) EXPECT_EQ(change.kind, ChangeKind::line);
  for (const Corner& c : points.corners)
    EXPECT_EQ(c.source, c.angle_degrees > 100 ? NodeSource::line : NodeSource::angle);
}

TEST(LineField, symmetric_plates_have_symmetric_corners) {
  for (const CadFace& face : {chamfered(4, 3, 0.5, 0.5, 0, 0), chamfered(4, 3, 0.5, 0.5, 0.5, 0.5),
                              chamfered(3, 3, 0.5, 0, 0.5, 0), chamfered(4, 3, 0.5, 0.3, 0.5, 0.3)}) {
    ASSERT_TRUE(field::is_line_field(face));
    const CriticalPoints points = line_field_points(face, 6);
    expect_sound(face, points);
    EXPECT_EQ(num_invariant(face, points), curve::symmetries(face).size());
  }
  // The long sides end in the corners of one block.
  const CriticalPoints plate = line_field_points(chamfered(4, 3, 0.5, 0.5, 0.5, 0.5), 6);
  EXPECT_TRUE(plate.critical_points.empty());
  EXPECT_EQ(valence_at(plate, {0.5, 0}), 1);
  EXPECT_EQ(valence_at(plate, {0, 0.5}), 2);
}

TEST(LineField, one_chamfer_on_the_mirror_axis_takes_a_node) {
  // Both ends of the chamfer are one orbit, but only one of them could take the smaller valence.
  const CadFace face = chamfered(3, 3, 0.5, 0, 0, 0);
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_EQ(points.critical_points[0].source, NodeSource::line);
  EXPECT_EQ(num_invariant(face, points), 2u);
  EXPECT_NEAR(points.critical_points[0].position.x, points.critical_points[0].position.y, 1e-9);
  EXPECT_NEAR(points.critical_points[0].position.x, 1.5, 0.3);
}

TEST(LineField, octagons_have_four_nodes_of_valence_3) {
  for (const CadFace& face : {octagon(), chamfered(3, 3, 0.5, 0.5, 0.5, 0.5), moved(octagon(), 2, 0.3, {5, 1}, true)}) {
    ASSERT_TRUE(field::is_line_field(face));
    const CriticalPoints points = line_field_points(face, 6);
    expect_sound(face, points);
    ASSERT_EQ(points.critical_points.size(), 4u);
    for (const CriticalPoint& p : points.critical_points) EXPECT_EQ(p.valence, 3);
    for (const Corner& c : points.corners) EXPECT_EQ(c.valence, 2);
    EXPECT_EQ(num_invariant(face, points), 8u);
  }
}

TEST(LineField, ramps_take_two_on_both_ends) {
  const CadFace face = make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {5, 1}, {5, 2.5}, {0, 2.5}})});
  ASSERT_TRUE(field::is_line_field(face));
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(valence_at(points, {2, 0}), 2);
  EXPECT_EQ(valence_at(points, {3, 1}), 2);
}

TEST(LineField, triangle_has_one_node_on_its_axis_instead_of_a_corner_of_valence_0) {
  const CadFace face = make_face({polygon({{0, 0}, {2, 0}, {0, 2}})});
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_EQ(num_invariant(face, points), 2u);
  for (const Corner& c : points.corners) EXPECT_EQ(c.valence, 1);
}

TEST(LineField, holes_turned_by_45_degrees) {
  const Loop outline = polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  const CadFace face = make_face({outline, diamond_hole({0, 0}, 0.8)});
  ASSERT_TRUE(field::is_line_field(face));
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(num_invariant(face, points), 8u);
}

TEST(LineField, nodes_about_a_hole_lie_inside_the_face) {
  const CadFace plate = chamfered(4, 4, 1, 1, 1, 1);
  const Loop outline(plate.curves.begin(), plate.curves.end());
  const CadFace face = make_face({outline, diamond_hole({2, 2}, 0.5)});
  const CriticalPoints points = line_field_points(face, 6);
  expect_sound(face, points);
  ASSERT_EQ(points.critical_points.size(), 4u);
  EXPECT_EQ(num_invariant(face, points), 8u);
  for (const CriticalPoint& p : points.critical_points) {
    const Vec2 d = p.position - Vec2{2, 2};
    EXPECT_GT(std::abs(d.x) + std::abs(d.y), 0.6);
    EXPECT_LT(std::abs(d.x) + std::abs(d.y), 2.9);
    EXPECT_LT(std::max(std::abs(d.x), std::abs(d.y)), 1.9);
  }
}

TEST(LineField, does_not_depend_on_place_orientation_or_first_curve) {
  const std::vector<CadFace> faces = {chamfered(4, 3, 0.6, 0.4, 0, 0), chamfered(4, 3, 0.5, 0.5, 0.5, 0.5),
                                      chamfered(4, 3, 0.9, 0, 0.7, 0), chamfered(3, 3, 0.5, 0, 0, 0),
                                      make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {3, 2}, {0, 2}})})};
  for (const CadFace& face : faces)
    for (const bool mirrored : {false, true}) {
      const double angle = radians(37);
      const Vec2 shift{3, -2};
      const auto h = [&](Vec2 x) { return 2 * curve::Isometry{{0, 0}, angle, mirrored}.turned(x) + shift; };
      CadFace image = moved(face, 2, angle, shift, mirrored);
      Loop turned(image.curves.begin(), image.curves.end());
      std::rotate(turned.begin(), turned.begin() + 2, turned.end());
      image = make_face({turned});
      const CriticalPoints here = line_field_points(face, 6), there = line_field_points(image, 6);
      for (const Corner& c : here.corners) EXPECT_EQ(valence_at(there, h(c.position)), c.valence);
      ASSERT_EQ(here.critical_points.size(), there.critical_points.size());
      for (const CriticalPoint& p : here.critical_points)
        EXPECT_TRUE(std::any_of(there.critical_points.begin(), there.critical_points.end(), [&](const auto& q) {
          return distance(h(p.position), q.position) < 1e-8 * image.diameter;
        }));
    }
}

/// Random polygons with sides at multiples of 45 degrees: the rectangle with a random cut or step at each corner and a
/// random bump on each side; every other one the same at each, with the symmetry of a square.
TEST(LineField, index_sum_holds_on_random_polygons) {
  std::mt19937 random(7);
  int with_nodes = 0, without = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec2> points;
    const auto seed = random();
    const auto pick = [&](int n) { return static_cast<int>(random() % n); };
    for (int side = 0; side < 4; ++side) {
      if (trial % 2 == 1) random.seed(seed);
      const Vec2 along = std::array<Vec2, 4>{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}[side], in = left_of(along);
      const Vec2 corner = std::array<Vec2, 4>{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}[side];
      const double cut = 1 + pick(2);
      const int kind = pick(3);
      if (kind == 0) points.push_back(corner);
      if (kind >= 1) points.push_back(corner + cut * in);
      if (kind == 2) points.push_back(corner + cut * in + cut * along);
      if (kind >= 1) points.push_back(corner + cut * along);
      const int bump = pick(4);
      const double depth = bump == 1 ? -1 : 1;  // outwards or inwards, with ramps; 3: a notch with a sharp end
      if (bump == 0) continue;
      points.push_back(corner + 3.5 * along);
      if (bump < 3) points.push_back(corner + 4.5 * along + depth * in);
      points.push_back(corner + (bump < 3 ? 5.5 : 5.0) * along + (bump < 3 ? depth : 1.5) * in);
      if (bump < 3) points.push_back(corner + 6.5 * along);
      if (bump == 3) points.push_back(corner + 6.5 * along);
    }
    const CadFace face = make_face({polygon(points)});
    if (!field::is_line_field(face)) continue;
    const CriticalPoints result = line_field_points(face, 6);
    expect_sound(face, result);
    ++(result.critical_points.empty() ? without : with_nodes);
    EXPECT_EQ(num_invariant(face, result), curve::symmetries(face).size());
  }
  EXPECT_GT(with_nodes, 5);
  EXPECT_GT(without, 20);
}

}  // namespace
}  // namespace quadrille::guide
