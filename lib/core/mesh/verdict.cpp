#include "mesh/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/enum_names.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "mesh/element_sizes.hpp"
#include "surface/positions.hpp"

namespace quadrille::mesh {

namespace {

constexpr double near_sine = 0.95;  ///< of the scaled Jacobian that a corner allows

double severity_of(double value, const GradeLimits& limits) {
  const double severity = std::log(value / limits.good) / std::log(limits.poor / limits.good);
  return value > 0 ? severity : std::numeric_limits<double>::infinity();
}

/// The first of the greatest values, equal ones within 1e-6.
int greatest(const std::vector<double>& values) {
  const double most = std::ranges::max(values);
  const double least = most - tolerance::tied * std::abs(most);
  return static_cast<int>(std::ranges::find_if(values, [&](double v) { return v >= least; }) - values.begin());
}

int least(std::vector<double> values) {
  for (double& value : values) value = -value;
  return greatest(values);
}

/// The sharpest corner of the face, below 90 degrees, at which the element has one of its own; -1: none.
int sharp_corner(const QuadMesh& mesh, int elem) {
  int sharpest = -1;
  for (int k = 0; k < 4; ++k) {
    const Vec2 x = mesh.nodes[side_start(mesh, elem, k)];
    for (int j = 0; j < static_cast<int>(mesh.face.joints.size()); ++j) {
      const Joint& joint = mesh.face.joints[j];
      if (!joint.is_corner || joint.interior_angle >= half_pi) continue;
      if (distance(joint.position, x) > tolerance::same_point * mesh.face.diameter) continue;
      if (sharpest < 0 || joint.interior_angle < mesh.face.joints[sharpest].interior_angle) sharpest = j;
    }
  }
  return sharpest;
}

Fault unproved(const QuadMesh& mesh) {
  const int elem = least(mesh.elem_jacobian_bound);
  return {Limit::proof,
          static_cast<double>(mesh.num_unproved()),
          std::numeric_limits<double>::infinity(),
          elem,
          centre(mesh, elem),
          {}};
}

Fault of_scaled_jacobian(const QuadMesh& mesh) {
  const int elem = least(mesh.elem_scaled_jacobian);
  const double value = mesh.elem_scaled_jacobian[elem];
  Fault fault{Limit::scaled_jacobian, value, severity_of(value, scaled_jacobian_limits), elem, centre(mesh, elem), {}};
  const int corner = sharp_corner(mesh, elem);
  if (corner < 0 || value < near_sine * std::sin(mesh.face.joints[corner].interior_angle)) return fault;
  fault.position = mesh.face.joints[corner].position;
  fault.cause = fmt::format("that of the face's corner of {:.0f} degrees, which no mesh can better",
                            degrees(mesh.face.joints[corner].interior_angle));
  return fault;
}

/// The place is that of the element with the greatest part of the error.
Fault of_resolution(const QuadMesh& mesh) {
  const std::vector<ElementPowers> powers = element_powers(mesh);
  const Resolution measure = resolution(mesh, {}, powers);
  std::vector<double> parts;
  for (const auto& [along1, along2] : measure.parts) parts.push_back(along1 + along2);
  const int elem = greatest(parts);
  Fault fault{
      Limit::resolution, measure.ratio, severity_of(measure.ratio, resolution_limits), elem, centre(mesh, elem), {}};
  if (fault.severity <= 0 || mesh.elem_prescribed_length.empty()) return fault;
  const auto length = [&](double along) { return std::pow(along / powers[elem].area, 1.0 / (2 * resolution_power)); };
  fault.cause = fmt::format("elements there are {:.2g} by {:.2g} prescribed lengths", length(powers[elem].along[0]),
                            length(powers[elem].along[1]));
  return fault;
}

/// Of elements outside wall layers.
Fault of_area_jump(const QuadMesh& mesh) {
  std::vector<double> jumps = mesh.elem_area_jump;
  for (std::size_t elem = 0; elem < mesh.elem_prescribed_length.size(); ++elem)
    if (!(mesh.elem_prescribed_length[elem] > 0)) jumps[elem] = 1;
  const int elem = greatest(jumps);
  return {Limit::area_jump, jumps[elem], severity_of(jumps[elem], area_jump_limits), elem, centre(mesh, elem), {}};
}

/// A sine with two decimals, a ratio with three digits, never as a power of ten.
std::string figure_text(const Fault& fault) {
  if (fault.limit == Limit::scaled_jacobian) return fmt::format("{:.2f}", fault.value);
  return fault.value < 100 ? fmt::format("{:.3g}", fault.value) : fmt::format("{:.0f}", fault.value);
}

std::string text_of(const Fault& fault, const CadFace& face) {
  const std::string place = surface::rounded_position_text(face, fault.position);
  if (fault.limit == Limit::proof)
    return fmt::format("{} not proved valid, the worst at {}", counted(std::llround(fault.value), "element"), place);
  const std::string figure = fmt::format("{} {}", enum_name(fault.limit), figure_text(fault));
  if (fault.cause.empty()) return fmt::format("{} at {}", figure, place);
  return fault.limit == Limit::resolution ? fmt::format("{} near {}, {}", figure, place, fault.cause)
                                          : fmt::format("{}, {}, at {}", figure, fault.cause, place);
}

}  // namespace

Grade Verdict::grade() const {
  if (faults.empty()) return Grade::good;
  return faults.front().severity > 1 + tolerance::tied ? Grade::poor : Grade::usable;
}

Verdict verdict_of(const QuadMesh& mesh) {
  Verdict verdict;
  if (mesh.num_elems() == 0) return verdict;
  std::vector<Fault> all{of_scaled_jacobian(mesh), of_resolution(mesh)};
  if (!mesh.elem_area_jump.empty() && mesh.elem_prescribed_stretch.empty()) all.push_back(of_area_jump(mesh));
  if (!mesh.is_valid) all.push_back(unproved(mesh));
  for (Fault& fault : all)
    if (fault.severity > tolerance::tied) verdict.faults.push_back(std::move(fault));
  std::ranges::stable_sort(verdict.faults, std::greater(), &Fault::severity);
  return verdict;
}

std::string describe(const Verdict& verdict, const CadFace& face) {
  std::string text = enum_name(verdict.grade());
  for (const Fault& fault : verdict.faults)
    text += fmt::format("{} {}", &fault == &verdict.faults.front() ? ":" : ";", text_of(fault, face));
  return text;
}

}  // namespace quadrille::mesh
