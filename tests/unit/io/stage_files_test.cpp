#include "io/stage_files.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../region_layout_samples.hpp"
#include "base/error.hpp"
#include "scratch.hpp"

namespace quadrille::io {

namespace {

class StageFiles : public Scratch {
 protected:
  /// Writing what was read gives the same bytes: nothing is lost and nothing is added.
  template <typename Stage>
  void expect_same_bytes(const Stage& stage) {
    write_stage(path("first"), stage);
    const InputFile file = read_input(path("first"));
    write_stage(path("second"), read_stage<Stage>(file));
    EXPECT_EQ(bytes_of("first"), bytes_of("second"));
    EXPECT_GT(file.bytes.size(), 500u);
  }
  static void expect_same_regions(const CadFace& face, const CadFace& expected) {
    EXPECT_EQ(face.region_loops, expected.region_loops);
    EXPECT_EQ(face.region_names, expected.region_names);
    EXPECT_EQ(face.partners, expected.partners);
    ASSERT_EQ(face.periodic_pairs.size(), expected.periodic_pairs.size());
    for (std::size_t i = 0; i < face.periodic_pairs.size(); ++i) {
      EXPECT_EQ(face.periodic_pairs[i].curves, expected.periodic_pairs[i].curves);
      EXPECT_EQ(face.periodic_pairs[i].angle, expected.periodic_pairs[i].angle);
      EXPECT_EQ(face.periodic_pairs[i].shift, expected.periodic_pairs[i].shift);
    }
  }
};

TEST_F(StageFiles, TriMeshSurvivesTheRoundTrip) {
  expect_same_bytes(samples::tri_mesh());
  const TriMesh mesh = read_stage<TriMesh>(read_input(path("second"))), expected = samples::tri_mesh();
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.elem2vertices, expected.elem2vertices);
  EXPECT_EQ(mesh.curved_nodes, expected.curved_nodes);
  EXPECT_EQ(mesh.face.curve_names, expected.face.curve_names);
  EXPECT_EQ(mesh.face.joints[1].interior_angle, expected.face.joints[1].interior_angle);
  EXPECT_TRUE(mesh.face.joints[3].is_corner);
  EXPECT_EQ(mesh.provenance[0].options, expected.provenance[0].options);
  EXPECT_EQ(stage_format(read_input(path("first"))), "tri-mesh");
}

TEST_F(StageFiles, RegionsSurviveTheRoundTrip) {
  expect_same_bytes(samples::two_regions_mesh());
  const TriMesh mesh = read_stage<TriMesh>(read_input(path("second"))), expected = samples::two_regions_mesh();
  EXPECT_EQ(mesh.region_elems, expected.region_elems);
  expect_same_regions(mesh.face, expected.face);
  expect_same_bytes(samples::two_regions_points());
  expect_same_regions(read_stage<CriticalPoints>(read_input(path("second"))).face, expected.face);
  expect_same_bytes(samples::two_regions_field());
  expect_same_regions(read_stage<Field>(read_input(path("second"))).mesh.face, expected.face);
}

TEST_F(StageFiles, RegionsOfLayoutsAndMeshesSurviveTheRoundTrip) {
  expect_same_bytes(samples::two_regions_graph());
  expect_same_regions(read_stage<SeparatrixGraph>(read_input(path("second"))).face, samples::two_regions_face());
  expect_same_bytes(samples::two_regions_layout());
  EXPECT_EQ(read_stage<BlockLayout>(read_input(path("second"))).block_region, (std::vector<int>{0, 1}));
  expect_same_bytes(samples::two_regions_quads());
  const QuadMesh mesh = read_stage<QuadMesh>(read_input(path("second")));
  EXPECT_EQ(mesh.block_region, (std::vector<int>{0, 1}));
  ASSERT_EQ(mesh.interface_edges.size(), 2u);
  EXPECT_EQ(mesh.interface_edges[1].curve, 7);
}

TEST_F(StageFiles, PhasesOfRegionsSurviveTheRoundTrip) {
  const Field expected = samples::two_regions_phase_field();
  expect_same_bytes(expected);
  const Field field = read_stage<Field>(read_input(path("second")));
  ASSERT_EQ(field.region_phases.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(field.region_phases[r].s, expected.region_phases[r].s);
    EXPECT_EQ(field.region_phases[r].prescribed, expected.region_phases[r].prescribed);
  }
  EXPECT_TRUE(field.phase.s.empty());
}

TEST_F(StageFiles, ChartsSurviveTheRoundTrip) {
  expect_same_bytes(samples::charted_face());
  const InputFile file = read_input(path("second"));
  EXPECT_TRUE(is_chart(file));
  const CadFace face = read_stage<ChartedFace>(file).face;
  ASSERT_TRUE(face.chart);
  const ChartedFace written = samples::charted_face();
  const Chart &chart = *face.chart, &expected = *written.face.chart;
  EXPECT_EQ(chart.elem2vertices, expected.elem2vertices);
  EXPECT_EQ(chart.space_nodes, expected.space_nodes);
  EXPECT_EQ(chart.uv, expected.uv);
  EXPECT_EQ(chart.log_scale, expected.log_scale);
  EXPECT_EQ(chart.closedness, expected.closedness);
  ASSERT_EQ(chart.surfaces.size(), 1u);
  EXPECT_EQ(chart.surfaces[0].poles, expected.surfaces[0].poles);
  EXPECT_EQ(chart.surfaces[0].knots_v, expected.surfaces[0].knots_v);
  ASSERT_EQ(chart.space_curves.size(), 4u);
  EXPECT_EQ(chart.space_curves[2].poles, expected.space_curves[2].poles);
  write_stage(path("plane"), samples::tri_mesh());
  EXPECT_FALSE(is_chart(read_input(path("plane"))));
  EXPECT_FALSE(is_chart({{"file", ""}, "ISO-10303-21;"}));
}

TEST_F(StageFiles, EveryStageOfACurvedFaceCarriesItsChart) {
  const CadFace face = samples::sphere_face(1, 2);
  const auto expect_chart = [&](auto stage, auto face_of) {
    face_of(stage) = face;
    expect_same_bytes(stage);
    const auto read = read_stage<decltype(stage)>(read_input(path("second")));
    ASSERT_TRUE(face_of(read).chart);
    EXPECT_EQ(face_of(read).chart->space_nodes, face.chart->space_nodes);
    EXPECT_EQ(face_of(read).chart->space_curves[3].poles, face.chart->space_curves[3].poles);
  };
  const auto own = [](auto& stage) -> auto& { return stage.face; };
  expect_chart(samples::tri_mesh(), own);
  expect_chart(
      samples::field(), [](auto& field) -> auto& { return field.mesh.face; });
  expect_chart(samples::resolved_points(), own);
  expect_chart(samples::separatrix_graph(), own);
  expect_chart(samples::block_layout(), own);
  expect_chart(samples::quad_mesh(), own);
}

TEST_F(StageFiles, NumbersOfChartsArePackedInJson) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.face = samples::sphere_face(1, 2);
  const std::string written = stage_bytes(graph), packed = "\"log_scale\": \"7zn6/kIu5j";  // ln 2
  ASSERT_NE(written.find(packed), std::string::npos);
  const auto replaced = [&](const std::string& by) {
    std::string bytes = written;
    return InputFile{{"a.sep.json", ""}, bytes.replace(bytes.find(packed), packed.size(), by)};
  };
  for (const char* by : {"\"log_scale\": \"7zn6/kIu5", "\"log_scale\": \"7zn6 kIu5j"})
    EXPECT_THROW(read_stage<SeparatrixGraph>(replaced(by)), FormatError) << by;
  SeparatrixGraph broken = graph;
  Chart chart = *graph.face.chart;
  chart.log_scale[0] = NAN;
  broken.face.chart = std::make_shared<const Chart>(chart);
  EXPECT_THROW(stage_bytes(broken), Defect);
}

