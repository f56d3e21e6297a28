#pragma once
// The field in pixels, region by region: coloured cells, crosses.

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "draw/picture.hpp"
#include "field/evaluate.hpp"

namespace quadrille::draw {

/// Paints every element with cells that are refined until `colour` is nearly constant over each or they are a few
/// pixels small. `difference` compares two values: above 1 the cell is split.
void draw_field_cells(Picture& picture, const field::FieldEvaluator& evaluator,
                      const std::function<std::string(Vec2 value)>& colour,
                      const std::function<double(Vec2 a, Vec2 b)>& difference);

/// Crosses on a lattice of `spacing` pixels, the same for all regions.
void draw_crosses(Picture& picture, const field::FieldEvaluator& evaluator, double spacing);

/// A field on each region of its face: the regions do not know each other, and neither do their explicit terms.
struct RegionFields {
  explicit RegionFields(const Field& field);
  RegionFields(const RegionFields&) = delete;  // the evaluators refer to the fields

  std::vector<Field> fields;                     ///< one for each region
  std::deque<field::FieldEvaluator> evaluators;  ///< of these fields
};

}  // namespace quadrille::draw
