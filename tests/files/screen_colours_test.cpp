#include "files/screen_colours.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/made_profiles.hpp"
#include "files/temporary_folder.hpp"
#include "pigment/colour.hpp"

#include <algorithm>
#include <cmath>
#include <lcms2.h>
#include <random>

#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using document::error_of;
using pigment::EncodedRgb;
using pigment::WorkingSpace;
using testing::HasSubstr;
using testing::Pointwise;

constexpr float kLevel = 1.0F / 255.0F;

/// Seeded, a third of them dark.
std::vector<EncodedRgb> some_colours(int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> share(0.0F, 1.0F);
    std::vector<EncodedRgb> colours;
    for (int i = 0; i < count; ++i) {
        EncodedRgb colour{share(random), share(random), share(random)};
        if (i % 3 == 0)
            for (float& value : colour)
                value = value * value * value;
        colours.push_back(colour);
    }
    return colours;
}

EncodedRgb shown(const ScreenProfiles& profiles, const EncodedRgb& colour) {
    const auto cube = screen_cube(profiles);
    return cube == nullptr ? colour : pigment::shown_by(*cube, colour);
}

float decoded(float value) {
    return static_cast<float>(pigment::decode_srgb(value));
}

class ScreenColoursFile : public TemporaryFolder {
  protected:
    std::string file(const std::string& name, const std::string& bytes) const {
        core::write_text_file(folder / name, bytes);
        return (folder / name).string();
    }
};

TEST(ScreenColours, NothingIsChangedForTheScreenOfTheSpace) {
    EXPECT_EQ(screen_cube({}), nullptr);
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3})
        EXPECT_EQ(screen_cube({.space = space, .monitor = icc_profile(space)}), nullptr);
    EXPECT_NE(
        screen_cube({.space = WorkingSpace::DisplayP3, .monitor = icc_profile(WorkingSpace::Srgb)}),
        nullptr);
    // Without a printer there is nothing to be seen of it.
    EXPECT_EQ(screen_cube({.soft_proof = true, .gamut_warning = true}), nullptr);
}

TEST(ScreenColours, SwappedPrimariesSwapColours) {
    const ScreenProfiles profiles{.monitor = tests::made_monitor(tests::swapped_primaries(), 1.8)};
    const auto cube = screen_cube(profiles);
    for (const EncodedRgb& colour : some_colours(2000)) {
        EncodedRgb wanted{colour[1], colour[0], colour[2]};
        for (float& value : wanted)
            value = std::pow(decoded(value), 1.0F / 1.8F);
        // Between nodes a fifth of a level; the matrix of a profile has 16 digits after the point, which
        // the curve raises in the dark.
        EXPECT_THAT(pigment::shown_by(*cube, colour), Pointwise(testing::FloatNear(kLevel), wanted));
    }
}

TEST(ScreenColours, GreysStayGrey) {
    auto xy = chromaticities_of(WorkingSpace::Srgb);
    xy[0] -= 0.02F;
    xy[3] -= 0.03F;
    const ScreenProfiles profiles{.monitor = tests::made_monitor(xy, 2.2)};
    const auto cube = screen_cube(profiles);
    for (int level = 0; level <= 1020; ++level) {
        const float grey = static_cast<float>(level) / 1020.0F;
        const EncodedRgb seen = pigment::shown_by(*cube, {grey, grey, grey});
        const float wanted = std::pow(decoded(grey), 1.0F / 2.2F);
        EXPECT_THAT(seen, Pointwise(testing::FloatNear(kLevel / 4.0F), {wanted, wanted, wanted}));
    }
}

TEST(ScreenColours, ValuesAreGreysOfTheSameLuminance) {
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        const auto cube = screen_cube({.space = space, .values = true});
        const std::array<float, 3> weights = pigment::luminance_weights(space);
        for (const EncodedRgb& colour : some_colours(2000)) {
            double luminance = 0.0;
            for (int k = 0; k < 3; ++k)
                luminance += weights[k] * pigment::decode_srgb(colour[k]);
            const auto grey = static_cast<float>(pigment::encode_srgb(luminance));
            // Between nodes, where a curve is interpolated along a line.
            EXPECT_THAT(pigment::shown_by(*cube, colour),
                        Pointwise(testing::FloatNear(kLevel), {grey, grey, grey}));
        }
    }
}

