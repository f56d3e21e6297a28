#include "occ/read_face.hpp"

#include <gtest/gtest.h>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "cad/loaded_face.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {

namespace {

TEST(ReadFace, reading_twice_in_one_process_gives_the_same) {
  Report report;
  const std::string inches = test_bytes("bad/inches.step"), millimetres = test_bytes("bad/rectangle.step");
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(read_face(step_format(), inches, "a.step", {}, report).face.joints[2].position, (Vec2{2.1, 0.7}));
    EXPECT_EQ(read_face(step_format(), millimetres, "b.step", {}, report).face.joints[2].position, (Vec2{2, 1}));
  }
}

TEST(ReadFace, names_that_the_kernel_made_are_none) {
  Report report;
  std::string bytes = test_bytes("square.step");
  const std::string made = "Open CASCADE STEP translator 7.6 8";
  const auto name_of = [&](const std::string& product) {
    std::string text = bytes;
    for (size_t at = text.find(made); at != std::string::npos; at = text.find(made, at + product.size()))
      text.replace(at, made.size(), product);
    return list_faces(occ_load(step_format(), text, "a.step")).faces.at(0).part;
  };
  EXPECT_EQ(name_of(made), "");
  EXPECT_EQ(name_of("Open CASCADE STEP translator 7.6 4.1"), "");
  EXPECT_EQ(name_of("=>[0:1:1:2]"), "");
  EXPECT_EQ(name_of("Open CASCADE plate"), "Open CASCADE plate");
}

TEST(Answer, is_the_face_the_list_or_the_file_that_the_request_is_for) {
  cad::CadRequest request;
  request.name = "a.brep";
  request.bytes = test_bytes("bad/rectangle.brep");
  Report report;
  request.face = cad::from_bytes(answer_request(brep_format(), cad::to_bytes(request)), report).face;
  EXPECT_EQ(request.face.num_curves(), 4);
  EXPECT_EQ(report.entries().front().first, "input.format");

  request.task = cad::CadTask::list;
  EXPECT_EQ(cad::list_from_bytes(answer_request(brep_format(), cad::to_bytes(request))).faces.size(), 1U);

  request.task = cad::CadTask::write;
  expect_contains(answer_request(brep_format(), cad::to_bytes(request)), "CASCADE Topology V");
  expect_contains(answer_request(step_format(), cad::to_bytes(request)), "ISO-10303-21");
  EXPECT_THROW(answer_request(iges_format(), cad::to_bytes(request)), Defect);
}

TEST(ReadFace, a_curved_face_is_named_with_what_to_do) {
  Report report;
  cad::LoadOptions options;
  options.face = "0";
  const std::string bytes = test_bytes("curved/half_cylinder.step");
  const std::string message =
      message_of<FormatError>([&] { read_face(step_format(), bytes, "a.step", options, report); });
  expect_contains(message, "a.step: the face is not planar (a cylinder): cad2chart --face 0 makes a chart of it");
}

TEST(ReadFace, several_curved_faces_are_named_with_what_to_do) {
  const std::string bytes = test_bytes("curved_regions/halves.step");
  for (const std::string choice : {"", "0,1"}) {
    Report report;
    cad::LoadOptions options;
    options.face = choice;
    const std::string message =
        message_of<FormatError>([&] { read_face(step_format(), bytes, "a.step", options, report); });
    expect_contains(message, "a.step: the face is not planar (a cylinder): cad2chart --face 0,1 makes a chart of it");
    expect_contains(message, "quadmesh --face 0,1 does both");
  }
}

TEST(Answer, is_the_kind_of_the_face_or_the_face_in_space) {
  cad::CadRequest request;
  request.task = cad::CadTask::kind;
  request.bytes = test_bytes("curved/half_cylinder.step");
  request.options.face = "0";
  EXPECT_EQ(answer_request(step_format(), cad::to_bytes(request)), "cylinder");
  request.options.face = "1";
  EXPECT_EQ(answer_request(step_format(), cad::to_bytes(request)), "plane");
  request.task = cad::CadTask::load_space;
  Report report;
  const SpaceFace face = cad::space_face_from_bytes(answer_request(step_format(), cad::to_bytes(request)), report);
  EXPECT_EQ(face.curves.size(), 3U);
  EXPECT_EQ(cad::to_bytes(face, report), answer_request(step_format(), cad::to_bytes(request)));
}

TEST(Answer, is_a_face_in_the_plane_or_in_space_of_one_reading) {
  cad::CadRequest request;
  request.task = cad::CadTask::load_any;
  request.bytes = test_bytes("curved/half_cylinder.step");
  request.options.face = "0";
  Report report;
  const cad::AnyFace curved = cad::any_face_from_bytes(answer_request(step_format(), cad::to_bytes(request)), report);
  ASSERT_TRUE(std::holds_alternative<SpaceFace>(curved));
  EXPECT_EQ(std::get<SpaceFace>(curved).curves.size(), 4U);
  request.options.face = "1";
  const cad::AnyFace planar = cad::any_face_from_bytes(answer_request(step_format(), cad::to_bytes(request)), report);
  ASSERT_TRUE(std::holds_alternative<cad::LoadedFace>(planar));
  EXPECT_EQ(std::get<cad::LoadedFace>(planar).face.num_curves(), 3);
}

}  // namespace

}  // namespace quadrille::occ
