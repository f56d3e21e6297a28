#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "draw/contour_lattice.hpp"
#include "draw/field_cells.hpp"
#include "draw/marks.hpp"

namespace quadrille::draw {

namespace {

constexpr double join_distance = 0.6;  // pixels

/// Joins segments whose ends lie within join_distance into polylines.
class Joiner {
 public:
  explicit Joiner(std::vector<ContourSegment> segments)
      : segments_(std::move(segments)), is_used_(segments_.size(), false) {
    for (std::size_t s = 0; s < segments_.size(); ++s)
      for (int e = 0; e < 2; ++e) cells_[cell(segments_[s].ends[e])].push_back({s, e});
  }

  std::vector<Polyline> polylines() {
    std::vector<Polyline> lines;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (is_used_[s]) continue;
      is_used_[s] = true;
      Polyline line{segments_[s].ends[1], segments_[s].ends[0]};
      while (extend(line)) continue;
      std::reverse(line.begin(), line.end());
      while (extend(line)) continue;
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  using Cell = std::pair<int, int>;
  static int cell(double x) { return static_cast<int>(std::clamp(std::floor(x), -1e9, 1e9)); }
  static Cell cell(Vec2 p) { return {cell(p.x), cell(p.y)}; }

  bool extend(Polyline& line) {
    const Vec2 tip = line.back();
    const Cell home = cell(tip);
    double nearest = join_distance;
    std::pair<std::size_t, int> best{segments_.size(), 0};
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        const auto found = cells_.find({home.first + i, home.second + j});
        if (found == cells_.end()) continue;
        for (const auto& [s, e] : found->second)
          if (!is_used_[s] && distance(tip, segments_[s].ends[e]) < nearest) {
            nearest = distance(tip, segments_[s].ends[e]);
            best = {s, e};
          }
      }
    if (best.first == segments_.size()) return false;
    is_used_[best.first] = true;
    line.push_back(segments_[best.first].ends[1 - best.second]);
    return true;
  }

  std::vector<ContourSegment> segments_;
  std::vector<bool> is_used_;
  std::map<Cell, std::vector<std::pair<std::size_t, int>>> cells_;
};

std::string path_of(const std::vector<Polyline>& lines) {
  PathData path(1);
  for (const Polyline& line : lines) {
    path.move_to(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) path.line_to(line[i]);
  }
  return path.str();
}

/// Cuts polylines at the points where `keep` changes and returns the parts where it is true.
std::vector<Polyline> parts_where(const std::vector<Polyline>& lines, const std::function<bool(Vec2)>& keep) {
  std::vector<Polyline> parts;
  for (const Polyline& line : lines) {
    bool is_open = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const bool kept = keep(0.5 * (line[i] + line[i + 1]));
      if (kept && !is_open) parts.push_back({line[i]});
      if (kept) parts.back().push_back(line[i + 1]);
      is_open = kept;
    }
  }
  return parts;
}

}  // namespace

std::vector<Polyline> zero_contours(const Picture& picture, const field::FieldEvaluator& evaluator,
                                    const Component& component) {
  std::vector<ContourSegment> segments;
  const auto append = [&](const std::vector<ContourSegment>& more) {
    segments.insert(segments.end(), more.begin(), more.end());
  };
  std::vector<std::array<SideSigns, 3>> sides;
  for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e) {
    ElementContour contour = element_contour(picture, evaluator, e, component);
    append(contour.segments);
    sides.push_back(std::move(contour.sides));
  }
  const auto& topology = evaluator.topology();
  for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k)
      if (const int other = topology.elem2neighbors[e][k]; other > e)
        append(side_contour(picture, evaluator, e, k, sides[e][k], sides[other][topology.elem2neighbor_edges[e][k]]));
  return Joiner(std::move(segments)).polylines();
}

void draw_zero_contours(Picture& picture, const RegionFields& regions) {
  std::vector<Polyline> u_zero, v_zero, v_jump;
  const auto append = [](std::vector<Polyline>& all, const std::vector<Polyline>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  const Vec2 corner = picture.at({0, 0});
  for (const field::FieldEvaluator& evaluator : regions.evaluators) {
    const auto jumps = [&](Vec2 pixel) {
      Vec2 value;
      return evaluator.value_at((pixel - corner) / picture.scale(), value) && value.x < 0;
    };
    append(u_zero, zero_contours(picture, evaluator, [](Vec2 value) { return value.x; }));
    const std::vector<Polyline> lines = zero_contours(picture, evaluator, [](Vec2 value) { return value.y; });
    append(v_zero, parts_where(lines, [&](Vec2 p) { return !jumps(p); }));
    append(v_jump, parts_where(lines, jumps));
  }
  const auto add = [&](const std::string& css_class, const std::vector<Polyline>& lines, const std::string& label) {
    if (lines.empty()) return;
    picture.add(svg_element("path", {{"class", css_class}, {"d", path_of(lines)}}, label));
    picture.legend_mark(svg_element("path", {{"class", css_class}, {"d", "M-9 0L9 0"}}), label);
  };
  add("zero-u", u_zero, "u = 0");
  add("zero-v", v_zero, "v = 0");
  add("jump", v_jump, "v = 0, the cross angle jumps");
}

}  // namespace quadrille::draw
