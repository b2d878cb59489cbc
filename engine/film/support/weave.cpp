// The relief of a primed plain weave. Warp threads run along y, weft threads along x. Where they cross,
// one lies above the other, in turn, so that every thread rises and dips like a wave; its cross-section
// is a round crown. The cloth's surface is the higher of the two, with the valleys between them filled
// by the priming.
#include "core/check.hpp"
#include "film/support/smooth_noise.hpp"
#include "film/support/support.hpp"
#include "film/support/support_sampling.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pastoso::film {
namespace {

/// A thread where a line crosses it; lengths in pitches.
struct ThreadSection {
    float centre;
    float half_width;
    float crown;  ///< of the highest threads, 0 to 1: thick ones stand out of the cloth
};

enum class Direction : std::uint32_t { Warp = 1000, Weft = 2000 };

/// Where a thread was spun too thick: the swell of its width there, 0 elsewhere.
float slub_swell(double along_mm, double slubs_per_m, std::uint32_t thread) {
    constexpr double kStretch_mm = 120.0, kShortest_mm = 5.0, kLongest_mm = 40.0;
    constexpr float kThinnest = 0.4F, kThickest = 0.9F;
    const double stretch = std::floor(along_mm / kStretch_mm);
    const auto index = static_cast<std::uint32_t>(static_cast<std::int32_t>(stretch)) * 4U;
    const auto chance = [&](std::uint32_t what) { return core::uniform_noise(index + what, thread); };
    if (chance(0) >= slubs_per_m * kStretch_mm / 1000.0) return 0.0F;
    const double half_mm = 0.5 * (kShortest_mm + chance(1) * (kLongest_mm - kShortest_mm));
    const double middle_mm = half_mm + chance(2) * (kStretch_mm - 2.0 * half_mm);
    const double off = std::abs(along_mm - stretch * kStretch_mm - middle_mm) / half_mm;
    if (off >= 1.0) return 0.0F;
    return (kThinnest + chance(3) * (kThickest - kThinnest)) *
           smooth_step(static_cast<float>(1.0 - off));
}

/// How the threads of one direction wander and how thick they are.
class Threads {
  public:
    Threads(const Weave& weave, Direction direction)
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

    /// The thread of that number (from -1) at a place along it, counted in pitches.
    ThreadSection section(int number, double along) const {
        const auto own = core::scramble(stream_) + static_cast<std::uint32_t>(number) * 4U;
        const float shared_course = centred(smooth_noise(number / 9.0, along / 16.0, stream_));
        const float own_course = centred(smooth_noise(along / 5.0, own));
        const float slub = centred(smooth_noise(along / 7.0, own + 1));
        const float thickness = centred(core::uniform_noise(0, own + 2));
        const float paired = number % 2 == 0 ? pairing_ : -pairing_;
        float swell = irregularity_ * (0.14F * thickness + 0.12F * slub);
        float course = irregularity_ * (0.25F * shared_course + 0.10F * own_course);
        if (unevenness_ > 0.0F) swell += unevenness_ * uneven(along, own);
        if (slubs_per_m_ > 0.0) swell += slub_swell(along * along_mm_, slubs_per_m_, own + 3);
        if (drift_ > 0.0F)
            course += drift_ * centred(smooth_noise(number / kDriftThreads, along / 90.0, stream_ + 7));
        return {static_cast<float>(number) + 0.5F + paired + course, half_width_ * (1.0F + swell),
                crown_ + std::clamp(0.5F * swell, -0.14F, above_)};
    }

  private:
    static constexpr double kDriftThreads = 25.0;

    static float centred(float noise) { return 2.0F * noise - 1.0F; }

