#pragma once
// The strips of a subdivision that can be collapsed, in groups of equal ratio of width to length, the thinnest first.
// Groups of equal chords, or of equal spiral shortcuts, are changed together or not at all, so that symmetric layouts
// stay symmetric. After a collapse only strips beside what has changed are followed and measured again.

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_collapse.hpp"
#include "simplify/spiral_shortcut.hpp"

namespace quadrille::simplify {

/// The blends that strips need together; std::nullopt if two have a common rail, or one of them cannot be collapsed.
std::optional<std::vector<Blend>> blends_of_group(const field::FieldsOfRegions& fields,
                                                  const graph::Subdivision& subdivision,
                                                  const std::vector<graph::ChordStrip>& strips,
                                                  const BlendOptions& options);

/// Collapses strips, given their blends. If one of them cannot be collapsed after others, the result is std::nullopt,
/// and the subdivision may have changed: make it a trial.
std::optional<ArcChanges> collapse_group(graph::Subdivision& subdivision, const std::vector<graph::ChordStrip>& strips,
                                         const std::vector<Blend>& blends);

/// The greatest deviation of blends, radians.
double greatest_deviation(const std::vector<Blend>& blends);

/// A compact subdivision, and the greatest deviation of its new lines (radians).
struct Shortened {
  graph::Subdivision subdivision;
  double deviation = 0;
};

/// A copy in which the shortcuts are taken. std::nullopt if one line has two shortcuts, if one of them does not fit, or
/// if the result is not a smaller number of four-sided blocks.
std::optional<Shortened> shorten_group(const field::FieldsOfRegions& fields, const graph::Subdivision& subdivision,
                                       const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options);

/// Ratios of width to length that are tied with the least of a group belong to it.
class StripQueue {
 public:
  /// Of a compact subdivision.
  explicit StripQueue(const graph::Subdivision& subdivision);

  /// The thinnest group that was not refused; empty if there is none. Strips of equal ratio are in the order of their
  /// lowest arcs.
  std::vector<graph::ChordStrip> thinnest() const;

  /// A group is not returned again before one of its strips, or one of equal ratio, has changed.
  void refuse(const std::vector<graph::ChordStrip>& group);

  /// After the collapse of a group. `subdivision`: the same as before, with these changes and not compact.
  void update(const graph::Subdivision& subdivision, const ArcChanges& changes);

 private:
  using Key = std::pair<double, int>;  // the ratio and the lowest arc of a strip

  struct Entry {
    graph::ChordStrip strip;
    Key key;
    int arc = 0;  // through which it was followed: not a rung if it crosses itself before
    bool can_collapse = false;
  };

  void add_strips_through(const graph::Subdivision& subdivision, const std::set<int>& arcs);
  Key add_strip_through(const graph::Subdivision& subdivision, int arc);
  void remove_strip(int id);
  void reconsider(const std::vector<Key>& keys);
  std::map<Key, int>::const_iterator first_of_chain(std::map<Key, int>::const_iterator at) const;
  void measure(const graph::Subdivision& subdivision, const std::set<int>& arcs);

  std::vector<double> lengths_;   // of all arcs
  std::vector<int> arc2strip_;    // the strip of which an arc is a rung, -1
  std::map<int, Entry> strips_;   // by number
  int num_made_ = 0;              // strips so far
  std::map<Key, int> by_aspect_;  // of those that can be collapsed
  std::set<Key> pending_;         // of those that are not refused
};

}  // namespace quadrille::simplify
