#pragma once
// draw_FORMAT.cpp defines picture_of(const Model&, const DrawOptions&) and instantiates draw_stage of its struct:
//   template std::string draw_stage(const QuadMesh&, const DrawOptions&);
// Private to those sources.

#include "draw/draw.hpp"

namespace quadrille::draw {

template <typename Model>
std::string draw_stage(const Model& model, const DrawOptions& options) {
  return picture_of(model, options);
}

}  // namespace quadrille::draw
