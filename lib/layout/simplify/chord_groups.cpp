#include "simplify/chord_groups.hpp"

#include <algorithm>
#include <iterator>

#include "base/tolerance.hpp"
#include "graph/candidate_layout.hpp"
#include "simplify/block_quality.hpp"

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::Subdivision;

bool share_a_rail(const std::vector<ChordStrip>& strips) {
  std::set<int> rails;
  for (const ChordStrip& strip : strips)
    for (const std::vector<HalfEdge>* half_edges : {&strip.left, &strip.right})
      for (const HalfEdge h : *half_edges)
        if (!rails.insert(h.arc).second) return true;
  return false;
}

// Whether the curves around the ends of these arcs have the order of the topology.
bool are_drawn_in_order(const Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> nodes;
  for (const int a : arcs) nodes.insert({subdivision.start({a}), subdivision.end({a})});
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return graph::is_drawn_in_order(subdivision, n); });
}

std::set<int> all_arcs(const Subdivision& subdivision) {
  std::set<int> arcs;
  for (int a = 0; a < subdivision.arc_bound(); ++a) arcs.insert(arcs.end(), a);
  return arcs;
}

// The strip after the collapse of others that cross it.
bool collapse_one(Subdivision& subdivision, const ChordStrip& old_strip, const std::vector<Blend>& blends,
                  ArcChanges& changes) {
  int arc = -1;
  for (const HalfEdge h : old_strip.rungs)
    if (arc < 0) arc = changes.now(h.arc);
  if (arc < 0) return false;
  const ChordStrip strip = graph::strip_through(subdivision, arc);
  const std::optional<ArcChanges> own = collapse_strip(subdivision, strip, blends);
  if (!own || !are_drawn_in_order(subdivision, own->changed)) return false;
  changes.add(*own);
  return true;
}

// The shortcut of a line after others were applied; splines keep their numbers.
bool shorten_one(int line, const Blend& blend, Shortened& trial) {
  const std::vector<SpiralShortcut> now =
      find_shortcuts(trial.subdivision, graph::arc_lengths(trial.subdivision.graph()));
  const auto found = std::find_if(now.begin(), now.end(), [&](const SpiralShortcut& s) { return s.spline == line; });
  if (found == now.end()) return false;
  std::optional<Subdivision> result = with_shortcut(trial.subdivision, *found, blend);
  if (!result || result->num_faces() >= trial.subdivision.num_faces() ||
      !graph::faces_without_four_corners(*result).empty() || !are_drawn_in_order(*result, all_arcs(*result)))
    return false;
  trial.subdivision = std::move(*result);
  return true;
}

int lowest_arc(const ChordStrip& strip) { return std::min_element(strip.rungs.begin(), strip.rungs.end())->arc; }

// The sides of all faces beside these arcs.
std::set<int> arcs_around(const Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> around;
  for (const int f : faces_beside(subdivision, arcs))
    for (const HalfEdge side : subdivision.cycle(f)) around.insert(side.arc);
  return around;
}

}  // namespace

std::optional<std::vector<Blend>> blends_of_group(const field::FieldsOfRegions& fields, const Subdivision& subdivision,
                                                  const std::vector<ChordStrip>& strips, const BlendOptions& options) {
  if (share_a_rail(strips)) return std::nullopt;
  std::vector<Blend> blends;
  for (const ChordStrip& strip : strips) {
    auto own = blends_of(fields, subdivision, strip, options);
    if (!own) return std::nullopt;
    for (Blend& b : *own) blends.push_back(std::move(b));
  }
  return blends;
}

std::optional<ArcChanges> collapse_group(Subdivision& subdivision, const std::vector<ChordStrip>& strips,
                                         const std::vector<Blend>& blends) {
  ArcChanges changes;
  for (const ChordStrip& strip : strips)
    if (!collapse_one(subdivision, strip, blends, changes)) return std::nullopt;
  return changes;
}

double greatest_deviation(const std::vector<Blend>& blends) {
  double deviation = 0;
  for (const Blend& b : blends) deviation = std::max(deviation, b.deviation);
  return deviation;
}

std::optional<Shortened> shorten_group(const field::FieldsOfRegions& fields, const Subdivision& subdivision,
                                       const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options) {
  std::map<int, Blend> line2blend;
  for (const SpiralShortcut& s : shortcuts) {
    auto blend = blend_of(fields, subdivision.graph(), s, options);
    if (!blend || !line2blend.emplace(s.spline, std::move(*blend)).second) return std::nullopt;
  }
  Shortened trial{subdivision, 0};
  for (const auto& [line, blend] : line2blend) {
    if (!shorten_one(line, blend, trial)) return std::nullopt;
    trial.deviation = std::max(trial.deviation, blend.deviation);
  }
  return trial;
}

StripQueue::StripQueue(const Subdivision& subdivision)
    : lengths_(graph::arc_lengths(subdivision.graph())), arc2strip_(subdivision.arc_bound(), -1) {
  add_strips_through(subdivision, all_arcs(subdivision));
}

