#include "refine/align_chords.hpp"

#include <algorithm>
#include <cmath>

#include "growth/normal_equations.hpp"
#include "refine/divide_arcs.hpp"

namespace quadrille::refine {
namespace {

constexpr int coarse_samples = 8;
constexpr int fine_samples = 32;
constexpr int max_iterations = 12;

/// An arc in the direction of its chord, as a table at equal fractions with cubic Hermite pieces between.
struct ArcTable {
  double length = 0;
  std::vector<Vec2> positions, tangents;

  ArcTable(const curve::Chain& chain, bool backwards, int samples) : length(chain.length()) {
    for (int k = 0; k <= samples; ++k) {
      const double f = static_cast<double>(k) / samples;
      const curve::ChainPoint p = chain.at(backwards ? 1 - f : f);
      positions.push_back(p.position);
      tangents.push_back(backwards ? -p.tangent : p.tangent);
    }
  }
  int samples() const { return static_cast<int>(positions.size()) - 1; }

  curve::ChainPoint at(double f) const {
    const double x = f * samples();
    const int k = std::clamp(static_cast<int>(x), 0, samples() - 1);
    const double t = x - k, r = 1 - t, step = length / samples();
    const Vec2 position = r * r * (1 + 2 * t) * positions[k] + t * t * (1 + 2 * r) * positions[k + 1] +
                          r * t * step * (r * tangents[k] - t * tangents[k + 1]);
    return {position, r * tangents[k] + t * tangents[k + 1], 0, 0};
  }
};

using Fractions = std::vector<std::vector<double>>;  ///< by arc of the chord and sample

Fractions equal_fractions(std::size_t num_arcs, int samples) {
  std::vector<double> equal;
  for (int k = 0; k <= samples; ++k) equal.push_back(static_cast<double>(k) / samples);
  return Fractions(num_arcs, equal);
}

/// The line across the chord from arc a to arc b at one parameter.
struct CrossLine {
  double along = 0;    ///< d
  double width = 0;    ///< w
  double slope_a = 0;  ///< derivative of d by a's fraction, with the chord's direction frozen, and by b's
  double slope_b = 0;
};

CrossLine cross_line(const ArcTable& a, double fa, const ArcTable& b, double fb) {
  const curve::ChainPoint p = a.at(fa), q = b.at(fb);
  const Vec2 sum = p.tangent + q.tangent, step = q.position - p.position;
  const double size = norm(sum);
  const Vec2 direction = size > 0 ? sum / size : p.tangent;
  return {dot(step, direction), norm(step), -a.length * dot(p.tangent, direction),
          b.length * dot(q.tangent, direction)};
}

std::vector<CrossLine> cross_lines(const std::vector<ArcTable>& tables, const Fractions& g, int a, int b) {
  std::vector<CrossLine> lines;
  for (std::size_t k = 0; k < g[a].size(); ++k) lines.push_back(cross_line(tables[a], g[a][k], tables[b], g[b][k]));
  return lines;
}

/// (d - d*) / w at sample k.
double misalignment(const std::vector<CrossLine>& lines, std::size_t k) {
  const double u = static_cast<double>(k) / static_cast<double>(lines.size() - 1);
  const double linear = (1 - u) * lines.front().along + u * lines.back().along;
  return (lines[k].along - linear) / lines[k].width;
}

class Aligner {
 public:
  Aligner(const sizing::MeasuredLayout& measured, const mesh::Chord& chord, const AlignOptions& options)
      : measured_(measured), chord_(chord), options_(options) {}

  /// Whether equal fractions skew the chord's lines.
  bool is_misaligned() {
    tabulate(coarse_samples);
    const Fractions equal = equal_fractions(chord_.arcs.size(), coarse_samples);
    return worst(equal) > options_.tolerance;
  }

  /// Gauss-Newton from equal fractions; steps are shortened to keep the least slope.
  Fractions align() {
    tabulate(fine_samples);
    Fractions g = equal_fractions(chord_.arcs.size(), fine_samples);
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      const Eigen::VectorXd step = newton_step(g);
      const double fraction = admissible_fraction(g, step);
      move(g, step, fraction);
      if (fraction * step.lpNorm<Eigen::Infinity>() < 1e-4) break;
    }
    return worst(g) < worst(equal_fractions(chord_.arcs.size(), fine_samples)) ? g : Fractions();
  }

 private:
  void tabulate(int samples) {
    tables_.clear();
    for (std::size_t i = 0; i < chord_.arcs.size(); ++i)
      tables_.emplace_back(measured_.chain(chord_.arcs[i]), chord_.backwards[i], samples);
  }

