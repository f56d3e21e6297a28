#include "zeros/zero_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "surface/positions.hpp"

namespace quadrille::zeros {
namespace {

constexpr std::array<Vec2, 3> reference_vertices{Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}};

Vec2 on_edge(int edge, double t) {
  const Vec2 a = reference_vertices[edge], b = reference_vertices[(edge + 1) % 3];
  return a + t * (b - a);
}

Vec2 value(const field::FieldEvaluator& evaluator, int elem, Vec2 xi) {
  Vec2 x;
  Mat2 dx_dxi;
  return evaluator.value(elem, xi, x, dx_dxi);
}

double jump(const field::FieldEvaluator& evaluator, int elem, int edge) {
  const mesh::TriTopology& topology = evaluator.topology();
  const int other = topology.elem2neighbors[elem][edge], other_edge = topology.elem2neighbor_edges[elem][edge];
  const std::vector<int>& orders = evaluator.field().elem_order;
  const int n = std::max(orders[elem], orders[other]) + 2;
  double greatest = 0;
  for (int i = 0; i < n; ++i) {
    const double t = 0.5 * (1 - std::cos((2 * i + 1) * pi / (2 * n)));
    greatest = std::max(
        greatest, norm(value(evaluator, elem, on_edge(edge, t)) - value(evaluator, other, on_edge(other_edge, 1 - t))));
  }
  return 2 * greatest;
}

constexpr int max_depth = 72;           // 2^-36 of an element's size
constexpr long long max_cells = 50000;  // in one element; a simple zero needs some hundred at most

std::array<Vec2, 3> vertices(const Cell& cell) { return {cell.vertex(0), cell.vertex(1), cell.vertex(2)}; }

std::array<Vec2, 3> vertices(const spectral::TriMap& map) {
  return {map.position(reference_vertices[0]), map.position(reference_vertices[1]),
          map.position(reference_vertices[2])};
}

bool touches_vertex(const Cell& cell, int k) {
  return std::find(cell.xi.begin(), cell.xi.end(), reference_vertices[k]) != cell.xi.end();
}

bool is_inside(const FoundZero& zero) { return mesh::outside_reference(zero.xi) <= inside_tol; }

bool is_same(const FoundZero& a, const FoundZero& b, double diameter) {
  const double reach = 1e-3 * std::min(a.cell_radius, b.cell_radius) + 8 * std::max(a.shift, b.shift);
  return a.index == b.index && distance(a.x, b.x) <= reach + 1e-12 * diameter;
}

}  // namespace

std::vector<Jumps> edge_jumps(const field::FieldEvaluator& evaluator) {
  const TriMesh& mesh = evaluator.field().mesh;
  const mesh::TriTopology& topology = evaluator.topology();
  if (evaluator.field().method == FieldMethod::cg) return {};
  std::vector<double> by_edge(topology.edge2elems.size(), 0.0), by_vertex(mesh.vertices.size(), 0.0);
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      if (topology.elem2neighbors[e][k] < e) continue;  // also skips the boundary, -1
      const int edge = topology.elem2edges[e][k];
      by_edge[edge] = jump(evaluator, e, k);
      for (const int vertex : topology.edge2vertices[edge]) by_vertex[vertex] += by_edge[edge];
    }
  std::vector<Jumps> result(mesh.num_elems());
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      result[e].edge[k] = by_edge[topology.elem2edges[e][k]];
      result[e].vertex[k] = by_vertex[mesh.elem2vertices[e][k]] / 2;
    }
  return result;
}

ZeroSearch::ZeroSearch(const field::FieldEvaluator& evaluator, std::vector<Disc> ignored, double noise)
    : evaluator_(&evaluator),
      ignored_(std::move(ignored)),
      noise_(noise),
      jumps_(edge_jumps(evaluator)),
      liftings_(evaluator),
      halves_(max_depth) {}

void ZeroSearch::search(int elem) {
  KnownCells known;
  search(elem, 0, known);
}

