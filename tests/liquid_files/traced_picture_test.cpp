#include "liquid_files/traced_picture.hpp"

#include <gtest/gtest.h>

namespace pastoso::liquid_files {
namespace {

TEST(TracedPicture, KeepsItsPixelsPlacesAndIsToned) {
    trace::Picture picture(2, 1);
    picture.rgb = {0.0F, 0.2F, 0.4F, 1.0F, 2.0F, 50.0F};
    const pigment::LinearImage image = shown_image(picture);
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.space, pigment::WorkingSpace::Srgb);
    EXPECT_EQ(image.rgb, trace::toned(picture).rgb);
    const pigment::Image8 bytes = pigment::encode_srgb8(image);
    EXPECT_EQ(bytes.rgb[0], 0);
    EXPECT_EQ(bytes.rgb[5], 255);
    EXPECT_LT(bytes.rgb[1], bytes.rgb[2]);
}

}  // namespace
}  // namespace pastoso::liquid_files
