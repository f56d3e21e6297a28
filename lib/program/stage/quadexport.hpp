#pragma once
// The stage quadexport: a quad mesh, the blocks it was made from, or hexahedra, in the formats of other programs.

#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "model/cad_face.hpp"
#include "model/hex_mesh.hpp"
#include "model/length_scale.hpp"
#include "model/quad_mesh.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct QuadexportOptions {
  std::string format = "auto";           ///< a name of export/format_table, or "step"; auto: from the output's name
  std::string frame = "2d";              ///< "3d": coordinates of the CAD model
  std::vector<std::string> patch_types;  ///< NAME=TYPE
  std::string translation;               ///< "X,Y" or "X,Y,Z", lengths of the CAD file; empty: none
  std::string check_for = "none";        ///< a name of stage/solver_table: measure the mesh as that program does
  ScaleRequest length;                   ///< unit and factor of the coordinates
  bool block_groups = false;             ///< each block without a name is a region of its own
  bool merge_blocks = false;             ///< blocks of one region are joined to the fewest grids
  bool allow_invalid = false;            ///< export a mesh that is marked as not valid
};
void declare(Options& options, QuadexportOptions& quadexport);

/// The name of the format for the file `output` ("-": standard output). Throws UsageError if its name does not
/// determine one, and for options that are wrong or that the format, or the program of --check-for, does not support.
std::string format_of(const std::string& output, const QuadexportOptions& options);

/// Paths of the files that may be written beside `output`. Throws UsageError as format_of.
std::vector<std::string> side_paths(const std::string& output, const QuadexportOptions& options);

/// Whether the format `name` has elements with straight sides alone.
bool has_straight_sides(const std::string& format);

/// Throws UsageError if the format `name`, or the program of --check-for, does not support quads of this order, before
/// there is a mesh.
void require_order(const std::string& format, int order, const QuadexportOptions& options);

/// The same for hexahedra; also for formats without hexahedra, and for options that do not apply to them.
void require_hexahedra(const std::string& format, int order, const QuadexportOptions& options);

/// Throws UsageError if the format `name` supports meshes of the plane only, for a curved face, before there is a
/// chart.
void require_format_in_space(const std::string& format);

/// Throws UsageError for a unit or names of boundaries that do not fit the face, and a format of `output` that does not
/// support it, before there is a mesh.
void require_quadexport_of(const CadFace& face, const std::string& output, const QuadexportOptions& options);

struct OutputFile {
  std::string path, bytes;
  bool is_binary = false;
};

/// The files of the mesh, the one at `output` last. Beside standard output, a pipe or a device there are no others: a
/// warning is given for each. So it is for properties that the format cannot represent. `file`: of the mesh, for
/// messages. Throws FormatError if the mesh breaks a rule, ComputeError if it is marked as not valid, the format does
/// not support its order, or it reaches a limit of --check-for, UsageError as above. The phase `write` goes on, for the
/// caller who writes the files.
std::vector<OutputFile> quadexport(QuadMesh mesh, const std::string& file, const std::string& output,
                                   const QuadexportOptions& options, Run& run);

/// The same of a hexahedral mesh; UsageError also for a format without hexahedra, and for options of quads.
std::vector<OutputFile> quadexport(HexMesh mesh, const std::string& file, const std::string& output,
                                   const QuadexportOptions& options, Run& run);

/// The blocks of a block layout, given as the bytes of its file, as a STEP model: made by a program with the CAD kernel
/// (export/step_request.hpp). Throws FormatError if the layout breaks a rule, UsageError as above.
OutputFile quadexport_step(const Input<std::string>& blocks, const std::string& output,
                           const QuadexportOptions& options, Run& run);

}  // namespace quadrille::stage