void ZeroSearch::search(int elem, double change, KnownCells& known) {
  budget_ = max_cells;
  change_ = change;
  before_.swap(known);
  now_.clear();
  if (!keep_known(0)) visit(element_cell(*evaluator_, elem), 0, 0);
  known.assign(now_.begin(), now_.end());
}

void ZeroSearch::follow(int elem, const std::vector<FoundZero>& before) {
  constexpr double same = 1e-6;  // in reference coordinates
  std::vector<Vec2> starts{field::centroid};
  for (const Vec2 vertex : reference_vertices) starts.push_back(0.5 * (vertex + field::centroid));
  for (const FoundZero& zero : before) starts.push_back(zero.xi);
  const std::array<Vec2, 3> cell = vertices(evaluator_->maps()[elem]);
  const double radius = distance(cell[0], cell[1]);
  const auto first = std::ssize(found_.zeros);
  for (Vec2 xi : starts) {
    if (!polish_zero([&](Vec2 at) { return liftings_.sample(elem, at); }, xi)) continue;
    if (mesh::outside_reference(xi) > inside_tol) continue;
    const auto is_here = [&](const FoundZero& zero) { return distance(zero.xi, xi) < same; };
    if (std::any_of(found_.zeros.begin() + first, found_.zeros.end(), is_here)) continue;
    const field::FieldSample s = liftings_.sample(elem, xi);
    found_.zeros.push_back({elem, xi, s.x, det(s.dv_dx) > 0 ? 1 : -1, radius, 0, cell});
  }
}

void ZeroSearch::add(const SearchResult& found) {
  found_.zeros.insert(found_.zeros.end(), found.zeros.begin(), found.zeros.end());
  found_.open_cells.insert(found_.open_cells.end(), found.open_cells.begin(), found.open_cells.end());
  found_.counts.examined += found.counts.examined;
  found_.counts.excluded += found.counts.excluded;
  found_.counts.isolated += found.counts.isolated;
  found_.counts.ignored += found.counts.ignored;
  found_.counts.greatest_depth = std::max(found_.counts.greatest_depth, found.counts.greatest_depth);
}

void ZeroSearch::renew() {
  jumps_ = edge_jumps(*evaluator_);
  liftings_.renew();
  budget_ = 1;
  found_ = {};
}

bool ZeroSearch::is_ignored() const {
  return std::any_of(ignored_.begin(), ignored_.end(), [this](const Disc& disc) {
    return distance(disc.centre, enclosure_.centre()) + enclosure_.radius() <= disc.radius;
  });
}

double ZeroSearch::margin(const Cell& cell) const {
  double greatest = 0;
  if (jumps_.empty()) return greatest;
  for (int k = 0; k < 3; ++k) {
    if (touches_edge(cell, k)) greatest = std::max(greatest, jumps_[cell.elem].edge[k]);
    if (touches_vertex(cell, k)) greatest = std::max(greatest, jumps_[cell.elem].vertex[k]);
  }
  return greatest;
}

void ZeroSearch::isolate(const Cell& cell, const Mat2& inverse_jacobian, double contraction) {
  ++found_.counts.isolated;
  const double noise = enclosure_.value_noise();
  Vec2 xi;
  if (!find_cell_zero(*evaluator_, cell, inverse_jacobian, contraction, noise, xi)) return;
  const field::FieldSample s = evaluator_->sample(cell.elem, xi);
  const double shift = noise * frobenius_norm(s.dv_dx) / std::abs(det(s.dv_dx));  // |J^-1| noise
  found_.zeros.push_back({cell.elem, xi, s.x, det(s.dv_dx) > 0 ? 1 : -1, enclosure_.radius(), shift, vertices(cell)});
}

