#pragma once
// The rectangle [0, columns] x [0, rows] in unit squares, with straight arcs between neighbouring nodes.

#include <cmath>

#include "../hand_made.hpp"

namespace quadrille {

inline SeparatrixGraph grid_layout(int columns, int rows) {
  const double w = columns, h = rows;
  SeparatrixGraph g;
  g.face = hand_made::face({{curve::segment({0, 0}, {w, 0}), curve::segment({w, 0}, {w, h}),
                             curve::segment({w, h}, {0, h}), curve::segment({0, h}, {0, 0})}},
                           std::hypot(w, h));
  const auto number = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const bool is_side = i == 0 || i == columns, is_floor = j == 0 || j == rows;
      const int curve = j == 0 && i < columns      ? 0
                        : i == columns && j < rows ? 1
                        : j == rows && i > 0       ? 2
                        : i == 0                   ? 3
                                                   : -1;
      const double t = curve == 0 ? i : curve == 1 ? j : curve == 2 ? columns - i : rows - j;
      const Vec2 x{static_cast<double>(i), static_cast<double>(j)};
      if (is_side && is_floor)
        hand_made::add_node(g, x, NodeKind::corner, 1, curve, 0);
      else if (is_side || is_floor)
        hand_made::add_node(g, x, NodeKind::boundary, 2, curve, t);
      else
        hand_made::add_node(g, x, NodeKind::crossing, 4);
    }
  for (int i = 0; i < columns; ++i) {
    hand_made::add_arc(g, number(i, 0), number(i + 1, 0), true, {{0, i + 0.0, i + 1.0}});
    hand_made::add_arc(g, number(i + 1, rows), number(i, rows), true, {{2, w - i - 1, w - i}});
    for (int j = 1; j < rows; ++j) hand_made::add_cut(g, number(i, j), number(i + 1, j));
  }
  for (int j = 0; j < rows; ++j) {
    hand_made::add_arc(g, number(columns, j), number(columns, j + 1), true, {{1, j + 0.0, j + 1.0}});
    hand_made::add_arc(g, number(0, j + 1), number(0, j), true, {{3, h - j - 1, h - j}});
    for (int i = 1; i < columns; ++i) hand_made::add_cut(g, number(i, j), number(i, j + 1));
  }
  return g;
}

}  // namespace quadrille
