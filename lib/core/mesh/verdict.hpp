#pragma once
// Whether a quad mesh is good: a verdict in words, with what limits it and where. Three figures, of which each is good
// up to one limit and poor beyond another, and that all elements are proved valid:
//
//                                          good      poor
//   least scaled Jacobian                  0.5       0.3       a sine: how flat the angles of elements are
//   resolution ratio                       5         50        mesh/element_sizes: unequal lengths; errors 2.2 and 7
//                                                              times those of equal squares
//   greatest area jump                     10        100       sizes of neighbours, about 3 and 10 by length
//
// The severity of a figure v is ln(v / good) / ln(poor / good): above 0 the mesh is only usable, above 1 it is poor. In
// this measure figures are compared: the most severe limits the mesh. Elements in wall layers, and all where a metric
// is prescribed, have the area jumps that were asked for.

#include <array>
#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

enum class Grade { good, usable, poor };
constexpr auto enum_names(Grade) { return std::to_array({"good", "usable", "poor"}); }

/// What limits a mesh.
enum class Limit { proof, scaled_jacobian, resolution, area_jump };
constexpr auto enum_names(Limit) {
  return std::to_array({"proof", "least scaled Jacobian", "resolution ratio", "area jump"});
}

/// The figures at which a mesh ceases to be good, and becomes poor.
struct GradeLimits {
  double good = 0, poor = 0;
};
inline constexpr GradeLimits scaled_jacobian_limits{0.5, 0.3}, resolution_limits{5, 50}, area_jump_limits{10, 100};

/// A figure that is not good.
struct Fault {
  Limit limit = Limit::proof;
  double value = 0;     ///< the figure; of the proof the number of elements without it
  double severity = 0;  ///< above 0; infinite for elements that are not proved
  int elem = 0;         ///< the worst element
  Vec2 position;        ///< relative to face.origin
  std::string cause;    ///< for messages; may be empty
};

struct Verdict {
  std::vector<Fault> faults;  ///< the most severe first
  Grade grade() const;
};

/// Elements must be measured. Where the element of the least scaled Jacobian lies in a corner of the face whose sine is
/// no more than 5 % greater, no mesh can be better there, and the cause says so.
Verdict verdict_of(const QuadMesh& mesh);

/// "good", or "usable: resolution ratio 14.8: ...; area jump 12 at (1, 2)".
std::string describe(const Verdict& verdict, const CadFace& face);

}  // namespace quadrille::mesh
