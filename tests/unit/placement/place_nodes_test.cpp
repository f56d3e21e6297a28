#include "placement/place_nodes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <complex>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "node_samples.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;
using Complex = std::complex<double>;

Complex as_complex(Vec2 x) { return {x.x, x.y}; }
Vec2 as_vec(Complex z) { return {z.real(), z.imag()}; }

struct Charge {
  Complex place;
  double index;
};

/// W of the unit disc and its gradient (lib/method.md §8.11):
/// -pi sum_{i != j} d_i d_j ln |a_i - a_j| - pi sum_{i, j} d_i d_j ln |1 - a_i conj(a_j)|.
NodeEnergy disc_energy(const std::vector<Charge>& nodes) {
  NodeEnergy w{0, std::vector<Vec2>(nodes.size())};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Complex a = nodes[i].place;
    if (std::abs(a) >= 1) throw ComputeError("a node is outside the disc");
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Complex b = nodes[j].place, image = 1.0 - a * std::conj(b);
      const double product = pi * nodes[i].index * nodes[j].index;
      w.value -= product * std::log(std::abs(image));
      w.gradient[i] += 2 * product * as_vec(b / std::conj(image));
      if (i == j) continue;
      w.value -= product * std::log(std::abs(a - b));
      w.gradient[i] -= 2 * product * as_vec(1.0 / std::conj(a - b));
    }
  }
  return w;
}

/// Of the upper half of the disc: half of what the nodes have together with their mirror images.
NodeEnergy half_disc_energy(std::vector<Charge> nodes) {
  const std::size_t n = nodes.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (nodes[k].place.imag() <= 0) throw ComputeError("a node is outside the half disc");
    nodes.push_back({std::conj(nodes[k].place), nodes[k].index});
  }
  NodeEnergy w = disc_energy(nodes);
  w.value /= 2;
  w.gradient.resize(n);
  return w;
}

/// x -> scale * R(angle) x + shift, mirrored about the x axis first where asked; of the unit disc or its upper half.
struct Motion {
  double scale = 1, angle = 0;
  Vec2 shift;
  bool mirrored = false;

  CadFace operator()(const CadFace& face) const { return moved(face, scale, angle, shift, mirrored); }
  Vec2 operator()(Vec2 x) const {
    const Complex z = as_complex(x);
    return as_vec(scale * std::polar(1.0, angle) * (mirrored ? std::conj(z) : z)) + shift;
  }
  Complex back(Vec2 x) const {
    const Complex z = as_complex(x - shift) / (scale * std::polar(1.0, angle));
    return mirrored ? std::conj(z) : z;
  }
  EnergyFunction operator()(NodeEnergy (*energy)(std::vector<Charge>)) const {
    return [=, *this](const CriticalPoints& points) {
      std::vector<Charge> nodes;
      for (const CriticalPoint& p : points.critical_points) nodes.push_back({back(p.position), 4.0 - p.valence});
      NodeEnergy w = energy(nodes);
      for (Vec2& g : w.gradient) {
        const Complex z = as_complex(g);
        g = as_vec(std::polar(1.0, angle) / scale * (mirrored ? std::conj(z) : z));
      }
      return w;
    };
  }
};

NodeEnergy in_disc(std::vector<Charge> nodes) { return disc_energy(nodes); }

CadFace disc() { return make_face({circle({0, 0}, 1)}); }

struct Placed {
  Placed(const CadFace& face, const EnergyFunction& energy, const CriticalPoints& start, double weight,
         std::vector<bool> is_free = {}, const LogScale& log_scale = {})
      : points(start) {
    PlacementOptions options;
    options.weight = weight;
    options.log_scale = log_scale;
    is_free.resize(start.critical_points.size(), is_free.empty());
    place_nodes(face, energy, is_free, options, points, report);
  }
  Vec2 operator[](std::size_t k) const { return points.critical_points[k].position; }
  CriticalPoints points;
  Report report;
};

const double disc_radius = std::pow(3.0 / 11, 1.0 / 8);

/// The root r of 8 q^4 / (1 - q^4) + 2 w q / (1 - q) = 3, q = r^2: d F / d r = 0 for four nodes on a square.
double radius_of(double weight) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double q = (low + high) / 2;
    (8 * std::pow(q, 4) / (1 - std::pow(q, 4)) + 2 * weight * q / (1 - q) > 3 ? high : low) = q;
  }
  return std::sqrt(low);
}