TEST_F(StageFiles, NodesInSpaceSurviveTheRoundTrip) {
  QuadMesh mesh = samples::quad_mesh();
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x / 2));
  expect_same_bytes(mesh);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).space_nodes, mesh.space_nodes);
  EXPECT_EQ(stage_bytes(samples::quad_mesh()).find("space_nodes"), std::string::npos);
  EXPECT_EQ(stage_bytes(samples::quad_mesh()).find("chart"), std::string::npos);
}

TEST_F(StageFiles, OneRegionHasNoArraysOfRegions) {
  const auto bytes = [&](const auto& stage) {
    write_stage(path("file"), stage);
    return bytes_of("file");
  };
  for (const char* name : {"region_elems", "region_loops", "region_names", "partners", "periodic_pairs"}) {
    EXPECT_EQ(bytes(samples::tri_mesh()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_mesh()).find(name), std::string::npos) << name;
  }
  for (const char* name : {"block_region", "region_names"}) {
    EXPECT_EQ(bytes(samples::block_layout()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_layout()).find(name), std::string::npos) << name;
  }
  for (const char* name : {"block_region", "interface_edges"}) {
    EXPECT_EQ(bytes(samples::quad_mesh()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_quads()).find(name), std::string::npos) << name;
  }
  const std::string slit = bytes(samples::slit_mesh());
  EXPECT_NE(slit.find("partners"), std::string::npos);
  EXPECT_EQ(slit.find("region_"), std::string::npos);
}

