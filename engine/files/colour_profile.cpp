#include "files/colour_profile.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "pigment/colour.hpp"

#include <lcms2.h>
#include <memory>
#include <type_traits>

namespace pastoso::files {
namespace {

using pigment::WorkingSpace;

constexpr std::size_t kMaxProfileBytes = std::size_t{1} << 26;

struct Closer {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, Closer>;

struct TransformDeleter {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Transform = std::unique_ptr<void, TransformDeleter>;

struct CurveDeleter {
    void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
using Curve = std::unique_ptr<cmsToneCurve, CurveDeleter>;

/// LittleCMS as one piece of work uses it, with what it complained about.
class Workshop {
  public:
    Workshop() : context_(cmsCreateContext(nullptr, &complaint_)) {
        PASTOSO_CHECK(context_ != nullptr);
        cmsSetLogErrorHandlerTHR(context_, [](cmsContext context, cmsUInt32Number, const char* text) {
            *static_cast<std::string*>(cmsGetContextUserData(context)) = text;
        });
    }
    ~Workshop() { cmsDeleteContext(context_); }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    cmsContext context() const { return context_; }
    std::string complaint() const { return complaint_.empty() ? "it is damaged" : complaint_; }

  private:
    std::string complaint_;
    cmsContext context_;
};

Profile open_profile(const Workshop& workshop, const IccProfile& bytes) {
    return Profile(cmsOpenProfileFromMemTHR(workshop.context(), bytes.data(),
                                            static_cast<cmsUInt32Number>(bytes.size())));
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

/// "CMYK" of the signature 'CMYK'.
std::string text_of(cmsColorSpaceSignature signature) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8)
        text += static_cast<char>(static_cast<unsigned>(signature) >> shift & 0xFFU);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

cmsUInt32Number intent_of(const Profile& profile) {
    return cmsIsCLUT(profile.get(), INTENT_PERCEPTUAL, LCMS_USED_AS_OUTPUT)
               ? INTENT_PERCEPTUAL
               : INTENT_RELATIVE_COLORIMETRIC;
}

/// From linear light of a working space to the profile; null when the profile does not allow it.
Transform to_profile(const Workshop& workshop, WorkingSpace space, const Profile& profile) {
    const Profile source = working_profile(workshop, space);
    return Transform(cmsCreateTransformTHR(workshop.context(), source.get(), TYPE_RGB_FLT, profile.get(),
                                           TYPE_RGB_FLT, intent_of(profile),
                                           cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOCACHE));
}

/// The profile that the values in a file are in. `grey` is set where it describes one channel alone.
Profile source_profile(const Workshop& workshop, const StoredColour& colour, const std::string& name,
                       bool& grey) {
    if (colour.profile.empty()) {
        const Curve curve = colour.linear ? linear_curve(workshop) : srgb_curve(workshop);
        return rgb_profile(workshop,
                           colour.chromaticities.value_or(chromaticities_of(WorkingSpace::Srgb)), curve);
    }
    Profile profile = open_profile(workshop, colour.profile);
    if (profile == nullptr) {
        throw core::InputError(name + ": holds an ICC profile that is none (" + workshop.complaint() +
                               ").");
    }
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    grey = space == cmsSigGrayData;
    if (space != cmsSigRgbData && !grey) {
        throw core::InputError(name + ": holds an ICC profile for " + text_of(space) +
                               ", but the picture's values are red, green and blue.");
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
    IccProfile bytes = core::read_text_file(path, kMaxProfileBytes);
    const Workshop workshop;
    const Profile profile = open_profile(workshop, bytes);
    if (profile == nullptr) {
        throw core::InputError(path.string() + ": is no ICC profile (" + workshop.complaint() + ").");
    }
    if (cmsGetColorSpace(profile.get()) != cmsSigRgbData) {
        throw core::InputError(path.string() + ": is an ICC profile for " +
                               text_of(cmsGetColorSpace(profile.get())) +
                               ", but a picture is written in red, green and blue.");
    }
    if (to_profile(workshop, WorkingSpace::Srgb, profile) == nullptr) {
        throw core::InputError(path.string() +
                               ": is an ICC profile that no picture can be written in (" +
                               workshop.complaint() + ").");
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
                        const std::string& name) {
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
        throw core::InputError(name + ": holds an ICC profile that cannot be applied (" +
                               workshop.complaint() + ").");
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
