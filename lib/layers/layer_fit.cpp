#include "layers/layer_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "layers/layer_law.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::layers {
namespace {

constexpr int lines_per_block = 9;
constexpr int samples_per_line = 64;
constexpr double greatest_change = 1.25;
constexpr double least_growth = 1.1;
constexpr int max_intervals = 10000;

std::array<const curve::Chain*, 4> side_chains(const std::array<HalfEdge, 4>& sides,
                                               const sizing::MeasuredLayout& measured) {
  return {&measured.chain(sides[0].arc), &measured.chain(sides[1].arc), &measured.chain(sides[2].arc),
          &measured.chain(sides[3].arc)};
}

/// A point of the block in the frame of its side k: x along that side, y away from it.
Vec2 in_frame(const mesh::TransfiniteMap& map, int k, double x, double y) {
  switch (k) {
    case 0:
      return map.position(x, y);
    case 1:
      return map.position(1 - y, x);
    case 2:
      return map.position(1 - x, 1 - y);
    default:
      return map.position(y, 1 - x);
  }
}

class Prober {
 public:
  Prober(const sizing::MeasuredLayout& measured, const WallSides& walls, const std::vector<double>& arc_sizes)
      : measured_(measured), walls_(walls), arc_sizes_(arc_sizes) {}

  std::vector<ColumnProbe> probe() {
    for (const WallSide& wall : walls_.sides) {
      const int far = walls_.of_block[wall.block][(wall.side + 2) % 4];
      if (far >= 0 && wall.side >= 2) continue;  // seen from the other side
      for (int k = 0; k < lines_per_block; ++k) add(wall, far, static_cast<double>(k) / (lines_per_block - 1));
    }
    return std::move(probes_);
  }

 private:
  void add(const WallSide& wall, int far, double x) {
    const std::array<HalfEdge, 4>& sides = measured_.blocks().block2arcs[wall.block];
    const mesh::TransfiniteMap map(side_chains(sides, measured_), {sides[0].is_backwards, sides[1].is_backwards,
                                                                   sides[2].is_backwards, sides[3].is_backwards});
    const int begin = sides[(wall.side + 3) % 4].arc, end = sides[(wall.side + 1) % 4].arc;
    ColumnProbe probe;
    probe.chord = measured_.chord_of(begin);
    probe.front = wall.spec;
    probe.back = far < 0 ? -1 : walls_.sides[far].spec;
    probe.size = (1 - x) * arc_sizes_[begin] + x * arc_sizes_[end];
    std::vector<Vec2> line;
    for (int i = 0; i <= samples_per_line; ++i)
      line.push_back(in_frame(map, wall.side, x, (1 - std::cos(pi * i / samples_per_line)) / 2));
    probe.lengths = {0};
    for (std::size_t i = 1; i < line.size(); ++i)
      probe.lengths.push_back(probe.lengths.back() + distance(line[i - 1], line[i]));
    probe.far_end = line.back();
    probe.front_heights = heights(wall, line, x);
    std::reverse(line.begin(), line.end());
    if (far >= 0) probe.back_heights = heights(walls_.sides[far], line, 1 - x);
    probes_.push_back(std::move(probe));
  }

  /// Heights of the points of a line that leaves the wall at the share x of its side.
  std::vector<double> heights(const WallSide& wall, const std::vector<Vec2>& line, double x) const {
    const HalfEdge directed = measured_.blocks().block2arcs[wall.block][wall.side];
    const curve::ChainPoint start = measured_.chain(directed.arc).at(directed.is_backwards ? 1 - x : x);
    const int count = wall.end.piece - wall.begin.piece;
    WallFoot foot{wall.begin.piece + (directed.is_backwards ? count - start.piece : start.piece), start.t};
    std::vector<double> result;
    for (const Vec2 point : line) result.push_back(wall.line.distance(point, foot));
    return result;
  }

  const sizing::MeasuredLayout& measured_;
  const WallSides& walls_;
  const std::vector<double>& arc_sizes_;
  std::vector<ColumnProbe> probes_;
};

/// Length at which the line first reaches the height, negative where it turns back before.
double length_at(const std::vector<double>& heights, const std::vector<double>& lengths, double height) {
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (heights[i] <= heights[i - 1]) return -1;
    if (heights[i] < height) continue;
    const double share = (height - heights[i - 1]) / (heights[i] - heights[i - 1]);
    return lengths[i - 1] + share * (lengths[i] - lengths[i - 1]);
  }
  return -1;
}

/// Lengths from the other end.
std::vector<double> from_back(const std::vector<double>& lengths) {
  std::vector<double> result;
  for (std::size_t i = lengths.size(); i-- > 0;) result.push_back(lengths.back() - lengths[i]);
  return result;
}

struct LayerRoom {
  double top = 0;   ///< length that the layers take
  double last = 0;  ///< of the last one
};

LayerRoom room_of(const std::vector<double>& line_heights, const std::vector<double>& lengths,
                  const std::vector<double>& layers) {
  const double top = length_at(line_heights, lengths, layers.back());
  const double below = layers.size() > 1 ? length_at(line_heights, lengths, layers[layers.size() - 2]) : 0;
  return {top, top - below};
}

class Fitter {
 public:
  Fitter(const std::vector<WallSpec>& specs, const std::vector<ColumnProbe>& probes, bool is_strict)
      : specs_(specs), probes_(probes), is_strict_(is_strict) {
    for (std::size_t i = 0; i < specs.size(); ++i) counts_.push_back(first_count(static_cast<int>(i)));
  }

  /// Lowers the numbers of all specs that have a part in what does not fit, until everything does.
  std::vector<int> fit() {
    for (std::set<int> misfits = find_misfits(); !misfits.empty(); misfits = find_misfits())
      for (const int spec : misfits) --counts_[spec];
    return counts_;
  }
  /// By spec: where its first number did not fit.
  const std::vector<std::optional<Vec2>>& places() const { return places_; }

