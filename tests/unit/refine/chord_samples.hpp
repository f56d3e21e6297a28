#pragma once
// Chords of layouts made by hand, ready to be divided.

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "refine/chord_division.hpp"

namespace quadrille::refine {

/// A chord with its plan; equal elements of the given count unless a grading is set. Not to be copied: the task refers
/// to the members.
struct ChordSample {
  BlockLayout layout;
  sizing::MeasuredLayout measured;
  sizing::ChordPlan plan;
  DivideOptions options;
  ChordTask task;

  ChordSample(const SeparatrixGraph& graph, int arc, int count, DivideOptions o)
      : layout(blocks_of(graph)),
        measured(layout),
        plan{sizing::Grading(count), count},
        options(o),
        task{measured, measured.chords()[measured.chord_of(arc)], plan, options} {}
  ChordSample(const ChordSample&) = delete;
  ChordSample& operator=(const ChordSample&) = delete;

 private:
  static BlockLayout blocks_of(const SeparatrixGraph& graph) {
    Report report;
    return block::extract_blocks(graph, report);
  }
};

}  // namespace quadrille::refine