TEST_F(StageFiles, FieldSurvivesTheRoundTrip) {
  expect_same_bytes(samples::field());
  const Field field = read_stage<Field>(read_input(path("second")));
  EXPECT_EQ(field.u, samples::field().u);
  EXPECT_EQ(field.adapt_steps.size(), 1u);
  EXPECT_EQ(field.adapt_steps[0].max_sensor, 1e-9);
  EXPECT_EQ(field.adapt_steps[0].elem_order, samples::field().adapt_steps[0].elem_order);
  EXPECT_EQ(field.adapt_steps[0].elem_sensor, samples::field().adapt_steps[0].elem_sensor);
  EXPECT_EQ(field.elem_error, samples::field().elem_error);
  EXPECT_EQ(stage_format(read_input(path("first"))), "field");
}

TEST_F(StageFiles, CriticalPointsSurviveTheRoundTrip) {
  expect_same_bytes(samples::critical_points());
  EXPECT_EQ(read_stage<CriticalPoints>(read_input(path("second"))).critical_points[1].error, 2e-9);
  EXPECT_EQ(stage_format(read_input(path("first"))), "critical-points");
}

TEST_F(StageFiles, PhaseFieldSurvivesTheRoundTrip) {
  expect_same_bytes(samples::phase_field());
  const Field field = read_stage<Field>(read_input(path("second")));
  EXPECT_EQ(field.kind, FieldKind::phase);
  EXPECT_TRUE(field.u.empty());
  EXPECT_EQ(field.phase.s, samples::phase_field().phase.s);
  EXPECT_EQ(field.phase.prescribed.corners[0].valence, 2);
  EXPECT_EQ(field.phase.terms.images[0].position, (Vec2{0.5, -0.375}));
  EXPECT_EQ(field.phase.terms.corner_angles[0].beta, -4);
}

TEST_F(StageFiles, ResolvedPointsSurviveTheRoundTrip) {
  expect_same_bytes(samples::resolved_points());
  const CriticalPoints points = read_stage<CriticalPoints>(read_input(path("second")));
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.critical_points[1].source, NodeSource::cluster);
  EXPECT_EQ(points.corners[0].source, NodeSource::absorb);
  EXPECT_EQ(points.boundary_nodes[0].t, 0.5);
  EXPECT_EQ(points.changes[1].before[1].valence, 5);
  EXPECT_EQ(points.clusters[0].members.size(), 1u);
  EXPECT_EQ(points.zeros[2].index, -1);
  EXPECT_EQ(points.certificate.cells[2].verdict, CellVerdict::open);
  EXPECT_EQ(points.certificate.disc_radii, (std::vector<double>{0.0625}));
}

