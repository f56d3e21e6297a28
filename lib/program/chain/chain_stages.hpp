#pragma once
// The stages of the chain in their order, and the files that they write.

#include <array>
#include <string>

#include "base/enum_names.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::chain {

enum class ChainStage { cad2tri, fieldsolve, padapt, critpoints, separatrix, blocksplit, quadrefine, quadexport };
constexpr auto enum_names(ChainStage) {
  return std::to_array(
      {"cad2tri", "fieldsolve", "padapt", "critpoints", "separatrix", "blocksplit", "quadrefine", "quadexport"});
}
constexpr int num_stages = 8;

/// Whether a stage comes before another one in the chain.
constexpr bool is_before(ChainStage stage, ChainStage other) {
  return static_cast<int>(stage) < static_cast<int>(other);
}

/// "tri.h5" of SHAPE.tri.h5; nothing for quadexport.
inline std::string ending_of(ChainStage stage) { return std::string(find_stage_tool(enum_name(stage))->ending); }

}  // namespace quadrille::chain
