#pragma once
// All separatrices of a field, each traced to the length that a layout needs.
//
// A separatrix that starts on a mirror axis of the field, along it, is that axis. Where the field turns away from the
// axis on both sides, lines beside it leave it exponentially, and an integrated line would leave it to the side to
// which round-off pushes it: images of one line would end at different places. Such lines are launched as straight
// ones.

#include <vector>

#include "base/progress.hpp"
#include "model/critical_points.hpp"
#include "trace/advance.hpp"

namespace quadrille::trace {

struct TraceOptions {
  double tolerance = 1e-10;  ///< bound of a step's estimated error, in diameters
  double step = 0;           ///< greatest one, file units; 0: diameter / 20
  /// Degrees: head-on separatrices are merged if neither changes its direction by more. On all benchmark shapes 15
  /// removes most thin chords and does not reduce the least scaled Jacobian of the mesh.
  double merge_angle = 15;
  double merge_distance = 0;  ///< file units: also separatrices that pass within this distance are merged
  double max_length = 20;     ///< of one line, in diameters
  /// Of all lines that are traced to their ends, in diameters. Few lines of plates with many holes are longer than one
  /// diameter; spirals have many.
  double max_total_length = 500;
  /// Of one line, in the mean over all lines, at least 100. Plates with many holes need 150, racks of teeth 400; a line
  /// in a damaged field takes max_stream_steps and gets nowhere.
  int max_steps = 1000;
  void validate() const;  ///< throws UsageError
};

/// The axes of reflections that map the face and its nodes, with their valences, onto themselves (curve/symmetry). None
/// if windings of holes are prescribed, which need not be symmetric.
std::vector<MirrorAxis> mirror_axes(const CadFace& face, const CriticalPoints& points);

/// Lines that are merged behind each other's nodes, or that stop at others, need not be traced to their ends: they are
/// traced in rounds of increasing length. A line that is continued keeps its earlier steps. Every function that follows
/// lines throws ComputeError as advance(), and as soon as they have more steps than TraceOptions::max_steps allows.
class LineTracer {
 public:
  /// `evaluator` must outlive the tracer. `nodes`: the positions of fixed_nodes. Launches all separatrices; if none
  /// starts in an annulus, cuts. Throws ComputeError as launch_all.
  LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const std::vector<Vec2>& nodes,
             const TraceOptions& options);

  /// Follows all lines that have no end yet to a length, at most options.max_length.
  void follow_all_to(double length, Progress* progress = nullptr);

  /// Continues one line that was traced before.
  void follow_to(int line, double length);

  /// Adds a line from a point of the boundary (a cut), followed to a length.
  void add_cut(int curve, double t, double length);

  /// A line in direction `angle` (radians) from a point of the domain, up to options.max_length; it is not added to
  /// lines().
  Streamline follow_from(Vec2 x, double angle) const;

  /// By line, the length to which it was followed, if it had no end before; 0: to the greatest length.
  std::vector<double> reaches() const;
  double max_length() const { return max_length_; }
  /// Of all lines.
  std::size_t num_steps() const { return num_steps_; }

  const std::vector<Streamline>& lines() const { return lines_; }

 private:
  AdvanceOptions bounds(double length) const;
  void add_line(Streamline line, double reach);
  void require_few_steps() const;
  Streamline traced(const Launch& launch, const AdvanceOptions& options) const;

  const field::FieldEvaluator& evaluator_;
  PointGrid nodes_;
  TraceOptions options_;
  double max_length_ = 0;
  std::size_t num_steps_ = 0, max_num_steps_ = 0;
  std::vector<MirrorAxis> axes_;
  std::vector<Launch> launches_;  // of lines that have not been followed yet
  std::vector<Streamline> lines_;
  std::vector<double> reaches_;  // of lines_
};

}  // namespace quadrille::trace
