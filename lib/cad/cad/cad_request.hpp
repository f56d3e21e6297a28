#pragma once
// What cad2tri asks of the program that is linked with the CAD kernel's libraries for one format.

#include <string>

#include "model/cad_face.hpp"

namespace quadrille::cad {

struct LoadOptions {
  double corner_angle = 0.017453292519943295;  ///< radians; greater tangent jumps are corners of the layout
  double heal_tolerance = -1;                  ///< as in heal::HealOptions
  std::string face = {};                       ///< number or name; empty: the only face
  double blunt_width = 0;                      ///< as in heal::BluntOptions
  double fit_tolerance = 0;                    ///< as in outline::AssembleOptions
};

enum class CadTask : int {
  load,  ///< answered by to_bytes(LoadedFace, Report)
  list,  ///< answered by to_bytes(FaceList)
  write  ///< answered by the bytes of a CAD file
};

struct CadRequest {
  CadTask task = CadTask::load;
  std::string name;     ///< of the file, for messages
  std::string bytes;    ///< contents of the file to load or list
  LoadOptions options;  ///< of load
  CadFace face;         ///< to write
};

}  // namespace quadrille::cad
