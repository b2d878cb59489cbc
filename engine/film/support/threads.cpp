#include "film/support/threads.hpp"

#include "film/support/smooth_noise.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

constexpr double kDriftThreads = 25.0;
constexpr double kStretch_mm = 120.0;

constexpr Threads::Noise kAll[] = {Threads::kShared, Threads::kOwn,   Threads::kSlow,
                                   Threads::kBroad,  Threads::kShort, Threads::kDrift};

constexpr float centred(float noise) {
    return 2.0F * noise - 1.0F;
}

std::uint32_t place_of(double whole) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(whole));
}

float share_of(double place) {
    return smooth_step(static_cast<float>(place - std::floor(place)));
}

}  // namespace

float Slub::swell(double along_mm) const {
    const double off = std::abs(along_mm - stretch_mm - middle_mm) / half_mm;
    return !exists || off >= 1.0 ? 0.0F : most * smooth_step(static_cast<float>(1.0 - off));
}

Threads::Threads(const Weave& weave, Direction direction)
    : irregularity_(static_cast<float>(weave.irregularity)),
      half_width_(static_cast<float>(weave.thread_width) / 2.0F),
      pairing_(direction == Direction::Warp ? static_cast<float>(weave.pairing) : 0.0F),
      drift_(static_cast<float>(kDriftThreads / 4.0 * weave.drift)),
      unevenness_(static_cast<float>(weave.unevenness)),
      slubs_per_m_(weave.slubs_per_m),
      crown_(weave.slubs_per_m > 0.0 ? 0.76F : 0.86F),
      above_(weave.slubs_per_m > 0.0 ? 0.24F : 0.14F),
      along_mm_(weave.thread_pitch_mm * (direction == Direction::Warp ? weave.weft_pitch : 1.0)),
      stream_(static_cast<std::uint32_t>(direction)) {}

bool Threads::has(Noise noise) const {
    if (noise == kBroad || noise == kShort) return unevenness_ > 0.0F;
    return noise != kDrift || drift_ > 0.0F;
}

/// Unevenness is as spun: thick and thin within a few centimetres, and within millimetres.
double Threads::places(Noise noise, double along) const {
    switch (noise) {
        case kShared:
            return along / 16.0;
        case kOwn:
            return along / 5.0;
        case kSlow:
            return along / 7.0;
        case kBroad:
            return mm(along) / 9.0;
        case kShort:
            return mm(along) / 2.0;
        default:
            return along / 90.0;
    }
}

std::uint32_t Threads::own_stream(int thread) const {
    return core::scramble(stream_) + static_cast<std::uint32_t>(thread) * 4U;
}

float Threads::value(Noise noise, int thread, std::uint32_t place) const {
    switch (noise) {
        case kShared:
            return smooth_noise(thread / 9.0, core::scramble(stream_) + place);
        case kOwn:
            return core::uniform_noise(place, own_stream(thread));
        case kSlow:
        case kShort:
            return core::uniform_noise(place, own_stream(thread) + 1);
        case kBroad:
            return core::uniform_noise(place, own_stream(thread) + 2);
        default:
            return smooth_noise(thread / kDriftThreads, core::scramble(stream_ + 7) + place);
    }
}

double Threads::stretch(double along) const {
    return std::floor(mm(along) / kStretch_mm);
}

Slub Threads::slub(int thread, double stretch) const {
    constexpr double kShortest_mm = 5.0, kLongest_mm = 40.0;
    constexpr float kThinnest = 0.4F, kThickest = 0.9F;
    const std::uint32_t index = place_of(stretch) * 4U;
    const auto chance = [&](std::uint32_t what) {
        return core::uniform_noise(index + what, own_stream(thread) + 3);
    };
    if (chance(0) >= slubs_per_m_ * kStretch_mm / 1000.0) return {};
    const double half_mm = 0.5 * (kShortest_mm + chance(1) * (kLongest_mm - kShortest_mm));
    const double middle_mm = half_mm + chance(2) * (kStretch_mm - 2.0 * half_mm);
    return {true, stretch * kStretch_mm, middle_mm, half_mm,
            kThinnest + chance(3) * (kThickest - kThinnest)};
}

float Threads::base(int thread) const {
    const float paired = thread % 2 == 0 ? pairing_ : -pairing_;
    return static_cast<float>(thread) + 0.5F + paired;
}

float Threads::thickness(int thread) const {
    return centred(core::uniform_noise(0, own_stream(thread) + 2));
}

