#pragma once
// The nodes of one half of a symmetric whole: those of the whole, chosen on its own field, without their mirror images.

#include "base/error.hpp"
#include "choice/node_options.hpp"
#include "curve/symmetry_lines.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"

namespace quadrille::choice {

/// A node of odd valence is on the line of symmetry. Of its blocks one is a mirror image of itself: the line runs
/// through it from corner to corner, so that its half is a triangle.
struct OddValenceError : ComputeError {
  using ComputeError::ComputeError;
};

/// A whole of which a face is one half. Where the boundary meets the line the valence of the whole must be even, twice
/// that of the half: it is prescribed there.
class HalfModel {
 public:
  /// `half` must outlive the object. Throws ComputeError if a prescribed valence of a corner on the line does not fit
  /// the whole.
  HalfModel(const Field& half, const NodeOptions& options, curve::SymmetryLine line);

  /// The harmonic field of the whole, on the mesh of the half and its mirror image with the orders of the half.
  Field field_of_whole(int num_threads) const;
  const NodeOptions& options_of_whole() const { return options_; }
  /// The nodes, corner valences and records of the half; nodes of the whole on the line are its boundary nodes. The
  /// form is `phase`: they are no zeros of the field of the half. Counts of the certificate are those of the whole.
  /// Throws OddValenceError if a valence on the line is odd, ComputeError if the nodes of the whole are not symmetric.
  CriticalPoints nodes_of_half(const CriticalPoints& whole) const;

 private:
  const CadFace& face() const { return half_.mesh.face; }
  bool is_on_line(int curve) const { return mirrored_.copy[curve] < 0; }
  bool is_beside_line(int joint) const { return is_on_line(joint) != is_on_line(face().previous_in_loop(joint)); }
  bool is_near_line(Vec2 x) const;
  int joint_of_whole(int joint) const;
  void mirror_override(const guide::CornerOverride& prescribed);
  void prescribe_even_valences();
  void mirror_walls();
  void mirror_scale();
  Corner corner_of_half(int joint, const CriticalPoints& whole) const;
  int even_half(int valence, Vec2 position) const;
  void add_boundary_node(IrregularBoundaryPoint node, CriticalPoints& half) const;
  void add_nodes(const CriticalPoints& whole, CriticalPoints& half) const;
  void add_boundary_nodes(const CriticalPoints& whole, CriticalPoints& half) const;
  void add_records(const CriticalPoints& whole, CriticalPoints& half) const;

  const Field& half_;
  curve::SymmetryLine line_;
  curve::MirroredFace mirrored_;
  NodeOptions options_;
};

}  // namespace quadrille::choice
