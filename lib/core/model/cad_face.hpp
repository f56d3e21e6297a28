#pragma once
// A planar CAD face for all later stages: exact boundary curves as NURBS, loops, joints, names. Every stage file
// contains it (formats/cad-face.md), so that no stage after cad2tri needs a CAD kernel.
//
// Conventions. Curves are listed loop after loop, in the order and direction in which the loop is traversed with the
// face on the LEFT: loop 0 is the outline (counter-clockwise), the others are holes (clockwise). Curve i ends at the
// start of its successor in the loop. Joint i is the START of curve i. No curve has a tangent jump inside: cad2tri
// splits curves there. All positions are relative to `origin`, which is (0, 0) unless the shape lies far from it.

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "model/chart.hpp"

namespace quadrille {

/// A clamped rational B-spline curve: knots.size() = poles.size() + degree + 1, the domain is [knots.front(),
/// knots.back()], weights are positive. Never periodic.
struct Nurbs {
  int degree = 1;
  std::vector<double> knots;
  std::vector<Vec2> poles;
  std::vector<double> weights;

  double begin() const { return knots.front(); }
  double end() const { return knots.back(); }
};

/// The start of a curve, which is the end of its predecessor in the loop.
struct Joint {
  Vec2 position;
  double tangent_in = 0;      ///< angle of the predecessor's tangent at its end, radians in (-pi, pi]
  double tangent_out = 0;     ///< angle of this curve's tangent at its start, radians in (-pi, pi]
  double interior_angle = 0;  ///< radians in (0, 2 pi); pi if the tangent is continuous
  bool is_corner = false;     ///< the tangent jump exceeds --corner-angle: a corner of the layout
};

/// Two curves of which a motion maps the first onto the second, reversed: x -> R(angle) x + shift, x with the face's
/// origin added. A solver sees them as one: their nodes are equal up to the motion.
struct PeriodicPair {
  std::array<int, 2> curves{};
  double angle = 0;  ///< radians
  Vec2 shift;        ///< a length
};

struct CadFace {
  std::string length_unit = "unknown";  ///< of the file: "metre", "millimetre", "inch", ..., "unknown"
  double metres_per_unit = 0;           ///< 0: unknown
  /// The face's plane in the CAD model's space, in the file's unit: x3d = origin3d + x e_x + y e_y, with (x, y)
  /// including `origin`. A face in z = const keeps its x and y: origin3d = (0, 0, const), e_x and e_y are the axes.
  std::array<double, 3> plane_origin{0, 0, 0};
  std::array<double, 3> plane_x{1, 0, 0};
  std::array<double, 3> plane_y{0, 1, 0};
  Vec2 origin;  ///< add it to obtain the face's own 2-D coordinates
  /// Greatest distance of the curves from those of the file, a length: splines with many knots were replaced by splines
  /// with few (curve/simplify_spline.hpp). 0: none was.
  double fit_distance = 0;
  double diameter = 0;  ///< largest distance between two points of the outline; scale of all default lengths

  std::vector<Nurbs> curves;
  std::vector<std::string> curve_names;  ///< one per curve; boundary groups get unique tags made from them
  std::vector<int> unnamed_curves;       ///< ascending: curves without a given name; theirs is made from their number
  std::vector<int> curve_cad_edges;      ///< number of the edge in the CAD file from which the curve was cut, base 0
  std::vector<int> loop_offsets;         ///< loop l has the curves [loop_offsets[l], loop_offsets[l+1])
  std::vector<Joint> joints;             ///< one per curve
  std::string name;                      ///< of the face, may be empty

  // Of several regions that share curves: a fluid and a solid, a coating, the cells of a pattern. All empty for one
  // region. Loops, curves and joints are listed region after region, and each region has loops of its own, so that a
  // common curve is there twice, once for each neighbour, in opposite directions: poles and weights of the one are
  // those of the other in the opposite order, bit for bit, and its knots are mirrored. Both in one region: a slit.
  std::vector<int> region_loops;  ///< region r has the loops [region_loops[r], region_loops[r+1]), its outline first
  std::vector<std::string> region_names;  ///< one per region
  std::vector<int> partners;              ///< one per curve: the same curve of the neighbour, or -1 on the boundary
  std::vector<PeriodicPair> periodic_pairs;
  /// Of a curved face: the plane of curves, joints and all later stages is that of its chart. Null: the face is planar.
  std::shared_ptr<const Chart> chart;

  /// Whether the CAD file or a user named the curve.
  bool has_given_name(int curve) const {
    return !std::binary_search(unnamed_curves.begin(), unnamed_curves.end(), curve);
  }
  int num_curves() const { return static_cast<int>(curves.size()); }
  int num_regions() const { return region_loops.empty() ? 1 : static_cast<int>(region_loops.size()) - 1; }
  /// Whether two regions meet in the curve.
  bool is_interface(int curve) const { return !partners.empty() && partners[curve] >= 0; }
  /// Whether a slit ends, bends or branches in the joint: other joints are in its place, and no point beside it is
  /// outside the face.
  bool is_slit_joint(int joint) const { return is_interface(joint) || is_interface(previous_in_loop(joint)); }
  /// Whether loop l encloses nothing: it runs along both sides of slits.
  bool is_slit_loop(int l) const {
    if (partners.empty()) return false;
    return std::all_of(partners.begin() + loop_offsets[l], partners.begin() + loop_offsets[l + 1],
                       [this, l](int p) { return p >= loop_offsets[l] && p < loop_offsets[l + 1]; });
  }
  int num_loops() const { return static_cast<int>(loop_offsets.size()) - 1; }
  /// Region of loop l.
  int region_of_loop(int l) const {
    int r = 0;
    while (r + 1 < num_regions() && l >= region_loops[r + 1]) ++r;
    return r;
  }
  /// chi = 1 - number of holes, summed over the regions.
  int euler_characteristic() const { return 2 * num_regions() - num_loops(); }
  int loop_of(int curve) const {
    int l = 0;
    while (curve >= loop_offsets[l + 1]) ++l;
    return l;
  }
  int next_in_loop(int curve) const {
    const int l = loop_of(curve);
    return curve + 1 < loop_offsets[l + 1] ? curve + 1 : loop_offsets[l];
  }
  int previous_in_loop(int curve) const {
    const int l = loop_of(curve);
    return curve > loop_offsets[l] ? curve - 1 : loop_offsets[l + 1] - 1;
  }
};

}  // namespace quadrille