    /// As spun: thick and thin within a few centimetres, and within millimetres.
    float uneven(double along, std::uint32_t own) const {
        const double along_mm = along * along_mm_;
        return 0.7F * centred(smooth_noise(along_mm / 9.0, own + 2)) +
               0.3F * centred(smooth_noise(along_mm / 2.0, own + 1));
    }

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

/// cos(pi t) for t in [0, 1], as a cubic with the same values and slopes at both ends.
float half_wave(float t) {
    return 1.0F - 2.0F * smooth_step(t);
}

/// How deep the furrow between two plies is at a place on a thread, 0 to 1: they wind around each other.
float furrow(float along, float across) {
    constexpr float kLay = 1.3F, kAslant = 0.5F;  // length of a turn in pitches; turns across the thread
    const float turn = along / kLay + kAslant * across;
    const float share = turn - std::floor(turn);
    return 1.0F - smooth_step(2.0F * std::min(share, 1.0F - share));
}

/// Height of a thread at `offset` pitches from its centre line; `rise` is 1 where it passes over a
/// crossing thread and -1 where it passes under.
float thread_height(const ThreadSection& thread, float offset, float rise, float along, float twist) {
    constexpr float kDip = 0.7F;  // of the crown's height, from the top of a wave to its bottom
    const float across = offset / thread.half_width;
    const float roundness = std::sqrt(std::max(0.0F, 1.0F - across * across));
    const float height = thread.crown * roundness * (1.0F - 0.5F * kDip * (1.0F - rise));
    return twist > 0.0F && roundness > 0.0F ? height * (1.0F - twist * furrow(along, across)) : height;
}

/// The larger of two, rounded where they are nearly equal: priming fills the groove between threads.
float primed_maximum(float a, float b) {
    constexpr float kFill = 0.12F;
    const float gap = std::max(0.0F, kFill - std::abs(a - b));
    return std::max(a, b) + gap * gap / (4.0F * kFill);
}

/// The threads on both sides of a point and where between their centres it lies.
struct Neighbours {
    int number;   ///< of the thread before the point
    float share;  ///< 0 at that thread's centre, 1 at the next one's
    std::array<ThreadSection, 2> threads;
};

Neighbours neighbours(int number, const ThreadSection& before, const ThreadSection& after, float place) {
    return {number,
            std::clamp((place - before.centre) / (after.centre - before.centre), 0.0F, 1.0F),
            {before, after}};
}

float cloth_height(const Neighbours& warp, float u, const Neighbours& weft, float v, float twist) {
    const float parity = (warp.number + weft.number) % 2 == 0 ? 1.0F : -1.0F;
    const float along_warp = parity * half_wave(weft.share);
    const float along_weft = -parity * half_wave(warp.share);
    const float warp_height =
        std::max(thread_height(warp.threads[0], u - warp.threads[0].centre, along_warp, v, twist),
                 thread_height(warp.threads[1], u - warp.threads[1].centre, -along_warp, v, twist));
    const float weft_height =
        std::max(thread_height(weft.threads[0], v - weft.threads[0].centre, along_weft, u, twist),
                 thread_height(weft.threads[1], v - weft.threads[1].centre, -along_weft, u, twist));
    return std::min(1.0F, primed_maximum(warp_height, weft_height));
}

/// The mean of cloth_height() around a place: thick threads raise it.
float mean_height(const Neighbours& warp, const Neighbours& weft) {
    constexpr float kOfCrown = 0.66F;
    const float crowns =
        warp.threads[0].crown + warp.threads[1].crown + weft.threads[0].crown + weft.threads[1].crown;
    return kOfCrown * 0.25F * crowns;
}

/// What of a cloth's relief cells show: none of threads finer than two cells.
float shown_share(const Weave& weave, double column_mm) {
    if (!weave.averaged) return 1.0F;
    const double finer = std::min(1.0, weave.weft_pitch) * weave.thread_pitch_mm / column_mm;
    return static_cast<float>(std::clamp(0.5 * finer - 1.0, 0.0, 1.0));
}

/// Scans the cloth line by line, and keeps what the lines have in common.
class ClothScanner {
  public:
    /// `first_column` is the cloth's; there are `columns` of them. Cells show `shown` of the relief.
    ClothScanner(const Weave& weave, std::int64_t first_column, std::size_t columns,
                 double column_pitches, float shown)
        : warp_(weave, Direction::Warp),
          weft_(weave, Direction::Weft),
          twist_(static_cast<float>(weave.twist)),
          nap_(static_cast<float>(weave.nap)),
          shown_(shown),
          fibres_(static_cast<std::uint32_t>(Direction::Warp) + 11),
          fibre_pitches_(kFibre_mm / weave.thread_pitch_mm),
          column_pitches_(column_pitches),
          first_column_(first_column),
          columns_(columns),
          first_warp_(static_cast<int>(std::floor(static_cast<double>(first_column) * column_pitches)) -
                      2) {
        const int warp_count =
            static_cast<int>(std::ceil(static_cast<double>(columns) * column_pitches)) + 4;
        warp_sections_.resize(static_cast<std::size_t>(warp_count));
        for (WeftCourse& course : weft_courses_)
            course.sections.resize(columns);
    }

