#include "draw/field_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "regions/split.hpp"

namespace quadrille::draw {

namespace {

constexpr double smallest_cell = 5, largest_cell = 48;  // pixels
/// Enough for the widest picture. What is large even then is a folded element of a damaged file, and is left out.
constexpr int max_depth = 13;

/// xi moved slightly towards the centre: a lifting has no value at its apex.
Vec2 inside(Vec2 xi) {
  constexpr Vec2 middle{-1.0 / 3, -1.0 / 3};
  return xi + 1e-7 * (middle - xi);
}

struct Sampled {
  Vec2 xi, pixel, value;
};

Sampled sampled(const Picture& picture, const field::FieldEvaluator& evaluator, int elem, Vec2 xi) {
  Sampled s{xi, {}, {}};
  Mat2 dx_dxi;
  s.value = evaluator.value(elem, inside(xi), s.pixel, dx_dxi);
  s.pixel = picture.at(s.pixel);
  return s;
}

double longest_side(const std::array<Sampled, 3>& cell) {
  return std::max({distance(cell[0].pixel, cell[1].pixel), distance(cell[1].pixel, cell[2].pixel),
                   distance(cell[2].pixel, cell[0].pixel)});
}

/// Whether all corners lie beyond one and the same side of the drawing, or are not finite: parts of folded elements.
bool is_outside(const std::array<Sampled, 3>& cell, Vec2 size) {
  const auto all = [&](const auto& holds) {
    return std::all_of(cell.begin(), cell.end(), [&](const Sampled& s) { return holds(s.pixel); });
  };
  const bool is_finite = all([](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  return !is_finite || all([](Vec2 p) { return p.x < -largest_cell; }) ||
         all([](Vec2 p) { return p.y < -largest_cell; }) || all([&](Vec2 p) { return p.x > size.x + largest_cell; }) ||
         all([&](Vec2 p) { return p.y > size.y + largest_cell; });
}

struct CellPainter {
  const Picture& picture;
  const field::FieldEvaluator& evaluator;
  const std::function<std::string(Vec2)>& colour;
  const std::function<double(Vec2, Vec2)>& difference;
  std::map<std::string, std::string> paths;  ///< colour -> path data of its cells

  void paint(int elem, const std::array<Sampled, 3>& cell, int depth = 0) {
    if (is_outside(cell, picture.size())) return;
    const double size = longest_side(cell);
    const double change = std::max({difference(cell[0].value, cell[1].value), difference(cell[1].value, cell[2].value),
                                    difference(cell[2].value, cell[0].value)});
    const bool is_coarse = size > largest_cell || (size > smallest_cell && change > 1);
    if (is_coarse && depth < max_depth) return split(elem, cell, depth + 1);
    if (size > largest_cell) return;
    const Vec2 mean = (cell[0].value + cell[1].value + cell[2].value) / 3;
    PathData path(1);
    path.move_to(cell[0].pixel);
    path.relative_lines({cell[1].pixel - cell[0].pixel, cell[2].pixel - cell[1].pixel});
    path.close();
    paths[colour(mean)] += path.str();
  }

  void split(int elem, const std::array<Sampled, 3>& cell, int depth) {
    const auto middle = [&](int a, int b) {
      return sampled(picture, evaluator, elem, 0.5 * (cell[a].xi + cell[b].xi));
    };
    const Sampled m01 = middle(0, 1), m12 = middle(1, 2), m20 = middle(2, 0);
    paint(elem, {cell[0], m01, m20}, depth);
    paint(elem, {m01, cell[1], m12}, depth);
    paint(elem, {m20, m12, cell[2]}, depth);
    paint(elem, {m12, m20, m01}, depth);
  }
};

}  // namespace

void draw_field_cells(Picture& picture, const field::FieldEvaluator& evaluator,
                      const std::function<std::string(Vec2 value)>& colour,
                      const std::function<double(Vec2 a, Vec2 b)>& difference) {
  CellPainter painter{picture, evaluator, colour, difference, {}};
  const int num_elems = evaluator.field().mesh.num_elems();
  for (int e = 0; e < num_elems; ++e)
    painter.paint(e, {sampled(picture, evaluator, e, {-1, -1}), sampled(picture, evaluator, e, {1, -1}),
                      sampled(picture, evaluator, e, {-1, 1})});
  picture.open_group("cells");
  // The stroke in the cell's own colour closes the hairlines between cells.
  for (const auto& [fill, d] : painter.paths)
    picture.add(svg_element("path", {{"fill", fill}, {"stroke", fill}, {"d", d}}));
  picture.close_group();
}

void draw_crosses(Picture& picture, const field::FieldEvaluator& evaluator, double spacing) {
  constexpr double arm = 7;
  const Vec2 size = picture.size();
  const int nx = std::max(1, static_cast<int>(size.x / spacing)), ny = std::max(1, static_cast<int>(size.y / spacing));
  const Vec2 first = 0.5 * (size - spacing * Vec2{nx - 1.0, ny - 1.0});
  const Vec2 corner = picture.at({0, 0});
  const auto value_at = [&](Vec2 pixel, Vec2& value) {
    return evaluator.value_at((pixel - corner) / picture.scale(), value);
  };
  PathData path(1);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Vec2 pixel = first + spacing * Vec2{static_cast<double>(i), static_cast<double>(j)};
      Vec2 value, beside;
      if (!value_at(pixel, value) || norm(value) < 1e-6) continue;
      const Vec2 d = arm * unit(cross_angle(value)), e = left_of(d);
      // A cross that would extend beyond the face is omitted.
      if (!value_at(pixel + d, beside) || !value_at(pixel - d, beside) || !value_at(pixel + e, beside) ||
          !value_at(pixel - e, beside))
        continue;
      for (const Vec2 half : {d, e}) {
        path.move_to(pixel - half);
        path.line_to(pixel + half);
      }
    }
  if (!path.empty()) picture.add(path_element("cross", path.str()));
}

RegionFields::RegionFields(const Field& field) : fields(regions::split(field)) {
  for (const Field& part : fields) evaluators.emplace_back(part);
}

}  // namespace quadrille::draw
