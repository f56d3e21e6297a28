# The components of find_package(Quadrille): static libraries of the objects of whole folders, and of the sources of api
# and stage that belong to each, so that nothing is compiled twice.
option(QUADRILLE_LIBRARY "Build and install the library for other programs (find_package)" ON)
if(NOT QUADRILLE_LIBRARY)
  return()
endif()

function(quadrille_component name)
  cmake_parse_arguments(ARG "" "" "STAGES;FOLDERS" ${ARGN})
  set(objects "$<FILTER:$<TARGET_OBJECTS:api>,INCLUDE,/${name}[.]cpp>")
  if(ARG_STAGES)
    list(JOIN ARG_STAGES | stages)
    list(APPEND objects "$<FILTER:$<TARGET_OBJECTS:stage>,INCLUDE,/stage/(${stages})[.]cpp|/unity_${name}_>")
    list(TRANSFORM ARG_STAGES REPLACE "(.+)" "stage/\\1.cpp")
    quadrille_compile_joined(${name} ${ARG_STAGES})
  endif()
  foreach(folder ${ARG_FOLDERS})
    list(APPEND objects "$<TARGET_OBJECTS:${folder}>")
  endforeach()
  add_library(component_${name} STATIC ${objects})
  set_target_properties(component_${name} PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME quadrille_${name})
  add_dependencies(component_${name} api stage ${ARG_FOLDERS})
  install(TARGETS component_${name} ARCHIVE DESTINATION "lib" COMPONENT development)
endfunction()

quadrille_component(files FOLDERS base spectral surface check io) # model has headers only
quadrille_component(fields STAGES fieldsolve padapt given_positions
                    FOLDERS curve heal outline regions mesh field stiffness galerkin adapt)
quadrille_component(layouts STAGES critpoints separatrix blocksplit quadrefine symmetry_option
                    FOLDERS zeros placement guide ties features topology choice graph trace simplify quantize
                    layout couple block sizing prescribe layers growth refine)
quadrille_component(triangles STAGES triangulate_face FOLDERS triangulate)
add_custom_target(components DEPENDS component_files component_fields component_layouts component_triangles)

install(FILES api/files.hpp api/fields.hpp api/layouts.hpp api/triangles.hpp DESTINATION include/quadrille
        COMPONENT development)
# What the structs are made of, found by the folder include/quadrille.
file(GLOB model_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lib/core/model/*.hpp)
install(FILES ${model_headers} DESTINATION include/quadrille/model COMPONENT development)
set(base ${PROJECT_SOURCE_DIR}/lib/core/base)
install(FILES ${base}/enum_names.hpp ${base}/error.hpp ${base}/symmetric_tensor.hpp ${base}/vec2.hpp ${base}/vec3.hpp
        DESTINATION include/quadrille/base COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/lib/layout/layout/layout_choice.hpp DESTINATION include/quadrille/layout
        COMPONENT development)

include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/QuadrilleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES api/QuadrilleConfig.cmake ${PROJECT_BINARY_DIR}/QuadrilleConfigVersion.cmake
        DESTINATION "lib/cmake/Quadrille" COMPONENT development)
