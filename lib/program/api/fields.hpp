#pragma once
// Component `fields`: solves for the guiding field and evaluates it (formats/field.md).
//
// Positions are relative to face.origin. Errors are thrown (base/error.hpp): ComputeError if there is no field,
// UsageError for options outside their intervals, FormatError for structs that break a rule of their format. Faces of
// several regions have a field in each.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/critical_points.hpp"
#include "model/field.hpp"

namespace quadrille::api {

struct FieldOptions {
  int order = 8;               ///< of the first solution on every element, 1 to 20
  bool adapt = true;           ///< then adapt the order of each element, as padapt does
  double target_error = 1e-8;  ///< of |v|, 0 to 1, for elements that reach the highest order: a warning if they miss it
  int num_threads = 1;         ///< the result does not depend on it
};

/// The harmonic field of a mesh: fieldsolve, then padapt, with their provenance. Warnings, if wanted, are added to
/// `warnings`.
Field solve_field(const TriMesh& mesh, const FieldOptions& options = {}, std::vector<std::string>* warnings = nullptr);

/// The unit field with exactly these nodes and corner valences: fieldsolve --nodes, then padapt. Throws ComputeError if
/// no field can have them.
Field solve_field_of_nodes(const TriMesh& mesh, const CriticalPoints& points, const FieldOptions& options = {},
                           std::vector<std::string>* warnings = nullptr);

/// The field at a point of the face.
struct FieldValue {
  Vec2 value;              ///< (u, v)
  double cross_angle = 0;  ///< psi = atan2(v, u) / 4, radians; the other directions are psi + k pi / 2
};

/// Evaluates a field at points. Not copied cheaply: make it once.
class FieldAtPoints {
 public:
  explicit FieldAtPoints(Field field);
  ~FieldAtPoints();
  FieldAtPoints(FieldAtPoints&&) noexcept;
  FieldAtPoints& operator=(FieldAtPoints&&) noexcept;

  const Field& field() const;
  /// std::nullopt outside of the mesh; on an interface the value of the first of its regions.
  std::optional<FieldValue> at(Vec2 point) const;
  /// The same for many points, fastest if successive points are near each other.
  std::vector<std::optional<FieldValue>> at(const std::vector<Vec2>& points) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace quadrille::api
