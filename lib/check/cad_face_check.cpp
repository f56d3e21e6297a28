#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "check/nurbs_rules.hpp"
#include "check/rules.hpp"

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
}

void loops_are_sound(const CadFace& face, Findings& findings) {
  const std::vector<int>& offsets = face.loop_offsets;
  bool is_sound = offsets.size() >= 2 && offsets.front() == 0 && offsets.back() == face.num_curves();
  for (std::size_t l = 0; is_sound && l + 1 < offsets.size(); ++l) is_sound = offsets[l] < offsets[l + 1];
  if (!is_sound) findings.add("loop_offsets must increase from 0 to the number of curves, {}", face.num_curves());
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
  if (!is_finite(face.origin)) findings.add("origin is not finite");
  if (!(face.diameter > 0) || !is_finite(face.diameter)) findings.add("diameter must be a positive number");
  if (!(face.fit_distance >= 0) || !is_finite(face.fit_distance))
    findings.add("fit_distance must be a number, not negative");
}

/// Curves of STEP files meet within the tolerance of their vertices; a larger distance is a gap in the outline.
constexpr double gap_tol = 1e-5;  // relative to the diameter

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
    for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k)
      for (int s = 0; s < 16 && curve.knots[k] < curve.knots[k + 1]; ++s)
        points.push_back(curve_point(curve, curve.knots[k] + (curve.knots[k + 1] - curve.knots[k]) * s / 16));
  }
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

void loops_turn_right(const CadFace& face, Findings& findings) {
  for (int l = 0; l < face.num_loops(); ++l)
    if ((signed_area(face, l) > 0) != (l == 0))
      findings.add("loop {} is not {}", l, l == 0 ? "counter-clockwise" : "clockwise");
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

constexpr Rule<CadFace> rules[] = {
    {"FAC-R01", RuleKind::structure, arrays_agree},       {"FAC-R02", RuleKind::structure, loops_are_sound},
    {"FAC-R03", RuleKind::structure, curves_fit},         {"FAC-R04", RuleKind::structure, curves_are_sound},
    {"FAC-R05", RuleKind::structure, numbers_are_finite}, {"FAC-R06", RuleKind::quick, curves_meet},
    {"FAC-R07", RuleKind::quick, angles_agree},           {"FAC-R08", RuleKind::quick, plane_is_orthonormal},
    {"FAC-R09", RuleKind::full, loops_turn_right},        {"FAC-R10", RuleKind::full, tangents_agree},
};

}  // namespace

std::vector<Violation> check_cad_face(const CadFace& face, CheckDepth depth) { return apply_rules(rules, face, depth); }

void require_valid(const std::vector<Violation>& violations, const std::string& name) {
  if (!violations.empty())
    throw FormatError(fmt::format("{}: {}: {}", name, violations.front().rule, violations.front().text));
}

}  // namespace quadrille::check
