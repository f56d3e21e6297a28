#include "draw/zero_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "draw/field_cells.hpp"
#include "draw/marks.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

namespace {

struct ContourSettings {
  double step = 4;             ///< of the lattice, pixels
  int neighbourhood = 4;       ///< steps of the lattice
  double noise = 1e-7;         ///< of the solver: smaller values are none
  double least_value = 1e-13;  ///< in place of 0
  double join_distance = 0.6;  ///< of the ends of segments, pixels
};
constexpr ContourSettings contour_settings{};

bool is_finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// One element as the contour needs it.
struct Element {
  const Picture& picture;
  const field::FieldEvaluator& evaluator;
  const Component& component;
  int elem;

  /// The component, never zero; slightly inside, as a lifting has no value at its apex.
  double value(Vec2 xi) const {
    Vec2 x;
    Mat2 dx_dxi;
    const double f = component(evaluator.value(elem, xi + 1e-7 * (Vec2{-1.0 / 3, -1.0 / 3} - xi), x, dx_dxi));
    return std::abs(f) < contour_settings.least_value ? contour_settings.least_value : f;
  }

  Vec2 pixel(Vec2 xi) const { return picture.at(evaluator.maps()[elem].position(xi)); }

  /// Whether it lies beyond one side of the drawing: judged by points of its sides.
  bool is_outside() const {
    PictureBox box;
    for (int side = 0; side < 3; ++side)
      for (int k = 0; k < 8; ++k) box.include(pixel(spectral::tri_edge_point(side, k / 8.0)));
    const Vec2 end = picture.size(), margin = 0.1 * (box.upper - box.lower);
    return box.upper.x + margin.x < 0 || box.upper.y + margin.y < 0 || box.lower.x - margin.x > end.x ||
           box.lower.y - margin.y > end.y;
  }

  double size() const {
    const Vec2 a = pixel({-1, -1}), b = pixel({1, -1}), c = pixel({-1, 1});
    return std::max({distance(a, b), distance(b, c), distance(c, a)});
  }

  /// Where the component vanishes between two points with values of different sign, as a part of the way from a to b:
  /// regula falsi (Illinois), to far less than a pixel.
  double root(Vec2 a, double at_a, Vec2 b, double at_b) const {
    double low = 0, high = 1, t = 0.5;
    for (int i = 0, last_side = 0; i < 8; ++i) {
      t = (low * at_b - high * at_a) / (at_b - at_a);
      if (!(t >= 0 && t <= 1)) return 0.5;  // values that are not finite
      const double at_t = value(a + t * (b - a));
      if (std::abs(at_t) <= contour_settings.least_value) break;
      const int side = (at_t > 0) == (at_a > 0) ? 1 : -1;
      (side > 0 ? low : high) = t;
      (side > 0 ? at_a : at_b) = at_t;
      if (side == last_side) (side > 0 ? at_b : at_a) *= 0.5;
      last_side = side;
    }
    return t;
  }
};

/// Values on a lattice of n x n cells on the reference triangle.
class Lattice {
 public:
  explicit Lattice(const Element& element) : element_(element) {
    n_ = static_cast<int>(std::clamp(std::ceil(element.size() / contour_settings.step), 1.0, 200.0));
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) {
        points_.push_back({2.0 * i / n_ - 1, 2.0 * j / n_ - 1});
        values_.push_back(element.value(points_.back()));
      }
    mark_significant();
  }