void expect_square(const Placed& placed, double radius, double tol) {
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(norm(placed[k]), radius, tol);
    for (std::size_t j = 0; j < k; ++j) {
      const double turns = wrap_two_pi(angle_of(placed[k]) - angle_of(placed[j])) / half_pi;
      EXPECT_NEAR(turns, std::round(turns), tol);
    }
  }
}

TEST(DiscEnergy, its_gradient_is_that_of_its_value) {
  std::vector<Charge> nodes{{{0.3, 0.2}, 1}, {{-0.5, 0.1}, 1}, {{0.1, 0.7}, -1}};
  const double h = 1e-6;
  for (const auto energy : {in_disc, half_disc_energy})
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const auto at = [&](Complex move) {
        std::vector<Charge> shifted = nodes;
        shifted[k].place += move;
        return energy(shifted).value;
      };
      const Vec2 slope{(at(h) - at(-h)) / (2 * h), (at({0, h}) - at({0, -h})) / (2 * h)};
      EXPECT_NEAR(distance(energy(nodes).gradient[k], slope), 0, 1e-7);
    }
}

TEST(PlaceNodes, four_in_a_disc_come_to_the_radius_of_least_energy) {
  EXPECT_NEAR(radius_of(0), disc_radius, 1e-14);
  EXPECT_NEAR(radius_of(1.4), 0.691, 1e-3);
  for (const double weight : {0.0, 0.7, 1.4, 2.8}) {
    const Placed placed(disc(), Motion()(in_disc), points_at({{0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, -0.1}}), weight);
    expect_square(placed, radius_of(weight), 1e-9);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(distance(normalized(placed[k]), unit(k * half_pi)), 0, 1e-12) << "they keep their directions";
  }
}

/// lambda of the unit sphere in its stereographic chart.
double sphere_scale(Vec2 x, Vec2& gradient) {
  gradient = -2 / (1 + norm2(x)) * x;
  return std::log(2 / (1 + norm2(x)));
}

TEST(PlaceNodes, four_on_the_half_sphere_are_corners_of_a_cube) {
  const CriticalPoints start = points_at({{0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, -0.1}});
  const Placed placed(disc(), Motion()(in_disc), start, 0, {}, sphere_scale);
  expect_square(placed, (std::sqrt(3.0) - 1) / std::sqrt(2.0), 1e-10);
}

TEST(PlaceNodes, the_distance_of_the_boundary_term_is_that_of_the_chart) {
  const CriticalPoints start = points_at({{0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, -0.1}});
  const Placed placed(disc(), Motion()(in_disc), start, 2, {}, sphere_scale);
  const double r = norm(placed[0]);
  expect_square(placed, r, 1e-9);
  const double of_energy = -12 / r + 32 * std::pow(r, 7) / (1 - std::pow(r, 8)) + 56 * r / (1 + r * r);
  EXPECT_NEAR(of_energy + 2 * 8 * r / (1 - r * r), 0, 1e-7);
}

/// Four nodes of valence 5 on a square about a hole of radius 1 in a large plate: W = pi (52 ln s - 4 ln(s^8 - 1)).
NodeEnergy energy_about_hole(const CriticalPoints& points) {
  const double s = norm(points.critical_points[0].position), s8 = std::pow(s, 8);
  if (s <= 1) throw ComputeError("a node is in the hole");
  NodeEnergy w{pi * (52 * std::log(s) - 4 * std::log(s8 - 1)), {}};
  const double slope = pi * (52 - 32 * s8 / (s8 - 1)) / s;
  for (const CriticalPoint& p : points.critical_points) w.gradient.push_back(slope / 4 * normalized(p.position));
  return w;
}

TEST(PlaceNodes, about_a_hole_sizes_that_grow_like_a_power_take_them_farther_out) {
  const CadFace plate = make_face({circle({0, 0}, 50), hole({0, 0}, 1)});
  const CriticalPoints start = points_at({{2, 0}, {0, 2}, {-2, 0}, {0, -2}}, 5);
  for (const double power : {0.0, 0.25, 0.5}) {
    const LogScale log_scale = [&](Vec2 x, Vec2& gradient) {
      gradient = -power / norm2(x) * x;
      return -power * std::log(norm(x));
    };
    const double part = (13 - 9 * power) / 8;  // s^8 / (s^8 - 1)
    expect_square(Placed(plate, energy_about_hole, start, 0, {}, log_scale), std::pow(part / (part - 1), 1.0 / 8),
                  1e-10);
  }
}

