#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "draw/field_cells.hpp"
#include "draw/marks.hpp"

namespace quadrille::draw {

namespace {

constexpr double lattice_step = 4;  // pixels
constexpr double join_distance = 0.6;
/// Where a component stays below it over a whole cell, the component is identically zero up to solver errors.
constexpr double noise = 1e-7;
constexpr double least_value = 1e-13;

struct Segment {
  std::array<Vec2, 2> ends;
};

bool is_finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// A lattice of n x n cells on the reference triangle of one element.
class Lattice {
 public:
  Lattice(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
          const std::function<double(Vec2)>& component) {
    const auto pixel_of = [&](Vec2 xi) { return picture.at(evaluator.maps()[elem].position(xi)); };
    const Vec2 a = pixel_of({-1, -1}), b = pixel_of({1, -1}), c = pixel_of({-1, 1});
    const double size = std::max({distance(a, b), distance(b, c), distance(c, a)});
    n_ = static_cast<int>(std::clamp(std::ceil(size / lattice_step), 1.0, 200.0));
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) {
        const Vec2 xi{2.0 * i / n_ - 1, 2.0 * j / n_ - 1};
        Vec2 x;
        Mat2 dx_dxi;
        const double value = component(evaluator.value(elem, xi + 1e-7 * (Vec2{-1.0 / 3, -1.0 / 3} - xi), x, dx_dxi));
        pixels_.push_back(picture.at(x));
        values_.push_back(std::abs(value) < least_value ? least_value : value);
      }
  }

  void contour(std::vector<Segment>& segments) const {
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        cell({id(i, j), id(i + 1, j), id(i, j + 1)}, segments);
        if (i + j + 1 < n_) cell({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}, segments);
      }
  }

 private:
  int id(int i, int j) const { return j * (n_ + 1) - j * (j - 1) / 2 + i; }

  void cell(const std::array<int, 3>& corners, std::vector<Segment>& segments) const {
    std::array<Vec2, 2> ends;
    int num_ends = 0;
    const auto is_noise = [&](int i) { return std::abs(values_[i]) < noise; };
    if (std::all_of(corners.begin(), corners.end(), is_noise)) return;
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(corners[k], corners[(k + 1) % 3]), b = std::max(corners[k], corners[(k + 1) % 3]);
      if ((values_[a] > 0) == (values_[b] > 0)) continue;
      const double s = values_[a] / (values_[a] - values_[b]);
      ends[num_ends++] = pixels_[a] + s * (pixels_[b] - pixels_[a]);
    }
    if (num_ends == 2 && is_finite(ends[0]) && is_finite(ends[1])) segments.push_back({ends});
  }

  int n_ = 1;
  std::vector<Vec2> pixels_;
  std::vector<double> values_;
};

/// Joins segments whose ends lie within join_distance into polylines.
class Joiner {
 public:
  explicit Joiner(std::vector<Segment> segments) : segments_(std::move(segments)), is_used_(segments_.size(), false) {
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

  std::vector<Segment> segments_;
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
                                    const std::function<double(Vec2 value)>& component) {
  std::vector<Segment> segments;
  for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e)
    Lattice(picture, evaluator, e, component).contour(segments);
  return Joiner(std::move(segments)).polylines();
}

void draw_zero_contours(Picture& picture, const field::FieldEvaluator& evaluator) {
  const auto u_zero = zero_contours(picture, evaluator, [](Vec2 value) { return value.x; });
  const auto v_zero = zero_contours(picture, evaluator, [](Vec2 value) { return value.y; });
  const Vec2 corner = picture.at({0, 0});
  const auto jumps = [&](Vec2 pixel) {
    Vec2 value;
    return evaluator.value_at((pixel - corner) / picture.scale(), value) && value.x < 0;
  };
  const auto add = [&](const std::string& css_class, const std::vector<Polyline>& lines, const std::string& label) {
    if (lines.empty()) return;
    picture.add(svg_element("path", {{"class", css_class}, {"d", path_of(lines)}}, label));
    picture.legend_mark(svg_element("path", {{"class", css_class}, {"d", "M-9 0L9 0"}}), label);
  };
  add("zero-u", u_zero, "u = 0");
  add("zero-v", parts_where(v_zero, [&](Vec2 p) { return !jumps(p); }), "v = 0");
  add("jump", parts_where(v_zero, jumps), "v = 0, the cross angle jumps");
}

}  // namespace quadrille::draw
