#pragma once
// A source of sheets defines sheet_of(const Model&, const PageFrame&) and instantiates stage_sheet of its struct:
//   template Sheet stage_sheet(const QuadMesh&, const PageFrame&);
// Private to those sources.

#include "page/sheet.hpp"

namespace quadrille::page {

template <typename Model>
Sheet stage_sheet(const Model& model, const PageFrame& frame) {
  return sheet_of(model, frame);
}

}  // namespace quadrille::page
