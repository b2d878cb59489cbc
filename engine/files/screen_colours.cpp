#include "files/screen_colours.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "files/icc_workshop.hpp"
#include "pigment/colour.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::files {
namespace {

using pigment::ColourCube;

constexpr cmsUInt32Number kBlackMatched = cmsFLAGS_BLACKPOINTCOMPENSATION;

/// So many colours are converted at once.
constexpr std::size_t kAtOnce = std::size_t{ColourCube::kSide} * ColourCube::kSide;

Profile encoded_profile(const Workshop& workshop, pigment::WorkingSpace space) {
    return rgb_profile(workshop, chromaticities_of(space), srgb_curve(workshop));
}

/// Values of colours, so many a colour.
struct Colours {
    std::size_t channels = 3;
    std::vector<float> values{};
};

std::size_t channels_of(const Profile& profile) {
    return cmsChannelsOf(cmsGetColorSpace(profile.get()));
}

/// The most that a device takes: LittleCMS counts light to 1 and ink to 100.
float most_of(const Profile& profile) {
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    return space == cmsSigRgbData || space == cmsSigGrayData ? 1.0F : 100.0F;
}

/// From the values of one profile to those of another.
struct Way {
    Transform transform;
    std::size_t channels;
    bool ends_at_device;
    float most;

    Way(const Workshop& workshop, const Profile& from, const Profile& to, cmsUInt32Number intent,
        cmsUInt32Number flags)
        : transform(float_transform(workshop, from, to, intent, flags)),
          channels(channels_of(to)),
          ends_at_device(cmsGetColorSpace(to.get()) != cmsSigLabData),
          most(most_of(to)) {}

    bool exists() const { return transform != nullptr; }

    Colours along(const Colours& colours) const {
        const std::size_t count = colours.values.size() / colours.channels;
        Colours result{channels, std::vector<float>(count * channels)};
        cmsDoTransform(transform.get(), colours.values.data(), result.values.data(),
                       static_cast<cmsUInt32Number>(count));
        // Floats of LittleCMS go on beyond what a device has.
        if (ends_at_device)
            for (float& value : result.values)
                value = std::clamp(value, 0.0F, most);
        return result;
    }
};

/// How a printed colour is seen.
Way seen_on(const Workshop& workshop, const Profile& printer, const Profile& monitor) {
    return {workshop, printer, monitor, INTENT_RELATIVE_COLORIMETRIC, kBlackMatched};
}

/// The greys of the same luminance.
Colours greys_of(const Colours& colours, pigment::WorkingSpace space) {
    const std::array<float, 3> weights = pigment::luminance_weights(space);
    Colours greys = colours;
    for (std::size_t i = 0; i < greys.values.size(); i += 3) {
        double luminance = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            luminance += weights[k] * pigment::decode_srgb(colours.values[i + k]);
        std::fill_n(greys.values.begin() + static_cast<std::ptrdiff_t>(i), 3,
                    static_cast<float>(pigment::encode_srgb(luminance)));
    }
    return greys;
}

class ScreenWay {
  public:
    explicit ScreenWay(const ScreenProfiles& profiles)
        : space_(encoded_profile(workshop_, profiles.space)),
          monitor_(profiles.monitor.empty() ? encoded_profile(workshop_, profiles.space)
                                            : open_profile(workshop_, profiles.monitor)),
          printer_(profiles.printer.empty() ? nullptr : open_profile(workshop_, profiles.printer)),
          working_space_(profiles.space),
          values_(profiles.values) {
        const bool prints = printer_ != nullptr;
        if (prints && profiles.soft_proof) {
            shown_.emplace_back(workshop_, space_, printer_, intent_of(printer_), kBlackMatched);
            shown_.push_back(seen_on(workshop_, printer_, monitor_));
        } else if (!profiles.monitor.empty()) {
            shown_.emplace_back(workshop_, space_, monitor_, intent_of(monitor_), kBlackMatched);
        }
        if (!prints || !profiles.gamut_warning) return;
        constexpr auto kRelative = INTENT_RELATIVE_COLORIMETRIC;
        wanted_.emplace_back(workshop_, space_, lab_, kRelative, 0);
        printed_.emplace_back(workshop_, space_, printer_, kRelative, kBlackMatched);
        printed_.push_back(seen_on(workshop_, printer_, lab_));
        tolerance_ = cmsIsMatrixShaper(printer_.get()) ? 1.0F : 5.0F;
    }

