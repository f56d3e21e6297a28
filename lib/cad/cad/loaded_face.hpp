#pragma once
// What cad2tri asks of the programs that are linked with the CAD kernel's libraries, what they read from a CAD file,
// and the bytes in which these pass requests and answers to each other: exact, and not a file format.

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "base/report.hpp"
#include "base/vec3.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"
#include "model/space_face.hpp"

namespace quadrille::cad {

/// A plane that cuts the solids of a file; none if the normal is zero.
struct SectionPlane {
  Vec3 point, normal;  ///< in the coordinates of the file

  bool is_given() const { return norm(normal) > 0; }
};

struct LoadOptions {
  double corner_angle = 0.017453292519943295;  ///< radians; greater tangent jumps are corners of the layout
  double heal_tolerance = -1;                  ///< as in heal::HealOptions
  std::string face = {};                       ///< number or name; empty: the only face
  double blunt_width = 0;                      ///< as in heal::BluntOptions
  double fit_tolerance = 0;                    ///< as in outline::AssembleOptions
  SectionPlane section = {};                   ///< the faces are those in which it cuts the solids
};

enum class CadTask : int {
  load,        ///< answered by to_bytes(LoadedFace, Report)
  list,        ///< answered by to_bytes(FaceList)
  write,       ///< answered by the bytes of a CAD file
  load_space,  ///< answered by to_bytes(SpaceFace, Report)
  load_any,    ///< answered by either, as the face is planar or curved
  kind         ///< answered by the kind of the chosen face's surface, as in ListedShape
};

struct CadRequest {
  CadTask task = CadTask::load;
  std::string name;     ///< of the file, for messages
  std::string bytes;    ///< contents of the file to read
  LoadOptions options;  ///< of the loads and of kind
  CadFace face;         ///< to write
};

struct LoadedFace {
  CadFace face;
  std::vector<Repair> repairs;  ///< what healing changed
};

/// A face or an edge as it is in the file, in space and in the length unit of the file.
struct ListedShape {
  std::string name;                      ///< empty if the file states none
  std::string kind;                      ///< of the surface ("plane", "cylinder") or the curve ("line", "circle")
  double length = 0;                     ///< of the edge, or of all edges of the face
  std::array<double, 3> place{0, 0, 0};  ///< the middle of the edge, or the centre of mass of the edges of the face
};

struct ListedFace {
  ListedShape face;
  std::string part;   ///< names of the products, solids and shells around it, outermost first: "rig/bolt"
  std::string layer;  ///< of the face, else of the innermost part that has one
  std::vector<ListedShape> edges;
  std::string size = {};   ///< of a curved surface: "radius 1"; empty where numbers do not say it
  bool is_closed = false;  ///< has no boundary, and so no chart
};

struct FaceList {
  std::string length_unit;
  std::vector<ListedFace> faces;
  std::vector<std::string> not_built;  ///< entities of faces that could not be built: "#40 'lid'"
};

// Exact serialisation of what cad2tri and the programs that are linked with the CAD kernel pass to each other: a
// request, a LoadedFace or SpaceFace with its Report, or a FaceList. Not a file format.

/// Serialises the face and the report.
std::string to_bytes(const LoadedFace& loaded, const Report& report);

/// Returns the face and adds the contents of the serialised report to `report`. Throws Defect for bytes that were not
/// written by to_bytes.
LoadedFace from_bytes(const std::string& bytes, Report& report);

/// The same for a face in space.
std::string to_bytes(const SpaceFace& face, const Report& report);
SpaceFace space_face_from_bytes(const std::string& bytes, Report& report);

/// The same for one of them.
using AnyFace = std::variant<LoadedFace, SpaceFace>;
std::string to_bytes(const AnyFace& face, const Report& report);
AnyFace any_face_from_bytes(const std::string& bytes, Report& report);

/// The same for a list of faces.
std::string to_bytes(const FaceList& list);
FaceList list_from_bytes(const std::string& bytes);

/// The same for a request.
std::string to_bytes(const CadRequest& request);
CadRequest request_from_bytes(const std::string& bytes);

}  // namespace quadrille::cad
