#include "layers/tied_lines.hpp"

#include <algorithm>
#include <utility>

#include "layers/layer_rules.hpp"

namespace quadrille::layers {
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

constexpr double least_step = 1e-3;  // of the distance of nodes

class Across {
 public:
  Across(const LineNodes& nodes, const std::vector<double>& values, int node, int order, double reach)
      : nodes_(nodes), values_(values), node_(node), order_(order), reach_(reach) {}

  /// The values at node `node` of all lines.
  std::vector<double> smoothed() const {
    const int count = nodes_.num_lines;
    std::vector<double> diagonal(count, 1), below(count, 0), u(count);
    u.front() = value(0), u.back() = value(count - 1);
    for (int line = 1; line + 1 < count; ++line) {
      const double before = 1 / step(line), after = 1 / step(line + 1), length = reach_ * element_length(line);
      const double hold = (step(line) + step(line + 1)) / (2 * length * length);
      diagonal[line] = before + after + hold;
      u[line] = hold * value(line);
      if (line == 1) u[line] += before * value(0);
      if (line + 2 == count) u[line] += after * value(count - 1);
      below[line] = line == 1 ? 0 : -before;
    }
    below[count - 1] = 0;
    solve_tridiagonal(std::move(diagonal), below, u);
    return u;
  }

 private:
  int index(int line, int node) const { return line * nodes_.num_nodes + node; }
  double value(int line) const { return values_[index(line, node_)]; }
  double own(int line) const { return nodes_.parameters[index(line, node_)]; }
  Vec2 position(int line, int node) const { return nodes_.positions[index(line, node)]; }
  /// Of the line at a parameter near that of its node.
  Vec2 position_at(int line, double u) const {
    const int before = index(line, node_ - 1), after = index(line, node_ + 1);
    const Vec2 slope =
        (nodes_.positions[after] - nodes_.positions[before]) / (nodes_.parameters[after] - nodes_.parameters[before]);
    return position(line, node_) + (u - own(line)) * slope;
  }
  /// Length from the line before, at one parameter: where their divisions differ, their nodes are further apart than
  /// they are.
  double step(int line) const {
    const double u = (own(line - 1) + own(line)) / 2;
    const double length = distance(position_at(line - 1, u), position_at(line, u));
    return std::max(length, least_step * distance(position(line - 1, node_), position(line, node_)));
  }
  /// Of the line's element with the node; the mean of both if it is between two.
  double element_length(int line) const {
    const int low = (node_ - 1) / order_ * order_,
              high = std::min(node_ / order_ * order_, nodes_.num_nodes - 1 - order_);
    const auto length = [&](int at) { return distance(position(line, at), position(line, at + order_)); };
    return (length(low) + length(high)) / 2;
  }

  const LineNodes& nodes_;
  const std::vector<double>& values_;
  int node_, order_;
  double reach_;
};

}  // namespace

void smooth_across(const LineNodes& nodes, int first, int last, int order, double reach, std::vector<double>& values) {
  for (int node = first; node < last; ++node) {
    const std::vector<double> u = Across(nodes, values, node, order, reach).smoothed();
    for (int line = 0; line < nodes.num_lines; ++line) values[line * nodes.num_nodes + node] = u[line];
  }
}

TiedLines::TiedLines(const LineFamily& family, const std::vector<NormalLine>& lines, const std::vector<double>& first,
                     const std::vector<double>& last, std::vector<std::vector<double>>& parameters)
    : family_(family), lines_(lines), parameters_(parameters), num_nodes_(static_cast<int>(first.size())) {
  parameters.front() = first, parameters.back() = last;
  low_ = family.low_node(), high_ = family.high_node(num_nodes_);
}

void TiedLines::tie() {
  const LineNodes all = nodes();
  std::vector<double> tied = all.parameters;
  smooth(all, tied);
  set(tied);
}

void TiedLines::scale(const std::vector<std::vector<double>>& factors) {
  const LineNodes all = nodes();
  std::vector<double> scaled = all.parameters;
  for (std::size_t line = 0; line < factors.size(); ++line)
    if (!factors[line].empty()) scale_line(factors[line], &scaled[line * num_nodes_ + low_]);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] -= all.parameters[i];
  smooth(all, scaled);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] += all.parameters[i];
  set(scaled);
}

void TiedLines::smooth(const LineNodes& nodes, std::vector<double>& values) const {
  smooth_across(nodes, low_ + 1, high_, family_.order, layer_constants.reach_across, values);
}

LineNodes TiedLines::nodes() const {
  LineNodes all{static_cast<int>(lines_.size()), num_nodes_, {}, {}};
  for (std::size_t line = 0; line < lines_.size(); ++line)
    for (const double u : parameters_[line]) {
      const double bottom = parameters_[line][low_], top = parameters_[line][high_];
      all.parameters.push_back((u - bottom) / (top - bottom));
      all.positions.push_back(lines_[line](u));
    }
  return all;
}

void TiedLines::set(const std::vector<double>& relative) {
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const double bottom = parameters_[line][low_], top = parameters_[line][high_];
    for (int k = low_ + 1; k < high_; ++k)
      parameters_[line][k] = bottom + relative[line * num_nodes_ + k] * (top - bottom);
  }
}

/// `nodes`: from the end of the layers, relative.
void TiedLines::scale_line(const std::vector<double>& factors, double* nodes) const {
  const int order = family_.order, count = static_cast<int>(factors.size());
  const std::vector<double> given(nodes, nodes + count * order + 1);
  double total = 0;
  for (int k = 0; k < count; ++k) total += factors[k] * (given[(k + 1) * order] - given[k * order]);
  for (int k = 0; k < count; ++k)
    for (int i = 1; i <= order; ++i)
      nodes[k * order + i] = nodes[k * order] + factors[k] / total * (given[k * order + i] - given[k * order]);
}

}  // namespace quadrille::layers
