#pragma once
// The codes of all warnings (Report::warn), on which programs rely; formats/report.md explains them. A code never
// changes its meaning, and the code of a removed warning is not used again.

namespace quadrille {
namespace warning {

// cad2tri
inline constexpr const char* curves_ignored = "W-CAD-001";       ///< curves beside the face
inline constexpr const char* points_ignored = "W-CAD-002";       ///< points beside the face
inline constexpr const char* edge_approximated = "W-CAD-003";    ///< an edge without an exact rational form
inline constexpr const char* inner_point_ignored = "W-CAD-004";  ///< a point inside the face
inline constexpr const char* short_edge_ignored = "W-CAD-005";   ///< an edge shorter than the tolerance
inline constexpr const char* large_repair = "W-CAD-006";        ///< healing moved something by more than 1e-3 diameters
inline constexpr const char* faces_not_built = "W-CAD-007";     ///< faces that --list cannot show
inline constexpr const char* open_wire_embedded = "W-CAD-008";  ///< an inner wire that is not closed
inline constexpr const char* offset_compressed = "W-CAD-009";   ///< a curve nearer to its wall than prescribed
inline constexpr const char* name_of_both_kinds = "W-CAD-010";  ///< boundary curves and interfaces
inline constexpr const char* tip_cut_off = "W-CAD-011";         ///< a cusp, by --blunt auto
inline constexpr const char* face_of_curves = "W-CAD-012";      ///< the curves of a file without faces
inline constexpr const char* edge_off_surface = "W-CAD-013";    ///< of a curved face
inline constexpr const char* surface_approximated = "W-CAD-014";  ///< without an exact rational form
inline constexpr const char* closedness_missed = "W-CAD-016";     ///< of the chart of a curved face
inline constexpr const char* curve_tolerance_missed = "W-TRI-001";

// fieldsolve, padapt
inline constexpr const char* field_vanishes_on_curves = "W-SOLVE-001";
inline constexpr const char* orders_still_change = "W-ADAPT-001";
inline constexpr const char* target_error_missed = "W-ADAPT-002";

// critpoints
inline constexpr const char* mirror_images_differ = "W-NODE-001";
inline constexpr const char* nodes_by_rule = "W-NODE-002";
inline constexpr const char* sharp_corner = "W-NODE-003";       ///< below 15 degrees
inline constexpr const char* zeros_not_decided = "W-NODE-004";  ///< in a region where |v| is below its error
inline constexpr const char* half_for_itself = "W-NODE-005";    ///< the whole has no line along its line of symmetry
inline constexpr const char* least_energy_not_found = "W-PLACE-001";
inline constexpr const char* nodes_kept_apart = "W-PLACE-002";
inline constexpr const char* clearance_missed = "W-PLACE-003";

// separatrix, blocksplit
inline constexpr const char* quantized_instead_of_traced = "W-SEP-001";
inline constexpr const char* midpoint_instead_of_separatrices = "W-SEP-002";
inline constexpr const char* crowded_separatrices = "W-SEP-003";
inline constexpr const char* block_not_proved_valid = "W-BLK-001";

// quadrefine and the tools that read its meshes
inline constexpr const char* mesh_not_valid = "W-QUA-001";
inline constexpr const char* chord_count_missed = "W-QUA-002";
inline constexpr const char* geometry_tol_missed = "W-QUA-003";
inline constexpr const char* target_growth_missed = "W-QUA-004";
inline constexpr const char* unequal_sizes = "W-QUA-005";
inline constexpr const char* joint_inside_edge = "W-QUA-006";  ///< of curves without given names
inline constexpr const char* uneven_count = "W-QUA-007";
inline constexpr const char* walls_share_a_chord = "W-WAL-001";  ///< each prescribes heights of its own
inline constexpr const char* walls_disagree = "W-WAL-002";       ///< wall layers that continue each other
inline constexpr const char* reynolds_number_outside = "W-SIZ-001";
inline constexpr const char* end_length_missed = "W-SIZ-002";
inline constexpr const char* end_growth_missed = "W-SIZ-003";

// hexsweep
inline constexpr const char* periodicity_lost = "W-HEX-001";  ///< of sides of the face
inline constexpr const char* motion_missed = "W-HEX-002";     ///< too few layers

// quadexport
inline constexpr const char* format_loss = "W-EXP-001";
inline constexpr const char* side_file_not_written = "W-EXP-002";
inline constexpr const char* ending_of_trixi = "W-EXP-003";
inline constexpr const char* limit_of_solver = "W-EXP-004";  ///< of --check-for

inline constexpr const char* stage_stopped = "W-RUN-001";

}  // namespace warning
}  // namespace quadrille
