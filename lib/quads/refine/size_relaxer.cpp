#include "refine/size_relaxer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quadrille::refine {
namespace {

struct StepConstants {
  double longest_step =
      0.3;                ///< of the prescribed size, by which the ends of an edge move apart at most in a first step
  int first_sweeps = 60;  ///< with the diagonal blocks of the Hessian, that cost less
  double far = 1000;      ///< energy of an element in the mean, 2 for squares, above which these sweeps end when slow
  int blocks_kept = 10;   ///< sweeps, after which sizes and blocks are those of the new positions
  /// Sweeps after which sizes and factors of the Hessian are, also after one that lowers the energy by more than a
  /// fraction.
  int factors_kept = 20;
  double far_progress = 0.01;
  int slow_sweeps = 2;        ///< in turn, after which relaxation ends (SizeRelaxation::least_progress)
  double least_slope = 1e-9;  ///< least decrease that the linear model promises, of the energy
  double descent = 1e-4;      ///< least decrease of a step, of that of the linear model
  int max_halvings = 20;      ///< of a step
  double factors_work = 0.5;  ///< steps that take as long as factors of the Hessian, over the root of the elements
  int held_steps = 8;         ///< in which vertices slide to where they are held
  double shape_first = 40;    ///< factor of the weight of shapes where elements keep their lengths
};
constexpr StepConstants step_constants;

/// By element: the mean length of its opposite sides, along s and t.
std::vector<Vec2> element_lengths(const QuadMesh& mesh) {
  std::vector<Vec2> lengths;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto side = [&](int k) {
      return distance(mesh.nodes[side_start(mesh, elem, k)], mesh.nodes[side_start(mesh, elem, (k + 1) % 4)]);
    };
    lengths.push_back({(side(0) + side(2)) / 2, (side(1) + side(3)) / 2});
  }
  return lengths;
}

}  // namespace

SizeRelaxer::SizeRelaxer(const RelaxProblem& problem, const QuadMesh& shaped, const SizeRelaxation& options)
    : energy(problem, shaped),
      moves(problem.num_vertices()),
      least_progress(options.least_progress),
      problem_(problem),
      options_(options),
      held_(moves),
      lengths_(options.keeps_lengths ? element_lengths(shaped) : options.greatest_lengths),
      shorter_(shaped.num_elems(), {1, 1}),
      counts_(shorter_),
      known_sizes_(shaped.num_elems()),
      known_sizes_at_vertices_(problem.num_vertices()),
      inverse_(problem) {
  if (options.keeps_lengths)
    for (auto* weights : {&energy.shape_weights, &energy.skew_weights})
      for (double& weight : *weights) weight *= step_constants.shape_first;
  set_sizes();
  value = energy.value(moves);
}

void SizeRelaxer::begin_at(const PlacedVertices& start) {
  moves = start.moves(problem_);
  if (!std::isfinite(energy.value(moves))) moves = held_;
}

void SizeRelaxer::set_sizes() {
  const QuadMesh& mesh = problem_.start;
  const std::vector<Vec2> middles = energy.middles(moves);
  const bool has_gradients = !options_.keeps_lengths && !options_.sizes.is_uniform();
  std::vector<Vec2> sizes, log_size_gradients;
  size_.clear(), energy.stretches.clear();
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const sizing::DirectedSize of = options_.keeps_lengths
                                        ? sizing::DirectedSize{std::max(lengths_[elem].x, lengths_[elem].y)}
                                        : prescribed_size(elem, middles[elem], known_sizes_[elem]);
    const Vec2 own = lengths_.empty() ? Vec2{of.size, of.size}
                                      : Vec2{std::min(of.size, lengths_[elem].x), std::min(of.size, lengths_[elem].y)};
    // A side that is bent in the chart may be straight on the surface.
    const bool is_bent = !options_.keeps_lengths && !options_.sizes.scale();
    const Vec2 bend = is_bent ? energy.bend_factors(elem, of.size) : Vec2{1, 1};
    const Vec2 shorter = shorter_[elem], count = counts_[elem];
    sizes.push_back({own.x * shorter.x * count.x * bend.x, own.y * shorter.y * count.y * bend.y});
    size_.push_back(of.least());
    if (options_.sizes.has_metric()) energy.stretches.push_back(of.stretch);
    if (has_gradients) log_size_gradients.push_back(log_size_gradient(elem, middles[elem]));
  }
  if (options_.directions) set_directions();
  energy.set_sizes(sizes, std::move(log_size_gradients));
}

