#pragma once
// Error indicator S_e = |v_P - v_{P-1}|^2 / |v_P|^2 of an element, as in the paper (Persson and Peraire 2006).
//
// The projection onto order P - 1 drops the modes of degree P: the basis is orthonormal and sorted by degree. Norms are
// taken over the reference triangle, whose area 2 replaces |Omega_e|. The denominator is at least the squared norm of a
// field with |v| = 1 on the element: since |v| <= 1 everywhere, the scale is absolute and 0/0 cannot occur. Only the
// polynomial part enters: liftings are exact. A field of kind "phase" has one component, s, whichever component is
// selected; its scale is 1 radian, because |v - v_h| = |s - s_h| to first order.

#include <array>
#include <vector>

#include "base/enum_names.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

/// The components that enter the sensor.
enum class SensorKind { vector, u, v };
constexpr auto enum_names(SensorKind) { return std::to_array({"vector", "u", "v"}); }

/// The reference scale of the tail.
enum class SensorScale {
  absolute,  ///< as above; elements of a corner fan are weighted by fan_weights(), as is their effect on the far field:
             ///< otherwise the sensor near a singularity would never decrease
  relative   ///< as in the paper: norm of the selected components on the element, no weights; 0/0 counts as 0
};

constexpr auto enum_names(SensorScale) { return std::to_array({"absolute", "relative"}); }

/// For every element and each degree d = 0 .. P: the S_e that the modes of degree d give.
std::vector<std::vector<double>> degree_sensors(const Field& field, SensorKind kind, SensorScale scale);

/// S_e of every element, by element number: that of its highest degree.
std::vector<double> element_sensors(const Field& field, SensorKind kind, SensorScale scale = SensorScale::absolute);

/// The weights of squared errors in the sensor: 1 outside fans, in fans the element's area divided by the largest
/// element area.
std::vector<double> fan_weights(const TriMesh& mesh);

/// Replaces sensors that differ by less than 5 % by the greatest of them, so that a threshold treats the elements of a
/// symmetry orbit alike, independently of rounding errors.
std::vector<double> equalized(std::vector<double> sensors);

}  // namespace quadrille::adapt
