#include "mesh/smooth_across.hpp"

#include <algorithm>

namespace quadrille::mesh {
namespace {

/// Solves a tridiagonal system with equal off-diagonals; `below[i]` couples i - 1 and i.
void solve_tridiagonal(std::vector<double> diagonal, const std::vector<double>& below, std::vector<double>& x) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * below[i];
    x[i] -= factor * x[i - 1];
  }
  x.back() /= diagonal.back();
  for (std::size_t i = x.size() - 1; i-- > 0;) x[i] = (x[i] - below[i + 1] * x[i + 1]) / diagonal[i];
}

class Across {
 public:
  Across(LineNodes& nodes, int node, int order, double reach)
      : nodes_(nodes), node_(node), order_(order), reach_(reach) {}

  void smooth() {
    const int count = nodes_.num_lines;
    std::vector<double> diagonal(count, 1), below(count, 0), u(count);
    u.front() = own(0), u.back() = own(count - 1);
    for (int line = 1; line + 1 < count; ++line) {
      const double before = 1 / step(line), after = 1 / step(line + 1), length = reach_ * element_length(line);
      const double hold = (step(line) + step(line + 1)) / (2 * length * length);
      diagonal[line] = before + after + hold;
      u[line] = hold * own(line);
      if (line == 1) u[line] += before * own(0);
      if (line + 2 == count) u[line] += after * own(count - 1);
      below[line] = line == 1 ? 0 : -before;
    }
    below[count - 1] = 0;
    solve_tridiagonal(std::move(diagonal), below, u);
    for (int line = 1; line + 1 < count; ++line) nodes_.parameters[index(line, node_)] = u[line];
  }

 private:
  int index(int line, int node) const { return line * nodes_.num_nodes + node; }
  double own(int line) const { return nodes_.parameters[index(line, node_)]; }
  /// Length from the line before.
  double step(int line) const {
    return distance(nodes_.positions[index(line, node_)], nodes_.positions[index(line - 1, node_)]);
  }
  /// Of the line's element with the node; the mean of both if it is between two.
  double element_length(int line) const {
    const int low = (node_ - 1) / order_ * order_,
              high = std::min(node_ / order_ * order_, nodes_.num_nodes - 1 - order_);
    const auto length = [&](int at) {
      return distance(nodes_.positions[index(line, at)], nodes_.positions[index(line, at + order_)]);
    };
    return (length(low) + length(high)) / 2;
  }

  LineNodes& nodes_;
  int node_, order_;
  double reach_;
};

}  // namespace

void smooth_across(LineNodes& nodes, int first, int last, int order, double reach) {
  for (int node = first; node < last; ++node) Across(nodes, node, order, reach).smooth();
}

}  // namespace quadrille::mesh
