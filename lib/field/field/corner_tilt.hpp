#pragma once
// Boundary data tilted at a corner (lib/method.md §3, ties).
//
// At an interior angle of 45 + 90 k degrees the data on the two sides are opposite, and the harmonic field does not
// know which way to turn. A tilt turns the phase of the data near the corner, by -s tau on the incoming and by +s tau
// on the outgoing side, s = 1 for the smaller valence and -1 for the larger; tau falls from 40 degrees at the corner to
// 0 at half of the shorter adjacent curve, with continuous second derivatives. So tilts of different corners do not
// meet, and the tilted data are
//
//   v (cos tau - 1)  (even part)  +  s i v (+- sin tau)  (odd part)   on top of v:
//
// linear in the signs s of all corners. So the field for any signs is a sum of harmonic functions, each solved for
// once.

#include <functional>
#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::field {

/// Boundary data of a harmonic function: `values` at parameter t of a curve, continuous round every loop, are what is
/// left without `liftings`.
struct LiftedData {
  std::function<Vec2(int curve, double t)> values;
  std::vector<Lifting> liftings;
};

enum class TiltPart { even, odd };

/// The sum of one part of the tilts at these joints of the mesh's face. `mesh` must outlive the result. Jumps have
/// liftings (field/boundary_values, jump_tol): the odd part at the angle of a tie itself has none, and decays like what
/// a few boundary values cause.
LiftedData tilt_data(const TriMesh& mesh, const std::vector<int>& joints, TiltPart part);

/// A harmonic function that may be added to a field, on the mesh and with the orders of that field: coefficients of the
/// elements on which the function is not negligible, there up to the last mode that is not.
struct HarmonicPart {
  std::vector<int> elems;
  std::vector<int> num_modes;  ///< of each of these elements
  std::vector<double> u, v;    ///< element after element
  std::vector<Lifting> liftings;
};

/// Adds `factor` times `part` to a harmonic field with the same orders.
void add(const HarmonicPart& part, double factor, Field& field);

}  // namespace quadrille::field
