#pragma once
// The stages of the chain in their order, and the files that they write.

#include <array>
#include <string>

#include "base/enum_names.hpp"

namespace quadrille::chain {

enum class ChainStage { cad2tri, fieldsolve, padapt, critpoints, separatrix, blocksplit, quadrefine, quadexport };
constexpr auto enum_names(ChainStage) {
  return std::to_array<EnumName<ChainStage>>({{ChainStage::cad2tri, "cad2tri"},
                                              {ChainStage::fieldsolve, "fieldsolve"},
                                              {ChainStage::padapt, "padapt"},
                                              {ChainStage::critpoints, "critpoints"},
                                              {ChainStage::separatrix, "separatrix"},
                                              {ChainStage::blocksplit, "blocksplit"},
                                              {ChainStage::quadrefine, "quadrefine"},
                                              {ChainStage::quadexport, "quadexport"}});
}
constexpr int num_stages = 8;

/// Whether a stage comes before another one in the chain.
constexpr bool is_before(ChainStage stage, ChainStage other) {
  return static_cast<int>(stage) < static_cast<int>(other);
}

/// "tri.h5" of SHAPE.tri.h5; nothing for quadexport.
constexpr std::array<const char*, num_stages> stage_endings{"tri.h5",   "solve.h5",  "field.h5", "crit.json",
                                                            "sep.json", "blocks.h5", "quad.h5",  ""};

inline std::string ending_of(ChainStage stage) { return stage_endings.at(static_cast<std::size_t>(stage)); }

}  // namespace quadrille::chain
