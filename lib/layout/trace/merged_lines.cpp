#include "trace/merged_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "base/angle.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "graph/arc_pieces.hpp"
#include "surface/positions.hpp"

namespace quadrille::trace {
namespace {

// Picks among the candidates first ... last - 1, whose fronts meet at equal lengths.
// `num_competing`: 0 for every line, before and afterwards.
void choose_tied(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed, size_t first,
                 size_t last, std::vector<bool>& is_taken, std::vector<int>& num_competing, std::vector<int>& chosen) {
  std::vector<int> free;
  for (size_t i = first; i < last; ++i) {
    const MergeCandidate& c = candidates[i];
    if (!allowed[i] || is_taken[c.a] || is_taken[c.b]) continue;
    free.push_back(static_cast<int>(i));
    ++num_competing[c.a], ++num_competing[c.b];
  }
  for (const int i : free) {
    const MergeCandidate& c = candidates[i];
    if (num_competing[c.a] > 1 || num_competing[c.b] > 1) continue;
    is_taken[c.a] = is_taken[c.b] = true;
    chosen.push_back(i);
  }
  for (const int i : free) num_competing[candidates[i].a] = num_competing[candidates[i].b] = 0;
}

// A pair that is not known yet has a line longer than its reach. Lengths of a pair are so nearly equal that their mean
// is then above this fraction of the reach: pairs below are chosen before it in any case.
constexpr double settled_fraction = 1 - merge_limits.inequality / 2;

// The length is part of the key since a line may be continued later; its sign distinguishes a join from a merged pair.
graph::CurveKey key_of(int line, double length) { return {static_cast<double>(line), -1.0, length}; }
graph::CurveKey key_of(const MergeCandidate& c) {
  return {static_cast<double>(c.a), static_cast<double>(c.b), c.is_join ? -c.length() : c.length()};
}

constexpr std::size_t many_lines = 500;

[[noreturn]] void fail_endless(const CadFace& face, const Streamline& line) {
  const size_t count = line.steps.size();
  const std::string steps = count < max_stream_steps ? "" : fmt::format(" and {} steps, the most allowed", count);
  throw ComputeError(
      fmt::format("the separatrix from {} at {:.2f} degrees has reached neither boundary "
                  "nor node after {:.3g} diameters{}, near {}",
                  surface::position_text(face, line.launch.origin), degrees(wrap_pi(line.launch.angle)),
                  line.length() / face.diameter, steps, surface::position_text(face, line.end_position)));
}

}  // namespace

std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& is_taken) {
  std::vector<int> chosen, num_competing(is_taken.size(), 0);
  for (size_t first = 0, last = 0; first < candidates.size(); first = last) {
    const double same = candidates[first].delayed_meeting() * (1 + tolerance::tied);
    while (last < candidates.size() && candidates[last].delayed_meeting() <= same) ++last;
    choose_tied(candidates, allowed, first, last, is_taken, num_competing, chosen);
  }
  return chosen;
}

MergePlan::MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                     const std::vector<Vec2>& nodes, const MergeOptions& options, std::vector<double> reaches)
    : evaluator_(evaluator), lines_(lines), nodes_(nodes), options_(options), reaches_(std::move(reaches)) {
  renew();
}

void MergePlan::add_candidates(const MergeOptions& options) {
  for (const MergeCandidate& c : merge_candidates(evaluator_, lines_, nodes_, options)) candidates_.push_back(c);
  is_rejected_.resize(candidates_.size(), false);
}

// Ascending.
std::vector<int> MergePlan::endless_without_partner(const std::vector<int>& chosen) const {
  const std::vector<int> merge_of = merge_of_lines(chosen);
  std::vector<int> endless;
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
    if (lines_[i].is_endless() && merge_of[i] < 0) endless.push_back(i);
  return endless;
}

bool MergePlan::is_unfinished(int line) const {
  const Streamline& l = lines_[line];
  return !reaches_.empty() && reaches_[line] > 0 && l.is_endless() && !l.is_limit_cycle && !l.is_stuck();
}