TEST(PlaceNodes, without_symmetry_they_find_the_same_square) {
  const CriticalPoints start = points_at({{0.5, 0.1}, {0.1, 0.3}, {-0.8, 0.3}, {-0.1, -0.2}});
  for (const double weight : {0.0, 1.4})
    expect_square(Placed(disc(), Motion()(in_disc), start, weight), radius_of(weight), 1e-9);
}

TEST(PlaceNodes, turned_by_any_angle_they_stay_where_they_are) {
  const CriticalPoints start =
      points_at({0.3 * unit(0.2), 0.3 * unit(0.2 + pi / 2), 0.3 * unit(0.2 + pi), 0.3 * unit(0.2 + 1.5 * pi)});
  const Placed placed(disc(), Motion()(in_disc), start, 0);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(distance(placed[k], disc_radius * unit(0.2 + k * half_pi)), 0, 1e-9);
}

TEST(PlaceNodes, two_in_a_half_disc_are_the_half_of_four_in_a_disc) {
  for (const CriticalPoints& start : {points_at({{0.6, 0.3}, {-0.6, 0.3}}), points_at({{0.2, 0.05}, {-0.1, 0.7}})}) {
    const Placed placed(half_disc(), Motion()(half_disc_energy), start, 0);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(std::min(distance(placed[k], disc_radius * unit(pi / 4)),
                           distance(placed[k], disc_radius * unit(3 * pi / 4))),
                  0, 1e-9);
    EXPECT_GT(distance(placed[0], placed[1]), 1);
  }
}

TEST(PlaceNodes, a_greater_weight_takes_them_further_from_the_boundary) {
  double before = 0;
  for (const double weight : {0.0, 0.7, 1.4, 2.8}) {
    const CadFace face = half_disc();
    const Placed placed(face, Motion()(half_disc_energy), points_at({{0.6, 0.3}, {-0.6, 0.3}}), weight);
    const double clearance = SmoothBoundaryDistance(face).nearest(placed[0]).distance;
    EXPECT_GT(clearance, before + 0.01);
    before = clearance;
  }
}

TEST(PlaceNodes, start_at_a_hair_from_the_boundary) {
  const Placed placed(half_disc(), Motion()(half_disc_energy), points_at({{0.3, 1e-5}, {-0.9999, 1e-3}}), 0);
  EXPECT_NEAR(distance(placed[0], disc_radius * unit(pi / 4)), 0, 1e-9);
  EXPECT_NEAR(distance(placed[1], disc_radius * unit(3 * pi / 4)), 0, 1e-9);
}

TEST(PlaceNodes, move_with_the_face) {
  const std::vector<Vec2> start{{0.2, 0.15}, {-0.1, 0.7}};
  const Placed at_home(half_disc(), Motion()(half_disc_energy), points_at(start), 1.4);
  for (const Motion& motion :
       {Motion{1, radians(37), {}, false}, Motion{1, 0, {}, true}, Motion{1e-3, 1, {}, false},
        Motion{1e3, 2, {}, false}, Motion{1, 0, {3, -2}, false}, Motion{1e3, radians(37), {4e3, 1e3}, true}}) {
    const CriticalPoints there = points_at({motion(start[0]), motion(start[1])});
    const Placed placed(motion(half_disc()), motion(half_disc_energy), there, 1.4);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(distance(placed[k], motion(at_home[k])), 0, 1e-9 * motion.scale);
  }
}

TEST(PlaceNodes, that_are_not_free_stay) {
  const CriticalPoints start = points_at({{0.5, 0.3}, {-0.5, 0.3}});
  const Placed placed(half_disc(), Motion()(half_disc_energy), start, 0, {true, false});
  EXPECT_EQ(placed[1], start.critical_points[1].position);
  EXPECT_GT(distance(placed[0], start.critical_points[0].position), 0.1);
  ASSERT_EQ(placed.points.changes.size(), 1u);
  const NodeChange& change = placed.points.changes[0];
  EXPECT_EQ(change.kind, ChangeKind::place);
  EXPECT_EQ(change.before[0].position, start.critical_points[0].position);
  EXPECT_EQ(change.after[0].position, placed[0]);
  EXPECT_EQ(placed.points.critical_points[0].source, NodeSource::place);
  EXPECT_EQ(placed.points.critical_points[1].source, NodeSource::zero);
  EXPECT_EQ(placed.points.form, NodeForm::phase);
  ASSERT_EQ(placed.points.zeros.size(), 2u);
  EXPECT_EQ(placed.points.zeros[0].position, start.critical_points[0].position);
}