TEST(ScreenColours, ValuesAreShownOnTheScreenThatThereIs) {
    const ScreenProfiles profiles{.monitor = tests::made_monitor(tests::swapped_primaries(), 1.8),
                                  .values = true};
    const auto cube = screen_cube(profiles);
    const EncodedRgb red = pigment::shown_by(*cube, {1.0F, 0.0F, 0.0F});
    const float wanted = std::pow(pigment::luminance_weights(WorkingSpace::Srgb)[0], 1.0F / 1.8F);
    EXPECT_THAT(red, Pointwise(testing::FloatNear(kLevel), {wanted, wanted, wanted}));
}

/// What LittleCMS makes of a colour without a table of ours.
EncodedRgb converted(const IccProfile& from, const IccProfile& to, const EncodedRgb& colour) {
    const cmsHPROFILE source = cmsOpenProfileFromMem(from.data(), static_cast<unsigned>(from.size()));
    const cmsHPROFILE target = cmsOpenProfileFromMem(to.data(), static_cast<unsigned>(to.size()));
    const cmsHTRANSFORM way = cmsCreateTransform(source, TYPE_RGB_FLT, target, TYPE_RGB_FLT,
                                                 INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
    EncodedRgb result{};
    cmsDoTransform(way, colour.data(), result.data(), 1);
    cmsDeleteTransform(way);
    cmsCloseProfile(source);
    cmsCloseProfile(target);
    for (float& value : result)
        value = std::clamp(value, 0.0F, 1.0F);
    return result;
}

struct Differences {
    float largest = 0.0F, mean = 0.0F;
};

/// Of the table from LittleCMS, in levels.
Differences differences(WorkingSpace space, const IccProfile& monitor) {
    const auto cube = screen_cube({.space = space, .monitor = monitor});
    const auto colours = some_colours(3000);
    Differences result;
    for (const EncodedRgb& colour : colours) {
        const EncodedRgb exact = converted(icc_profile(space), monitor, colour);
        const EncodedRgb seen = pigment::shown_by(*cube, colour);
        for (int i = 0; i < 3; ++i) {
            const float difference = std::abs(seen[i] - exact[i]) / kLevel;
            result.largest = std::max(result.largest, difference);
            result.mean += difference / (3.0F * static_cast<float>(colours.size()));
        }
    }
    return result;
}

// A screen that has all colours of the space: nothing is clipped, all is smooth.
TEST(ScreenColours, AreThoseOfLittleCmsToAFractionOfALevel) {
    // ITU-R BT.2020 with D65
    const Chromaticities wide = {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F};
    for (const double gamma : {1.8, 2.2}) {
        const Differences found = differences(WorkingSpace::Srgb, tests::made_monitor(wide, gamma));
        EXPECT_LT(found.largest, 0.5F) << gamma;
        EXPECT_LT(found.mean, 0.05F) << gamma;
    }
}

// Where a colour leaves the screen's gamut one of its channels begins with a steep curve, which no table
// follows: there, the channel that is nearly dark beside bright ones is off by some levels.
TEST(ScreenColours, AreNearThoseOfLittleCmsWhereAScreenHasThemNot) {
    const Differences found = differences(WorkingSpace::DisplayP3, icc_profile(WorkingSpace::Srgb));
    EXPECT_LT(found.largest, 16.0F);
    EXPECT_LT(found.mean, 0.12F);
}

// The tables of the printer's profile have 49 steps of Lab and 13 of an ink: in the dark they are off by
// some levels.
TEST(ScreenColours, AProofIsSeenAsItIsPrinted) {
    const IccProfile printer = tests::made_printer();
    const auto cube = screen_cube({.printer = printer, .soft_proof = true});
    double mean = 0.0;
    const auto colours = some_colours(2000);
    for (const EncodedRgb& colour : colours) {
        const EncodedRgb seen = pigment::shown_by(*cube, colour);
        const auto wanted = tests::printed({colour[0], colour[1], colour[2]});
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(seen[i], wanted[i], 16.0 * kLevel);
            mean += std::abs(seen[i] - wanted[i]) / (3.0 * static_cast<double>(colours.size()));
        }
    }
    EXPECT_LT(mean, 1.5 * kLevel);
    EXPECT_EQ(screen_cube({.printer = printer}), nullptr);
}