/// A lower bound of |v| in the cell, 0 if there may be a zero; `is_decided`: the cell is not to be bisected.
double ZeroSearch::examine(const Cell& cell, int depth, bool& is_decided) {
  ++found_.counts.examined;
  found_.counts.greatest_depth = std::max(found_.counts.greatest_depth, depth);
  const double jump = margin(cell);
  enclosure_.set(cell, evaluator_->field(), liftings_.of(cell.elem), jump);
  is_decided = true;
  if (const double least = enclosure_.least_value(); least > 0) {
    ++found_.counts.excluded;
    return least;
  }
  if (is_ignored()) {
    ++found_.counts.ignored;
    return 0;
  }
  Mat2 inverse_jacobian;
  double contraction = 0;
  if (enclosure_.isolates(inverse_jacobian, contraction)) {
    isolate(cell, inverse_jacobian, contraction);
  } else if (--budget_ == 0 || depth == max_depth || enclosure_.greatest_value() < std::max(noise_, jump)) {
    found_.open_cells.push_back({cell.elem, enclosure_.centre(), enclosure_.radius(), vertices(cell)});
  } else {
    is_decided = false;
  }
  return 0;
}

/// Adds the cell at a place of before_ with its parts, if the change leaves no zero in it. Returns whether it does.
bool ZeroSearch::keep_known(std::size_t at) {
  if (at >= before_.size() || !(before_[at].least > change_)) return false;
  const std::size_t here = now_.size();
  now_.insert(now_.end(), &before_[at], &before_[at] + before_[at].num_cells);
  for (std::size_t i = here; i < now_.size(); ++i) now_[i].least -= change_, now_[i].most -= change_;
  return true;
}

/// `at`: where before_ has the cell; its size if it has not.
void ZeroSearch::visit(const Cell& cell, int depth, std::size_t at) {
  if (budget_ == 0 || keep_known(at)) return;
  const std::size_t unknown = before_.size(), here = now_.size();
  now_.emplace_back();
  const bool is_bisected = at < unknown && before_[at].num_cells > 1 && before_[at].most > change_;
  if (!is_bisected) {
    bool is_decided = false;
    now_[here].least = now_[here].most = examine(cell, depth, is_decided);
    if (is_decided) return;
  }
  auto& [first, second] = halves_[depth];
  bisect(cell, first, second);
  visit(first, depth + 1, is_bisected ? at + 1 : unknown);
  const std::size_t between = now_.size();
  visit(second, depth + 1, is_bisected ? at + 1 + before_[at + 1].num_cells : unknown);
  if (budget_ > 0)
    now_[here] = {std::min(now_[here + 1].least, now_[between].least),
                  std::max(now_[here + 1].most, now_[between].most), static_cast<int>(now_.size() - here)};
}

void require_decided(const ZeroSearch& search, const CadFace& face) {
  if (!search.is_budget_exhausted()) return;
  throw ComputeError("the guiding field vanishes to higher order, or on a whole curve, near " +
                     surface::position_text(face, search.open_cells().back().centre));
}

std::vector<FoundZero> distinct_zeros(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros) {
  const double diameter = evaluator.field().mesh.face.diameter;
  std::vector<FoundZero> result;
  for (const bool inside : {true, false})
    for (const FoundZero& zero : zeros) {
      if (is_inside(zero) != inside) continue;
      const bool known = std::any_of(result.begin(), result.end(),
                                     [&](const FoundZero& other) { return is_same(zero, other, diameter); });
      if (known) continue;
      if (inside || evaluator.locator().find(zero.x).elem >= 0) result.push_back(zero);
    }
  return result;
}

std::vector<OpenCell> cells_without_zero(const std::vector<OpenCell>& open_cells, const std::vector<FoundZero>& zeros) {
  std::vector<OpenCell> result;
  for (const OpenCell& cell : open_cells) {
    const bool is_explained = std::any_of(zeros.begin(), zeros.end(), [&](const FoundZero& zero) {
      return distance(cell.centre, zero.x) + cell.radius <= 8 * zero.shift;
    });
    if (!is_explained) result.push_back(cell);
  }
  return result;
}

}  // namespace quadrille::zeros
