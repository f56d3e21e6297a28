#pragma once
// The solver formats, one row each. One source file per format implements its writer.

#include <string_view>
#include <vector>

#include "export/exported.hpp"
#include "export/patches.hpp"
#include "model/hex_mesh.hpp"
#include "model/length_scale.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// What a user can choose.
struct ExportOptions {
  ScaleRequest length{};                 ///< unit and factor of the coordinates
  bool in_space = false;                 ///< coordinates of the CAD model rather than of the face's plane
  std::vector<PatchType> patch_types{};  ///< of formats whose boundaries have types
  bool block_groups = false;  ///< each block without a name of its own is a region of its own (export/groups)
  bool merge_blocks = false;  ///< blocks of one region are joined (export/merge_blocks)
};

/// What the file has of each element.
enum class WrittenPieces {
  whole,          ///< the element itself
  between_nodes,  ///< elements of order 1 between its nodes
  quadratic,      ///< of a quad elements of order 1 or 2 between equal intervals, of a hexahedron the element
};

/// The nodes that the file has of an element of its own; readers make the others by blending (Gordon and Hall).
enum class WrittenNodes { all, sides, edges };

struct ExportFormat {
  std::string_view name;      ///< for --format
  std::string_view ending{};  ///< of file names; empty: by --format only
  std::string_view summary;   ///< for --help
  int max_order = 20;         ///< greater ones are refused before the writer is called
  bool holds_space = false;   ///< can be written with --frame 3d
  Exported (*write)(const QuadMesh& mesh, const Frame& frame) = nullptr;
  /// The same for a format whose boundaries have types; nullptr: they have none.
  Exported (*write_with_types)(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types) = nullptr;
  bool loses_periodic_sides = false;      ///< which export_mesh reports; the other writers report those that they lose
  std::vector<SideName> side_names = {};  ///< of files that may be written beside the main one
  bool has_straight_sides = false;        ///< whatever the order of the mesh
  Exported (*write_hex)(const HexMesh& mesh) = nullptr;  ///< nullptr: the format has no hexahedra
  Exported (*write_hex_with_types)(const HexMesh& mesh, const std::vector<PatchType>& types) = nullptr;
  int max_hex_order = 20;
  WrittenPieces pieces = WrittenPieces::whole;
  WrittenNodes written_nodes = WrittenNodes::all;
  /// A program in libexec that makes the file of what the writer returns; empty: that is the file.
  std::string_view program = {};
};

/// All formats of a quad mesh, in the order of the help.
const std::vector<ExportFormat>& export_formats();

/// The row of the format `name`; nullptr if no format has that name.
const ExportFormat* find_export_format(std::string_view name);

/// The first row whose ending the file name has; nullptr if no format has that ending.
const ExportFormat* export_format_of(std::string_view file_name);

/// Throws UsageError for a frame in space or types of boundaries that the format does not support.
void require_options(const ExportFormat& format, const ExportOptions& options);

/// Why a format without coordinates in space is refused for a curved face, and which are not.
std::string planar_format_text(const ExportFormat& format);

/// Writes the mesh. Throws ComputeError for an order that the format does not support, UsageError as require_options,
/// for a unit where that of the mesh is unknown, and for types of boundaries that the mesh does not have.
Exported export_mesh(QuadMesh mesh, const ExportFormat& format, const ExportOptions& options = {});

/// Throws UsageError for a format without hexahedra, naming those that have them, and for options of quads that do not
/// apply: a frame, groups of blocks, types of boundaries of a format without them.
void require_hex_options(const ExportFormat& format, const ExportOptions& options);

/// The same for hexahedra, whose options are `length` and those that require_hex_options accepts.
Exported export_mesh(HexMesh mesh, const ExportFormat& format, const ExportOptions& options = {});

}  // namespace quadrille::exports
