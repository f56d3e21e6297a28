#pragma once
// The stage cad2tri: the face of a CAD file, named, with its periodic sides and offset curves, and its triangle mesh.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "cad/loaded_face.hpp"
#include "model/charted_face.hpp"
#include "model/name_rules.hpp"
#include "model/tri_mesh.hpp"
#include "outline/face_of_loops.hpp"
#include "stage/stage_input.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::stage {

struct Cad2triOptions {
  /// "all", "planar", "curved": the caller writes a table of these faces (list_faces), not a mesh; empty: a mesh.
  std::string listed;
  std::string face;         ///< number or name of the one face to read; empty: the only one, or all
  std::string section;      ///< a plane that cuts solids, as cad::section_plane reads it; empty: none
  double corner_angle = 1;  ///< degrees; greater tangent jumps are corners of the layout
  double polyline_angle = outline::greatest_polyline_kink;  ///< degrees; smaller kinks inside polylines are no corners
  double heal_tolerance = -1;                ///< diameters; -1: 1e-5, or the tolerances of the shape if larger
  std::string blunt = "auto";                ///< length of the edge at a blunted cusp; 0: cusps are refused
  double fit_tolerance = 1e-8;               ///< diameters, for splines with many breaks; 0: they stay
  std::string healed_file;                   ///< path of the healed face, which the caller writes: cad_file_of
  triangulate::TriangulateOptions elements;  ///< order, size and grading
  std::string names_file;                    ///< path of names of boundaries, which the caller reads
  std::vector<std::string> curve_names;      ///< NAME=LIST or NAME@X,Y
  std::vector<std::string> region_names;     ///< likewise
  bool keep_joints = false;                  ///< regions that region_names give one name stay apart
  std::vector<std::string> periodic;         ///< A=B or A=B:MOTION
  std::vector<std::string> offsets;          ///< NAME=T
  std::vector<std::string> symmetry;         ///< names or patterns (stage/symmetry_option.hpp): offset curves end there

  void validate() const;  ///< throws UsageError for texts that mean nothing, and for options that exclude each other
};
void declare(Options& options, Cad2triOptions& cad2tri);

/// The bytes of a CAD file (STEP, IGES or BREP), and new names of its curves.
struct Cad2triInput {
  Input<std::string> cad;
  std::optional<Input<std::vector<NameRule>>> names;  ///< those of Cad2triOptions::curve_names override them
  std::optional<Input<ChartedFace>> chart = {};       ///< in place of `cad`: what the file holds, x.chart.h5
  std::optional<cad::LoadedFace> face = {};           ///< what read_any_face has read of `cad`
};

/// Reads the chosen face of a CAD file, whether it is planar, for load_shape, or curved, for stage/cad2chart.
cad::AnyFace read_any_face(const Input<std::string>& cad, const Cad2triOptions& options, Run& run);

/// A face that was read, what healing changed, and the digests of its files.
struct LoadedShape : cad::LoadedFace {
  std::vector<InputDigest> inputs;
  Provenance before = {};  ///< of a chart, or of a STEP file that says how it was made
};

/// Reads the face in a program with the CAD kernel (cad/load_face.hpp), names regions and curves, pairs periodic sides
/// and embeds offset curves. Reports what the face has and what was healed. Throws UsageError for options that are
/// wrong or do not fit the face, FormatError for a file without a valid planar face, ComputeError for offset curves
/// that do not fit. The face of a chart is taken as it is, with new names: options that change curves are refused.
LoadedShape load_shape(const Cad2triInput& input, const Cad2triOptions& options, Run& run);

/// The mesh of the face (stage/triangulate_face.hpp), with repairs and provenance.
TriMesh cad2tri(const LoadedShape& shape, const Cad2triOptions& options, Run& run);

/// Both after each other.
TriMesh cad2tri(const Cad2triInput& input, const Cad2triOptions& options, Run& run);

/// The table of the faces of a CAD file and their edges (cad/load_face.hpp), which are reported too; of a section if
/// options.section is a plane.
std::string list_faces(const Input<std::string>& file, const Cad2triOptions& options, Run& run);

/// The face as the bytes of a CAD file, in the format that the ending of `path` means: .step, .stp or .brep. Throws
/// UsageError for other endings.
std::string cad_file_of(const CadFace& face, const std::string& path);

}  // namespace quadrille::stage