TEST(PlaceNodes, at_the_minimum_nothing_changes) {
  const CriticalPoints start = points_at({disc_radius * unit(pi / 4), disc_radius * unit(3 * pi / 4)});
  const Placed placed(half_disc(), Motion()(half_disc_energy), start, 0);
  EXPECT_TRUE(placed.points.changes.empty());
  EXPECT_EQ(placed.points.form, NodeForm::harmonic);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(placed[k], start.critical_points[k].position);
}

/// Two nodes that repel each other in a valley along an axis: the sum of 4 across^2 + along^2, less 2 ln of their
/// distance.
NodeEnergy energy_in_valley(const CriticalPoints& points, bool is_along_x) {
  const Vec2 a = points.critical_points[0].position, b = points.critical_points[1].position;
  const Vec2 steep = is_along_x ? Vec2{1, 4} : Vec2{4, 1}, push = 2 / norm2(a - b) * (a - b);
  NodeEnergy w{-std::log(norm2(a - b)), {-1 * push, push}};
  for (int k = 0; k < 2; ++k) {
    const Vec2 x = points.critical_points[k].position;
    w.value += steep.x * x.x * x.x + steep.y * x.y * x.y;
    w.gradient[k] += 2 * Vec2{steep.x * x.x, steep.y * x.y};
  }
  return w;
}

TEST(PlaceNodes, pairs_leave_a_mirror_axis_where_that_lowers_the_energy) {
  const CadFace box = make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}})});
  for (const bool is_along_x : {false, true}) {
    const EnergyFunction energy = [&](const CriticalPoints& points) { return energy_in_valley(points, is_along_x); };
    for (const Vec2 start : {Vec2{0.3, 0}, Vec2{0, 0.3}}) {
      const Placed placed(box, energy, points_at({start, -start}, 5), 0);
      const Vec2 x = placed[0], least = is_along_x ? Vec2{std::sqrt(0.5), 0} : Vec2{0, std::sqrt(0.5)};
      EXPECT_NEAR(std::min(distance(x, least), distance(x, -least)), 0, 1e-9);
      EXPECT_NEAR(distance(x, -placed[1]), 0, 1e-12);
    }
  }
}

TEST(PlaceNodes, of_opposite_index_are_kept_apart_and_named) {
  CriticalPoints start = points_at({{0.4, 0.3}, {-0.4, 0.3}, {0.1, 0.5}, {0.2, 0.5}});
  start.critical_points[3].valence = 5;
  start.critical_points[3].index = -1;
  const Placed placed(half_disc(), Motion()(half_disc_energy), start, 0);
  double nearest = 2;
  for (int k = 0; k < 3; ++k) nearest = std::min(nearest, distance(placed[k], placed[3]));
  const double reach = 0.02 * half_disc().diameter;
  EXPECT_GT(nearest, reach / 2);
  EXPECT_LT(nearest, reach);
  ASSERT_FALSE(placed.report.warnings().empty());
  EXPECT_EQ(placed.report.warnings()[0].code, "W-PLACE-002");
  EXPECT_NE(placed.report.warnings()[0].message.find("the node of valence"), std::string::npos);
  EXPECT_NE(placed.report.warnings()[0].message.find(fmt::format("{:.3g} apart", nearest)), std::string::npos);
  const LogScale twice = [](Vec2, Vec2& gradient) {
    gradient = {};
    return std::log(2);
  };
  const Placed in_space(half_disc(), Motion()(half_disc_energy), start, 0, {}, twice);
  EXPECT_NE(in_space.report.warnings().at(0).message.find(fmt::format("{:.3g} apart", 2 * nearest)), std::string::npos);
}

TEST(PlaceNodes, too_few_steps_are_confessed) {
  CriticalPoints points = points_at({{0.2, 0.05}, {-0.1, 0.7}});
  PlacementOptions options;
  options.max_iterations = 2;
  Report report;
  place_nodes(half_disc(), Motion()(half_disc_energy), {true, true}, options, points, report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-PLACE-001");
}

TEST(PlaceNodes, outside_at_the_start_is_an_error) {
  EXPECT_THROW(Placed(half_disc(), Motion()(half_disc_energy), points_at({{0.2, -0.05}, {0, 0.5}}), 0), ComputeError);
}

}  // namespace
}  // namespace quadrille::placement
