#include "trace/finish_lines.hpp"

#include <fmt/format.h>

#include <string>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/fit_line.hpp"

namespace quadrille::trace {
namespace {

[[noreturn]] void fail_endless(const CadFace& face, const Streamline& line) {
  const Vec2 from = line.launch.origin + face.origin, to = line.end_position + face.origin;
  const size_t count = line.steps.size();
  const std::string steps = count < max_stream_steps ? "" : fmt::format(" and {} steps, the most allowed", count);
  throw ComputeError(fmt::format(
      "the separatrix from ({:.6g}, {:.6g}) at {:.2f} degrees has reached neither boundary "
      "nor node after {:.3g} diameters{}, near ({:.6g}, {:.6g})",
      from.x, from.y, degrees(wrap_pi(line.launch.angle)), line.length() / face.diameter, steps, to.x, to.y));
}

}  // namespace

LineFinisher::LineFinisher(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines, double tol)
    : evaluator_(evaluator), lines_(lines), tol_(tol), traced_(lines.size()) {}

void LineFinisher::finish(const MergePlan& plan, const std::vector<int>& chosen) {
  std::vector<int> merge_of_line(lines_.size(), -1);
  for (const int c : chosen) merge_of_line[plan.candidate(c).a] = merge_of_line[plan.candidate(c).b] = c;
  finished_.clear(), splines_.clear(), merge_of_.clear();
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
    const int c = merge_of_line[i];
    if (c >= 0 && plan.candidate(c).b == i) continue;
    finished_.push_back(c >= 0 ? merged(plan, c) : traced(i));
    splines_.push_back(finished_.back().spline);
    merge_of_.push_back(c);
  }
}

graph::FinishedLine LineFinisher::merged(const MergePlan& plan, int candidate) {
  if (merged_.size() <= static_cast<size_t>(candidate)) merged_.resize(candidate + 1);
  const MergeCandidate& m = plan.candidate(candidate);
  const Streamline &a = lines_[m.a], &b = lines_[m.b];
  if (!merged_[candidate]) merged_[candidate] = curve::fit_line(merged_curve(evaluator_, a, b, m), m.length(), tol_);
  return {{a.launch.node, -1, 0}, {b.launch.node, -1, 0}, *merged_[candidate], "merged"};
}

graph::FinishedLine LineFinisher::traced(int line) {
  const Streamline& l = lines_[line];
  if (l.end == Streamline::End::length) fail_endless(evaluator_.field().mesh.face, l);
  if (!traced_[line]) {
    const auto along = [&](double s, Vec2& direction) { return l.at(evaluator_, s, direction); };
    traced_[line] = curve::fit_line(along, l.length(), tol_);
  }
  const bool is_cut = l.launch.node < 0;
  const graph::LineEnd start =
      is_cut ? graph::LineEnd{-1, l.launch.curve, l.launch.t} : graph::LineEnd{l.launch.node, -1, 0};
  return {start, {l.end_node, l.curve, l.t}, *traced_[line], is_cut ? "cut" : "traced"};
}

}  // namespace quadrille::trace
