#pragma once
// The requirements on the divisions of arcs.

namespace quadrille::refine {

struct DivideOptions {
  int order = 4;         ///< N, of the elements
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, a length
};

}  // namespace quadrille::refine
