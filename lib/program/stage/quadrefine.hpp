#pragma once
// The stage quadrefine: the quads of a block layout.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "layers/wall_spec.hpp"
#include "model/block_layout.hpp"
#include "model/given_metric.hpp"
#include "model/quad_mesh.hpp"
#include "refine/refine_options.hpp"
#include "sizing/make_size_field.hpp"
#include "stage/given_positions.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

/// The options as a user gives them. Members of `refine` and `sizes` that follow from texts and files are not used.
struct QuadrefineOptions {
  refine::RefineOptions refine;
  sizing::SizeOptions sizes;
  std::string per_curve = "auto";
  std::string relax = "size";
  std::vector<std::string> near;      ///< NAME=H[:H2]
  std::vector<std::string> symmetry;  ///< names or patterns (stage/symmetry_option.hpp)
  std::vector<std::string> counts;    ///< CHORD=N or NAME=N
  std::vector<std::string> gradings;  ///< NAME=FIRST:LAST
  std::string size_field_file;        ///< path of prescribed sizes, which the caller reads
  std::string metric_file;            ///< path of a metric, which the caller reads
  std::string align_file;             ///< path of directions to align with, which the caller reads
  double align_strength = 1;          ///< over that of each feature of the file, >= 0
  std::vector<std::string> walls;     ///< NAME:first=H,growth=R,layers=N
  double yplus = 0;                   ///< of walls without first and yplus; 0: none
  layers::PlateFlow flow;
  std::string flow_unit = "file";   ///< length unit of `flow`
  std::string blocks;               ///< numbers or names; empty: all
  bool has_straight_sides = false;  ///< sides of elements will be straight: along walls they are short
  bool is_trial = false;            ///< no option of a command: a mesh that is not proved valid is no failure
  JoinPoints join_points = {};      ///< no option of a command; without it, tables of sizes are refused

  /// What can be refused without a face. Throws UsageError.
  void validate() const;
};
void declare(Options& options, QuadrefineOptions& quadrefine);

/// What the mesh is made from. Files as read: stage/given_positions.hpp puts their positions on the face.
struct QuadrefineInput {
  Input<BlockLayout> layout;
  std::optional<Input<SizeSources>> sizes = {};
  std::optional<Input<GivenMetric>> metric = {};
  std::optional<Input<GivenAlignment>> alignment = {};  ///< directions that sides of elements follow
};

/// The proved mesh (refine/refine.hpp). Throws FormatError if the layout breaks a rule of its format, UsageError for
/// options outside their intervals or names that nothing has, ComputeError as refine::refine.
QuadMesh quadrefine(const QuadrefineInput& input, const QuadrefineOptions& options, Run& run);

/// Before there are blocks: throws UsageError if the face lacks what the options name, ComputeError if the mesh would
/// have far too many elements.
void require_quadrefine_of(const CadFace& face, const SizeSources& sources, const GivenMetric& metric,
                           const QuadrefineOptions& options);

/// "NAMES=T" for each wall that shall have blocks of its own: cad2tri --offset makes their curves. Throws UsageError.
std::vector<std::string> offsets_of(const QuadrefineOptions& options);

/// "NAME=T" for critpoints --clearance: the room that layers without blocks of their own need below the irregular
/// nodes. Not of walls on one side of an interface, from which nodes keep away on both. Throws UsageError.
std::vector<std::string> clearances_of(const QuadrefineOptions& options);

}  // namespace quadrille::stage