TEST_F(StageFiles, NodesAddedByHandNeedPlaceAndValenceOnly) {
  const std::string text =
      R"({"format": "critical-points", "version": [2, 0], "producer": "an editor", "provenance": [],
    "origin": [0, 0], "form": "phase", "critical_points": [{"position": [0.5, 0.5], "valence": 6}],
    "corners": [{"joint": 0, "position": [0, 0], "angle_degrees": 90, "valence": 1, "curves": [3, 0]}],
    "index_sum": {"expected": 4}})";
  const CriticalPoints points = read_stage<CriticalPoints>({{"file", ""}, text});
  EXPECT_EQ(points.critical_points[0].index, -2);
  EXPECT_EQ(points.index_sum, -1) << "4 - 6 and 2 - 1";
  EXPECT_TRUE(points.changes.empty());
}

TEST_F(StageFiles, UnknownKindsOfChangesAreReadButUnknownFormsAreRefused) {
  const auto read = [](const std::string& form, const std::string& location) {
    return read_stage<CriticalPoints>(
        {{"file", ""},
         R"({"format": "critical-points", "version": [2, 99], "producer": "a later version", "provenance": [],
    "origin": [0, 0], "form": ")" +
             form + R"(", "critical_points": [{"position": [0.5, 0.5], "valence": 3,
      "source": "dream"}], "corners": [], "index_sum": {"expected": 4},
    "changes": [{"kind": "dream", "reason": "later", "before": [], "after": [
      {"position": [0.5, 0.5], "valence": 3, "where": ")" +
             location + R"("}]}]})"});
  };
  const CriticalPoints points = read("phase", "inside");
  EXPECT_EQ(points.critical_points[0].source, NodeSource::other);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::other);
  const auto refusal = [&](const std::string& form, const std::string& location) {
    try {
      read(form, location);
    } catch (const FormatError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("magic", "inside").find("CRT-R12"), std::string::npos);
  EXPECT_NE(refusal("phase", "outside").find("must be inside, corner or boundary, not 'outside' (CRT-R16)"),
            std::string::npos);
}

TEST_F(StageFiles, SeparatrixGraphSurvivesTheRoundTrip) {
  expect_same_bytes(samples::separatrix_graph());
  const SeparatrixGraph graph = read_stage<SeparatrixGraph>(read_input(path("second")));
  EXPECT_EQ(graph.nodes[4].kind, NodeKind::boundary);
  EXPECT_EQ(graph.arcs[6].pieces[0].curve, 4);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::traced);
  EXPECT_EQ(graph.certificate.face_valence_histogram.at(0).faces, 2);
  EXPECT_EQ(stage_format(read_input(path("first"))), "separatrix-graph");
}

TEST_F(StageFiles, ASeparatrixGraphMayComeWithoutACertificate) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.certificate = {};
  expect_same_bytes(graph);
  EXPECT_FALSE(read_stage<SeparatrixGraph>(read_input(path("second"))).certificate.method);
  EXPECT_EQ(bytes_of("second").find("certificate"), std::string::npos);
}

TEST_F(StageFiles, BlockLayoutSurvivesTheRoundTrip) {
  expect_same_bytes(samples::block_layout());
  const BlockLayout layout = read_stage<BlockLayout>(read_input(path("second")));
  EXPECT_EQ(layout.block2arcs, samples::block_layout().block2arcs);
  EXPECT_EQ(layout.block_scaled_jacobian, samples::block_layout().block_scaled_jacobian);
  EXPECT_EQ(layout.block_boundary_distance, samples::block_layout().block_boundary_distance);
  EXPECT_EQ(layout.arcs[6].pieces[0].curve, 4);
  EXPECT_EQ(stage_format(read_input(path("first"))), "block-layout");
}

