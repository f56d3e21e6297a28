#pragma once
// A mesh of a separatrix graph, for tests of what reads or changes meshes.

#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"

namespace quadrille {

inline QuadMesh refined(const SeparatrixGraph& graph, const refine::RefineOptions& options) {
  Report report;
  return refine::refine(block::extract_blocks(graph, report), options, report);
}

}  // namespace quadrille
