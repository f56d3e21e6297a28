#pragma once
// A field on each region of its face: the regions do not know each other, and neither do their explicit terms.

#include <deque>
#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::draw {

struct RegionFields {
  explicit RegionFields(const Field& field);
  RegionFields(const RegionFields&) = delete;  // the evaluators refer to the fields

  std::vector<Field> fields;                     ///< one for each region
  std::deque<field::FieldEvaluator> evaluators;  ///< of these fields
};

}  // namespace quadrille::draw