TEST_F(StageFiles, NamesThatNobodyGaveAreRecorded) {
  BlockLayout layout = samples::block_layout();
  layout.unnamed_blocks = {1};
  layout.face.unnamed_curves = {0, 2};
  expect_same_bytes(layout);
  const BlockLayout read = read_stage<BlockLayout>(read_input(path("second")));
  EXPECT_EQ(read.unnamed_blocks, layout.unnamed_blocks);
  EXPECT_EQ(read.face.unnamed_curves, layout.face.unnamed_curves);
  QuadMesh mesh = samples::quad_mesh();
  mesh.unnamed_blocks = {0};
  expect_same_bytes(mesh);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).unnamed_blocks, mesh.unnamed_blocks);
}

TEST_F(StageFiles, QuadMeshSurvivesTheRoundTrip) {
  expect_same_bytes(samples::quad_mesh());
  EXPECT_EQ(stage_format(read_input(path("first"))), "quad-mesh");
  QuadMesh mesh = samples::quad_mesh();
  mesh.is_valid = false;
  mesh.least_jacobian_bound = -0.25;
  expect_same_bytes(mesh);
  EXPECT_FALSE(read_stage<QuadMesh>(read_input(path("second"))).is_valid);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).least_jacobian_bound, -0.25);
}

TEST_F(StageFiles, HexMeshSurvivesTheRoundTrip) {
  HexMesh mesh = samples::hex_mesh();
  mesh.face_groups[1].is_interface = true;
  mesh.is_valid = false;
  expect_same_bytes(mesh);
  const HexMesh read = read_stage<HexMesh>(read_input(path("second")));
  EXPECT_EQ(read.face_groups[2].elems, mesh.face_groups[2].elems);
  EXPECT_TRUE(read.face_groups[1].is_interface);
  EXPECT_EQ(read.face_groups[4].motion.shift, mesh.face_groups[4].motion.shift);
  EXPECT_EQ(read.face_groups[4].motion.matrix, mesh.face_groups[4].motion.matrix);
}

TEST_F(StageFiles, AStructHasTheBytesAndTheIdentityOfItsFile) {
  const std::string bytes = stage_bytes(samples::field());
  write_stage(path("file"), samples::field());
  EXPECT_EQ(bytes, bytes_of("file"));
  const InputFile file = read_input(path("file"));
  const FileIdentity identity = identity_of(path("file"), bytes);
  EXPECT_EQ(identity.name, file.name);
  EXPECT_EQ(identity.sha256, file.sha256);
  EXPECT_NE(identity_of(path("file"), bytes + ' ').sha256, file.sha256);
}

TEST_F(StageFiles, TheReaderOfAStructReadsItsFormatAlone) {
  const auto expect_own_format = [](const auto& model, const std::string& format) {
    using Model = std::decay_t<decltype(model)>;
    const std::string bytes = stage_bytes(model);
    const InputFile file{{"file", ""}, bytes};
    EXPECT_EQ(stage_format(file), format);
    EXPECT_EQ(stage_bytes(read_stage<Model>(file)), bytes);
    const InputFile other{{"file", ""},
                          format == "tri-mesh" ? stage_bytes(samples::quad_mesh()) : stage_bytes(samples::tri_mesh())};
    EXPECT_THROW(read_stage<Model>(other), FormatError) << format;
  };
  expect_own_format(samples::charted_face(), "chart");
  expect_own_format(samples::tri_mesh(), "tri-mesh");
  expect_own_format(samples::field(), "field");
  expect_own_format(samples::critical_points(), "critical-points");
  expect_own_format(samples::separatrix_graph(), "separatrix-graph");
  expect_own_format(samples::block_layout(), "block-layout");
  expect_own_format(samples::quad_mesh(), "quad-mesh");
  expect_own_format(samples::hex_mesh(), "hex-mesh");
}

}  // namespace

}  // namespace quadrille::io
