#include "export/format_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "export/groups.hpp"
#include "export/merge_blocks.hpp"
#include "export/periodic_edges.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// Of many programs.
std::vector<ExportFormat> general_formats() {
  return {
      {.name = "msh",
       .ending = ".msh",
       .summary = "Gmsh MSH 4.1, ASCII",
       .max_order = 10,
       .holds_space = true,
       .write = gmsh_msh41,
       .write_hex = gmsh_msh41,
       .max_hex_order = 9},
      {.name = "msh22",
       .summary = "Gmsh MSH 2.2, ASCII",
       .max_order = 10,
       .holds_space = true,
       .write = gmsh_msh22,
       .write_hex = gmsh_msh22,
       .max_hex_order = 9},
      {.name = "msh-pyfr",
       .summary = "Gmsh MSH 4.1 as PyFR reads it",
       .max_order = 4,
       .write = gmsh_pyfr,
       .side_names = {names_table_name}},
      {.name = "vtu",
       .ending = ".vtu",
       .summary = "VTK XML with Lagrange cells",
       .max_order = 10,
       .holds_space = true,
       .write = vtu_lagrange,
       .loses_periodic_sides = true,
       .side_names = {vtu_curves_name, vtu_faces_name},
       .write_hex = vtu_lagrange,
       .max_hex_order = 10},
      {.name = "vtu-bezier",
       .summary = "VTK XML with Bezier cells",
       .max_order = 10,
       .holds_space = true,
       .write = vtu_bezier,
       .loses_periodic_sides = true,
       .side_names = {vtu_curves_name, vtu_faces_name},
       .write_hex = vtu_bezier,
       .max_hex_order = 10},
  };
}

/// Of solvers with elements of a high order.
std::vector<ExportFormat> high_order_formats() {
  return {
      {.name = "nektar",
       .ending = ".xml",
       .summary = "Nektar++ XML",
       .holds_space = true,
       .write = nektar_xml,
       .write_hex = nektar_xml},
      {.name = "mfem",
       .ending = ".mesh",
       .summary = "MFEM mesh v1.0",
       .holds_space = true,
       .write = mfem_mesh10,
       .side_names = {names_table_name},
       .write_hex = mfem_mesh10},
      {.name = "mfem13",
       .summary = "MFEM mesh v1.3, with names",
       .holds_space = true,
       .write = mfem_mesh13,
       .write_hex = mfem_mesh13},
      {.name = "ism-v2",
       .ending = ".ism",
       .summary = "HOHQMesh ISM-V2",
       .write = hohqmesh_ism,
       .side_names = {names_table_name},
       .written_nodes = WrittenNodes::sides},
      {.name = "ism-mm",
       .summary = "HOHQMesh ISM-MM, with materials",
       .write = hohqmesh_ism_mm,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .written_nodes = WrittenNodes::sides},
      {.name = "inp",
       .ending = ".inp",
       .summary = "Abaqus in HOHQMesh's flavour",
       .write = abaqus_inp,
       .side_names = {names_table_name},
       .write_hex = abaqus_inp,
       .written_nodes = WrittenNodes::sides},
      {.name = "re2",
       .ending = ".re2",
       .summary = "Nek5000 mesh, with a geometry field",
       .write = nek_re2,
       .side_names = {names_table_name, nek_field_name},
       .write_hex = nek_re2},
  };
}

/// Of finite volumes, with straight sides.
std::vector<ExportFormat> volume_formats() {
  return {
      {.name = "blockmesh",
       .ending = "blockMeshDict",
       .summary = "OpenFOAM blockMeshDict",
       .write = [](const QuadMesh& mesh, const Frame& frame) { return block_mesh_dict(mesh, frame, {}); },
       .write_with_types = block_mesh_dict,
       .side_names = {names_table_name},
       .has_straight_sides = true,
       .write_hex = [](const HexMesh& mesh) { return block_mesh_dict(mesh, {}); },
       .write_hex_with_types = block_mesh_dict},
      {.name = "polymesh",
       .ending = "polyMesh/points",
       .summary = "OpenFOAM polyMesh",
       .write = [](const QuadMesh& mesh, const Frame& frame) { return poly_mesh(mesh, frame, {}); },
       .write_with_types = poly_mesh,
       .side_names = {poly_faces_name, poly_owner_name, poly_neighbour_name, poly_boundary_name, poly_zones_name,
                      names_table_name},
       .has_straight_sides = true,
       .write_hex = [](const HexMesh& mesh) { return poly_mesh(mesh, {}); },
       .write_hex_with_types = poly_mesh},
      {.name = "su2",
       .ending = ".su2",
       .summary = "SU2 mesh, straight sides",
       .write = su2_mesh,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = su2_mesh,
       .pieces = WrittenPieces::between_nodes},
  };
}