/// Runs that begin at the same vertices (refine/count_relaxer) have the same sizes at first.
const sizing::DirectedSize& SizeRelaxer::prescribed_size(int elem, Vec2 at, KnownSize& known) {
  const int region = problem_.start.region_of(elem);
  if (!(known.size.size > 0 && known.at == at && known.region == region))
    known = {at, region, options_.sizes.directed(at, region)};
  return known.size;
}

/// The mean over the element, by the sizes at its corners: sizes have kinks halfway between their sources. In a chart
/// that of its scale alone: sources there are where elements miss the surface, and have to stay.
Vec2 SizeRelaxer::log_size_gradient(int elem, Vec2 middle) {
  if (const auto& scale = options_.sizes.scale()) return -scale->gradient(middle);
  const auto& v = problem_.follow.elem_vertices()[elem];
  const std::vector<Vec2>& x = energy.positions();
  const auto at = [&](int c) { return std::log(prescribed_size(elem, x[v[c]], known_sizes_at_vertices_[v[c]]).size); };
  const std::array<double, 4> log_size{at(0), at(1), at(2), at(3)};
  const auto along = [&](const auto& of) { return of(1) - of(0) + of(2) - of(3); };
  const auto across = [&](const auto& of) { return of(3) - of(0) + of(2) - of(1); };
  const auto position = [&](int c) { return x[v[c]]; };
  const auto size = [&](int c) { return log_size[c]; };
  const Vec2 s = along(position), t = across(position);
  return (along(size) * Vec2{t.y, -t.x} + across(size) * Vec2{-s.y, s.x}) / cross(s, t);
}

/// Means over elements, which may be larger than the features that prescribe directions.
void SizeRelaxer::set_directions() {
  constexpr std::array<double, 3> along{1.0 / 6, 1.0 / 2, 5.0 / 6};
  const std::vector<Vec2>& x = energy.positions();
  energy.directions.clear();
  for (const auto& [a, b, c, d] : problem_.follow.elem_vertices()) {
    Vec2 sum;
    for (const double s : along)
      for (const double t : along)
        sum += options_.directions((1 - t) * ((1 - s) * x[a] + s * x[b]) + t * ((1 - s) * x[d] + s * x[c]));
    energy.directions.push_back(sum / (along.size() * along.size()));
  }
}

void SizeRelaxer::set_counts(std::vector<Vec2> counts) {
  inverse_.forget();
  counts_ = std::move(counts);
  for (std::size_t elem = 0; elem < counts_.size(); ++elem)
    energy.multiplicities[elem] = counts_[elem].x * counts_[elem].y;
}

/// Of this direction, at most 1.
double SizeRelaxer::longest_step(const VertexMoves& direction) const {
  VertexMoves shifts = direction;
  for (int v = 0; v < problem_.num_vertices(); ++v)
    if (problem_.follow.on_boundary(v) >= 0) shifts[v] = direction[v].x * energy.curve_tangents()[v];
  double length = 1;
  for (int elem = 0; elem < problem_.start.num_elems(); ++elem) {
    const auto& vertices = problem_.follow.elem_vertices()[elem];
    const double longest = step_constants.longest_step * size_[elem];
    for (int c = 0; c < 4; ++c) {
      const Vec2 apart = shifts[vertices[c]] - shifts[vertices[(c + 1) % 4]];
      if (length * length * norm2(apart) > longest * longest) length = longest / norm(apart);
    }
  }
  return length;
}

/// Returns whether the energy became less.
bool SizeRelaxer::step(EnergyDerivatives& at) {
  VertexMoves direction = inverse_.descent(at.gradient);
  symmetry_->average(direction);
  const double slope = inner_product(direction, at.gradient);
  if (!(slope < -step_constants.least_slope * at.value)) return false;
  double length = inverse_.is_factored() ? 1 : longest_step(direction);
  for (int halving = 0; halving < step_constants.max_halvings; ++halving, length /= 2) {
    VertexMoves next = moves;
    add_multiple(length, direction, next);
    EnergyDerivatives there = energy.with_derivatives(next);
    count_work(1);
    if (!(there.value <= at.value + step_constants.descent * length * slope)) continue;
    problem_.join_twins(there.gradient);
    symmetry_->average(there.gradient);
    VertexMoves change = there.gradient, step = direction;
    add_multiple(-1, at.gradient, change);
    for (Vec2& x : step) x *= length;
    inverse_.add_step(std::move(step), std::move(change));
    moves = std::move(next);
    at = std::move(there);
    return true;
  }
  return false;
}

