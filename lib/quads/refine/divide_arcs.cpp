#include "refine/divide_arcs.hpp"

#include <utility>

#include "refine/correct_misses.hpp"
#include "refine/settle_counts.hpp"

namespace quadrille::refine {
namespace {

std::vector<sizing::ArcDivision> divide_chord(const ChordTask& task) {
  ChordDivision division = begin_division(task);
  do settle_counts(task, division);
  while (correct_misses(task, division));
  return std::move(division.arcs);
}

}  // namespace

sizing::ArcDivisions divide_arcs(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                                 const DivideOptions& options, Progress* progress, const KnownDivisions& known) {
  sizing::ArcDivisions divisions(measured.num_arcs());
  const std::vector<mesh::Chord>& chords = measured.chords();
  const Progress::Part part(progress, "chords", static_cast<int>(chords.size()));
  for (std::size_t c = 0; c < chords.size(); ++c, part.advance()) {
    if (known.plans && (*known.plans)[c] == plans[c]) {
      for (const int arc : chords[c].arcs) divisions[arc] = (*known.divisions)[arc];
      continue;
    }
    std::vector<sizing::ArcDivision> divided = divide_chord({measured, chords[c], plans[c], options});
    for (std::size_t i = 0; i < divided.size(); ++i) divisions[chords[c].arcs[i]] = std::move(divided[i]);
  }
  return divisions;
}

}  // namespace quadrille::refine