/// Of finite elements of order 1 or 2.
std::vector<ExportFormat> low_order_formats() {
  return {
      {.name = "abaqus",
       .summary = "Abaqus, CalculiX, plane stress",
       .write = abaqus_cps,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = abaqus_c3d,
       .max_hex_order = 2,
       .pieces = WrittenPieces::quadratic,
       .written_nodes = WrittenNodes::edges},
      {.name = "abaqus-cpe",
       .summary = "the same, plane strain",
       .write = abaqus_cpe,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .pieces = WrittenPieces::quadratic,
       .written_nodes = WrittenNodes::edges},
      {.name = "abaqus-cax",
       .summary = "the same, axisymmetric",
       .write = abaqus_cax,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .pieces = WrittenPieces::quadratic,
       .written_nodes = WrittenNodes::edges},
      {.name = "specfem2d",
       .summary = "text files of SPECFEM2D",
       .write = specfem2d,
       .loses_periodic_sides = true,
       .side_names = {specfem_nodes, specfem_materials, specfem_free_surface, specfem_absorbing, names_table_name},
       .pieces = WrittenPieces::quadratic},
  };
}

/// Written by a program that has the library of the format.
std::vector<ExportFormat> exodus_formats() {
  return {
      {.name = "exodus",
       .ending = ".exo",
       .summary = "Exodus II",
       .write = exodus,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = exodus,
       .max_hex_order = 2,
       .pieces = WrittenPieces::quadratic,
       .program = "quadexport-netcdf"},
      {.name = "exodus-serendipity",
       .summary = "QUAD8, HEX20",
       .write = exodus_serendipity,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = exodus_serendipity,
       .max_hex_order = 2,
       .pieces = WrittenPieces::quadratic,
       .written_nodes = WrittenNodes::edges,
       .program = "quadexport-netcdf"},
  };
}

/// Of structured solvers.
std::vector<ExportFormat> structured_formats() {
  return {
      {.name = "cgns",
       .ending = ".cgns",
       .summary = "CGNS, unstructured",
       .max_order = 4,
       .holds_space = true,
       .write = cgns_unstructured,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = cgns_unstructured,
       .max_hex_order = 4,
       .program = "quadexport-cgns"},
      {.name = "cgns-structured",
       .summary = "CGNS, structured zones",
       .holds_space = true,
       .write = cgns_structured,
       .loses_periodic_sides = true,
       .side_names = {names_table_name},
       .write_hex = cgns_structured,
       .pieces = WrittenPieces::between_nodes,
       .program = "quadexport-cgns"},
      {.name = "plot3d",
       .ending = ".xyz",
       .summary = "PLOT3D grids, with a neutral map",
       .holds_space = true,
       .write = plot3d,
       .loses_periodic_sides = true,
       .side_names = {neutral_map_name, names_table_name},
       .write_hex = plot3d,
       .pieces = WrittenPieces::between_nodes},
  };
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats = [] {
    std::vector<ExportFormat> all = general_formats();
    for (const auto& more :
         {high_order_formats(), volume_formats(), low_order_formats(), exodus_formats(), structured_formats()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
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

void require_hex_options(const ExportFormat& format, const ExportOptions& options) {
  if (format.write_hex == nullptr) {
    std::string others;
    for (const ExportFormat& other : export_formats())
      if (other.write_hex != nullptr) others += fmt::format("{}{}", others.empty() ? "" : ", ", other.name);
    throw UsageError(fmt::format("the format {} has no hexahedra: choose one of {}", format.name, others));
  }
  if (options.in_space) throw UsageError("--frame 3d: hexahedra have coordinates of the CAD model always: omit it");
  if (options.block_groups) throw UsageError("--block-groups: blocks of hexahedra have no names: omit it");
  require_options(format, options);
}

Exported export_mesh(HexMesh mesh, const ExportFormat& format, const ExportOptions& options) {
  require_hex_options(format, options);
  if (mesh.order > format.max_hex_order)
    throw ComputeError(
        fmt::format("the format {} supports hexahedra up to order {}, this mesh has order {}: refine with a lower "
                    "--order",
                    format.name, format.max_hex_order, mesh.order));
  const LengthScale length = length_scale(mesh, options.length);
  if (length.factor != 1 || length.unit != mesh.length_unit) scale_lengths(mesh, length);
  if (options.merge_blocks) mesh = merge_blocks(std::move(mesh));
  Exported exported =
      format.write_hex_with_types ? format.write_hex_with_types(mesh, options.patch_types) : format.write_hex(mesh);
  exported.length = length;
  return exported;
}

}  // namespace quadrille::exports
