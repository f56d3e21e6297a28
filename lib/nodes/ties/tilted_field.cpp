#include "ties/tilted_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "curve/symmetry.hpp"
#include "field/error_estimate.hpp"
#include "field/explicit_value.hpp"
#include "guide/valence.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::ties {
namespace {

constexpr double symmetry_tolerance = 1e-3;  // diameters

std::optional<Tie> tie_at(const CadFace& face, int joint) {
  const double angle = face.joints[joint].interior_angle;
  const int smaller = static_cast<int>(std::floor(angle / half_pi));
  const double tie = (smaller + 0.5) * half_pi;
  if (!face.joints[joint].is_corner || std::abs(angle - tie) > guide::tie_window) return {};
  return Tie{joint, tie, smaller};
}

/// The tie nearest to x, if it is near enough to be an image; -1: none.
int tie_near(const CadFace& face, const std::vector<Tie>& ties, Vec2 x) {
  int nearest = -1;
  double least = 4 * symmetry_tolerance * face.diameter;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    const double d = distance(face.joints[ties[i].joint].position, x);
    if (d < least) least = d, nearest = static_cast<int>(i);
  }
  return nearest;
}

/// The sets of ties that these isometries map onto each other; ties without a choice are left out.
std::vector<std::vector<int>> sets_of(const CadFace& face, const std::vector<Tie>& ties,
                                      const std::vector<curve::Isometry>& group) {
  const auto is_image = [&](const curve::Isometry& g, int i, int j) {
    return ties[i].smaller == ties[j].smaller && tie_near(face, ties, g(face.joints[ties[i].joint].position)) == j;
  };
  std::vector<std::vector<int>> sets = curve::orbits(ties.size(), group, is_image).sets;
  std::erase_if(sets, [&](const std::vector<int>& set) { return ties[set.front()].smaller == 0; });
  return sets;
}

/// The orbit of the tie at a joint, -1: no tie with a choice there.
int orbit_at(const TieOrbits& ties, int joint) {
  for (std::size_t u = 0; u < ties.units.size(); ++u)
    for (const int t : ties.units[u])
      if (ties.ties[t].joint == joint) return ties.unit2orbit[u];
  return -1;
}

/// Where the odd parts are sampled, in reference coordinates, and the factor that covers what lies between.
constexpr std::array<Vec2, 7> samples{
    Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{0, -1}, Vec2{0, 0}, Vec2{-1, 0}, Vec2{-1.0 / 3, -1.0 / 3}};
constexpr double safety = 2;

std::vector<int> joints_of(const TieOrbits& ties, const std::vector<int>& unit) {
  std::vector<int> joints;
  for (const int t : unit) joints.push_back(ties.ties[t].joint);
  return joints;
}

/// What parts omit: coefficients, and changes of an element. That of a few units is far below the error of any field;
/// with many, each tie has others between itself and most of the face, where its part is small.
struct Negligible {
  double always = 1e-13, of_many = 1e-6;
  double change = 1e-9;  ///< on an element: far less than what moves a node noticeably
  std::size_t many_units = 16;
};
constexpr Negligible negligible;

/// Lower orders where the coefficients of higher ones are negligible.
Field shortened(Field field, double limit) {
  int end = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    int &first = field.coef_offsets[e], &order = field.elem_order[e], size = spectral::num_tri_modes(order);
    const auto is_negligible = [&](int i) { return std::hypot(field.u[first + i], field.v[first + i]) < limit; };
    for (int last = size - 1; order > 1 && is_negligible(last); --last)
      if (last == spectral::num_tri_modes(order - 1)) size = spectral::num_tri_modes(--order);
    for (std::vector<double>* values : {&field.u, &field.v})
      std::copy_n(values->begin() + first, size, values->begin() + end);
    first = std::exchange(end, end + size);
  }
  field.coef_offsets.back() = end;
  field.u.resize(end);
  field.v.resize(end);
  return field;
}

}  // namespace

TieOrbits tie_orbits(const CadFace& face) {
  TieOrbits result;
  for (int j = 0; j < face.num_curves(); ++j)
    if (const auto tie = tie_at(face, j)) result.ties.push_back(*tie);
  if (result.ties.empty()) return result;
  std::vector<curve::Isometry> group = curve::symmetries(face, symmetry_tolerance);
  const std::vector<std::vector<int>> orbits = sets_of(face, result.ties, group);
  std::erase_if(group, [](const curve::Isometry& g) { return g.is_mirrored; });
  result.units = sets_of(face, result.ties, group);
  result.orbits.resize(orbits.size());
  for (std::size_t u = 0; u < result.units.size(); ++u)
    for (std::size_t o = 0; o < orbits.size(); ++o) {
      if (std::find(orbits[o].begin(), orbits[o].end(), result.units[u].front()) == orbits[o].end()) continue;
      result.orbits[o].push_back(static_cast<int>(u));
      result.unit2orbit.push_back(static_cast<int>(o));
    }
  return result;
}

