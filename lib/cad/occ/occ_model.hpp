#pragma once
// The contents of a CAD file as an OpenCASCADE shape with labels, in the length unit of the file.

#include <IGESData_IGESModel.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_TransientProcess.hxx>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "occ/kernel_format.hpp"

namespace quadrille::occ {

/// The labels of a face or an edge; empty if the file states none.
struct ShapeLabel {
  std::string name;
  std::string layer;
  std::string colour;  ///< "ff0000" for red
};

/// The labels of a shape that holds faces: a shell, a solid, a part of an assembly.
struct PartLabel {
  std::vector<std::string> names;  ///< outermost first: a product and its only solid are one shape
  std::string layer;               ///< empty if the file assigns none
};

struct OccModel {
  TopoDS_Shape shape;                   ///< all entities of the file
  std::string length_unit = "unknown";  ///< lower case
  double metres_per_unit = 0;
  double tolerance = 1e-7;  ///< tolerance stated by the file, in its length unit
  int num_faces = 0;        ///< faces that the file describes, including those that could not be built
  int num_solids = 0;
  std::vector<std::string> not_built;  ///< faces, or what holds them, that could not be built: "#40 'lid'"
  /// Uses of edges by the loops of each face, as stated by the file, with the keys of `labels`; empty if unknown.
  std::map<const TopoDS_TShape*, int> num_edges;
  /// Labels of faces and edges. The key is the TShape that OpenCASCADE shares among all uses of a shape; the stored
  /// shape keeps it alive.
  std::map<const TopoDS_TShape*, std::pair<TopoDS_Shape, ShapeLabel>> labels;

  /// Labels of shells, solids and assembled parts that have any, with keys as above.
  std::map<const TopoDS_TShape*, PartLabel> parts;

  /// The label of `part`, independent of its orientation and location.
  ShapeLabel label_of(const TopoDS_Shape& part) const {
    const auto found = labels.find(part.TShape().get());
    return found == labels.end() ? ShapeLabel() : found->second.second;
  }
};

// Reads the labels (name, layer, colour) of faces, edges and the parts that hold faces, directly from the entities of
// the file. An XCAF document is not used, because its libraries would slow down every start. One source file for each
// format.

/// The name that a string entity states, cleaned. Empty for what programs write where nobody gave a name: NONE, and
/// OpenCASCADE's names for products and references ("Open CASCADE STEP translator 7.6 4.1", "=>[0:1:1:2]").
std::string given_name(const Handle(TCollection_HAsciiString) & text);

/// Fills model.labels from `file`; `process` is the transfer of the file to shapes. The name of a
/// label is read from FACE_SURFACE or EDGE_CURVE, its layer from the first PRESENTATION_LAYER_ASSIGNMENT that lists the
/// entity, its curve or a STYLED_ITEM of it, and its colour from the CURVE_STYLE of the STYLED_ITEM of the entity, or
/// of an overriding STYLED_ITEM if there is one. Fills model.parts with the names of products, and the names and layers
/// of solids, surface models and shells.
void add_step_labels(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

/// Fills model.labels and model.parts from `file`; `process` is the transfer of the file to shapes. Labels are read
/// from faces (trimmed surfaces, entity 144, and faces of solids, 510), the lines, arcs and splines of the boundaries
/// of trimmed surfaces in space (110, 100, 126), and what holds faces (solids 186, shells 514, groups 402, instances of
/// subfigures 408). Names are name properties (406, form 15; the short labels of entities only state their kind) or
/// those of subfigures, layers are "level_N" for levels other than 0, and colours are read from the directory entries.
void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

// Reads a CAD file into an OpenCASCADE shape. Only occ_load_*.cpp include OpenCASCADE's readers, one source file for
// each format, so that a program is linked only with the libraries of the formats that it reads.

/// Reads without OpenCASCADE's shape healing: errors of the file are reported, not repaired silently. Throws
/// FormatError with `name` if nothing can be read.
OccModel occ_load(const KernelFormat& format, const std::string& bytes, const std::string& name);

/// The readers behind occ_load.
OccModel occ_load_step(const std::string& bytes, const std::string& name);
OccModel occ_load_iges(const std::string& bytes, const std::string& name);
OccModel occ_load_brep(const std::string& bytes, const std::string& name);

/// Switches OpenCASCADE's healing off in the readers of STEP and IGES, for the whole process.
void switch_healing_off();

}  // namespace quadrille::occ
