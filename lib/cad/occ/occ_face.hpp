#pragma once
// Faces of an OpenCASCADE model: all of them as a list, the chosen one, and that one as NURBS in its plane.

#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "cad/loaded_face.hpp"
#include "heal/raw_face.hpp"
#include "occ/occ_model.hpp"
#include "outline/face_of_loops.hpp"

namespace quadrille::occ {

/// All faces with their edges, in the order of the file. A face that an assembly places several times is listed at each
/// place; one that two solids share is listed once.
cad::FaceList list_faces(const OccModel& model);

/// The faces of list_faces, in its order.
std::vector<TopoDS_Face> faces_of(const OccModel& model);

struct FaceChoice {
  TopoDS_Face face;
  outline::FacePiece piece;
  std::string part = {};  ///< name of the innermost part that holds it
  int number = 0;         ///< in list_faces
};

/// The face whose name is `choice` or, if no face has that name, whose number it is, or else the only face in the part
/// or on the layer of that name. A part is chosen by its name or by its path ("rig/bolt"). ".0" and so on behind that:
/// a piece of the face. "0,1" and the like: several faces. If `choice` is empty: all faces of the model, in the order
/// of the file. Throws FormatError if no face or several faces are chosen, or if `choice` is empty and the model is a
/// solid, or has several faces of which one is not planar. `file`: name of the file, for messages.
std::vector<FaceChoice> choose_faces(const OccModel& model, const std::string& choice, const std::string& file);

/// Whether an edge or a wire of a face bounds nothing: the face is on both sides.
bool has_face_on_both_sides(const TopoDS_Shape& shape);

/// The kind of its surface: "plane", "cylinder", ..., "other".
std::string kind_of(const TopoDS_Face& face);

/// "not planar (a cylinder): ...", with what to do, for messages. `choices`: all that were chosen.
std::string not_planar_text(const std::vector<FaceChoice>& choices);

/// Name, layer, unit and tolerances of the face; no edges, and no plane.
heal::RawFace labels_of_face(const OccModel& model, const TopoDS_Face& face, const std::string& file);

/// Throws FormatError if an edge of the face has a placement with a scale.
void require_unscaled(const TopoDS_Face& face, const std::string& file);

/// The plane of the face in space; std::nullopt if the face is not planar.
std::optional<gp_Pln> plane_of(const TopoDS_Face& face);

struct FacesAndEdges {
  std::vector<heal::RawFace> faces;
  std::vector<heal::RawEdge> free_edges;  ///< of no face, numbered from 0
  int num_ignored_curves = 0;             ///< of no face, and without use
  int num_points = 0;                     ///< of no edge
};

/// The faces with their edges in the plane of the first one; edges that lie off it have a height. An edge that a face
/// has on both sides is one of its inner edges. Throws FormatError unless the first face is planar. `file`: name of
/// the file, for messages.
FacesAndEdges occ_faces(const OccModel& model, const std::vector<FaceChoice>& faces, const std::string& file,
                        Report& report);

/// The edges of a model without faces as the only wire of a face in their plane, in the order of the file, whatever
/// their directions. Throws FormatError for curves on one line, and if there are none.
FacesAndEdges face_of_curves(const OccModel& model, const std::string& file, Report& report);

/// Warns of what was only counted.
void warn_of_ignored(const FacesAndEdges& found, const std::string& file, Report& report);

}  // namespace quadrille::occ
