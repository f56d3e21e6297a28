#include "simplify/strip_queue.hpp"

#include <algorithm>
#include <iterator>

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::Subdivision;

int lowest_arc(const ChordStrip& strip) {
  int lowest = strip.rungs.front().arc;
  for (const HalfEdge h : strip.rungs) lowest = std::min(lowest, h.arc);
  return lowest;
}

// The sides of all faces beside these arcs.
std::set<int> arcs_around(const Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> around;
  for (const int a : arcs)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}})
      if (const int f = subdivision.face(h); f >= 0)
        for (const HalfEdge side : subdivision.cycle(f)) around.insert(side.arc);
  return around;
}

}  // namespace

StripQueue::StripQueue(const Subdivision& subdivision)
    : lengths_(graph::arc_lengths(subdivision.graph())), arc2strip_(subdivision.arc_bound(), -1) {
  std::set<int> arcs;
  for (int arc = 0; arc < subdivision.arc_bound(); ++arc) arcs.insert(arcs.end(), arc);
  add_strips_through(subdivision, arcs);
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
  while (at != by_aspect_.begin() && at->first.first <= std::prev(at)->first.first * (1 + equal_aspect)) --at;
  return at;
}

// All groups that strips with these keys may belong to.
void StripQueue::reconsider(const std::vector<Key>& keys) {
  std::set<Key> done;
  for (const Key& key : keys) {
    const auto found = by_aspect_.find(key);
    if (found == by_aspect_.end() || done.contains(key)) continue;
    auto at = first_of_chain(found);
    for (double before = at->first.first; at != by_aspect_.end() && at->first.first <= before * (1 + equal_aspect);
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
    const double same = first->first.first * (1 + equal_aspect);
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
