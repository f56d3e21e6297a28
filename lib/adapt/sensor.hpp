#pragma once
// The paper's error indicator S_e = |v_P - v_{P-1}|^2 / |v_P|^2 on an element (Persson and Peraire 2006).
//
// The projection onto order P - 1 drops the modes of degree P: the basis is orthonormal and sorted by degree. Norms are
// those of the reference triangle, whose area 2 stands for |Omega_e|. The denominator is at least that of a field of
// length 1 on the element: |v| <= 1 everywhere, so the scale is absolute and 0/0 cannot happen. Taken of the polynomial
// part: liftings are exact. A field of kind "phase" has one component, s, whatever is asked for; its scale is 1 radian,
// because |v - v_h| is |s - s_h|.

#include <array>
#include <vector>

#include "base/enum_names.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

/// Which components are sensed.
enum class SensorKind { vector, u, v };
constexpr auto enum_names(SensorKind) {
  return std::to_array<EnumName<SensorKind>>(
      {{SensorKind::vector, "vector"}, {SensorKind::u, "u"}, {SensorKind::v, "v"}});
}

/// What the tail is compared with.
enum class SensorScale {
  absolute,  ///< as above; elements of a corner fan are weighed by fan_weights(), as is the error that they send to the
             ///< far field: a sensor near a singularity never falls otherwise
  relative   ///< the paper's own: the sensed components' norm on the element alone, no weights; 0/0 counts as 0
};

constexpr auto enum_names(SensorScale) {
  return std::to_array<EnumName<SensorScale>>(
      {{SensorScale::absolute, "absolute"}, {SensorScale::relative, "relative"}});
}

/// S_e of every element.
std::vector<double> sense(const Field& field, SensorKind kind, SensorScale scale = SensorScale::absolute);

/// The weights of squared errors in that: 1 outside fans, else the element's area over that of the largest element.
std::vector<double> fan_weights(const TriMesh& mesh);

/// Sensors that differ by less than 5 % made equal to the greatest of them, so that a threshold decides the elements of
/// a symmetry orbit together and not by their rounding errors.
std::vector<double> equalized(std::vector<double> sensors);

}  // namespace quadrille::adapt
