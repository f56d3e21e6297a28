# cpack: a package for Debian 12 (.deb) and a relocatable archive (.tar.gz) of everything that is installed. Run it on a
# build that is complete (ninja -C build tools): cpack -G "DEB;TGZ" --config build/CPackConfig.cmake -B DIR
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME quadrille)
set(CPACK_PACKAGE_VENDOR "The Quadrille authors")
# An address is required; a packager gives that of whom to ask: -DQUADRILLE_PACKAGE_CONTACT="NAME <ADDRESS>".
set(QUADRILLE_PACKAGE_CONTACT "The Quadrille authors <quadrille@example.org>" CACHE STRING "Maintainer of packages")
set(CPACK_PACKAGE_CONTACT "${QUADRILLE_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Quadrille solves for a guiding field that represents a cross at every point of a planar
CAD face and is aligned with its boundary, traces the separatrices of the field, which
divide the face into four-sided blocks, and splits the blocks into quads of any order
whose boundary edges lie on the CAD curves. Each element is proved valid. Meshes are
written for Gmsh, Nektar++, MFEM, Trixi.jl, Nek5000, OpenFOAM and others.
.
Each stage is a command that reads and writes documented files; quadmesh runs them all.
The package contains a Python package and a C++ library for these files as well.")
# cpack and the description say so if the package may not run elsewhere.
if(QUADRILLE_NATIVE)
  set(native "Built with QUADRILLE_NATIVE, for the processor of one machine: the programs may not run on others.")
  string(APPEND CPACK_PACKAGE_DESCRIPTION "\n.\n${native}")
  set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/native_package.cmake)
  file(CONFIGURE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} CONTENT "message(WARNING \"${native}\")\n")
endif()
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no program is linked with: separatrix and quadmesh load CBC, quadplace, points2step, drawing2step, quadbatch, quadbench
# and quadgallery are in Python, quadbatch runs parallel, and drawing2step reads DXF by ezdxf.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "coinor-libcbc3, parallel, python3")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "librsvg2-bin, man-db, python3-ezdxf, python3-h5py")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "jq, libfmt-dev, libgmp-dev, libhdf5-dev, python3-matplotlib")
include(CPack)