bool SizeRelaxer::hold(const std::optional<std::vector<HeldVertex>>& vertices, RelaxProblem& problem) {
  if (!vertices) return false;
  for (const HeldVertex& at : *vertices) problem.fix_vertex(at.vertex);
  inverse_.forget();
  const VertexMoves before = moves;
  // In each step as far as elements allow; then the other vertices follow.
  double left = 1;
  for (int step = 0; step < step_constants.held_steps && left > 0; ++step) {
    const VertexMoves from = moves;
    const auto is_possible = [&](double part) {
      moves = from;
      for (const HeldVertex& at : *vertices) held_[at.vertex].x = moves[at.vertex].x += part * at.slide;
      return std::isfinite(energy.value(moves));
    };
    double part = left;
    for (int halving = 0; !is_possible(part) && halving < step_constants.max_halvings; ++halving) part /= 2;
    left -= part;
    if (left > 0) run();
  }
  for (const HeldVertex& at : *vertices) moves[at.vertex].x = held_[at.vertex].x = before[at.vertex].x + at.slide;
  return std::isfinite(energy.value(moves));
}

bool SizeRelaxer::begin_again() {
  inverse_.forget();
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (problem_.is_fixed[v]) moves[v] = held_[v];
  if (std::isfinite(energy.value(moves))) return true;
  moves = held_;
  return std::isfinite(energy.value(moves));
}

void SizeRelaxer::count_work(double steps) { work_ += steps * problem_.start.num_elems(); }

double SizeRelaxer::steps_of_factors() const {
  return step_constants.factors_work * std::sqrt(problem_.start.num_elems());
}

EnergyDerivatives SizeRelaxer::begin(bool is_first) {
  count_work(is_first ? 1 : steps_of_factors());
  EnergyDerivatives at = energy.with_derivatives(moves, is_first);
  problem_.join_twins(at.gradient);
  if (!symmetry_) symmetry_.emplace(problem_, energy.positions(), energy.curve_tangents(), at.gradient);
  symmetry_->average(at.gradient);
  if (is_first)
    inverse_.set_blocks(at.blocks, energy.curve_tangents());
  else
    inverse_.factorise(energy);
  return at;
}

void SizeRelaxer::run() {
  set_sizes();
  // Of many elements factors take longer.
  int slow = 0, kept = 0, first_sweeps = std::max(step_constants.first_sweeps, static_cast<int>(steps_of_factors()));
  const int num_elems = problem_.start.num_elems();
  EnergyDerivatives at = begin(true);
  for (int sweep = 0; sweep < options_.sweeps && !is_exhausted(); ++sweep, ++kept) {
    if (slow >= step_constants.slow_sweeps) {
      const bool may_factorise = work_ + steps_of_factors() * num_elems <= options_.most_work;
      if (sweep >= first_sweeps || at.value < step_constants.far * num_elems || !may_factorise) break;
      first_sweeps = sweep, slow = 0;
    }
    const bool is_first = sweep < first_sweeps;
    if (sweep == first_sweeps) inverse_.forget();
    if (kept == (is_first ? step_constants.blocks_kept : step_constants.factors_kept) || sweep == first_sweeps) {
      if (!options_.keeps_lengths || !options_.sizes.is_uniform() || options_.directions) set_sizes();
      at = begin(is_first), kept = 0;
    }
    const double before = at.value;
    if (!step(at)) {
      if (inverse_.is_plain()) slow = step_constants.slow_sweeps;
      inverse_.forget();
      continue;
    }
    ++num_sweeps;
    const double progress = (before - at.value) / before;
    slow = progress < least_progress ? slow + 1 : 0;
    if (is_first || progress <= step_constants.far_progress) continue;
    inverse_.forget();
    kept = step_constants.factors_kept - 1;
  }
  value = at.value;
}

}  // namespace quadrille::refine
