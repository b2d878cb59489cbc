#include "files/colour_profile.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "pigment/colour.hpp"

#include <cmath>
#include <lcms2.h>

#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using document::error_of;
using pigment::WorkingSpace;
using testing::HasSubstr;
using testing::Pointwise;

class ColourProfileTest : public TemporaryFolder {
  protected:
    std::string file(const std::string& name, const std::string& bytes) const {
        core::write_text_file(folder / name, bytes);
        return (folder / name).string();
    }
};

std::string bytes_of(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

/// The primaries of Adobe RGB (1998) with a gamma of 2.2 and D65.
cmsHPROFILE new_wide_profile() {
    const cmsCIExyY white = {0.3127, 0.3290, 1.0};
    const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1.0}, {0.21, 0.71, 1.0}, {0.15, 0.06, 1.0}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 2.2);
    cmsToneCurve* const curves[] = {curve, curve, curve};
    const cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsFreeToneCurve(curve);
    return profile;
}

std::string wide_profile() {
    return bytes_of(new_wide_profile());
}

/// The same of a medium whose white is a dim yellow.
std::string yellowed_profile() {
    const cmsHPROFILE profile = new_wide_profile();
    const cmsCIEXYZ paper = {0.70, 0.72, 0.45};
    cmsWriteTag(profile, cmsSigMediaWhitePointTag, &paper);
    return bytes_of(profile);
}

/// Writes the same value for every colour, by a table for each of the two intents.
std::string table_profile(double perceptual, double relative) {
    const cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, cmsSigRgbData);
    cmsSetPCS(profile, cmsSigLabData);
    for (const auto& [tag, value] :
         {std::pair{cmsSigBToA0Tag, perceptual}, {cmsSigBToA1Tag, relative}}) {
        const std::vector<cmsUInt16Number> corners(std::size_t{8} * 3,
                                                   static_cast<cmsUInt16Number>(65535.0 * value));
        cmsPipeline* steps = cmsPipelineAlloc(nullptr, 3, 3);
        cmsPipelineInsertStage(steps, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
        cmsPipelineInsertStage(steps, cmsAT_END,
                               cmsStageAllocCLut16bit(nullptr, 2, 3, 3, corners.data()));
        cmsPipelineInsertStage(steps, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
        cmsWriteTag(profile, tag, steps);
        cmsPipelineFree(steps);
    }
    return bytes_of(profile);
}

std::string grey_profile() {
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 2.0);
    const std::string bytes = bytes_of(cmsCreateGrayProfile(cmsD50_xyY(), curve));
    cmsFreeToneCurve(curve);
    return bytes;
}

const std::vector<float> kEncoded = {0.0F, 0.5F, 1.0F, 0.9F, 0.2F, 0.1F, 0.02F, 0.7F, 0.3F};

std::vector<float> decoded(const std::vector<float>& encoded) {
    std::vector<float> linear;
    for (const float value : encoded)
        linear.push_back(static_cast<float>(pigment::decode_srgb(value)));
    return linear;
}

std::vector<float> converted(const std::vector<float>& linear, WorkingSpace to, WorkingSpace from) {
    const pigment::Matrix3 matrix = pigment::linear_from_linear(to, from);
    std::vector<float> result;
    for (std::size_t i = 0; i < linear.size(); i += 3) {
        for (const double value :
             pigment::transformed(matrix, {linear[i], linear[i + 1], linear[i + 2]}))
            result.push_back(static_cast<float>(value));
    }
    return result;
}

pigment::LinearImage read(const std::vector<float>& values, const StoredColour& colour,
                          WorkingSpace space) {
    pigment::LinearImage image{static_cast<int>(values.size() / 3), 1, values, space};
    into_working_space(image, colour, core::Message::verbatim("a.png"));
    return image;
}

TEST(WorkingProfiles, AreSmallVersionFourDisplayProfilesAndAlwaysTheSame) {
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        const IccProfile profile = icc_profile(space);
        EXPECT_LT(profile.size(), 800U);
        EXPECT_EQ(profile[8], 4);
        EXPECT_EQ(profile.substr(12, 12), "mntrRGB XYZ ");
        EXPECT_EQ(profile.substr(36, 4), "acsp");
        EXPECT_EQ(profile, icc_profile(space));
    }
    EXPECT_NE(icc_profile(WorkingSpace::Srgb), icc_profile(WorkingSpace::DisplayP3));
}

TEST(WorkingProfiles, MeanTheirSpace) {
    // The profile's matrix has 16 binary digits after the point, its primaries' sum is D50 in four
    // digits.
    for (const WorkingSpace stored : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        for (const WorkingSpace wanted : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
            const auto image = read(kEncoded, {icc_profile(stored), false, {}}, wanted);
            EXPECT_THAT(image.rgb, Pointwise(testing::FloatNear(2e-4F),
                                             converted(decoded(kEncoded), wanted, stored)));
        }
    }
}

TEST(IntoWorkingSpace, WithoutAProfileValuesAreSrgb) {
    EXPECT_THAT(read(kEncoded, {}, WorkingSpace::Srgb).rgb,
                Pointwise(testing::FloatNear(2e-6F), decoded(kEncoded)));
    const std::vector<float> linear = {0.25F, 3.0F, -0.5F};
    EXPECT_THAT(read(linear, {{}, true, {}}, WorkingSpace::Srgb).rgb,
                Pointwise(testing::FloatNear(2e-6F), linear));
}

TEST(IntoWorkingSpace, ChromaticitiesSayWhatLinearValuesMean) {
    const std::vector<float> linear = {0.25F, 0.5F, 0.75F};
    const StoredColour stored{{}, true, chromaticities_of(WorkingSpace::DisplayP3)};
    EXPECT_THAT(read(linear, stored, WorkingSpace::Srgb).rgb,
                Pointwise(testing::FloatNear(2e-5F),
                          converted(linear, WorkingSpace::Srgb, WorkingSpace::DisplayP3)));
}

