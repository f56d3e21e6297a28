#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../regions/faces_of_regions.hpp"
#include "../support/texts.hpp"
#include "draw/labels.hpp"

namespace quadrille::draw {

namespace {

using namespace testing_faces;

std::string labelled(const CadFace& face, int width) {
  DrawOptions options;
  options.width = width;
  Picture picture(bounding_box(face), options, "", "");
  label_regions(picture, face);
  return picture.str();
}

TEST(RegionLabels, TheFirstPlaceIsInTheMiddle) {
  const CadFace face = samples::two_regions_face();
  EXPECT_NEAR(distance(region_places(face, 0).front().position, {0.5, 0.5}), 0, 1e-12);
  EXPECT_NEAR(distance(region_places(face, 1).front().position, {1.5, 0.5}), 0, 1e-12);
  EXPECT_NEAR(region_places(face, 0).front().clearance, 0.5, 1e-12);
}

TEST(RegionLabels, OfARingThePlacesAreBetweenItsCircles) {
  const CadFace face =
      face_of_regions({make_face({circle({0, 0}, 2), hole({0, 0}, 1)}), make_face({circle({0, 0}, 1)})});
  for (const RegionPlace& place : region_places(face, 0)) {
    EXPECT_GT(norm(place.position), 1);
    EXPECT_LT(norm(place.position), 2);
  }
  EXPECT_NEAR(region_places(face, 0).front().clearance, 0.5, 0.06);
  EXPECT_LT(norm(region_places(face, 1).front().position), 1e-12);
}

TEST(RegionLabels, BothSidesOfASlitAreInside) {
  const CadFace face = samples::slit_face();
  const std::vector<RegionPlace> places = region_places(face, 0);
  EXPECT_EQ(places.size(), 33u * 33u - 17u) << "all but those on the slit";
}

TEST(RegionLabels, NamesAreOmittedWithoutRoom) {
  CadFace face = samples::two_regions_face();
  EXPECT_EQ(count(labelled(face, 600), "class=\"region\""), 2);
  face.region_names[1] = std::string(100, 'x');
  EXPECT_EQ(count(labelled(face, 600), "class=\"region\""), 1);
  EXPECT_EQ(count(labelled(face, 110), "class=\"region\""), 0);
  EXPECT_EQ(count(labelled(samples::face(), 600), "class=\"region\""), 0) << "one region";
}

TEST(RegionLabels, NamesDoNotCoverOtherTexts) {
  const CadFace face = samples::two_regions_face();
  DrawOptions options;
  options.width = 600;
  Picture picture(bounding_box(face), options, "", "");
  picture.text(picture.at({0.5, 0.5}), "label", "taken");
  label_regions(picture, face);
  ASSERT_EQ(picture.text_boxes().size(), 3u);
  EXPECT_FALSE(picture.text_boxes()[1].overlaps(picture.text_boxes()[0]));
}

}  // namespace

}  // namespace quadrille::draw