  std::vector<ContourSegment> segments() const {
    std::vector<ContourSegment> segments;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        add_cell({id(i, j), id(i + 1, j), id(i, j + 1)}, segments);
        if (i + j + 1 < n_) add_cell({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}, segments);
      }
    return segments;
  }

  SideSigns side(int side) const {
    SideSigns signs;
    signs.is_positive = values_[side_id(side, 0)] > 0;
    for (int k = 0; k < n_; ++k) {
      const int a = side_id(side, k), b = side_id(side, k + 1);
      signs.is_significant.push_back(is_significant_[a] || is_significant_[b]);
      if (!changes_sign(a, b)) continue;
      const double t = root(std::min(a, b), std::max(a, b));
      signs.roots.push_back((k + (a < b ? t : 1 - t)) / n_);
    }
    return signs;
  }

 private:
  int id(int i, int j) const { return j * (n_ + 1) - j * (j - 1) / 2 + i; }
  int side_id(int side, int k) const { return side == 0 ? id(k, 0) : side == 1 ? id(n_ - k, k) : id(0, n_ - k); }
  bool changes_sign(int a, int b) const { return (values_[a] > 0) != (values_[b] > 0); }
  double root(int a, int b) const { return element_.root(points_[a], values_[a], points_[b], values_[b]); }

  /// Also the neighbours of significant points: a zero of high order has a small neighbourhood below the
  /// contour_settings.noise.
  void mark_significant() {
    is_significant_.assign(values_.size(), false);
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) {
        if (std::abs(values_[id(i, j)]) < contour_settings.noise) continue;
        for (int l = std::max(0, j - contour_settings.neighbourhood);
             l <= std::min(n_, j + contour_settings.neighbourhood); ++l)
          for (int k = std::max(0, i - contour_settings.neighbourhood);
               k <= std::min(n_ - l, i + contour_settings.neighbourhood); ++k)
            is_significant_[id(k, l)] = true;
      }
  }

  void add_cell(const std::array<int, 3>& corners, std::vector<ContourSegment>& segments) const {
    if (std::none_of(corners.begin(), corners.end(), [&](int i) { return is_significant_[i]; })) return;
    std::array<Vec2, 2> ends;
    int num_ends = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(corners[k], corners[(k + 1) % 3]), b = std::max(corners[k], corners[(k + 1) % 3]);
      if (changes_sign(a, b)) ends[num_ends++] = element_.pixel(points_[a] + root(a, b) * (points_[b] - points_[a]));
    }
    if (num_ends == 2 && is_finite(ends[0]) && is_finite(ends[1])) segments.push_back({ends});
  }

  const Element& element_;
  int n_ = 1;
  std::vector<Vec2> points_;
  std::vector<double> values_;
  std::vector<bool> is_significant_;
};

/// Joins segments whose ends nearly meet into polylines.
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
    double nearest = contour_settings.join_distance;
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

bool SideSigns::is_positive_at(double s) const {
  const auto num_roots = std::lower_bound(roots.begin(), roots.end(), s) - roots.begin();
  return is_positive == (num_roots % 2 == 0);
}

bool SideSigns::is_significant_at(double s) const {
  const double piece = std::floor(s * static_cast<double>(is_significant.size()));
  return is_significant[std::min(static_cast<std::size_t>(std::max(piece, 0.0)), is_significant.size() - 1)];
}

ElementContour element_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                               const Component& component) {
  const Element element{picture, evaluator, component, elem};
  if (picture.is_window() && element.is_outside()) return {};
  const Lattice lattice(element);
  return {lattice.segments(), {lattice.side(0), lattice.side(1), lattice.side(2)}};
}

std::vector<ContourSegment> side_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                                         int side, const SideSigns& own, const SideSigns& other) {
  if (own.is_significant.empty() || other.is_significant.empty()) return {};  // outside the picture
  std::vector<double> cuts = own.roots;
  for (const double s : other.roots) cuts.push_back(1 - s);
  for (std::size_t k = 0; k <= own.is_significant.size(); ++k)
    cuts.push_back(static_cast<double>(k) / static_cast<double>(own.is_significant.size()));
  std::sort(cuts.begin(), cuts.end());
  const auto pixel = [&](double s) {
    return picture.at(evaluator.maps()[elem].position(spectral::tri_edge_point(side, s)));
  };
  std::vector<ContourSegment> segments;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (!(cuts[i] < cuts[i + 1]) || own.is_positive_at(middle) == other.is_positive_at(1 - middle)) continue;
    if (!own.is_significant_at(middle) || !other.is_significant_at(1 - middle)) continue;
    const ContourSegment segment{{pixel(cuts[i]), pixel(cuts[i + 1])}};
    if (is_finite(segment.ends[0]) && is_finite(segment.ends[1])) segments.push_back(segment);
  }
  return segments;
}

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
    picture.add(path_element(css_class, path_of(lines), label));
    picture.legend_mark(path_element(css_class, "M-9 0L9 0"), label);
  };
  add("zero-u", u_zero, "u = 0");
  add("zero-v", v_zero, "v = 0");
  add("jump", v_jump, "v = 0, the cross angle jumps");
}

}  // namespace quadrille::draw