TEST(IntoWorkingSpace, WideColoursGoBeyondTheSpace) {
    const auto image = read({0.0F, 1.0F, 0.0F}, {wide_profile(), false, {}}, WorkingSpace::Srgb);
    // Adobe RGB (1998), the green primary in linear sRGB.
    EXPECT_NEAR(image.rgb[0], -0.398, 2e-3);
    EXPECT_NEAR(image.rgb[1], 1.0, 2e-3);
    EXPECT_NEAR(image.rgb[2], -0.043, 2e-3);
}

TEST(IntoWorkingSpace, GreyProfilesApplyToGreys) {
    const auto image = read({0.5F, 0.5F, 0.5F}, {grey_profile(), false, {}}, WorkingSpace::Srgb);
    EXPECT_THAT(image.rgb, Pointwise(testing::FloatNear(1e-3F), {0.25F, 0.25F, 0.25F}));
}

// A scan of yellowed paper is to be seen as its painter saw it: the eye takes the paper for white.
TEST(IntoWorkingSpace, TheWhiteOfTheMediumBecomesWhite) {
    const auto image =
        read({1.0F, 1.0F, 1.0F, 0.5F, 0.5F, 0.5F}, {yellowed_profile(), false, {}}, WorkingSpace::Srgb);
    const float grey = std::pow(0.5F, 2.2F);
    EXPECT_THAT(image.rgb, Pointwise(testing::FloatNear(1e-3F), {1.0F, 1.0F, 1.0F, grey, grey, grey}));
}

TEST(IntoWorkingSpace, RefusesProfilesThatAreNone) {
    EXPECT_THAT(error_of([] {
                    read(kEncoded, {"this is no profile", false, {}}, WorkingSpace::Srgb);
                }),
                testing::StartsWith("a.png: holds an ICC profile that is none ("));
    const std::string cut = icc_profile(WorkingSpace::Srgb).substr(0, 200);
    EXPECT_THAT(error_of([&] {
                    read(kEncoded, {cut, false, {}}, WorkingSpace::Srgb);
                }),
                testing::StartsWith("a.png: holds an ICC profile that "));
    const std::string lab = bytes_of(cmsCreateLab4Profile(nullptr));
    EXPECT_EQ(error_of([&] {
                  read(kEncoded, {lab, false, {}}, WorkingSpace::Srgb);
              }),
              "a.png: holds an ICC profile for Lab, but the picture's values are red, green and blue.");
}

TEST_F(ColourProfileTest, ReadsProfilesForWriting) {
    const std::string wide = wide_profile();
    EXPECT_EQ(read_icc_profile(file("wide.icc", wide)), wide);
}

TEST_F(ColourProfileTest, RefusesFilesThatPicturesCannotBeWrittenIn) {
    const std::string text = file("text.icc", "this is no profile");
    EXPECT_THAT(error_of([&] { read_icc_profile(text); }), HasSubstr("text.icc: is no ICC profile ("));
    EXPECT_THAT(error_of([&] { read_icc_profile(file("empty.icc", "")); }),
                HasSubstr("empty.icc: is no ICC profile ("));
    const std::string cut = file("cut.icc", wide_profile().substr(0, 300));
    EXPECT_THAT(error_of([&] { read_icc_profile(cut); }), HasSubstr("cut.icc: is "));
    EXPECT_THAT(error_of([&] { read_icc_profile(file("grey.icc", grey_profile())); }),
                HasSubstr("grey.icc: is an ICC profile for GRAY, but a picture is written in red"));
    EXPECT_THAT(error_of([] { read_icc_profile("/nonexistent.icc"); }), HasSubstr("cannot be opened"));
}

TEST(InProfile, ConvertsAndReadsBack) {
    const std::vector<float> linear = {0.2F, 0.5F, 0.1F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.0F};
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        const pigment::LinearImage image{3, 1, linear, space};
        const pigment::LinearImage encoded = in_profile(image, wide_profile());
        EXPECT_NEAR(encoded.rgb[3], 1.0F, 1e-4F);
        EXPECT_NEAR(encoded.rgb[6], 0.0F, 1e-4F);
        const auto back = read(encoded.rgb, {wide_profile(), false, {}}, space);
        EXPECT_THAT(back.rgb, Pointwise(testing::FloatNear(5e-4F), linear));
    }
}

TEST(InProfile, WhiteBecomesTheWhiteOfTheMedium) {
    const auto encoded = in_profile({1, 1, {1.0F, 1.0F, 1.0F}}, yellowed_profile());
    EXPECT_THAT(encoded.rgb, Pointwise(testing::FloatNear(1e-3F), {1.0F, 1.0F, 1.0F}));
}

// Its makers have fitted the colours of others into those that a printer has.
TEST(InProfile, TakesThePerceptualTableWhereThereIsOne) {
    const auto encoded = in_profile({1, 1, {0.2F, 0.5F, 0.1F}}, table_profile(0.25, 0.75));
    EXPECT_THAT(encoded.rgb, Pointwise(testing::FloatNear(1e-3F), {0.25F, 0.25F, 0.25F}));
}

TEST(InProfile, BringsColoursIntoThePicturesGamutFirst) {
    const pigment::LinearImage image{1, 1, {1.2F, 0.3F, -0.1F}};
    const pigment::LinearRgb mapped = pigment::into_gamut({1.2F, 0.3F, -0.1F});
    const auto encoded = in_profile(image, icc_profile(WorkingSpace::Srgb));
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(encoded.rgb[i], pigment::encode_srgb(mapped[i]), 1e-3);
}

}  // namespace
}  // namespace pastoso::files
