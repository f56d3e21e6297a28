#pragma once
// The one table of formats and stages: their names, versions, endings, tools and order. What differs between formats in
// code is a function of the struct's type: io::read_stage, check::check_stage, draw::draw_stage, page::stage_sheet.
// `stagecheck --list-formats` prints the table for scripts.

#include <array>
#include <string_view>
#include <utility>
#include <variant>

#include "model/block_layout.hpp"
#include "model/charted_face.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille {

/// What a stage file holds.
using StageModel =
    std::variant<ChartedFace, TriMesh, Field, CriticalPoints, SeparatrixGraph, BlockLayout, QuadMesh, HexMesh>;

enum class Storage { hdf5, json };

struct StageFormat {
  const char* name;  ///< `format` in the file and stem of the page: "tri-mesh"
  int major, minor;  ///< version that is written; readers accept any minor one of this major version
  Storage storage;
};

/// The formats of the alternatives of StageModel.
constexpr auto stage_formats = std::to_array<StageFormat>({
    {"chart", 1, 0, Storage::hdf5},
    {"tri-mesh", 1, 5, Storage::hdf5},
    {"field", 2, 4, Storage::hdf5},
    {"critical-points", 2, 3, Storage::json},
    {"separatrix-graph", 2, 5, Storage::json},
    {"block-layout", 2, 1, Storage::hdf5},
    {"quad-mesh", 2, 2, Storage::hdf5},
    {"hex-mesh", 1, 0, Storage::hdf5},
});
static_assert(stage_formats.size() == std::variant_size_v<StageModel>);

/// The row of one alternative of StageModel.
template <typename Model>
constexpr const StageFormat& format_of() {
  constexpr std::size_t row = []<std::size_t... I>(std::index_sequence<I...>) {
    return ((std::is_same_v<Model, std::variant_alternative_t<I, StageModel>> ? I : 0) + ...);
  }
  (std::make_index_sequence<stage_formats.size()>());
  static_assert(std::is_same_v<Model, std::variant_alternative_t<row, StageModel>>);
  return stage_formats[row];
}

/// The provenance of a stage.
inline const Provenance& provenance_of(const StageModel& stage) {
  return std::visit([](const auto& model) -> const Provenance& { return model.provenance; }, stage);
}

/// A tool that reads what others wrote.
struct StageTool {
  std::string_view name;
  std::string_view after;   ///< the tool whose file it reads first; empty: it reads a CAD file (cad2tri: or a chart)
  std::string_view writes;  ///< a format of stage_formats; empty: formats of other programs
  std::string_view ending;  ///< "tri.h5" of SHAPE.tri.h5
};

/// In the order of the chain.
constexpr auto stage_tools = std::to_array<StageTool>({
    {"cad2chart", "", "chart", "chart.h5"},
    {"cad2tri", "", "tri-mesh", "tri.h5"},
    {"fieldsolve", "cad2tri", "field", "solve.h5"},
    {"padapt", "fieldsolve", "field", "field.h5"},
    {"critpoints", "padapt", "critical-points", "crit.json"},
    {"separatrix", "critpoints", "separatrix-graph", "sep.json"},
    {"blocksplit", "separatrix", "block-layout", "blocks.h5"},
    {"quadrefine", "blocksplit", "quad-mesh", "quad.h5"},
    {"hexsweep", "quadrefine", "hex-mesh", "hex.h5"},
    {"quadexport", "quadrefine", "", ""},
});

/// The row of a tool; nullptr if it is no stage.
constexpr const StageTool* find_stage_tool(std::string_view name) {
  for (const StageTool& tool : stage_tools)
    if (tool.name == name) return &tool;
  return nullptr;
}

/// A file that a tool reads by an option, beside that of the tool before it.
struct OptionalInput {
  std::string_view tool, option, format;
  std::string_view ending;  ///< by which commands for a shell name it
};
constexpr auto optional_inputs = std::to_array<OptionalInput>({
    {"cad2tri", "--boundary-names", "boundary-names", "boundary-names"},
    {"fieldsolve", "--nodes", "critical-points", "crit.json"},
    {"fieldsolve", "--orders", "field", "orders.h5"},
    {"fieldsolve", "--orders", "order-map", "orders.json"},
    {"fieldsolve", "--align", "alignment", "align.json"},
    {"blocksplit", "--block-names", "block-names", "block-names"},
    {"quadrefine", "--size-field", "size-field", "size-field"},
    {"quadrefine", "--metric", "metric", "metric.csv"},
    {"quadrefine", "--align", "alignment", "align.json"},
    {"hexsweep", "--curve", "curve", "curve.csv"},
    {"hexsweep", "--terrain", "terrain", "terrain.csv"},
});

}  // namespace quadrille
