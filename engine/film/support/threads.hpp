// The threads of a weave: where each lies, how wide it is and how high it stands, from place to place
// along it. All of it is smooth noise of the thread's number and of the place; what neighbouring places
// have in common is found once.
#pragma once

#include "film/support/support.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pastoso::film {

enum class Direction : std::uint32_t { Warp = 1000, Weft = 2000 };

/// Threads where lines cross them, or one thread at places along it; lengths in pitches.
struct Sections {
    std::vector<float> centre;
    std::vector<float> half_width;
    std::vector<float> crown;  ///< of the highest threads, 0 to 1: thick ones stand out of the cloth

    explicit Sections(std::size_t count = 0) : centre(count), half_width(count), crown(count) {}
};

/// A stretch of a thread that was spun too thick, or none.
struct Slub {
    bool exists = false;
    double stretch_mm = 0.0;  ///< where the stretch begins
    double middle_mm = 0.0;   ///< in it
    double half_mm = 1.0;
    float most = 0.0F;

    /// The swell of the thread's width, 0 outside.
    float swell(double along_mm) const;
};

/// How the threads of one direction wander and how thick they are.
class Threads {
  public:
    enum Noise { kShared, kOwn, kSlow, kBroad, kShort, kDrift };
    static constexpr int kNoises = 6;
    using Values = std::array<const float*, kNoises>;

    Threads(const Weave& weave, Direction direction);

    /// Whether these threads are moved by it.
    bool has(Noise noise) const;
    /// How many of its whole places lie before a place along the threads, counted in pitches.
    double places(Noise noise, double along) const;
    /// Its value at a whole place.
    float value(Noise noise, int thread, std::uint32_t place) const;

    double mm(double along) const { return along * along_mm_; }
    bool has_slubs() const { return slubs_per_m_ > 0.0; }
    /// Slubs are rolled for in stretches, one in each at most.
    double stretch(double along) const;
    Slub slub(int thread, double stretch) const;

    /// Of threads: base() and thickness() of each. Along one: the same for all.
    float base(int thread) const;
    float thickness(int thread) const;

    /// Sections of what has these values of the noises; null for those that it has not. `swell` is that
    /// of slubs.
    struct Spun {
        std::span<const float> base, thickness;  ///< one, or as many as there are sections
        Values noise{};
        const float* swell = nullptr;
    };
    void put_sections(const Spun& spun, Sections& out) const;

  private:
    std::uint32_t own_stream(int thread) const;

    float irregularity_;
    float half_width_;
    float pairing_;
    float drift_;  ///< largest shift of a thread, pitches
    float unevenness_;
    double slubs_per_m_;
    float crown_, above_;  ///< of threads of middle width, and how much higher others may be
    double along_mm_;      ///< a pitch of the crossing threads
    std::uint32_t stream_;
};

/// Neighbouring threads, cut by one line after the other.
class CutThreads {
  public:
    CutThreads(const Weave& weave, Direction direction, int first, std::size_t count);

    void cut(double along);
    const Sections& sections() const { return sections_; }

  private:
    /// A noise between two whole places, of each thread.
    struct Between {
        bool found = false;
        std::uint32_t place = 0;
        std::vector<float> before, after, value;
    };

    void find(Threads::Noise noise, double along);
    void find_slubs(double along);

    Threads threads_;
    int first_;
    std::vector<float> base_, thickness_, swell_;
    std::array<Between, Threads::kNoises> noises_;
    double stretch_ = 0.0;
    std::vector<Slub> slubs_;  ///< of each thread, in that stretch
    Sections sections_;
};

/// One thread after the other, at the same places along them.
class FollowedThreads {
  public:
    /// The places are ascending.
    FollowedThreads(const Weave& weave, Direction direction, std::vector<double> places);

    void follow(int thread, Sections& out);

  private:
    /// Places between the same two whole ones of a noise.
    struct Run {
        std::size_t begin, end;
        std::uint32_t place;
    };
    struct Stretch {
        std::size_t begin, end;
        double number;
    };
    void find_slubs(int thread);

    struct Along {
        std::vector<Run> runs;
        std::vector<float> share, value;
    };

    Threads threads_;
    std::vector<double> places_;
    std::array<Along, Threads::kNoises> noises_;
    std::vector<Stretch> stretches_;
    std::vector<float> swell_;
};

}  // namespace pastoso::film
