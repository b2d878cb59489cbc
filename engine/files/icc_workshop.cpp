#include "files/icc_workshop.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"

namespace pastoso::files {
namespace {

constexpr std::size_t kMaxProfileBytes = std::size_t{1} << 26;

/// Four bytes a value.
cmsUInt32Number float_format(const Profile& profile) {
    return cmsFormatterForColorspaceOfProfile(profile.get(), 4, TRUE);
}

}  // namespace

Workshop::Workshop() : context_(cmsCreateContext(nullptr, &complaint_)) {
    PASTOSO_CHECK(context_ != nullptr);
    cmsSetLogErrorHandlerTHR(context_, [](cmsContext context, cmsUInt32Number, const char* text) {
        *static_cast<std::string*>(cmsGetContextUserData(context)) = text;
    });
}

Profile open_profile(const Workshop& workshop, const IccProfile& bytes) {
    return Profile(cmsOpenProfileFromMemTHR(workshop.context(), bytes.data(),
                                            static_cast<cmsUInt32Number>(bytes.size())));
}

IccProfile profile_bytes(const std::filesystem::path& path) {
    return core::read_text_file(path, kMaxProfileBytes);
}

Profile checked_profile(const Workshop& workshop, const IccProfile& bytes, const std::string& name) {
    Profile profile = open_profile(workshop, bytes);
    if (profile == nullptr)
        throw core::InputError("%1: is no ICC profile (%2).", name, workshop.complaint());
    return profile;
}

std::string text_of(cmsColorSpaceSignature signature) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8)
        text += static_cast<char>(static_cast<unsigned>(signature) >> shift & 0xFFU);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

Curve srgb_curve(const Workshop& workshop) {
    // ICC.1, parametric curve of type 3: ((a x + b)^g from d on, c x below.
    const cmsFloat64Number parameters[] = {2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045};
    return Curve(cmsBuildParametricToneCurve(workshop.context(), 4, parameters));
}

Curve linear_curve(const Workshop& workshop) {
    return Curve(cmsBuildGamma(workshop.context(), 1.0));
}

Profile rgb_profile(const Workshop& workshop, const Chromaticities& xy, const Curve& curve) {
    const cmsCIExyY white = {xy[6], xy[7], 1.0};
    const cmsCIExyYTRIPLE primaries = {{xy[0], xy[1], 1.0}, {xy[2], xy[3], 1.0}, {xy[4], xy[5], 1.0}};
    cmsToneCurve* const curves[] = {curve.get(), curve.get(), curve.get()};
    return Profile(cmsCreateRGBProfileTHR(workshop.context(), &white, &primaries, curves));
}

cmsUInt32Number intent_of(const Profile& profile) {
    return cmsIsCLUT(profile.get(), INTENT_PERCEPTUAL, LCMS_USED_AS_OUTPUT)
               ? INTENT_PERCEPTUAL
               : INTENT_RELATIVE_COLORIMETRIC;
}

Transform float_transform(const Workshop& workshop, const Profile& from, const Profile& to,
                          cmsUInt32Number intent, cmsUInt32Number flags) {
    return Transform(cmsCreateTransformTHR(workshop.context(), from.get(), float_format(from), to.get(),
                                           float_format(to), intent, flags | cmsFLAGS_NOCACHE));
}

}  // namespace pastoso::files
