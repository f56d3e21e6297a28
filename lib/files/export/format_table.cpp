#include "export/format_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "export/groups.hpp"
#include "export/merge_blocks.hpp"
#include "export/periodic_edges.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats{
      {"msh", ".msh", "Gmsh MSH 4.1, ASCII", 10, true, gmsh_msh41},
      {"msh22", "", "Gmsh MSH 2.2, ASCII", 10, true, gmsh_msh22},
      {"msh-pyfr", "", "Gmsh MSH 4.1 as PyFR reads it", 4, false, gmsh_pyfr, nullptr, false, {names_table_name}},
      {"vtu", ".vtu", "VTK XML with Lagrange cells", 10, true, vtu_lagrange, nullptr, true, {vtu_curves_name}},
      {"vtu-bezier", "", "VTK XML with Bezier cells", 10, true, vtu_bezier, nullptr, true, {vtu_curves_name}},
      {"nektar", ".xml", "Nektar++ XML", 20, true, nektar_xml},
      {"mfem", ".mesh", "MFEM mesh v1.0", 20, true, mfem_mesh10, nullptr, false, {names_table_name}},
      {"mfem13", "", "MFEM mesh v1.3, with names", 20, true, mfem_mesh13},
      {"ism-v2", ".ism", "HOHQMesh ISM-V2", 20, false, hohqmesh_ism, nullptr, false, {names_table_name}},
      {"ism-mm", "", "HOHQMesh ISM-MM, with materials", 20, false, hohqmesh_ism_mm, nullptr, true, {names_table_name}},
      {"inp", ".inp", "Abaqus in HOHQMesh's flavour", 20, false, abaqus_inp, nullptr, false, {names_table_name}},
      {"re2",
       ".re2",
       "Nek5000 mesh, with a geometry field",
       20,
       false,
       nek_re2,
       nullptr,
       false,
       {names_table_name, nek_field_name}},
      {"blockmesh",
       "blockMeshDict",
       "OpenFOAM blockMeshDict",
       20,
       false,
       [](const QuadMesh& mesh, const Frame& frame) { return block_mesh_dict(mesh, frame, {}); },
       block_mesh_dict,
       false,
       {names_table_name},
       true},
      {"abaqus", "", "Abaqus and CalculiX, plane stress", 20, false, abaqus_cps, nullptr, true, {names_table_name}},
      {"abaqus-cpe", "", "the same, plane strain", 20, false, abaqus_cpe, nullptr, true, {names_table_name}},
      {"abaqus-cax", "", "the same, axisymmetric", 20, false, abaqus_cax, nullptr, true, {names_table_name}},
      {"cgns",
       ".cgns",
       "CGNS, unstructured",
       4,
       true,
       cgns_unstructured,
       nullptr,
       true,
       {names_table_name},
       false,
       "quadexport-cgns"},
      {"cgns-structured",
       "",
       "CGNS, structured zones",
       20,
       true,
       cgns_structured,
       nullptr,
       true,
       {names_table_name},
       false,
       "quadexport-cgns"},
      {"exodus", ".exo", "Exodus II", 20, false, exodus, nullptr, true, {names_table_name}},
      {"plot3d",
       ".xyz",
       "PLOT3D grids, with a neutral map",
       20,
       true,
       plot3d,
       nullptr,
       true,
       {neutral_map_name, names_table_name}},
      {"specfem2d",
       "",
       "text files of SPECFEM2D",
       20,
       false,
       specfem2d,
       nullptr,
       true,
       {specfem_nodes, specfem_materials, specfem_free_surface, specfem_absorbing, names_table_name}},
      {"su2", ".su2", "SU2 mesh of straight quads", 20, false, su2_mesh, nullptr, true, {names_table_name}},
  };
  return formats;
}

const ExportFormat* find_export_format(std::string_view name) {
  const auto& formats = export_formats();
  const auto at = std::find_if(formats.begin(), formats.end(), [&](const ExportFormat& f) { return f.name == name; });
  return at == formats.end() ? nullptr : &*at;
}

const ExportFormat* export_format_of(std::string_view file_name) {
  const auto& formats = export_formats();
  const auto at = std::find_if(formats.begin(), formats.end(), [&](const ExportFormat& f) {
    return !f.ending.empty() && file_name.ends_with(f.ending);
  });
  return at == formats.end() ? nullptr : &*at;
}

void require_options(const ExportFormat& format, const ExportOptions& options) {
  if (options.in_space && !format.holds_space)
    throw UsageError(fmt::format("the format {} supports coordinates of the plane only: omit --frame 3d", format.name));
  if (!options.patch_types.empty() && format.write_with_types == nullptr)
    throw UsageError(fmt::format("--patch-type: boundaries have no types in the format {}", format.name));
}

std::string planar_format_text(const ExportFormat& format) {
  std::string others;
  for (const ExportFormat& other : export_formats())
    if (other.holds_space) others += fmt::format("{}, ", other.name);
  return fmt::format(
      "the format {} supports meshes of the plane only, but this face is curved: choose {}or step for the blocks",
      format.name, others);
}

Exported export_mesh(QuadMesh mesh, const ExportFormat& format, const ExportOptions& options) {
  require_options(format, options);
  if (mesh.order > format.max_order)
    throw ComputeError(
        fmt::format("the format {} supports quads up to order {}, this mesh has order {}: refine with a "
                    "lower --order",
                    format.name, format.max_order, mesh.order));
  if (!mesh.space_nodes.empty() && !format.holds_space) throw ComputeError(planar_format_text(format));
  const LengthScale length = length_scale(mesh.face, options.length);
  if (length.factor != 1 || length.unit != mesh.face.length_unit) scale_lengths(mesh, length);
  if (options.merge_blocks) mesh = merge_blocks(std::move(mesh));
  if (options.block_groups) separate_blocks(mesh);
  const Frame frame = options.in_space ? model_frame(mesh.face) : plane_frame(mesh.face);
  Exported exported =
      format.write_with_types ? format.write_with_types(mesh, frame, options.patch_types) : format.write(mesh, frame);
  if (format.loses_periodic_sides && !mesh.face.periodic_pairs.empty())
    exported.losses.push_back(periodic_loss(mesh.face, mesh.face.periodic_pairs));
  exported.length = length;
  return exported;
}

}  // namespace quadrille::exports