    void fill_row(double v, std::span<float> heights) {
        for (std::size_t i = 0; i < warp_sections_.size(); ++i) {
            warp_sections_[i] = warp_.section(static_cast<int>(i) + first_warp_, v);
        }
        const int middle = static_cast<int>(std::floor(v));
        for (int number = middle - 2; number <= middle + 2; ++number)
            keep_weft(number);
        const auto v_place = static_cast<float>(v);
        std::size_t i = 0;
        for (std::size_t k = 0; k < heights.size(); ++k) {
            const auto u = static_cast<float>(place_pitches(k));
            while (warp_sections_[i + 1].centre <= u)
                ++i;
            const Neighbours warp = neighbours(static_cast<int>(i) + first_warp_, warp_sections_[i],
                                               warp_sections_[i + 1], u);
            heights[k] = height(warp, u, weft_neighbours(middle, k, v_place), v_place);
        }
    }

  private:
    static constexpr int kKeptCourses = 5;
    static constexpr double kFibre_mm = 0.18;

    float height(const Neighbours& warp, float u, const Neighbours& weft, float v) {
        float height = cloth_height(warp, u, weft, v, twist_);
        if (nap_ > 0.0F) {
            const float fibres = fibres_.at(u / fibre_pitches_, v / (3.0 * fibre_pitches_));
            height = std::clamp(height + nap_ * (fibres - 0.5F), 0.0F, 1.0F);
        }
        if (shown_ == 1.0F) return height;
        const float mean = mean_height(warp, weft);
        return mean + shown_ * (height - mean);
    }

    struct WeftCourse {
        std::optional<int> number{};
        std::vector<ThreadSection> sections;  ///< one per column
    };

    WeftCourse& course(int number) {
        const int slot = (number % kKeptCourses + kKeptCourses) % kKeptCourses;
        return weft_courses_[static_cast<std::size_t>(slot)];
    }

    double place_pitches(std::size_t column) const {
        const auto of_cloth = static_cast<double>(first_column_ + static_cast<std::int64_t>(column));
        return (of_cloth + 0.5) * column_pitches_;
    }

    void keep_weft(int number) {
        WeftCourse& kept = course(number);
        if (kept.number == number) return;
        kept.number = number;
        for (std::size_t k = 0; k < columns_; ++k) {
            kept.sections[k] = weft_.section(number, place_pitches(k));
        }
    }

    Neighbours weft_neighbours(int middle, std::size_t column, float v) {
        int number = middle - 2;
        while (number < middle + 1 && course(number + 1).sections[column].centre <= v)
            ++number;
        return neighbours(number, course(number).sections[column], course(number + 1).sections[column],
                          v);
    }

    Threads warp_;
    Threads weft_;
    float twist_, nap_, shown_;
    NoiseWalk fibres_;
    double fibre_pitches_;
    double column_pitches_;
    std::int64_t first_column_;
    std::size_t columns_;
    int first_warp_;
    std::vector<ThreadSection> warp_sections_;
    std::array<WeftCourse, kKeptCourses> weft_courses_;
};

}  // namespace

SupportHeights woven_support(grid::Shape shape, double cell_mm, const Weave& weave,
                             core::ThreadPool& pool, SupportForm form, const ClothPlace& place) {
    PASTOSO_CHECK_OP(cell_mm, >, 0.0);
    PASTOSO_CHECK_OP(weave.thread_pitch_mm, >, 0.0);
    PASTOSO_CHECK_OP(weave.weft_pitch, >, 0.0);
    const double cell_pitches = cell_mm / weave.thread_pitch_mm;
    const double row_pitches = cell_pitches / weave.weft_pitch;
    const float shown = shown_share(weave, cell_mm);
    const int samples = samples_per_cell(cell_pitches, 1.0 / 6.0);
    const auto columns = static_cast<std::size_t>(shape.width) * samples;
    const std::int64_t first_column = std::int64_t{place.x0} * samples;
    return sampled_in(form, {shape, place.y0}, samples, weave.relief_mm, pool, [&] {
        return [row_pitches,
                scanner = ClothScanner(weave, first_column, columns, cell_pitches / samples, shown)](
                   double y_cells, std::span<float> heights) mutable {
            scanner.fill_row(y_cells * row_pitches, heights);
        };
    });
}

}  // namespace pastoso::film
