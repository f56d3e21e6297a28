#include "zeros/undecided_zeros.hpp"

#include <algorithm>
#include <limits>

#include "field/error_estimate.hpp"

namespace quadrille::zeros {
namespace {

/// A cell in which |v| <= error was not excluded.
struct RegionCell {
  Vec2 centre;
  double radius = 0;
  bool is_on_boundary = false;
};

bool overlap(const RegionCell& a, const RegionCell& b) { return distance(a.centre, b.centre) <= a.radius + b.radius; }

/// The elements about a zero that contain cells with |v| <= error, without a gap between them.
class RegionFlood {
 public:
  RegionFlood(const field::FieldEvaluator& evaluator, double error, double least_radius, std::size_t most_cells)
      : evaluator_(evaluator), error_(error), least_radius_(least_radius), most_cells_(most_cells) {}

  /// All cells found from this element on; none if they are too many.
  std::vector<RegionCell> from(int elem) {
    std::vector<bool> is_reached(evaluator_.field().mesh.num_elems(), false);
    std::vector<int> pending{elem};
    is_reached[elem] = true;
    while (!pending.empty()) {
      const int e = pending.back();
      pending.pop_back();
      const std::size_t before = cells_.size();
      visit(element_cell(evaluator_, e));
      if (cells_.size() > most_cells_) return {};
      if (cells_.size() == before) continue;
      for (const int next : evaluator_.topology().elem2neighbors[e])
        if (next >= 0 && !is_reached[next]) is_reached[next] = true, pending.push_back(next);
    }
    return std::move(cells_);
  }

 private:
  bool is_on_boundary(const Cell& cell) const {
    for (int k = 0; k < 3; ++k)
      if (evaluator_.topology().elem2neighbors[cell.elem][k] < 0 && touches_edge(cell, k)) return true;
    return false;
  }

  void visit(const Cell& cell) {
    if (cells_.size() > most_cells_) return;
    enclosure_.set(cell, evaluator_.field().liftings, error_);
    if (enclosure_.excludes_zero()) return;
    if (enclosure_.radius() <= least_radius_) {
      cells_.push_back({enclosure_.centre(), enclosure_.radius(), is_on_boundary(cell)});
      return;
    }
    Cell first, second;
    bisect(cell, first, second);
    visit(first);
    visit(second);
  }

  const field::FieldEvaluator& evaluator_;
  double error_, least_radius_;
  std::size_t most_cells_;
  Enclosure enclosure_;
  std::vector<RegionCell> cells_;
};

/// The cells that overlaps connect with the point x.
std::vector<RegionCell> connected_part(std::vector<RegionCell> cells, Vec2 x) {
  std::vector<RegionCell> part{{x, 0, false}};
  for (std::size_t i = 0; i < part.size(); ++i) {
    const RegionCell at = part[i];
    const auto rest =
        std::stable_partition(cells.begin(), cells.end(), [&](const RegionCell& c) { return !overlap(at, c); });
    part.insert(part.end(), rest, cells.end());
    cells.erase(rest, cells.end());
  }
  return part;
}

std::vector<int> zeros_in(const std::vector<RegionCell>& region, const std::vector<FoundZero>& zeros) {
  std::vector<int> result;
  for (std::size_t i = 0; i < zeros.size(); ++i)
    if (std::any_of(region.begin(), region.end(),
                    [&](const RegionCell& c) { return distance(c.centre, zeros[i].x) <= c.radius; }))
      result.push_back(static_cast<int>(i));
  return result;
}

double distance_to_others(const std::vector<FoundZero>& zeros, std::size_t i) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < zeros.size(); ++j)
    if (j != i) least = std::min(least, distance(zeros[i].x, zeros[j].x));
  return least;
}

}  // namespace

double undecided_below(const Field& field, const RegionLimits& limits) {
  double greatest = 0;
  for (const double error : field.elem_error) greatest = std::max(greatest, error);
  return std::min(greatest, limits.greatest_error);
}

std::vector<std::vector<int>> undecided_zeros(const field::FieldEvaluator& evaluator,
                                              const std::vector<FoundZero>& zeros, double error,
                                              const RegionLimits& limits) {
  std::vector<std::vector<int>> groups;
  if (zeros.size() < 2 || error <= 0) return groups;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const double gap = distance_to_others(zeros, i);
    const Mat2 jacobian = evaluator.sample(zeros[i].elem, zeros[i].xi).dv_dx;
    if (field::position_error(jacobian, limits.soft * error) < gap) continue;
    RegionFlood flood(evaluator, error, limits.resolution * gap, limits.most_cells);
    const std::vector<RegionCell> region = connected_part(flood.from(zeros[i].elem), zeros[i].x);
    if (std::any_of(region.begin(), region.end(), [](const RegionCell& c) { return c.is_on_boundary; })) continue;
    std::vector<int> group = zeros_in(region, zeros);
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace quadrille::zeros
