#include "field/corner_tilt.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "field/boundary_values.hpp"
#include "model/interfaces.hpp"

namespace quadrille::field {
namespace {

/// The turn of the phase at the corner. The window of ties is 2 degrees wide, 8 degrees of phase: this is well above.
constexpr double greatest_tilt = 40 * pi / 180;

/// Falls from 1 to 0 with two continuous derivatives.
double ramp(double x) {
  if (x >= 1) return 0;
  return 1 - x * x * x * (10 + x * (6 * x - 15));
}

/// The tilts along one curve: at its start, the outgoing side of a corner, and at its end. A reach of 0: no tilt.
struct CurveTilts {
  curve::ArcLength lengths;
  double reach_at_start = 0, reach_at_end = 0;

  explicit CurveTilts(const Nurbs& curve) : lengths(curve) {}
  /// For the sign 1.
  double turn(double t) const {
    const double from_start = lengths.at(t);
    if (from_start < reach_at_start) return greatest_tilt * ramp(from_start / reach_at_start);
    const double from_end = lengths.total() - from_start;
    return from_end < reach_at_end ? -greatest_tilt * ramp(from_end / reach_at_end) : 0;
  }
};

/// The tilts at some corners of a face.
class Tilts {
 public:
  Tilts(const CadFace& face, const std::vector<int>& joints, TiltPart part)
      : face_(&face), part_(part), curves_(face.num_curves()) {
    for (const int joint : joints) {
      CurveTilts &in = tilts_of(face.previous_in_loop(joint)), &out = tilts_of(joint);
      in.reach_at_end = out.reach_at_start = 0.5 * std::min(in.lengths.total(), out.lengths.total());
    }
  }

  Vec2 value(int curve, double t) const {
    const double turn = curves_[curve] ? curves_[curve]->turn(t) : 0;
    if (turn == 0) return {};
    const Vec2 v = boundary_value(*face_, curve, t);
    return part_ == TiltPart::even ? (std::cos(turn) - 1) * v : std::sin(turn) * left_of(v);
  }

 private:
  CurveTilts& tilts_of(int curve) {
    if (!curves_[curve]) curves_[curve].emplace(face_->curves[curve]);
    return *curves_[curve];
  }

  const CadFace* face_;
  TiltPart part_;
  std::vector<std::optional<CurveTilts>> curves_;
};

}  // namespace

LiftedData tilt_data(const TriMesh& mesh, const std::vector<int>& joints, TiltPart part) {
  const CadFace& face = mesh.face;
  const auto tilts = std::make_shared<const Tilts>(face, joints, part);
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  LiftedData data;
  for (const int joint : joints) {
    const int before = face.previous_in_loop(joint);
    const Vec2 v_in = tilts->value(before, face.curves[before].end()),
               v_out = tilts->value(joint, face.curves[joint].begin());
    if (norm(v_in - v_out) > jump_tol && !are_enclosed[joint])
      data.liftings.push_back(lifting_at(face, joint, v_in, v_out));
  }
  const auto lifted = [&face, tilts, liftings = data.liftings](int curve, double t) {
    return tilts->value(curve, t) - liftings_on_boundary(face, liftings, curve, t);
  };
  data.values = [lifted, bridges = CornerBridges(mesh)](int curve, double t) {
    return bridges.bridged(lifted, curve, t);
  };
  return data;
}

void add(const HarmonicPart& part, double factor, Field& field) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < part.elems.size(); ++k) {
    const int first = field.coef_offsets[part.elems[k]];
    for (int i = first; i < first + part.num_modes[k]; ++i, ++next) {
      field.u[i] += factor * part.u[next];
      field.v[i] += factor * part.v[next];
    }
  }
  for (const Lifting& lifting : part.liftings) {
    const auto same = std::find_if(field.liftings.begin(), field.liftings.end(),
                                   [&](const Lifting& other) { return other.joint == lifting.joint; });
    if (same != field.liftings.end()) {
      same->jump += factor * lifting.jump;
    } else {
      field.liftings.push_back(lifting);
      field.liftings.back().jump = factor * lifting.jump;
    }
  }
}

}  // namespace quadrille::field
