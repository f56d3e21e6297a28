#include "stage/solver_table.hpp"

#include <algorithm>

#include "spectral/quadrature.hpp"

namespace quadrille::stage {

namespace {

using enum SolverMeasure;

std::vector<double> vertices(int /*order*/) { return {-1, 1}; }
std::vector<double> lobatto(int order) { return spectral::gauss_lobatto(order + 1).points; }
std::vector<double> finer_lobatto(int order) { return spectral::gauss_lobatto(order + 2).points; }
std::vector<double> five_lobatto(int /*order*/) { return spectral::gauss_lobatto(5).points; }
std::vector<double> gauss(int order) { return spectral::gauss_legendre(order + 1).points; }

/// acos 0.1
constexpr double almost_right_angle = 84.26082952273322;

const std::vector<SolverLimit> not_folded{{jacobian_ratio, {}, 0}};

/// Of cells with straight edges.
std::vector<SolverRow> volume_solvers() {
  return {
      // primitiveMeshCheck.C, whose errors are failures here: checkFaceOrthogonality, checkFaceSkewness,
      // checkClosedCells (aspect ratio) and checkFacePyramids; symmetryPlanePolyPatch.C, calcGeometry: |n - m|^2 below
      // 1e-15.
      {.name = "openfoam",
       .title = "OpenFOAM",
       .formats = {"blockmesh", "polymesh"},
       .limits = {{face_angle, 70, 90},
                  {skewness, {}, 4},
                  {aspect_ratio, {}, 1000},
                  {pyramid, {}, 0},
                  {plane_deviation, {}, 3.1623e-8}}},
      // cs_mesh_bad_cells.c, which only reports: _compute_ortho_norm, _compute_offsetting, _compute_least_squares,
      // _compute_volume_ratio. Its cells are hexahedra, straight whatever their order.
      {.name = "code_saturne",
       .title = "code_saturne",
       .formats = {"msh", "msh22", "cgns"},
       .limits = {{face_angle, almost_right_angle, {}},
                  {boundary_face_angle, almost_right_angle, {}},
                  {face_offset, 0.1, {}},
                  {gradient_condition, 0.1, {}},
                  {volume_ratio, 100, {}}},
       .max_order = 0,
       .max_hex_order = 2,
       .centre = mesh::CellCentre::surface},
      // CPhysicalGeometry.cpp, Check_IntElem_Orientation: by the edges at the corners.
      {.name = "su2", .title = "SU2", .formats = {"su2"}, .limits = not_folded, .points = vertices},
  };
}

/// Of spectral elements.
std::vector<SolverRow> spectral_solvers() {
  return {
      // GeomFactors.cpp, CheckIfValid, at the points of QuadGeom.cpp and HexGeom.cpp.
      {.name = "nektar", .title = "Nektar++", .formats = {"nektar"}, .limits = not_folded, .points = finer_lobatto},
      // coef.f, chkjac, of which mesh_check ends the run.
      {.name = "nek5000", .title = "Nek5000", .formats = {"re2"}, .limits = not_folded, .points = lobatto},
      // meshGeometricFactorsHex3D.cpp, geometricFactors: "Invalid element Jacobian < 0 found!" ends the run.
      {.name = "nekrs", .title = "NekRS", .formats = {"re2"}, .limits = not_folded, .max_order = 0, .points = lobatto},
      // metrics.f90, CalcMetrics: det J over the greatest of its element below 0.01; HOPR converts the mesh.
      {.name = "flexi",
       .title = "FLEXI",
       .formats = {"cgns"},
       .limits = {{jacobian_ratio, {}, 0.01}},
       .max_order = 0,
       .points = lobatto},
      // No check: dgsem_structured/containers_2d.jl, calc_inverse_jacobian!, stores 1 / det J, also for P4estMesh and
      // UnstructuredMesh2D.
      {.name = "trixi",
       .title = "Trixi.jl",
       .formats = {"ism-v2", "ism-mm", "inp"},
       .limits = not_folded,
       .points = lobatto},
      // solvers/base/elements.py, rcpdjac_at_np: divides by det J, and ends only below -1e-5 in the unit of the file
      // (pnorm_at also at normals of sides below 1e-10). Orders: readers/gmsh.py, _etype_map.
      {.name = "pyfr", .title = "PyFR", .formats = {"msh-pyfr"}, .limits = not_folded, .max_order = 4, .points = gauss},
      // setup_mesh.F90, setup_mesh_coordinates, by recompute_jacobian_with_negative_stop at NGLL = 5 points.
      {.name = "specfem2d",
       .title = "SPECFEM2D",
       .formats = {"specfem2d"},
       .limits = not_folded,
       .points = five_lobatto},
  };
}

/// Of finite elements.
std::vector<SolverRow> element_solvers() {
  return {
      // mesh.cpp, CheckElementOrientation, looks at the middle alone and only warns; integrators evaluate det J at the
      // points of Gauss.
      {.name = "mfem", .title = "MFEM", .formats = {"mfem", "mfem13"}, .limits = not_folded, .points = gauss},
      // No check: apply_integral_scaling.py of UFL, compute_integrand_scaling_factor, takes |det J|. Orders: the table
      // of cells in gmshio.py (now gmsh.py); cells.cpp, perm_gmsh, calls gmsh_quadrilateral and gmsh_hexahedron.
      {.name = "dolfinx",
       .title = "dolfinx",
       .formats = {"msh", "msh22"},
       .limits = not_folded,
       .max_order = 3,
       .max_hex_order = 2,
       .points = gauss},
      // grid_in.cc, GridIn::read_msh: straight cells. tria.cc, collect_distorted_coarse_cells, which Triangulation
      // calls if check_for_distorted_cells is set: det J of [0, 1]^d at a vertex is at most 1e-9 diameter^d.
      {.name = "dealii",
       .title = "deal.II",
       .formats = {"msh", "msh22"},
       .limits = {{relative_jacobian, {}, 1e-9}},
       .max_order = 1,
       .max_hex_order = 1,
       .points = vertices},
      // fe_map.C, FEMap::compute_single_point_map: det J at most jacobian_tolerance, 0 (fe_map.h); at the points of
      // Gauss of the order 2 N + 1.
      {.name = "moose",
       .title = "MOOSE (libMesh)",
       .formats = {"exodus", "exodus-serendipity"},
       .limits = not_folded,
       .points = gauss},
      // e_c3d.f, e_c3d: xsj below 1e-20; elements of two dimensions are expanded to hexahedra (gen3delem.f).
      {.name = "calculix",
       .title = "CalculiX",
       .formats = {"abaqus", "abaqus-cpe", "abaqus-cax"},
       .limits = {{jacobian, {}, 1e-20}},
       .points = gauss},
  };
}

constexpr std::string_view refine_there = "refine there (quadrefine --size-near, lower --size)";

std::vector<SolverMeasureRow> measure_rows() {
  return {
      {face_angle, "non-orthogonality", " degrees", false, mesh::face_angles,
       "choose other nodes or another --layout, or correct for it in the solver"},
      {boundary_face_angle, "boundary non-orthogonality", " degrees", false, mesh::boundary_face_angles,
       "choose other nodes or another --layout"},
      {skewness, "skewness", "", false, mesh::face_skewness, refine_there},
      {aspect_ratio, "aspect ratio", "", false, mesh::cell_aspects,
       "prescribe shorter elements along walls (quadrefine --size-near, --max-edge-ratio) or a greater first height"},
      {pyramid, "pyramid volume", "", true, mesh::face_pyramids, refine_there},
      {plane_deviation, "plane deviation", "", false, mesh::plane_deviations,
       "a symmetryPlane must be flat: choose --patch-type NAME=symmetry for it"},
      {volume_ratio, "volume ratio", "", false, mesh::volume_ratios, "limit the growth (quadrefine --target-growth)"},
      {face_offset, "face offset", "", true, mesh::face_offsets, refine_there},
      {gradient_condition, "gradient condition", "", true, mesh::gradient_conditions,
       "prescribe shorter elements along walls, or choose another gradient than that of least squares"},
      {jacobian_ratio, "Jacobian ratio", "", true, nullptr, refine_there},
      {relative_jacobian, "relative Jacobian", "", true, nullptr, refine_there},
      {jacobian, "Jacobian", "", true, nullptr, "refine there, or export with a smaller unit (--unit, --scale)"},
  };
}

}  // namespace

const SolverMeasureRow& solver_measure(SolverMeasure measure) {
  static const std::vector<SolverMeasureRow> rows = measure_rows();
  return rows[static_cast<int>(measure)];
}

const std::vector<SolverRow>& solver_rows() {
  static const std::vector<SolverRow> rows = [] {
    std::vector<SolverRow> all = volume_solvers();
    for (const auto& more : {spectral_solvers(), element_solvers()}) all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return rows;
}

const SolverRow* find_solver(std::string_view name) {
  const std::vector<SolverRow>& rows = solver_rows();
  const auto at = std::find_if(rows.begin(), rows.end(), [&](const SolverRow& row) { return row.name == name; });
  return at == rows.end() ? nullptr : &*at;
}

}  // namespace quadrille::stage
