#include "ties/tilted_field.hpp"

#include <algorithm>
#include <array>

#include "base/tolerance.hpp"
#include "field/error_estimate.hpp"
#include "zeros/surely_empty.hpp"

namespace quadrille::ties {
namespace {

/// Where the odd parts are sampled, in reference coordinates, and the factor that covers what lies between.
constexpr std::array<Vec2, 7> samples{
    Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{0, -1}, Vec2{0, 0}, Vec2{-1, 0}, Vec2{-1.0 / 3, -1.0 / 3}};
constexpr double safety = 2;

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
  sum_.elem_error.clear();
  evaluator_ = std::make_unique<field::FieldEvaluator>(sum_);
  find_empty_elements();
}

/// The sum over all units of the greatest sampled value of the odd part on each element. Leaves another field in sum_.
std::vector<double> TiltedField::greatest_changes() {
  std::vector<double> sums(sum_.mesh.num_elems(), 0);
  for (const field::HarmonicPart& part : odd_) {
    std::fill(sum_.u.begin(), sum_.u.end(), 0);
    std::fill(sum_.v.begin(), sum_.v.end(), 0);
    sum_.liftings.clear();
    field::add(part, 1, sum_);
    for (const int e : part.elems) {
      double greatest = 0;
      Vec2 x;
      Mat2 ignored;
      for (const Vec2 xi : samples) greatest = std::max(greatest, norm(evaluator_->value(e, xi, x, ignored)));
      sums[e] += greatest;
    }
  }
  return sums;
}

void TiltedField::find_empty_elements() {
  is_empty_.assign(sum_.mesh.num_elems(), false);
  if (sum_.method != FieldMethod::cg) return;
  const std::vector<double> u = sum_.u, v = sum_.v;
  const std::vector<Lifting> liftings = sum_.liftings;
  const std::vector<double> changes = greatest_changes();
  sum_.u = u;
  sum_.v = v;
  sum_.liftings = liftings;
  for (int e = 0; e < sum_.mesh.num_elems(); ++e)
    is_empty_[e] = zeros::is_surely_empty(*evaluator_, e, safety * changes[e] + tolerance::round_off);
}

const field::FieldEvaluator& TiltedField::with(const Choice& choice) {
  if (choice_.empty()) {
    choice_ = choice;
    for (std::size_t i = 0; i < odd_.size(); ++i) field::add(odd_[i], choice[i] ? 1 : -1, sum_);
  }
  for (std::size_t i = 0; i < odd_.size(); ++i)
    if (choice[i] != choice_[i]) field::add(odd_[i], choice[i] ? 2 : -2, sum_);
  choice_ = choice;
  if (sum_.elem_error.empty()) sum_.elem_error = field::error_estimate(sum_);
  return *evaluator_;
}

}  // namespace quadrille::ties
