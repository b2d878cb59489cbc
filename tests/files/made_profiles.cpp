#include "files/made_profiles.hpp"

#include <algorithm>
#include <lcms2.h>
#include <utility>
#include <vector>

namespace pastoso::tests {
namespace {

using Rgb = std::array<double, 3>;

files::IccProfile bytes_of(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    files::IccProfile bytes(size, '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

void describe(cmsHPROFILE profile, const char* name) {
    cmsMLU* words = cmsMLUalloc(nullptr, 1);
    cmsMLUsetASCII(words, "en", "US", name);
    cmsWriteTag(profile, cmsSigProfileDescriptionTag, words);
    cmsMLUfree(words);
}

/// Between encoded sRGB and Lab, doubles.
cmsHTRANSFORM lab_way(bool to_lab) {
    const cmsHPROFILE srgb = cmsCreate_sRGBProfile(), lab = cmsCreateLab4Profile(nullptr);
    const cmsHTRANSFORM way =
        to_lab ? cmsCreateTransform(srgb, TYPE_RGB_DBL, lab, TYPE_Lab_DBL, 1, cmsFLAGS_NOOPTIMIZE)
               : cmsCreateTransform(lab, TYPE_Lab_DBL, srgb, TYPE_RGB_DBL, 1, cmsFLAGS_NOOPTIMIZE);
    cmsCloseProfile(srgb);
    cmsCloseProfile(lab);
    return way;
}

/// Lab as profiles of version 4 encode it in 16 bits.
constexpr double kMost = 65535.0;

/// Moves each value so far from the mean of the three as it is, times a factor.
Rgb purified(const Rgb& rgb, double factor) {
    const double mean = (rgb[0] + rgb[1] + rgb[2]) / 3.0;
    return {mean + factor * (rgb[0] - mean), mean + factor * (rgb[1] - mean),
            mean + factor * (rgb[2] - mean)};
}

/// Shares of the paper's light that the inks leave.
Rgb left_by_inks(const Rgb& rgb) {
    Rgb left = purified(rgb, 1.0 / kInkPurity);
    for (double& share : left)
        share = std::clamp(share, 0.0, 1.0);
    return left;
}

cmsInt32Number inks_to_lab(const cmsUInt16Number inks[], cmsUInt16Number lab16[], void* to_lab) {
    Rgb left;
    for (int i = 0; i < 3; ++i)
        left[i] = (1.0 - inks[i] / kMost) * (1.0 - inks[3] / kMost);
    const Rgb rgb = purified(left, kInkPurity);
    Rgb lab;
    cmsDoTransform(to_lab, rgb.data(), lab.data(), 1);
    lab16[0] = static_cast<cmsUInt16Number>(lab[0] / 100.0 * kMost + 0.5);
    for (int i = 1; i < 3; ++i)
        lab16[i] = static_cast<cmsUInt16Number>((lab[i] + 128.0) / 255.0 * kMost + 0.5);
    return 1;
}

cmsInt32Number lab_to_inks(const cmsUInt16Number lab16[], cmsUInt16Number inks[], void* from_lab) {
    const Rgb lab = {lab16[0] / kMost * 100.0, lab16[1] / kMost * 255.0 - 128.0,
                     lab16[2] / kMost * 255.0 - 128.0};
    Rgb rgb;
    cmsDoTransform(from_lab, lab.data(), rgb.data(), 1);
    const Rgb left = left_by_inks(rgb);
    for (int i = 0; i < 3; ++i)
        inks[i] = static_cast<cmsUInt16Number>(kMost * (1.0 - left[i]) + 0.5);
    inks[3] = 0;
    return 1;
}

void write_table(cmsHPROFILE profile, cmsTagSignature tag, int in, int out, int points,
                 cmsSAMPLER16 sampler, void* way) {
    cmsPipeline* steps = cmsPipelineAlloc(nullptr, in, out);
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, points, in, out, nullptr);
    cmsStageSampleCLut16bit(table, sampler, way, 0);
    cmsPipelineInsertStage(steps, cmsAT_END, cmsStageAllocToneCurves(nullptr, in, nullptr));
    cmsPipelineInsertStage(steps, cmsAT_END, table);
    cmsPipelineInsertStage(steps, cmsAT_END, cmsStageAllocToneCurves(nullptr, out, nullptr));
    cmsWriteTag(profile, tag, steps);
    cmsPipelineFree(steps);
}

}  // namespace

files::IccProfile made_monitor(const files::Chromaticities& xy, double gamma, const char* name) {
    const cmsCIExyY white = {xy[6], xy[7], 1.0};
    const cmsCIExyYTRIPLE primaries = {{xy[0], xy[1], 1.0}, {xy[2], xy[3], 1.0}, {xy[4], xy[5], 1.0}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    cmsToneCurve* const curves[] = {curve, curve, curve};
    const cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsFreeToneCurve(curve);
    describe(profile, name);
    return bytes_of(profile);
}

files::Chromaticities swapped_primaries() {
    files::Chromaticities xy = files::chromaticities_of(pigment::WorkingSpace::Srgb);
    std::swap(xy[0], xy[2]);
    std::swap(xy[1], xy[3]);
    return xy;
}

files::IccProfile made_printer() {
    const cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, cmsSigCmykData);
    cmsSetPCS(profile, cmsSigLabData);
    cmsWriteTag(profile, cmsSigMediaWhitePointTag, cmsD50_XYZ());
    describe(profile, "four inks");
    const cmsHTRANSFORM to_lab = lab_way(true), from_lab = lab_way(false);
    write_table(profile, cmsSigAToB0Tag, 4, 3, 13, inks_to_lab, to_lab);
    write_table(profile, cmsSigBToA0Tag, 3, 4, 49, lab_to_inks, from_lab);
    cmsDeleteTransform(to_lab);
    cmsDeleteTransform(from_lab);
    return bytes_of(profile);
}

Rgb printed(const Rgb& colour) {
    return purified(left_by_inks(colour), kInkPurity);
}

}  // namespace pastoso::tests
