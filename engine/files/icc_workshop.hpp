// LittleCMS, as what works with colour profiles uses it.
#pragma once

#include "files/colour_profile.hpp"

#include <lcms2.h>
#include <memory>
#include <string>

namespace pastoso::files {

struct ProfileCloser {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, ProfileCloser>;

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
    Workshop();
    ~Workshop() { cmsDeleteContext(context_); }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    cmsContext context() const { return context_; }
    core::Message complaint() const {
        return complaint_.empty() ? core::message("it is damaged") : core::Message::verbatim(complaint_);
    }

  private:
    std::string complaint_;
    cmsContext context_;
};

/// Null when the bytes are no profile.
Profile open_profile(const Workshop& workshop, const IccProfile& bytes);

/// What a file holds, which may be none.
IccProfile profile_bytes(const std::filesystem::path& path);

/// Throws InputError, with the name, when the bytes are no profile.
Profile checked_profile(const Workshop& workshop, const IccProfile& bytes, const std::string& name);

/// "CMYK" of the signature 'CMYK'.
std::string text_of(cmsColorSpaceSignature signature);

Curve srgb_curve(const Workshop& workshop);
Curve linear_curve(const Workshop& workshop);
Profile rgb_profile(const Workshop& workshop, const Chromaticities& xy, const Curve& curve);

/// How pictures are written with a profile.
cmsUInt32Number intent_of(const Profile& profile);

/// Between floats of two profiles, as many a colour as it takes; null when the profiles do not allow it.
Transform float_transform(const Workshop& workshop, const Profile& from, const Profile& to,
                          cmsUInt32Number intent, cmsUInt32Number flags);

}  // namespace pastoso::files