 private:
  int first_count(int spec) {
    places_.emplace_back();
    if (!specs_[spec].many_as_fit) return asked_layers(specs_[spec]);
    double least = 1e300;
    for (const ColumnProbe& p : probes_) {
      if (p.front == spec) least = std::min(least, p.front_heights.back());
      if (p.back == spec) least = std::min(least, p.back_heights.back());
    }
    int count = 1;
    while (count < 1000 && layer_heights(specs_[spec], count + 1).back() < least) ++count;
    return count;
  }

  std::set<int> find_misfits() {
    std::vector<std::vector<double>> heights;
    for (std::size_t i = 0; i < specs_.size(); ++i)
      heights.push_back(counts_[i] > 0 ? layer_heights(specs_[i], counts_[i]) : std::vector<double>());
    struct Widest {
      InnerLine widest, narrowest;
      const ColumnProbe* narrow = nullptr;
    };
    std::set<int> misfits;
    std::map<int, std::map<std::pair<int, int>, Widest>> chords;
    for (const ColumnProbe& p : probes_) {
      const InnerLine rest = rest_of_probe(p, heights);
      if (greatest_change * rest.length < std::max(rest.ends.before, rest.ends.after)) {
        blame(p, misfits);
        continue;
      }
      Widest& w = chords[p.chord][{p.front, p.back}];
      if (!w.narrow || rest.length > w.widest.length) w.widest = rest;
      if (!w.narrow || rest.length < w.narrowest.length) w.narrowest = rest, w.narrow = &p;
    }
    for (const auto& [chord, kinds] : chords) {
      int count = 0;
      double growth = 2;
      for (const auto& [kind, w] : kinds) growth = std::min(growth, growth_of(kind));
      for (const auto& [kind, w] : kinds)
        count = std::max(count, w.widest.layers + sizing::least_graded_count(w.widest.ends, w.widest.length,
                                                                             w.widest.size, growth, max_intervals));
      for (const auto& [kind, w] : kinds)
        if (is_strict_ && is_crowded(w.narrowest, count, growth)) blame(*w.narrow, misfits);
    }
    return misfits;
  }

  double growth_of(const std::pair<int, int>& kind) const {
    const double front = growth_beyond(specs_[kind.first]);
    return kind.second < 0 ? front : std::min(front, growth_beyond(specs_[kind.second]));
  }

  static bool is_crowded(const InnerLine& rest, int count, double growth) {
    if (rest.ends.are_free()) return false;
    const std::vector<double> intervals =
        sizing::graded_intervals(rest.ends, count - rest.layers, rest.length, rest.size);
    return sizing::worst_growth(rest.ends, intervals) > (1 + 1e-6) * std::max(growth, greatest_change);
  }

  void blame(const ColumnProbe& probe, std::set<int>& misfits) {
    for (const int spec : {probe.front, probe.back})
      if (spec >= 0 && counts_[spec] > 0) {
        misfits.insert(spec);
        if (!places_[spec]) places_[spec] = probe.far_end;
      }
  }

  const std::vector<WallSpec>& specs_;
  const std::vector<ColumnProbe>& probes_;
  bool is_strict_;
  std::vector<int> counts_;
  std::vector<std::optional<Vec2>> places_;
};

}  // namespace

std::vector<ColumnProbe> probe_columns(const sizing::MeasuredLayout& measured, const WallSides& walls,
                                       const std::vector<double>& arc_sizes) {
  return Prober(measured, walls, arc_sizes).probe();
}

InnerLine rest_of_probe(const ColumnProbe& probe, const std::vector<std::vector<double>>& spec_heights) {
  InnerLine rest{{}, probe.lengths.back(), probe.size, 0};
  const auto take = [&](int spec, const std::vector<double>& line, const std::vector<double>& lengths, double& end) {
    if (spec < 0 || spec_heights[spec].empty() || rest.length < 0) return;
    const LayerRoom room = room_of(line, lengths, spec_heights[spec]);
    rest.layers += static_cast<int>(spec_heights[spec].size());
    rest.length = room.top < 0 ? -1 : rest.length - room.top;
    end = room.last;
  };
  take(probe.front, probe.front_heights, probe.lengths, rest.ends.before);
  take(probe.back, probe.back_heights, from_back(probe.lengths), rest.ends.after);
  return rest;
}

double growth_beyond(const WallSpec& spec) { return std::max(spec.growth, least_growth); }

std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<ColumnProbe>& probes,
                                Vec2 origin) {
  Fitter strict(specs, probes, true);
  std::vector<int> counts = strict.fit();
  std::vector<std::optional<Vec2>> places = strict.places();
  if (std::count(counts.begin(), counts.end(), 0) > 0) {
    // Where a chord is far wider in one place than in another no number of layers keeps its narrow places even.
    Fitter lenient(specs, probes, false);
    counts = lenient.fit();
    places = lenient.places();
  }
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const bool fits = counts[i] > 0 && (specs[i].many_as_fit || counts[i] == asked_layers(specs[i]));
    if (fits) continue;
    const Vec2 place = places[i].value_or(Vec2{}) + origin;
    const std::string most = counts[i] == 0 ? "not even one does"
                                            : fmt::format("at most {} do, with a thickness of {:.6g}", counts[i],
                                                          layer_heights(specs[i], counts[i]).back());
    throw ComputeError(fmt::format(
        "--wall {}: the layers do not fit into the blocks along the wall, which end at ({:.6g}, {:.6g}); {}",
        fmt::join(specs[i].names, ","), place.x, place.y, most));
  }
  return counts;
}

}  // namespace quadrille::layers