void MergePlan::find_unsettled(const std::vector<int>& chosen) {
  const std::vector<int> merge_of = merge_of_lines(chosen);
  unsettled_.clear();
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
    if (is_unfinished(i) &&
        (merge_of[i] < 0 || candidates_[merge_of[i]].delayed_meeting() > settled_fraction * reaches_[i]))
      unsettled_.insert(i);
}

std::vector<int> MergePlan::choose_by_rules() const {
  std::vector<bool> is_taken(lines_.size(), false), allowed(candidates_.size(), false);
  for (size_t i = 0; i < num_regular_; ++i) allowed[i] = !is_rejected_[i];
  return choose_merges(candidates_, allowed, is_taken);
}

std::optional<std::vector<int>> MergePlan::choose_once() {
  std::vector<int> chosen = choose_by_rules();
  find_unsettled(chosen);
  if (!unsettled_.empty()) return std::nullopt;
  const std::vector<int> endless = endless_without_partner(chosen);
  if (!endless.empty()) add_last_resorts(endless, chosen);
  return chosen;
}

void MergePlan::add_last_resorts(const std::vector<int>& endless, std::vector<int>& chosen) {
  if (candidates_.size() == num_regular_) add_candidates({merge_limits.endless_angle, 0, true});
  const auto needs_partner = [&](int line) { return std::binary_search(endless.begin(), endless.end(), line); };
  std::vector<bool> allowed(candidates_.size(), false), is_taken(lines_.size(), false);
  for (const int c : chosen) is_taken[candidates_[c].a] = is_taken[candidates_[c].b] = true;
  for (size_t i = num_regular_; i < candidates_.size(); ++i)
    allowed[i] = !is_rejected_[i] && (needs_partner(candidates_[i].a) || needs_partner(candidates_[i].b));
  for (const int c : choose_merges(candidates_, allowed, is_taken)) chosen.push_back(c);
}

// Rejects the merge that occupies the first partner of an endless line, if both merged lines end. True if it was not
// rejected before. If it is not known whether they end, they are unsettled.
bool MergePlan::reject_for(int endless, const std::vector<int>& merge_of) {
  for (size_t i = 0; i < candidates_.size(); ++i) {
    const MergeCandidate& pair = candidates_[i];
    if (is_rejected_[i] || (pair.a != endless && pair.b != endless)) continue;
    const int other = merge_of[pair.a == endless ? pair.b : pair.a];
    if (other < 0) continue;
    const std::array merged{candidates_[other].a, candidates_[other].b};
    const auto is_endless = [this](int line) { return lines_[line].is_endless() && !is_unfinished(line); };
    if (std::any_of(merged.begin(), merged.end(), is_endless)) continue;
    for (const int line : merged)
      if (is_unfinished(line)) unsettled_.insert(line);
    if (!unsettled_.empty()) return false;
    const bool is_new = !is_rejected_[other];
    is_rejected_[other] = true;
    return is_new;
  }
  return false;
}

std::optional<std::vector<int>> MergePlan::choose() {
  std::optional<std::vector<int>> chosen = choose_once();
  // Every round rejects a candidate permanently, so the loop ends.
  while (chosen) {
    const std::vector<int> merge_of = merge_of_lines(*chosen);
    bool any = false;
    for (const int line : endless_without_partner(*chosen)) any = reject_for(line, merge_of) || any;
    if (!unsettled_.empty()) return std::nullopt;
    if (!any) break;
    chosen = choose_once();
  }
  return chosen;
}

// The two lengths of a pair differ so little that all pairs of such a line are known.
std::optional<int> MergePlan::stuck_without_partner() const {
  double reach = std::numeric_limits<double>::infinity();
  for (const int line : unsettled_) reach = std::min(reach, reaches_[line]);
  for (const int line : endless_without_partner(choose_by_rules()))
    if (lines_[line].is_stuck() && 2 * lines_[line].length() < reach) return line;
  return std::nullopt;
}