void StripQueue::add_strips_through(const Subdivision& subdivision, const std::set<int>& arcs) {
  std::vector<Key> keys;
  for (const int arc : arcs)
    if (subdivision.has_arc(arc) && arc2strip_[arc] < 0) keys.push_back(add_strip_through(subdivision, arc));
  reconsider(keys);
}

// Of a closed strip the lowest arc is the first rung. Strips that cross themselves end where they do, so that several
// may be followed from one chord; when the crossing is gone, the last one replaces the others.
StripQueue::Key StripQueue::add_strip_through(const Subdivision& subdivision, int arc) {
  ChordStrip strip = graph::measured_strip(subdivision, arc, lengths_);
  const int lowest = lowest_arc(strip);
  if (strip.is_closed && lowest < strip.rungs.front().arc) strip = graph::measured_strip(subdivision, lowest, lengths_);
  const bool can_collapse =
      !graph::ends_on_periodic_side(subdivision, strip) && !graph::fixed_sides(subdivision, strip).empty();
  const int id = num_made_++;
  for (const HalfEdge h : strip.rungs) {
    if (arc2strip_[h.arc] >= 0 && !strip.crosses_itself) remove_strip(arc2strip_[h.arc]);
    if (arc2strip_[h.arc] < 0) arc2strip_[h.arc] = id;
  }
  arc2strip_[arc] = id;
  const Key key{strip.aspect(), lowest};
  if (can_collapse) by_aspect_.emplace(key, id);
  strips_.emplace(id, Entry{std::move(strip), key, arc, can_collapse});
  return key;
}

void StripQueue::remove_strip(int id) {
  const auto found = strips_.find(id);
  const Entry& entry = found->second;
  for (const HalfEdge h : entry.strip.rungs)
    if (arc2strip_[h.arc] == id) arc2strip_[h.arc] = -1;
  arc2strip_[entry.arc] = -1;
  if (entry.can_collapse) {
    reconsider({entry.key});
    by_aspect_.erase(entry.key);
    pending_.erase(entry.key);
  }
  strips_.erase(found);
}

// The first of consecutive strips each of which is nearly as thin as the next one: groups begin anew at it.
std::map<StripQueue::Key, int>::const_iterator StripQueue::first_of_chain(std::map<Key, int>::const_iterator at) const {
  while (at != by_aspect_.begin() && at->first.first <= std::prev(at)->first.first * (1 + tolerance::tied)) --at;
  return at;
}

// All groups that strips with these keys may belong to.
void StripQueue::reconsider(const std::vector<Key>& keys) {
  std::set<Key> done;
  for (const Key& key : keys) {
    const auto found = by_aspect_.find(key);
    if (found == by_aspect_.end() || done.contains(key)) continue;
    auto at = first_of_chain(found);
    for (double before = at->first.first; at != by_aspect_.end() && at->first.first <= before * (1 + tolerance::tied);
         ++at) {
      before = at->first.first;
      pending_.insert(at->first);
      done.insert(at->first);
    }
  }
}

std::vector<ChordStrip> StripQueue::thinnest() const {
  std::vector<ChordStrip> group;
  if (pending_.empty()) return group;
  const Key next = *pending_.begin();
  auto first = first_of_chain(by_aspect_.find(next)), last = first;
  for (; first != by_aspect_.end() && first->first <= next; first = last) {
    const double same = first->first.first * (1 + tolerance::tied);
    while (last != by_aspect_.end() && last->first.first <= same) ++last;
    if (last != by_aspect_.end() && last->first <= next) continue;
    for (auto at = first; at != last; ++at) group.push_back(strips_.at(at->second).strip);
    break;
  }
  return group;
}

void StripQueue::refuse(const std::vector<ChordStrip>& group) {
  for (const ChordStrip& strip : group) pending_.erase(strips_.at(arc2strip_[strip.rungs.front().arc]).key);
}

void StripQueue::measure(const Subdivision& subdivision, const std::set<int>& arcs) {
  const curve::CurveTable table(subdivision.graph().face, subdivision.graph().splines);
  for (const int a : arcs) lengths_[a] = graph::arc_length(table, subdivision.graph().arcs[a]);
}

void StripQueue::update(const Subdivision& subdivision, const ArcChanges& changes) {
  measure(subdivision, changes.changed);
  std::set<int> touched = changes.changed;
  for (const auto& [arc, in_its_place] : changes.removed)
    if (const int now = changes.now(arc); now >= 0) touched.insert(now);
  touched = arcs_around(subdivision, touched);
  for (const auto& [arc, in_its_place] : changes.removed) touched.insert(arc);
  std::set<int> outdated;  // strips
  for (const int a : touched)
    if (arc2strip_[a] >= 0) outdated.insert(arc2strip_[a]);
  for (const int id : outdated) {
    const Entry& entry = strips_.at(id);
    for (const HalfEdge h : entry.strip.rungs) touched.insert(h.arc);
    touched.insert(entry.arc);
    remove_strip(id);
  }
  add_strips_through(subdivision, touched);
}

}  // namespace quadrille::simplify
