# find_package(Quadrille 0.1 REQUIRED COMPONENTS files fields layouts triangles)
#
#   Quadrille::files      reads, checks and writes stage files      quadrille/files.hpp       MIT
#   Quadrille::fields     solves for fields and evaluates them      quadrille/fields.hpp      MIT
#   Quadrille::layouts    nodes, separatrices, blocks, quads        quadrille/layouts.hpp     MIT
#   Quadrille::triangles  triangulates a face, by CGAL              quadrille/triangles.hpp   GPL-3.0-or-later
#
# Without COMPONENTS: the first three. A target links those before it. Needs C++20, fmt and HDF5 (libfmt-dev,
# libhdf5-dev), `triangles` GMP as well (libgmp-dev).
include(CMakeFindDependencyMacro)
find_dependency(fmt CONFIG)

get_filename_component(_quadrille_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(_quadrille_known files fields layouts triangles)
if(NOT Quadrille_FIND_COMPONENTS)
  set(Quadrille_FIND_COMPONENTS files fields layouts)
endif()

# _quadrille_library(VARIABLE NAMES...): finds a library, or sets Quadrille_NOT_FOUND_MESSAGE.
macro(_quadrille_library variable)
  find_library(${variable} NAMES ${ARGN} PATH_SUFFIXES hdf5/serial)
  mark_as_advanced(${variable})
  if(NOT ${variable})
    set(Quadrille_FOUND FALSE)
    set(Quadrille_NOT_FOUND_MESSAGE "Quadrille needs one of the libraries ${ARGN}")
    return()
  endif()
endmacro()

_quadrille_library(Quadrille_HDF5_LIBRARY hdf5 hdf5_serial)

function(_quadrille_target name)
  if(TARGET Quadrille::${name})
    return()
  endif()
  add_library(Quadrille::${name} STATIC IMPORTED)
  set_target_properties(Quadrille::${name} PROPERTIES
    IMPORTED_LOCATION "${_quadrille_prefix}/lib/libquadrille_${name}.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_quadrille_prefix}/include;${_quadrille_prefix}/include/quadrille"
    INTERFACE_COMPILE_FEATURES cxx_std_20
    INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()

_quadrille_target(files fmt::fmt "${Quadrille_HDF5_LIBRARY}" ${CMAKE_DL_LIBS})
_quadrille_target(fields Quadrille::files)
_quadrille_target(layouts Quadrille::fields)
set(Quadrille_files_FOUND TRUE)
set(Quadrille_fields_FOUND TRUE)
set(Quadrille_layouts_FOUND TRUE)
if("triangles" IN_LIST Quadrille_FIND_COMPONENTS)
  _quadrille_library(Quadrille_GMP_LIBRARY gmp)
  _quadrille_target(triangles Quadrille::layouts "${Quadrille_GMP_LIBRARY}")
  set(Quadrille_triangles_FOUND TRUE)
endif()

foreach(_quadrille_component ${Quadrille_FIND_COMPONENTS})
  if(NOT _quadrille_component IN_LIST _quadrille_known AND Quadrille_FIND_REQUIRED_${_quadrille_component})
    set(Quadrille_FOUND FALSE)
    set(Quadrille_NOT_FOUND_MESSAGE "Quadrille has no component ${_quadrille_component}, only ${_quadrille_known}")
  endif()
endforeach()
