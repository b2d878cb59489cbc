#include "files/colour_profile.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "files/icc_workshop.hpp"
#include "pigment/colour.hpp"

#include <algorithm>

namespace pastoso::files {
namespace {

using pigment::WorkingSpace;

Profile working_profile(const Workshop& workshop, WorkingSpace space) {
    return rgb_profile(workshop, chromaticities_of(space), linear_curve(workshop));
}

void set_description(const Workshop& workshop, const Profile& profile, const char* text) {
    const std::unique_ptr<cmsMLU, decltype(&cmsMLUfree)> words(cmsMLUalloc(workshop.context(), 1),
                                                               cmsMLUfree);
    PASTOSO_CHECK(cmsMLUsetASCII(words.get(), "en", "US", text));
    PASTOSO_CHECK(cmsWriteTag(profile.get(), cmsSigProfileDescriptionTag, words.get()));
}

IccProfile bytes_of(const Profile& profile) {
    cmsUInt32Number size = 0;
    PASTOSO_CHECK(cmsSaveProfileToMem(profile.get(), nullptr, &size));
    IccProfile bytes(size, '\0');
    PASTOSO_CHECK(cmsSaveProfileToMem(profile.get(), bytes.data(), &size));
    return bytes;
}

/// Replaces the time of making, so that the same picture gives the same file.
void set_creation_date(IccProfile& bytes) {
    constexpr std::size_t kDate = 24;  // in the header: year, month, day, hour, minute, second
    const unsigned char date[] = {2026 / 256, 2026 % 256, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
    std::copy(std::begin(date), std::end(date), bytes.begin() + kDate);
}

/// From linear light of a working space to the profile; null when the profile does not allow it.
Transform to_profile(const Workshop& workshop, WorkingSpace space, const Profile& profile) {
    const Profile source = working_profile(workshop, space);
    return float_transform(workshop, source, profile, intent_of(profile),
                           cmsFLAGS_BLACKPOINTCOMPENSATION);
}

/// The profile that the values in a file are in. `grey` is set where it describes one channel alone.
Profile source_profile(const Workshop& workshop, const StoredColour& colour, const core::Message& name,
                       bool& grey) {
    if (colour.profile.empty()) {
        const Curve curve = colour.linear ? linear_curve(workshop) : srgb_curve(workshop);
        return rgb_profile(workshop,
                           colour.chromaticities.value_or(chromaticities_of(WorkingSpace::Srgb)), curve);
    }
    Profile profile = open_profile(workshop, colour.profile);
    if (profile == nullptr)
        throw core::InputError("%1: holds an ICC profile that is none (%2).", name,
                               workshop.complaint());
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    grey = space == cmsSigGrayData;
    if (space != cmsSigRgbData && !grey) {
        throw core::InputError(
            "%1: holds an ICC profile for %2, but the picture's values are red, green and blue.", name,
            text_of(space));
    }
    return profile;
}

void transform_rows(const Transform& transform, pigment::LinearImage& image) {
    const auto width = static_cast<cmsUInt32Number>(image.width);
    for (int y = 0; y < image.height; ++y) {
        float* row = image.rgb.data() + std::size_t{3} * width * static_cast<std::size_t>(y);
        cmsDoTransform(transform.get(), row, row, width);
    }
}

IccProfile named_profile(const Workshop& workshop, WorkingSpace space, const Curve& curve,
                         const std::string& name) {
    const Profile profile = rgb_profile(workshop, chromaticities_of(space), curve);
    PASTOSO_CHECK(profile != nullptr);
    set_description(workshop, profile, name.c_str());
    IccProfile bytes = bytes_of(profile);
    set_creation_date(bytes);
    return bytes;
}

}  // namespace

IccProfile icc_profile(WorkingSpace space) {
    const Workshop workshop;
    return named_profile(workshop, space, srgb_curve(workshop), pigment::name_of(space));
}

IccProfile linear_icc_profile(WorkingSpace space) {
    const Workshop workshop;
    return named_profile(workshop, space, linear_curve(workshop),
                         std::string(pigment::name_of(space)) + ", linear");
}

IccProfile read_icc_profile(const std::filesystem::path& path) {
    const Workshop workshop;
    IccProfile bytes = profile_bytes(path);
    const Profile profile = checked_profile(workshop, bytes, path.string());
    if (cmsGetColorSpace(profile.get()) != cmsSigRgbData) {
        throw core::InputError(
            "%1: is an ICC profile for %2, but a picture is written in red, green and blue.",
            path.string(), text_of(cmsGetColorSpace(profile.get())));
    }
    if (to_profile(workshop, WorkingSpace::Srgb, profile) == nullptr) {
        throw core::InputError("%1: is an ICC profile that no picture can be written in (%2).",
                               path.string(), workshop.complaint());
    }
    return bytes;
}

Chromaticities chromaticities_of(WorkingSpace space) {
    Chromaticities result{};
    std::size_t i = 0;
    for (const pigment::Chromaticity& primary : pigment::primaries_of(space)) {
        result[i++] = static_cast<float>(primary.x);
        result[i++] = static_cast<float>(primary.y);
    }
    result[i++] = static_cast<float>(pigment::kD65White.x);
    result[i] = static_cast<float>(pigment::kD65White.y);
    return result;
}

void into_working_space(pigment::LinearImage& image, const StoredColour& colour,
                        const core::Message& name) {
    const Workshop workshop;
    bool grey = false;
    const Profile source = source_profile(workshop, colour, name, grey);
    const Profile target = working_profile(workshop, image.space);
    // A grey profile takes the first of three equal values.
    const cmsUInt32Number format = grey ? TYPE_GRAY_FLT | EXTRA_SH(2) : TYPE_RGB_FLT;
    const Transform transform(cmsCreateTransformTHR(workshop.context(), source.get(), format,
                                                    target.get(), TYPE_RGB_FLT,
                                                    INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE));
    if (transform == nullptr) {
        throw core::InputError("%1: holds an ICC profile that cannot be applied (%2).", name,
                               workshop.complaint());
    }
    transform_rows(transform, image);
}

pigment::LinearImage in_profile(const pigment::LinearImage& image, const IccProfile& profile) {
    pigment::LinearImage result = image;
    for (std::size_t i = 0; i < result.rgb.size(); i += 3) {
        const pigment::LinearRgb fitting =
            pigment::into_gamut({result.rgb[i], result.rgb[i + 1], result.rgb[i + 2]}, image.space);
        std::copy(fitting.begin(), fitting.end(), result.rgb.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Workshop workshop;
    const Profile target = open_profile(workshop, profile);
    PASTOSO_CHECK(target != nullptr);
    const Transform transform = to_profile(workshop, image.space, target);
    PASTOSO_CHECK(transform != nullptr);
    transform_rows(transform, result);
    return result;
}

}  // namespace pastoso::files