std::vector<std::vector<int>> chamfers(const CadFace& face, const TieOrbits& ties) {
  std::vector<std::vector<int>> pairs;
  for (std::size_t u = 0; u < ties.units.size(); ++u)
    for (const int t : ties.units[u]) {
      const int out = ties.ties[t].joint, in = face.previous_in_loop(out);
      const bool is_out_shorter = guide::side_length(face, out) < guide::side_length(face, in);
      const int other = orbit_at(ties, is_out_shorter ? face.next_in_loop(out) : in);
      const int own = ties.unit2orbit[u];
      if (other >= 0 && other != own) pairs.push_back({std::min(own, other), std::max(own, other)});
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

TiltedField::TiltedField(const Field& field, const TieOrbits& ties, PartSolver solve)
    : field_(&field),
      ties_(&ties),
      solve_(std::move(solve)),
      choice_(ties.units.size(), false),
      sum_(shortened(solved(choice_), negligible_part())),
      evaluator_(sum_) {
  std::vector<field::LiftedData> data;
  for (const std::vector<int>& unit : ties.units)
    data.push_back(field::tilt_data(field.mesh, joints_of(ties, unit), field::TiltPart::odd));
  odd_ = solve_(data, sum_.elem_order, negligible_part());
  for (const field::HarmonicPart& part : odd_) changes_.push_back(changes_by(part));
  const auto is_lifted = [](const field::HarmonicPart& part) { return !part.liftings.empty(); };
  if (std::none_of(odd_.begin(), odd_.end(), is_lifted)) evaluator_.set_far_terms(field::FarTerms::expanded);
}

double TiltedField::negligible_part() const {
  return choice_.size() > negligible.many_units ? negligible.of_many : negligible.always;
}

Field TiltedField::solved(const Choice& choice) const {
  std::vector<int> all, smaller, larger;  // joints
  for (const Tie& tie : ties_->ties) {
    all.push_back(tie.joint);
    if (tie.smaller == 0) larger.push_back(tie.joint);
  }
  for (std::size_t u = 0; u < choice.size(); ++u)
    for (const int joint : joints_of(*ties_, ties_->units[u])) (choice[u] ? smaller : larger).push_back(joint);
  const TriMesh& mesh = field_->mesh;
  const field::LiftedData even = field::tilt_data(mesh, all, field::TiltPart::even),
                          odd = field::tilt_data(mesh, smaller, field::TiltPart::odd),
                          opposite = field::tilt_data(mesh, larger, field::TiltPart::odd);
  field::LiftedData data{
      [&](int curve, double t) { return even.values(curve, t) + odd.values(curve, t) - opposite.values(curve, t); },
      even.liftings};
  data.liftings.insert(data.liftings.end(), odd.liftings.begin(), odd.liftings.end());
  for (const Lifting& lifting : opposite.liftings) data.liftings.emplace_back(lifting).jump *= -1;
  Field sum = *field_;
  field::add(solve_({data}, sum.elem_order, negligible.always).front(), 1, sum);
  sum.elem_error = field::error_estimate(sum);
  return sum;
}

std::size_t TiltedField::num_numbers() const {
  std::size_t sum = 0;
  for (const field::HarmonicPart& part : odd_) sum += part.u.size() + part.v.size();
  return sum;
}

// Twice the odd part: its sign changes.
std::vector<TiltedField::Change> TiltedField::changes_by(const field::HarmonicPart& part) {
  std::vector<Change> changes;
  std::size_t next = 0;
  for (std::size_t k = 0; k < part.elems.size(); ++k) {
    const int e = part.elems[k], order = sum_.elem_order[e], size = part.num_modes[k];
    Eigen::MatrixXd& basis = sampled_basis_[order];
    if (basis.size() == 0) basis = spectral::orthogonal_vandermonde(order, {samples.begin(), samples.end()});
    Eigen::Matrix<double, Eigen::Dynamic, 2> values(basis.rows(), 2);
    values.col(0).noalias() = basis.leftCols(size) * Eigen::Map<const Eigen::VectorXd>(&part.u[next], size);
    values.col(1).noalias() = basis.leftCols(size) * Eigen::Map<const Eigen::VectorXd>(&part.v[next], size);
    next += size;
    for (const Lifting& lifting : part.liftings)
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec2 lifted = field::lifting_angle(lifting, evaluator_.maps()[e].position(samples[i])) * lifting.jump;
        values.row(static_cast<Eigen::Index>(i)) += Eigen::RowVector2d(lifted.x, lifted.y);
      }
    const double most = 2 * safety * values.rowwise().norm().maxCoeff();
    if (most > negligible.change) changes.push_back({e, most});
  }
  return changes;
}

void TiltedField::forget_parts() {
  odd_.clear();
  odd_.shrink_to_fit();
  evaluator_.set_far_terms(field::FarTerms::summed);
}

const field::FieldEvaluator& TiltedField::with(const Choice& choice) {
  for (std::size_t i = 0; i < odd_.size(); ++i)
    if (choice[i] != choice_[i]) field::add(odd_[i], choice[i] ? 2 : -2, sum_);
  choice_ = choice;
  return evaluator_;
}

}  // namespace quadrille::ties
