#include "ties/tilted_field.hpp"

#include "field/error_estimate.hpp"

namespace quadrille::ties {
namespace {

std::vector<int> joints_of(const TieOrbits& ties, const std::vector<int>& unit) {
  std::vector<int> joints;
  for (const int t : unit) joints.push_back(ties.ties[t].joint);
  return joints;
}

/// The even parts of all ties, the odd part of those without a choice, then that of each unit.
std::vector<field::LiftedData> tilts(const CadFace& face, const TieOrbits& ties) {
  std::vector<int> all, without_choice;
  for (const Tie& tie : ties.ties) {
    all.push_back(tie.joint);
    if (tie.smaller == 0) without_choice.push_back(tie.joint);
  }
  std::vector<field::LiftedData> data{field::tilt_data(face, all, field::TiltPart::even),
                                      field::tilt_data(face, without_choice, field::TiltPart::odd)};
  for (const std::vector<int>& unit : ties.units)
    data.push_back(field::tilt_data(face, joints_of(ties, unit), field::TiltPart::odd));
  return data;
}

}  // namespace

TiltedField::TiltedField(const Field& field, const TieOrbits& ties, const PartSolver& solve) : sum_(field) {
  std::vector<field::HarmonicPart> parts = solve(tilts(field.mesh.face, ties));
  field::add(parts[0], 1, sum_);
  field::add(parts[1], -1, sum_);
  odd_.assign(parts.begin() + 2, parts.end());
  u_ = sum_.u;
  v_ = sum_.v;
  liftings_ = sum_.liftings;
  sum_.elem_error.clear();
}

const field::FieldEvaluator& TiltedField::with(const Choice& choice) {
  sum_.u = u_;
  sum_.v = v_;
  sum_.liftings = liftings_;
  for (std::size_t i = 0; i < odd_.size(); ++i) field::add(odd_[i], choice[i] ? 1 : -1, sum_);
  if (sum_.elem_error.empty()) sum_.elem_error = field::error_estimate(sum_);
  if (!evaluator_) evaluator_ = std::make_unique<field::FieldEvaluator>(sum_);
  return *evaluator_;
}

}  // namespace quadrille::ties