    bool changes_something() const { return values_ || !shown_.empty() || !printed_.empty(); }

    void convert(const Colours& colours, ColourCube::Node* nodes) const {
        const Colours shown = along(shown_, values_ ? greys_of(colours, working_space_) : colours);
        const Colours wanted = along(wanted_, colours), printed = along(printed_, colours);
        for (std::size_t i = 0; i < kAtOnce; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                nodes[i].shown[k] = shown.values[3 * i + k];
            if (printed_.empty()) continue;
            // Alike on both sides of the border, so that what is interpolated begins on it.
            const float beyond = difference(&wanted.values[3 * i], &printed.values[3 * i]) - tolerance_;
            nodes[i].outside = std::min(beyond, tolerance_);
        }
    }

  private:
    static Colours along(const std::vector<Way>& ways, Colours colours) {
        for (const Way& way : ways) {
            PASTOSO_CHECK(way.exists());
            colours = way.along(colours);
        }
        return colours;
    }

    /// CIE 1976.
    static float difference(const float* a, const float* b) {
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }

    Workshop workshop_;
    Profile space_, monitor_, printer_;
    Profile lab_{cmsCreateLab4ProfileTHR(workshop_.context(), nullptr)};
    std::vector<Way> shown_, wanted_, printed_;
    pigment::WorkingSpace working_space_;
    bool values_;
    float tolerance_ = 0.0F;
};

/// Of one value of blue, red fastest.
Colours colours_of_slice(int blue) {
    Colours colours;
    colours.values.reserve(3 * kAtOnce);
    for (int green = 0; green < ColourCube::kSide; ++green)
        for (int red = 0; red < ColourCube::kSide; ++red)
            for (const int step : {red, green, blue})
                colours.values.push_back(ColourCube::value_at(step));
    return colours;
}

}  // namespace

IccProfile read_monitor_profile(const std::filesystem::path& path) {
    return monitor_profile(profile_bytes(path), path.string());
}

IccProfile monitor_profile(IccProfile bytes, const std::string& name) {
    const Workshop workshop;
    const Profile profile = checked_profile(workshop, bytes, name);
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    if (space != cmsSigRgbData)
        throw core::InputError("%1: is an ICC profile for %2, but a screen shows red, green and blue.",
                               name, text_of(space));
    const Profile source = encoded_profile(workshop, pigment::WorkingSpace::Srgb);
    if (!Way(workshop, source, profile, intent_of(profile), kBlackMatched).exists())
        throw core::InputError("%1: is an ICC profile that no colour can be shown with (%2).", name,
                               workshop.complaint());
    return bytes;
}

IccProfile read_printer_profile(const std::filesystem::path& path) {
    const Workshop workshop;
    IccProfile bytes = profile_bytes(path);
    const Profile profile = checked_profile(workshop, bytes, path.string());
    const Profile screen = encoded_profile(workshop, pigment::WorkingSpace::Srgb);
    const bool prints = Way(workshop, screen, profile, intent_of(profile), kBlackMatched).exists();
    if (!prints || !seen_on(workshop, profile, screen).exists())
        throw core::InputError("%1: is an ICC profile that no print can be shown with (%2).",
                               path.string(), workshop.complaint());
    return bytes;
}

std::string description_of(const IccProfile& profile) {
    const Workshop workshop;
    const Profile opened = open_profile(workshop, profile);
    PASTOSO_CHECK(opened != nullptr);
    const auto text = [&](char* into, cmsUInt32Number size) {
        return cmsGetProfileInfoASCII(opened.get(), cmsInfoDescription, "en", "US", into, size);
    };
    std::string words(text(nullptr, 0), '\0');
    text(words.data(), static_cast<cmsUInt32Number>(words.size()));
    return words.substr(0, words.find('\0'));
}

std::shared_ptr<const ColourCube> screen_cube(const ScreenProfiles& profiles) {
    const ScreenWay way(profiles);
    if (!way.changes_something()) return nullptr;
    auto cube = std::make_shared<ColourCube>();
    for (int blue = 0; blue < ColourCube::kSide; ++blue)
        way.convert(colours_of_slice(blue), cube->nodes.data() + kAtOnce * blue);
    return changes_nothing(*cube) ? nullptr : cube;
}

}  // namespace pastoso::files
