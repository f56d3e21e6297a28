#include "block/make_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "block/extract_blocks.hpp"
#include "block/report_layout.hpp"
#include "block/split_chord.hpp"

namespace quadrille::block {
namespace {

constexpr int most_rounds = 4;

constexpr double poor_shape = 0.1;  // scaled Jacobian

bool is_proved(const BlockMeasure& m) { return m.divisions > 0; }
bool is_good(const BlockMeasure& m) { return is_proved(m) && m.map_scaled_jacobian >= poor_shape; }

/// Number of blocks that are not proved valid, and number of bad blocks.
std::pair<int, int> faults(const std::vector<BlockMeasure>& measures) {
  std::pair<int, int> count{0, 0};
  for (const BlockMeasure& m : measures) count.first += !is_proved(m), count.second += !is_good(m);
  return count;
}

/// The sides of a block that are cut. The exact map of a strip folds unless its long sides are cut; that of a block
/// around a nose, whose sides leave the nose at right angles, unless the cut begins there, whichever sides are longer.
enum class CutSides { longer, shorter };

/// One arc of every chord that runs across these sides of a bad block.
std::set<int> arcs_to_cut(const Blocks& blocks, CutSides cut) {
  const BlockMaps maps(blocks.layout);
  std::set<int> chords, arcs;
  for (int b = 0; b < blocks.layout.num_blocks(); ++b) {
    if (is_good(blocks.measures[b])) continue;
    const std::array<HalfEdge, 4>& sides = blocks.layout.block2arcs[b];
    const auto length = [&](int k) { return maps.arc(sides[k].arc).length(); };
    const bool is_longer = length(0) + length(2) >= (1 - 1e-6) * (length(1) + length(3));
    const int arc = sides[is_longer == (cut == CutSides::longer) ? 0 : 1].arc;
    if (chords.insert(blocks.layout.arc_chord[arc]).second) arcs.insert(arc);
  }
  return arcs;
}

/// The blocks of a subdivision, measured.
struct Trial {
  graph::Subdivision subdivision;
  Progress* progress = nullptr;
  Blocks blocks = {};

  void measure() {
    blocks.layout = blocks_of(subdivision);
    blocks.measures = measure_blocks(blocks.layout, progress);
  }
};

/// Cuts each of these chords once. Returns false if none can be cut.
bool cut_once(Trial& trial, CutSides cut) {
  std::vector<bool> sound;
  for (const BlockMeasure& m : trial.blocks.measures) sound.push_back(is_good(m));
  bool has_cut = false;
  for (const int arc : arcs_to_cut(trial.blocks, cut)) {
    has_cut |= split_chord(trial.subdivision, arc, sound);
    sound.resize(trial.subdivision.face_bound(), false);
  }
  if (has_cut) trial.measure();
  return has_cut;
}

/// Cuts the chords of bad blocks again and again, as long as it helps; `best`: the blocks with the fewest faults.
void cut_bad_blocks(Trial trial, CutSides cut, Blocks& best) {
  const Progress::Part rounds(trial.progress, "round");
  int in_vain = 0;
  for (int round = 0; round < most_rounds && in_vain < 2; ++round) {
    rounds.advance();
    if (faults(trial.blocks.measures).second == 0 || !cut_once(trial, cut)) break;
    const bool helps = faults(trial.blocks.measures) < faults(best.measures);
    if (helps) best = trial.blocks;
    in_vain = helps ? 0 : in_vain + 1;
  }
}

void warn_of_invalid(const Blocks& blocks, Report& report) {
  for (int b = 0; b < blocks.layout.num_blocks(); ++b) {
    const BlockMeasure& m = blocks.measures[b];
    if (is_proved(m)) continue;
    report.warn(warning::block_not_proved_valid,
                fmt::format("{} cannot be proved valid near {}: its exact map folds there, or nearly so",
                            blocks.layout.block_names[b],
                            position_text(m.scaled_jacobian_position + blocks.layout.face.origin)));
  }
}

}  // namespace

Blocks split_bad_chords(graph::Subdivision subdivision, Report& report) {
  const int blocks_before = subdivision.num_faces();
  Trial whole{std::move(subdivision), report.progress()};
  whole.measure();
  Blocks best = whole.blocks;
  cut_bad_blocks(whole, CutSides::longer, best);
  if (faults(best.measures).first > 0) cut_bad_blocks(std::move(whole), CutSides::shorter, best);
  store_measures(best.measures, best.layout);
  report.set("blocks_added_to_mend", best.layout.num_blocks() - blocks_before);
  warn_of_invalid(best, report);
  return best;
}

Blocks make_blocks(const SeparatrixGraph& graph, Report& report) {
  Blocks blocks = split_bad_chords(subdivision_into_blocks(graph), report);
  blocks.layout.provenance = graph.provenance;
  report_layout(blocks.layout, blocks.measures, report);
  return blocks;
}

BlockLayout extract_blocks(const SeparatrixGraph& graph, Report& report) { return make_blocks(graph, report).layout; }

}  // namespace quadrille::block
