#include "layers/tied_lines.hpp"

#include "layers/layer_rules.hpp"

namespace quadrille::layers {

TiedLines::TiedLines(const LineFamily& family, const std::vector<NormalLine>& lines, const std::vector<double>& first,
                     const std::vector<double>& last, std::vector<std::vector<double>>& parameters)
    : family_(family), lines_(lines), parameters_(parameters), num_nodes_(static_cast<int>(first.size())) {
  parameters.front() = first, parameters.back() = last;
  low_ = family.low_node(), high_ = family.high_node(num_nodes_);
}

void TiedLines::tie() {
  LineNodes all = nodes();
  smooth_across(all, low_ + 1, high_, family_.order, layer_constants.reach_across);
  set(all.parameters);
}

void TiedLines::scale(const std::vector<std::vector<double>>& factors) {
  const LineNodes all = nodes();
  std::vector<double> scaled = all.parameters;
  for (std::size_t line = 0; line < factors.size(); ++line)
    if (!factors[line].empty()) scale_line(factors[line], &scaled[line * num_nodes_ + low_]);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] -= all.parameters[i];
  smooth_across(all, low_ + 1, high_, family_.order, layer_constants.reach_across, scaled);
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] += all.parameters[i];
  set(scaled);
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