bool MergePlan::reject_worst(const std::vector<int>& candidates, double least_deviation) {
  double worst = -1;
  for (const int c : candidates) worst = std::max(worst, candidates_[c].deviation);
  if (worst < least_deviation) return false;
  for (const int c : candidates)
    if (candidates_[c].deviation > worst - tolerance::same_angle) is_rejected_[c] = true;
  return true;
}

void MergePlan::reject_whole_pairs() { reject(rejected_pairs()); }

void MergePlan::renew() {
  const LinePairs pairs = rejected_pairs();
  candidates_.clear();
  is_rejected_.clear();
  add_candidates(options_);
  num_regular_ = candidates_.size();
  reject(pairs);
}

void MergePlan::reject(const LinePairs& pairs) {
  for (size_t i = 0; i < candidates_.size(); ++i)
    if (pairs.count({candidates_[i].a, candidates_[i].b}) > 0) is_rejected_[i] = true;
}

MergePlan::LinePairs MergePlan::rejected_pairs() const {
  LinePairs pairs;
  for (size_t i = 0; i < candidates_.size(); ++i)
    if (is_rejected_[i]) pairs.insert({candidates_[i].a, candidates_[i].b});
  return pairs;
}

std::vector<int> MergePlan::merge_of_lines(const std::vector<int>& chosen) const {
  std::vector<int> merge_of(lines_.size(), -1);
  for (const int c : chosen) merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
  return merge_of;
}

bool is_of_one_family(const graph::Crossing& crossing) { return crossing.angle < pi / 4; }

void require_family_order(const std::vector<graph::Crossing>& crossings, const std::vector<bool>& is_exempt,
                          const CadFace& face) {
  for (const graph::Crossing& c : crossings) {
    if (!is_of_one_family(c) || c.angle < same_direction || is_exempt[c.a] || is_exempt[c.b]) continue;
    throw FamilyOrderError(
        fmt::format("two separatrices of one family cross at {}, at {:.3g} degrees: --tolerance is too "
                    "coarse for the field there",
                    surface::position_text(face, c.position), degrees(c.angle)));
  }
}

MergedLine LineFitter::single(int line) {
  const Streamline& l = lines_[line];
  const auto along = [&](double s, Vec2& direction) { return l.at(evaluator_, s, direction); };
  const graph::CurveKey key = key_of(line, l.length());
  const bool is_cut = l.launch.start.node < 0;
  const Nurbs& spline = fitted(key, along, l.length());
  return {{l.launch.start, l.reached, spline, is_cut ? LineKind::cut : LineKind::traced}, l.length(), -1, line, key};
}

MergedLine LineFitter::pair(const MergeCandidate& candidate, int merge) {
  const Streamline &a = lines_[candidate.a], &b = lines_[candidate.b];
  const graph::CurveKey key = key_of(candidate);
  const Nurbs& spline = fitted(key, merged_curve(evaluator_, a, b, candidate), candidate.length());
  return {{a.launch.start, b.launch.start, spline, LineKind::merged}, candidate.length(), merge, candidate.a, key};
}

const Nurbs& LineFitter::fitted(const graph::CurveKey& key, const curve::CurveFunction& curve, double length) {
  const auto known = fitted_.find(key);
  if (known != fitted_.end()) return known->second;
  return fitted_[key] = curve::fit_line(curve, length, graph::relative_fit_tol * evaluator_.field().mesh.face.diameter);
}

MergedLines::MergedLines(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                         const std::vector<Vec2>& nodes, double merge_angle, double merge_distance, LineEnds ends,
                         const LineBounds& bounds)
    : evaluator_(evaluator),
      lines_(lines),
      ends_(ends),
      max_crossings_(bounds.max_crossings),
      plan_(evaluator, lines, nodes, {std::max(merge_angle, same_line_angle), merge_distance}, bounds.reaches),
      fitter_(evaluator, lines) {}

