#include "refine/chosen_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"

namespace quadrille::refine {
namespace {

/// Counts are not raised beyond this if the mesh is still not valid.
constexpr int max_coarse_count = 64;

/// Several blocks may have the same name.
std::set<int> blocks_called(const std::string& word, const std::vector<std::string>& names) {
  std::set<int> blocks;
  for (std::size_t b = 0; b < names.size(); ++b)
    if (names[b] == word) blocks.insert(static_cast<int>(b));
  if (!blocks.empty()) return blocks;
  const int number = number_of<int>(word).value_or(-1);
  if (number >= 0 && number < std::ssize(names)) return {number};
  throw UsageError(fmt::format("--blocks: there is no block '{}'; they are numbered 0 to {}", word, names.size() - 1));
}

/// By chord: whether it passes one of the blocks.
std::vector<bool> passes(const sizing::MeasuredLayout& measured, const std::set<int>& blocks) {
  std::vector<bool> does_pass(measured.chords().size(), false);
  for (const int block : blocks)
    for (const HalfEdge side : measured.blocks().block2arcs[block]) does_pass[measured.chord_of(side.arc)] = true;
  return does_pass;
}

/// By chord: whether it passes a block with an element that is not proved valid.
std::vector<bool> passes_unproved(const sizing::MeasuredLayout& measured, const QuadMesh& mesh) {
  std::set<int> blocks;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    if (!(mesh.elem_jacobian_bound[elem] > 0)) blocks.insert(mesh.elem_block[elem]);
  return passes(measured, blocks);
}

}  // namespace

std::vector<int> parse_blocks(const std::string& list, const std::vector<std::string>& block_names) {
  std::set<int> blocks;
  for (const std::string& word : split_at_commas(list)) blocks.merge(blocks_called(word, block_names));
  return {blocks.begin(), blocks.end()};
}

std::vector<sizing::ChordCount> coarse_counts(const sizing::MeasuredLayout& measured, const std::vector<int>& chosen,
                                              const std::vector<sizing::ChordCount>& prescribed) {
  std::vector<bool> is_free = passes(measured, {chosen.begin(), chosen.end()});
  for (const sizing::ChordCount& p : prescribed)
    if (p.chord >= 0 && p.chord < static_cast<int>(is_free.size())) is_free[p.chord] = true;
  std::vector<sizing::ChordCount> coarse;
  for (std::size_t c = 0; c < is_free.size(); ++c)
    if (!is_free[c]) coarse.push_back({static_cast<int>(c), 1});
  return coarse;
}

bool raise_counts(const sizing::MeasuredLayout& measured, const QuadMesh& mesh,
                  std::vector<sizing::ChordCount>& coarse) {
  const std::vector<bool> is_concerned = passes_unproved(measured, mesh);
  bool is_any = false;
  for (sizing::ChordCount& c : coarse)
    if (is_concerned[c.chord] && c.count < max_coarse_count) c.count *= 2, is_any = true;
  return is_any;
}

bool double_counts(const sizing::MeasuredLayout& measured, const QuadMesh& mesh, const sizing::ArcDivisions& divisions,
                   const std::vector<sizing::ChordCount>& prescribed, std::vector<sizing::ChordCount>& counts) {
  std::vector<bool> is_concerned = passes_unproved(measured, mesh);
  std::erase_if(counts, [&](const sizing::ChordCount& c) { return is_concerned[c.chord]; });
  bool is_any = false;
  for (int arc = 0; arc < measured.num_arcs(); ++arc) {
    const int chord = measured.chord_of(arc);
    if (!is_concerned[chord] || std::ranges::count(prescribed, chord, &sizing::ChordCount::chord) > 0) continue;
    counts.push_back({chord, 2 * divisions[arc].num_intervals()});
    is_concerned[chord] = false;
    is_any = true;
  }
  return is_any;
}

}  // namespace quadrille::refine