void Threads::put_sections(const Spun& spun, Sections& out) const {
    const bool single = spun.base.size() == 1;
    const float *shared = spun.noise[kShared], *own = spun.noise[kOwn], *slow = spun.noise[kSlow],
                *broad = spun.noise[kBroad], *brief = spun.noise[kShort], *drift = spun.noise[kDrift];
    for (std::size_t i = 0; i < out.centre.size(); ++i) {
        const float thickness = spun.thickness[single ? 0 : i];
        float swell = irregularity_ * (0.14F * thickness + 0.12F * centred(slow[i]));
        float course = irregularity_ * (0.25F * centred(shared[i]) + 0.10F * centred(own[i]));
        if (broad != nullptr)
            swell += unevenness_ * (0.7F * centred(broad[i]) + 0.3F * centred(brief[i]));
        if (spun.swell != nullptr) swell += spun.swell[i];
        if (drift != nullptr) course += drift_ * centred(drift[i]);
        out.centre[i] = spun.base[single ? 0 : i] + course;
        out.half_width[i] = half_width_ * (1.0F + swell);
        out.crown[i] = crown_ + std::clamp(0.5F * swell, -0.14F, above_);
    }
}

CutThreads::CutThreads(const Weave& weave, Direction direction, int first, std::size_t count)
    : threads_(weave, direction), first_(first), sections_(count) {
    for (std::size_t i = 0; i < count; ++i) {
        base_.push_back(threads_.base(first + static_cast<int>(i)));
        thickness_.push_back(threads_.thickness(first + static_cast<int>(i)));
    }
}

void CutThreads::cut(double along) {
    Threads::Spun spun{base_, thickness_};
    for (const Threads::Noise noise : kAll) {
        if (!threads_.has(noise)) continue;
        find(noise, along);
        spun.noise[noise] = noises_[noise].value.data();
    }
    if (threads_.has_slubs()) {
        find_slubs(along);
        spun.swell = swell_.data();
    }
    threads_.put_sections(spun, sections_);
}

void CutThreads::find(Threads::Noise noise, double along) {
    Between& here = noises_[noise];
    const double places = threads_.places(noise, along);
    const std::uint32_t place = place_of(std::floor(places));
    const std::size_t count = base_.size();
    if (!here.found || here.place != place) {
        here.found = true;
        here.place = place;
        for (std::vector<float>* each : {&here.before, &here.after, &here.value})
            each->resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const int thread = first_ + static_cast<int>(i);
            here.before[i] = threads_.value(noise, thread, place);
            here.after[i] = threads_.value(noise, thread, place + 1);
        }
    }
    const float share = share_of(places);
    for (std::size_t i = 0; i < count; ++i)
        here.value[i] = here.before[i] + share * (here.after[i] - here.before[i]);
}

void CutThreads::find_slubs(double along) {
    const double stretch = threads_.stretch(along);
    if (slubs_.empty() || stretch != stretch_) {
        slubs_.clear();
        for (std::size_t i = 0; i < base_.size(); ++i)
            slubs_.push_back(threads_.slub(first_ + static_cast<int>(i), stretch));
        stretch_ = stretch;
    }
    swell_.assign(base_.size(), 0.0F);
    for (std::size_t i = 0; i < slubs_.size(); ++i)
        if (slubs_[i].exists) swell_[i] = slubs_[i].swell(threads_.mm(along));
}

FollowedThreads::FollowedThreads(const Weave& weave, Direction direction, std::vector<double> places)
    : threads_(weave, direction), places_(std::move(places)) {
    for (const Threads::Noise noise : kAll) {
        if (!threads_.has(noise)) continue;
        Along& along = noises_[noise];
        along.value.resize(places_.size());
        for (std::size_t k = 0; k < places_.size(); ++k) {
            const double at = threads_.places(noise, places_[k]);
            const std::uint32_t place = place_of(std::floor(at));
            if (along.runs.empty() || along.runs.back().place != place)
                along.runs.push_back({k, k, place});
            along.runs.back().end = k + 1;
            along.share.push_back(share_of(at));
        }
    }
    if (!threads_.has_slubs()) return;
    swell_.resize(places_.size());
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const double number = threads_.stretch(places_[k]);
        if (stretches_.empty() || stretches_.back().number != number)
            stretches_.push_back({k, k, number});
        stretches_.back().end = k + 1;
    }
}

void FollowedThreads::follow(int thread, Sections& out) {
    const float base = threads_.base(thread), thickness = threads_.thickness(thread);
    Threads::Spun spun{{&base, 1}, {&thickness, 1}};
    for (const Threads::Noise noise : kAll) {
        if (!threads_.has(noise)) continue;
        Along& along = noises_[noise];
        for (const Run& run : along.runs) {
            const float before = threads_.value(noise, thread, run.place),
                        after = threads_.value(noise, thread, run.place + 1);
            for (std::size_t k = run.begin; k < run.end; ++k)
                along.value[k] = before + along.share[k] * (after - before);
        }
        spun.noise[noise] = along.value.data();
    }
    if (threads_.has_slubs()) {
        find_slubs(thread);
        spun.swell = swell_.data();
    }
    threads_.put_sections(spun, out);
}

void FollowedThreads::find_slubs(int thread) {
    for (const Stretch& stretch : stretches_) {
        const Slub slub = threads_.slub(thread, stretch.number);
        for (std::size_t k = stretch.begin; k < stretch.end; ++k)
            swell_[k] = slub.exists ? slub.swell(threads_.mm(places_[k])) : 0.0F;
    }
}

}  // namespace pastoso::film
