#include "simplify/simplify.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "graph/arc_pieces.hpp"
#include "simplify/block_quality.hpp"
#include "simplify/chord_groups.hpp"

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::Subdivision;

struct Precision {
  double fit_tol;  // of blends, relative to the diameter
  double slack;    // angles (radians) and scaled Jacobians that are worse by less are accepted
};

constexpr Precision fine{graph::relative_fit_tol, tolerance::tied};  // equal quality in spite of rounding
constexpr Precision coarse{1e-6, 1e-2};  // shows at a fifth of the cost that most collapses are not acceptable

// The key of a group of strips: the pieces of all its arcs.
std::vector<double> key_of(const ArcGraph& graph, const std::vector<ChordStrip>& strips) {
  std::vector<std::vector<double>> keys;
  for (const ChordStrip& strip : strips) {
    keys.emplace_back();
    for (const std::vector<HalfEdge>* half_edges : {&strip.rungs, &strip.left, &strip.right})
      for (const HalfEdge h : *half_edges)
        for (const ArcPiece& p : graph.arcs[h.arc].pieces)
          keys.back().insert(keys.back().end(), {static_cast<double>(p.curve), p.t0, p.t1});
    std::sort(keys.back().begin(), keys.back().end());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<double> key;
  for (const std::vector<double>& k : keys) key.insert(key.end(), k.begin(), k.end());
  return key;
}

// Apart from validity. The loss of block quality must be justified by the number of blocks saved.
bool is_acceptable(const SimplifyOptions& options, const BlockQuality& before, const BlockQuality& after,
                   double fraction_left, double slack) {
  const double worth = options.limits_loss_by_saving ? fraction_left : 0;
  const double least = std::max(options.least_scaled_jacobian, worth * before.least_scaled_jacobian);
  return after.least_angle >= std::min(before.least_angle, options.least_angle) - slack &&
         after.greatest_angle <= std::max(before.greatest_angle, options.greatest_angle) + slack &&
         after.least_scaled_jacobian >= std::min(before.least_scaled_jacobian, least) - slack;
}

// Arcs that are removed or changed, but for rails whose place a rail takes that stays as it was.
std::set<int> touched_by(const ArcChanges& changes) {
  std::set<int> touched = changes.changed;
  for (const auto& [arc, in_its_place] : changes.removed)
    if (const int now = changes.now(arc); now < 0 || changes.changed.contains(now)) touched.insert(arc);
  return touched;
}

double fraction_left(const Subdivision& before, const Subdivision& after) {
  return static_cast<double>(after.num_faces()) / static_cast<double>(before.num_faces());
}

class Simplifier {
 public:
  Simplifier(const field::FieldsOfRegions& fields, Subdivision subdivision, const SimplifyOptions& options,
             Progress* progress)
      : fields_(fields), options_(options), subdivision_(std::move(subdivision)), tried_(progress, "chords tried") {}

  // Until no group of equal chords can be collapsed.
  void collapse_chords() {
    StripQueue queue(subdivision_);
    for (std::vector<ChordStrip> group = queue.thinnest(); !group.empty(); group = queue.thinnest())
      if (const std::optional<ArcChanges> changes = try_collapse(group))
        queue.update(subdivision_, *changes);
      else
        queue.refuse(group);
    subdivision_.compact();
  }

  // Not with periodic sides, on which the ends of lines have images.
  bool shorten_spirals() {
    if (!subdivision_.graph().face.periodic_pairs.empty()) return false;
    std::vector<SpiralShortcut> all = find_shortcuts(subdivision_, graph::arc_lengths(subdivision_.graph()));
    const auto aspect = [](const SpiralShortcut& s) { return s.aspect; };
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return aspect(a) < aspect(b); });
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
      last = end_of_ties(first, all.end(), tolerance::tied * first->aspect, aspect);
      if (try_shorten({first, last})) return true;
    }
    return false;
  }

  Subdivision& subdivision() { return subdivision_; }
  double least_scaled_jacobian() { return worst_of_all().least_scaled_jacobian; }
  int num_collapsed() const { return num_collapsed_; }
  int num_shortened() const { return num_shortened_; }
  double deviation() const { return deviation_; }

 private:
  BlockQuality worst_of_all() { return qualities_.worst(subdivision_, all_faces(subdivision_)); }

  std::optional<ArcChanges> try_collapse(const std::vector<ChordStrip>& strips) {
    std::vector<double> key = key_of(subdivision_.graph(), strips);
    if (refused_.contains(key)) return std::nullopt;
    tried_.advance();
    std::optional<std::vector<Blend>> blends = acceptable_blends(strips, coarse);
    if (blends) blends = acceptable_blends(strips, fine);
    if (!blends) {
      refused_.insert(std::move(key));
      return std::nullopt;
    }
    num_collapsed_ += static_cast<int>(strips.size());
    deviation_ = std::max(deviation_, greatest_deviation(*blends));
    return collapse_group(subdivision_, strips, *blends);
  }

  // std::nullopt if the strips cannot be collapsed or may not be.
  std::optional<std::vector<Blend>> acceptable_blends(const std::vector<ChordStrip>& strips,
                                                      const Precision& precision) {
    std::optional<std::vector<Blend>> blends =
        blends_of_group(fields_, subdivision_, strips, blend_options(precision.fit_tol));
    if (blends && !improves(strips, *blends, precision.slack)) blends.reset();
    return blends;
  }

  bool try_shorten(const std::vector<SpiralShortcut>& shortcuts) {
    tried_.advance();
    std::optional<Shortened> trial = shorten_group(fields_, subdivision_, shortcuts, blend_options(fine.fit_tol));
    if (!trial) return false;
    BlockQuads quads;
    const BlockQuality after = worst_quality(trial->subdivision, all_faces(trial->subdivision), quads);
    if (!is_acceptable(options_, worst_of_all(), after, fraction_left(subdivision_, trial->subdivision), fine.slack) ||
        !are_valid(quads))
      return false;
    num_shortened_ += static_cast<int>(shortcuts.size());
    subdivision_ = std::move(trial->subdivision);
    deviation_ = std::max(deviation_, trial->deviation);
    return true;
  }

  // Whether the strips can be collapsed and may be: by the blocks that a trial changes. Leaves the subdivision as it
  // is.
  bool improves(const std::vector<ChordStrip>& strips, const std::vector<Blend>& blends, double slack) {
    const double num_before = subdivision_.num_faces();
    subdivision_.begin_trial();
    const std::optional<ArcChanges> changes = collapse_group(subdivision_, strips, blends);
    BlockQuality after;
    BlockQuads quads;
    if (changes) after = worst_quality(subdivision_, faces_beside(subdivision_, changes->changed), quads);
    const double num_after = subdivision_.num_faces();
    subdivision_.undo_trial();
    if (!changes) return false;
    const BlockQuality before = qualities_.worst(subdivision_, faces_beside(subdivision_, touched_by(*changes)));
    return is_acceptable(options_, before, after, num_after / num_before, slack) && are_valid(quads);
  }

  BlendOptions blend_options(double fit_tol) const {
    return {options_.max_deviation, fit_tol * subdivision_.graph().face.diameter};
  }

  const field::FieldsOfRegions& fields_;
  const SimplifyOptions& options_;
  Subdivision subdivision_;
  BlockQualities qualities_;               // not of trials, whose splines get the numbers of later ones
  std::set<std::vector<double>> refused_;  // groups that were tried, by their arcs: most are unchanged by other steps
  int num_collapsed_ = 0, num_shortened_ = 0;
  double deviation_ = 0;
  Progress::Part tried_;
};