/// How far a colour of Display P3 lies within what sRGB has, of encoded values; below 0 outside.
double distance_within_srgb(const EncodedRgb& colour) {
    static const auto to_srgb = pigment::linear_from_linear(WorkingSpace::Srgb, WorkingSpace::DisplayP3);
    double distance = 1.0;
    for (const double linear :
         pigment::transformed(to_srgb, {decoded(colour[0]), decoded(colour[1]), decoded(colour[2])})) {
        const double size = std::abs(linear);
        const double encoded = size > 1.0 ? size : pigment::encode_srgb(size);
        const double value = std::copysign(encoded, linear);
        distance = std::min({distance, value, 1.0 - value});
    }
    return distance;
}

// The printer's profile is that of sRGB: what cannot be printed is what lies outside that, by more than
// the eye sees. The border is exact to half a step of the table, which is 0.04 where that is widest; a
// channel that is 0.15 below 0 in its curve is a fiftieth of the light.
TEST(ScreenColours, TheWarningMarksWhatLiesOutside) {
    const auto cube = screen_cube({.space = WorkingSpace::DisplayP3,
                                   .printer = icc_profile(WorkingSpace::Srgb),
                                   .gamut_warning = true});
    int inside = 0, outside = 0;
    for (const EncodedRgb& colour : some_colours(6000)) {
        const double distance = distance_within_srgb(colour);
        const EncodedRgb seen = pigment::shown_by(*cube, colour);
        if (distance > 0.02) {
            ++inside;
            EXPECT_THAT(seen, Pointwise(testing::FloatNear(0.1F * kLevel), colour)) << distance;
        } else if (distance < -0.15) {
            ++outside;
            EXPECT_EQ(seen, pigment::kGamutMark) << distance << testing::PrintToString(colour);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 500);
}

TEST(ScreenColours, ABrightGreenIsMarkedForFourInks) {
    const ScreenProfiles profiles{.printer = tests::made_printer(), .gamut_warning = true};
    EXPECT_EQ(shown(profiles, {0.0F, 1.0F, 0.0F}), pigment::kGamutMark);
    EXPECT_NE(shown(profiles, {0.45F, 0.5F, 0.4F}), pigment::kGamutMark);
}

TEST_F(ScreenColoursFile, ProfilesAreReadAndNamed) {
    const IccProfile monitor = tests::made_monitor(tests::swapped_primaries(), 1.8, "a screen");
    EXPECT_EQ(read_monitor_profile(file("a.icc", monitor)), monitor);
    EXPECT_EQ(description_of(monitor), "a screen");
    const IccProfile printer = tests::made_printer();
    EXPECT_EQ(read_printer_profile(file("b.icc", printer)), printer);
    EXPECT_EQ(read_printer_profile(file("c.icc", monitor)), monitor) << "some printers take RGB";
    EXPECT_EQ(description_of(printer), "four inks");
}

TEST_F(ScreenColoursFile, RefusesWhatIsNoneInOneSentence) {
    const std::string text = file("text.icc", "this is no profile");
    const std::string four = file("four.icc", tests::made_printer());
    EXPECT_THAT(error_of([&] { read_monitor_profile(text); }),
                HasSubstr("text.icc: is no ICC profile ("));
    EXPECT_THAT(error_of([&] { read_printer_profile(text); }),
                HasSubstr("text.icc: is no ICC profile ("));
    EXPECT_THAT(error_of([&] { read_monitor_profile(four); }),
                HasSubstr("is an ICC profile for CMYK, but a screen shows red, green and blue."));
    EXPECT_THAT(error_of([] { read_monitor_profile("/nonexistent.icc"); }),
                HasSubstr("cannot be opened"));
    const std::string cut = file("cut.icc", tests::made_printer().substr(0, 300));
    EXPECT_THAT(error_of([&] { read_printer_profile(cut); }), HasSubstr("cut.icc: is "));
}

}  // namespace
}  // namespace pastoso::files