bool MergedLines::merge(Progress* progress) {
  do {
    if (ends_ == LineEnds::optional) {
      arrangement_.chosen = plan_.choose_by_rules();
    } else {
      const std::optional<std::vector<int>> chosen = plan_.choose();
      if (!chosen) {
        if (const auto stuck = plan_.stuck_without_partner()) fail_endless(face(), lines_[*stuck]);
        return false;
      }
      arrangement_.chosen = *chosen;
    }
    arrange(progress);
  } while (reject_crossing_merges());
  require_family_order();
  return true;
}

bool MergedLines::reject_worst(const std::vector<int>& merges, double least_deviation) {
  if (!plan_.reject_worst(merges, least_deviation)) return false;
  // Lines that stop at others may be continued later: no other pass of such a pair may be merged then.
  if (ends_ == LineEnds::optional) plan_.reject_whole_pairs();
  return true;
}

// The worst of all; among many lines, the worse one at every crossing, as these are far from each other.
bool MergedLines::reject_crossing_merges() {
  std::vector<int> all;
  bool any = false;
  for (const graph::Crossing& c : arrangement_.inner_crossings) {
    if (!is_of_one_family(c)) continue;
    std::vector<int> merges;
    for (const int i : {c.a, c.b})
      if (arrangement_.lines[i].merge >= 0) merges.push_back(arrangement_.lines[i].merge);
    all.insert(all.end(), merges.begin(), merges.end());
    if (lines_.size() > many_lines) any = plan_.reject_worst(merges, 0) || any;
  }
  if (lines_.size() <= many_lines) return reject_worst(all, 0);
  if (any && ends_ == LineEnds::optional) plan_.reject_whole_pairs();
  return any;
}

void MergedLines::arrange(Progress* progress) {
  const Progress::Part fitted(progress, "fitted lines", std::ssize(lines_));
  const std::vector<int> merge_of = plan_.merge_of_lines(arrangement_.chosen);
  for (int i = 0; i < static_cast<int>(lines_.size()) && ends_ == LineEnds::required; ++i)
    if (merge_of[i] < 0 && lines_[i].is_endless()) fail_endless(face(), lines_[i]);
  arrangement_.lines.clear();
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i, fitted.advance()) {
    const int c = merge_of[i];
    if (c >= 0 && plan_.candidate(c).b == i) continue;
    arrangement_.lines.push_back(c >= 0 ? fitter_.pair(plan_.candidate(c), c) : fitter_.single(i));
  }
  std::vector<graph::CurveKey> keys;
  std::vector<Nurbs> splines;
  for (const MergedLine& m : arrangement_.lines) {
    keys.push_back(m.key);
    splines.push_back(m.line.spline);
  }
  arrangement_.crossings = cache_.find(keys, splines, tolerance::round_off * face().diameter,
                                       {.max_crossings = max_crossings_, .face = &face(), .sought = {}});
  arrangement_.inner_crossings.clear();
  for (const graph::Crossing& c : arrangement_.crossings)
    if (!is_common_end(c)) arrangement_.inner_crossings.push_back(c);
}

bool MergedLines::is_common_end(const graph::Crossing& crossing) const {
  const double near = 2 * (tolerance::round_off * face().diameter);
  const auto ends_there = [&](int i) {
    const Nurbs& spline = arrangement_.lines[i].line.spline;
    return distance(spline.poles.front(), crossing.position) <= near ||
           distance(spline.poles.back(), crossing.position) <= near;
  };
  return ends_there(crossing.a) && ends_there(crossing.b);
}

void MergedLines::require_family_order() const {
  std::vector<bool> is_exempt;  // cuts that stop at each other may start on two sides and be one line
  for (const MergedLine& m : arrangement_.lines)
    is_exempt.push_back(m.merge >= 0 || (ends_ == LineEnds::optional && m.line.kind == LineKind::cut));
  trace::require_family_order(arrangement_.inner_crossings, is_exempt, face());
}

double MergedLines::largest_deviation() const {
  double deviation = 0;
  for (const int c : arrangement_.chosen) deviation = std::max(deviation, plan_.candidate(c).deviation);
  return deviation;
}

}  // namespace quadrille::trace