void report_steps(const Simplifier& simplifier, Report& report) {
  report.set("simplify.collapsed", simplifier.num_collapsed());
  report.set("simplify.shortened_spirals", simplifier.num_shortened());
  report.set("simplify.largest_deviation_degrees", degrees(simplifier.deviation()));
}

}  // namespace

graph::CandidateLayout simplify(const field::FieldsOfRegions& fields, graph::CandidateLayout layout,
                                const SimplifyOptions& options, Report& report) {
  report.set("simplify.blocks_before", layout.subdivision.num_faces());
  std::vector<LineKind> kinds = graph::spline_kinds(layout.graph(), layout.lines);
  Simplifier simplifier(fields, std::move(layout.subdivision), options, report.progress());
  report.set("simplify.least_scaled_jacobian_before", simplifier.least_scaled_jacobian());
  do simplifier.collapse_chords();
  while (simplifier.shorten_spirals());
  const double least = simplifier.least_scaled_jacobian();
  layout.subdivision = std::move(simplifier.subdivision());
  report_steps(simplifier, report);
  if (simplifier.num_collapsed() + simplifier.num_shortened() > 0)
    graph::rebuild_lines(layout, std::move(kinds), LineKind::merged);  // the new ones are blends
  else
    layout.subdivision.drop_unused_splines();
  report.set("simplify.least_scaled_jacobian", least);
  LayoutCertificate& certificate = layout.certificate;
  certificate.collapsed_chords += simplifier.num_collapsed();
  certificate.shortened_spirals += simplifier.num_shortened();
  certificate.largest_deviation_degrees =
      std::max(certificate.largest_deviation_degrees, degrees(simplifier.deviation()));
  return layout;
}

}  // namespace quadrille::simplify
