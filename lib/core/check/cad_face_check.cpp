#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "check/rules.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "model/periodic.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::check {

namespace {

void arrays_agree(const CadFace& face, Findings& findings) {
  const std::size_t n = face.curves.size();
  if (n == 0) findings.add("the face has no curves");
  const auto agree = [&](const char* name, std::size_t size) {
    if (size != n) findings.add("{} has {} entries for {} curves", name, size, n);
  };
  agree("curve_names", face.curve_names.size());
  agree("curve_cad_edges", face.curve_cad_edges.size());
  agree("joints", face.joints.size());
  if (!are_ascending_indices(face.unnamed_curves, n))
    findings.add("unnamed_curves must be curves in ascending order, each once");
  const auto num_regions = static_cast<std::size_t>(std::max(face.num_regions(), 0));
  const bool has_regions = num_regions > 1;
  if (has_regions || !face.partners.empty()) agree("partners", face.partners.size());
  if ((has_regions || !face.region_names.empty()) && face.region_names.size() != num_regions)
    findings.add("region_names has {} entries for {} regions", face.region_names.size(), num_regions);
  for (std::size_t i = 0; i < face.partners.size(); ++i)
    if (face.partners[i] != -1 && !is_index(face.partners[i], n))
      findings.add("curve {}: its partner {} does not exist", i, face.partners[i]);
  for (std::size_t i = 0; i < face.periodic_pairs.size(); ++i)
    if (const auto [a, b] = face.periodic_pairs[i].curves; !is_index(a, n) || !is_index(b, n))
      findings.add("periodic pair {}: curve {} or {} does not exist", i, a, b);
}

void loops_are_sound(const CadFace& face, Findings& findings) {
  if (!are_offsets(face.loop_offsets, face.num_curves()))
    return findings.add("loop_offsets must increase from 0 to the number of curves, {}", face.num_curves());
  if (!face.region_loops.empty() && !are_offsets(face.region_loops, face.num_loops()))
    findings.add("region_loops must increase from 0 to the number of loops, {}", face.num_loops());
}

void curves_fit(const CadFace& face, Findings& findings) {
  for (std::size_t i = 0; i < face.curves.size(); ++i)
    if (const std::string fault = structure_fault(face.curves[i]); !fault.empty())
      findings.add("curve {}: {}", i, fault);
}

void curves_are_sound(const CadFace& face, Findings& findings) {
  for (std::size_t i = 0; i < face.curves.size(); ++i)
    if (const std::string fault = number_fault(face.curves[i]); !fault.empty()) findings.add("curve {}: {}", i, fault);
}

void numbers_are_finite(const CadFace& face, Findings& findings) {
  for (std::size_t i = 0; i < face.joints.size(); ++i) {
    const Joint& joint = face.joints[i];
    if (!is_finite(joint.position) || !is_finite(joint.tangent_in) || !is_finite(joint.tangent_out) ||
        !is_finite(joint.interior_angle))
      findings.add("joint {} contains a number that is not finite", i);
  }
  for (std::size_t i = 0; i < face.periodic_pairs.size(); ++i)
    if (!is_finite(face.periodic_pairs[i].angle) || !is_finite(face.periodic_pairs[i].shift))
      findings.add("periodic pair {} contains a number that is not finite", i);
  if (!is_finite(face.origin)) findings.add("origin is not finite");
  if (!(face.diameter > 0) || !is_finite(face.diameter)) findings.add("diameter must be a positive number");
  if (!(face.fit_distance >= 0) || !is_finite(face.fit_distance))
    findings.add("fit_distance must be a number, not negative");
}

void curves_meet(const CadFace& face, Findings& findings) {
  for (std::size_t i = 0; i < face.curves.size(); ++i)
    if (has_far_pole(face.curves[i], face)) findings.add("curve {} has a pole farther out than 1000 diameters", i);
  for (int l = 0; l < face.num_loops(); ++l)
    for (int i = face.loop_offsets[l]; i < face.loop_offsets[l + 1]; ++i) {
      const int next = i + 1 < face.loop_offsets[l + 1] ? i + 1 : face.loop_offsets[l];
      const double gap = distance(face.curves[i].poles.back(), face.curves[next].poles.front());
      if (gap > gap_tol * face.diameter)
        findings.add("curve {} ends {:.3g} away from the start of curve {}, at {}", i, gap, next,
                     position_text(face, face.curves[next].poles.front()));
      const double off = distance(face.joints[i].position, face.curves[i].poles.front());
      if (off > gap_tol * face.diameter)
        findings.add("joint {} lies {:.3g} away from the start of its curve, at {}", i, off,
                     position_text(face, face.joints[i].position));
    }
}

void angles_agree(const CadFace& face, Findings& findings) {
  for (std::size_t i = 0; i < face.joints.size(); ++i) {
    const Joint& joint = face.joints[i];
    if (std::abs(joint.tangent_in) > pi + 1e-9 || std::abs(joint.tangent_out) > pi + 1e-9 || joint.interior_angle < 0 ||
        joint.interior_angle > 2 * pi)
      findings.add("joint {}: tangent angles lie in (-pi, pi], interior angles in (0, 2 pi)", i);
    else if (is_slit_tip(face, static_cast<int>(i)) && joint.interior_angle < 1.5 * pi)
      findings.add("joint {}: interior_angle {:.9g} is not 2 pi, but a slit ends there", i, joint.interior_angle);
    else if (std::abs(wrap_pi(joint.interior_angle - (pi - (joint.tangent_out - joint.tangent_in)))) > 1e-6)
      findings.add("joint {}: interior_angle {:.9g} is not pi - (tangent_out - tangent_in)", i, joint.interior_angle);
  }
}

void plane_is_orthonormal(const CadFace& face, Findings& findings) {
  const auto product = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const double faults[] = {product(face.plane_x, face.plane_x) - 1, product(face.plane_y, face.plane_y) - 1,
                           product(face.plane_x, face.plane_y), product(face.plane_origin, face.plane_origin) * 0};
  for (const double fault : faults)
    if (!(std::abs(fault) < 1e-9))
      return findings.add("plane_x and plane_y must be finite, of length 1, at a right angle");
  if (!(face.metres_per_unit >= 0) || !is_finite(face.metres_per_unit))
    findings.add("metres_per_unit must be positive, or 0 where unknown");
}

/// Twice the signed area of the loop's polygon through 16 points per knot span.
double signed_area(const CadFace& face, int loop) {
  std::vector<Vec2> points;
  for (int i = face.loop_offsets[loop]; i < face.loop_offsets[loop + 1]; ++i) {
    const Nurbs& curve = face.curves[i];
    curve::for_each_span(curve, [&](double a, double b) {
      for (int s = 0; s < 16; ++s) points.push_back(curve::point(curve, a + (b - a) * s / 16));
    });
  }
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

void loops_turn_right(const CadFace& face, Findings& findings) {
  for (int l = 0; l < face.num_loops(); ++l) {
    const bool is_outline = l == 0 || std::binary_search(face.region_loops.begin(), face.region_loops.end(), l);
    if (is_outline && face.is_slit_loop(l))
      findings.add("loop {} must be an outline, but encloses nothing", l);
    else if (!face.is_slit_loop(l) && (signed_area(face, l) > 0) != is_outline)
      findings.add("loop {} is not {}", l, is_outline ? "counter-clockwise" : "clockwise");
  }
}

void tangents_agree(const CadFace& face, Findings& findings) {
  for (int i = 0; i < face.num_curves(); ++i) {
    const Nurbs& before = face.curves[face.previous_in_loop(i)];
    const Nurbs& after = face.curves[i];
    const Vec2 in = before.poles.back() - before.poles[before.poles.size() - 2], out = after.poles[1] - after.poles[0];
    // If two poles coincide, the tangent results from a higher derivative and is not compared.
    const double least = 1e-9 * face.diameter;
    if (norm(in) > least && std::abs(wrap_pi(angle_of(in) - face.joints[i].tangent_in)) > 1e-4)
      findings.add("joint {}: tangent_in is not the direction in which its predecessor ends", i);
    if (norm(out) > least && std::abs(wrap_pi(angle_of(out) - face.joints[i].tangent_out)) > 1e-4)
      findings.add("joint {}: tangent_out is not the direction in which its curve starts", i);
  }
}

/// Whether `b` is `a` in the opposite direction: poles and weights bit for bit, knots up to rounding.
bool are_reversed(const Nurbs& a, const Nurbs& b) {
  const double tol = 1e-12 * (a.end() - a.begin());
  return a.degree == b.degree && std::equal(a.poles.begin(), a.poles.end(), b.poles.rbegin(), b.poles.rend()) &&
         std::equal(a.weights.begin(), a.weights.end(), b.weights.rbegin(), b.weights.rend()) &&
         std::equal(a.knots.begin(), a.knots.end(), b.knots.rbegin(), b.knots.rend(), [&](double from_begin, double k) {
           return std::abs((from_begin - a.begin()) - (b.end() - k)) <= tol;
         });
}

void partners_agree(const CadFace& face, Findings& findings) {
  for (int i = 0; i < static_cast<int>(face.partners.size()); ++i) {
    const int p = face.partners[i];
    if (p == -1) continue;
    if (p == i || face.partners[p] != i)
      findings.add("curve {}: its partner {} is not another curve that has it as partner", i, p);
    else if (p < i)
      continue;
    else if (!are_reversed(face.curves[i], face.curves[p]))
      findings.add("curves {} and {} are partners, but not one curve in opposite directions, at {}", i, p,
                   position_text(face, face.curves[i].poles.front()));
    else if (face.curve_names[i] != face.curve_names[p] || face.has_given_name(i) != face.has_given_name(p))
      findings.add("curves {} and {} are partners, but of different names", i, p);
  }
}

/// Greatest distance of the first curve of a pair, moved in space, from the points of the second one with mirrored
/// parameters. 0 of a chart that breaks rules, which are checked later.
double gap_in_space(const CadFace& face, const PeriodicPair& pair) {
  if (!chart_violations(face, CheckDepth::quick).empty()) return 0;
  const auto [first, second] = pair.curves;
  const SpaceCurve &from = face.chart->space_curves[first], &to = face.chart->space_curves[second];
  const SpaceMotion motion = surface::periodic_motion(face, pair);
  double gap = 0;
  for (int k = 0; k <= 16; ++k) {
    const double t = from.begin() + (from.end() - from.begin()) * k / 16;
    const Vec3 other = surface::point(to, periodic_parameter(face, first, t, second));
    gap = std::max(gap, distance(surface::image(motion, surface::point(from, t)), other));
  }
  return gap;
}

/// Greatest distance of the first curve of a pair, moved, from the second one, reversed.
double periodic_gap(const CadFace& face, const PeriodicPair& pair) {
  if (face.chart) return gap_in_space(face, pair);
  const Nurbs &from = face.curves[pair.curves[0]], &to = face.curves[pair.curves[1]];
  const PeriodicMotion motion(pair, face.origin);
  double gap = std::max(distance(motion.image(from.poles.front()), to.poles.back()),
                        distance(motion.image(from.poles.back()), to.poles.front()));
  for (int k = 1; k < 16; ++k) {
    const Vec2 x = curve::point(from, from.begin() + (from.end() - from.begin()) * k / 16);
    gap = std::max(gap, curve::project(to, motion.image(x)).distance);
  }
  return gap;
}

void periodic_pairs_agree(const CadFace& face, Findings& findings) {
  std::vector<bool> is_paired(face.curves.size());
  for (std::size_t i = 0; i < face.periodic_pairs.size(); ++i) {
    const PeriodicPair& pair = face.periodic_pairs[i];
    for (const int c : pair.curves) {
      if (is_paired[c]) findings.add("curve {} is in two periodic pairs, or twice in one", c);
      if (face.is_interface(c)) findings.add("periodic pair {}: curve {} is not on the boundary", i, c);
      is_paired[c] = true;
    }
    if (const double gap = periodic_gap(face, pair); !(gap <= gap_tol * face.diameter))
      findings.add("periodic pair {}: its motion maps curve {} {:.3g} away from curve {}", i, pair.curves[0], gap,
                   pair.curves[1]);
  }
}

constexpr Rule<CadFace> cad_face_rules[] = {
    {"FAC-R01", RuleKind::structure, arrays_agree},       {"FAC-R02", RuleKind::structure, loops_are_sound},
    {"FAC-R03", RuleKind::structure, curves_fit},         {"FAC-R04", RuleKind::structure, curves_are_sound},
    {"FAC-R05", RuleKind::structure, numbers_are_finite}, {"FAC-R06", RuleKind::quick, curves_meet},
    {"FAC-R07", RuleKind::quick, angles_agree},           {"FAC-R08", RuleKind::quick, plane_is_orthonormal},
    {"FAC-R09", RuleKind::full, loops_turn_right},        {"FAC-R10", RuleKind::full, tangents_agree},
    {"FAC-R11", RuleKind::quick, partners_agree},         {"FAC-R12", RuleKind::full, periodic_pairs_agree},
};

}  // namespace

std::vector<Violation> violations_of(const CadFace& face, CheckDepth depth) {
  const std::vector<Violation> violations = apply_rules(cad_face_rules, face, depth);
  return violations.empty() ? chart_violations(face, depth) : violations;
}

template std::vector<Violation> check_stage(const CadFace&, CheckDepth);

void require_valid(const std::vector<Violation>& violations, const std::string& name) {
  if (!violations.empty())
    throw FormatError(fmt::format("{}: {}: {}", name, violations.front().rule, violations.front().text));
}

}  // namespace quadrille::check