  double worst(const Fractions& g) const {
    double result = 0;
    for (const auto& [a, b] : chord_.pairs) {
      const std::vector<CrossLine> lines = cross_lines(tables_, g, a, b);
      for (std::size_t k = 1; k + 1 < lines.size(); ++k)
        if (lines[k].width > 0) result = std::max(result, std::abs(misalignment(lines, k)));
    }
    return result;
  }

  /// Unknown number of arc i's fraction at sample k; -1 for the fixed ends.
  int unknown(int i, int k) const {
    return k <= 0 || k >= fine_samples ? -1 : (k - 1) * static_cast<int>(chord_.arcs.size()) + i;
  }

  Eigen::VectorXd newton_step(const Fractions& g) const {
    growth::NormalEquations equations((fine_samples - 1) * static_cast<int>(chord_.arcs.size()));
    std::vector<double> width(chord_.arcs.size(), 0), pairs(chord_.arcs.size(), 0);
    for (const auto& [a, b] : chord_.pairs) {
      const std::vector<CrossLine> lines = cross_lines(tables_, g, a, b);
      for (int k = 1; k < fine_samples; ++k) {
        const CrossLine& r = lines[k];
        if (r.width <= 0) continue;
        equations.add(1, misalignment(lines, k),
                      {{unknown(a, k), r.slope_a / r.width}, {unknown(b, k), r.slope_b / r.width}});
        for (const int i : {a, b}) width[i] += r.width, pairs[i] += 1;
      }
    }
    for (int i = 0; i < static_cast<int>(chord_.arcs.size()); ++i)
      add_stiffness(g[i], i, pairs[i] > 0 ? width[i] / pairs[i] : tables_[i].length, equations);
    return equations.step();
  }

  void add_stiffness(const std::vector<double>& g, int i, double width, growth::NormalEquations& equations) const {
    const double factor = options_.stiffness * width / tables_[i].length * fine_samples * fine_samples;
    for (int k = 1; k < fine_samples; ++k)
      equations.add(1, factor * (g[k - 1] - 2 * g[k] + g[k + 1]),
                    {{unknown(i, k - 1), factor}, {unknown(i, k), -2 * factor}, {unknown(i, k + 1), factor}});
  }

  double step_at(const Eigen::VectorXd& step, int i, int k) const {
    const int u = unknown(i, k);
    return u < 0 ? 0 : step[u];
  }

  /// The greatest fraction of the step, at most 1, with which no slope falls below its least value.
  double admissible_fraction(const Fractions& g, const Eigen::VectorXd& step) const {
    const double least = options_.least_slope / fine_samples;
    double fraction = 1;
    for (int i = 0; i < static_cast<int>(g.size()); ++i)
      for (int k = 1; k <= fine_samples; ++k) {
        const double rise = g[i][k] - g[i][k - 1], change = step_at(step, i, k) - step_at(step, i, k - 1);
        if (rise + change < least) fraction = std::min(fraction, std::max(0.0, (rise - least) / -change));
      }
    return fraction;
  }

  void move(Fractions& g, const Eigen::VectorXd& step, double fraction) const {
    for (int i = 0; i < static_cast<int>(g.size()); ++i)
      for (int k = 1; k < fine_samples; ++k) g[i][k] += fraction * step_at(step, i, k);
  }

  const sizing::MeasuredLayout& measured_;
  const mesh::Chord& chord_;
  const AlignOptions& options_;
  std::vector<ArcTable> tables_;
};

}  // namespace

std::vector<sizing::ArcParameter> align_chords(const sizing::MeasuredLayout& measured, const AlignOptions& options) {
  std::vector<std::vector<double>> by_arc(measured.num_arcs());
  for (const mesh::Chord& chord : measured.chords()) {
    Aligner aligner(measured, chord, options);
    if (!aligner.is_misaligned()) continue;
    const Fractions g = aligner.align();
    for (std::size_t i = 0; i < g.size(); ++i) {
      std::vector<double> fractions = g[i];
      if (chord.backwards[i]) sizing::reverse_fractions(fractions);
      by_arc[chord.arcs[i]] = std::move(fractions);
    }
  }
  for (const PeriodicArcs& arcs : measured.periodic_arcs())
    match_fractions(arcs, by_arc[arcs[0].arc], by_arc[arcs[1].arc]);
  std::vector<sizing::ArcParameter> parameters(measured.num_arcs());
  for (std::size_t arc = 0; arc < by_arc.size(); ++arc)
    if (!by_arc[arc].empty()) parameters[arc] = sizing::ArcParameter(std::move(by_arc[arc]));
  return parameters;
}

}  // namespace quadrille::refine
