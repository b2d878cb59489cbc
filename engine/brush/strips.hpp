// The elements of a tip on several threads, with the result of one.
//
// Two elements depend on each other only where their footprints share cells, and there the earlier one
// must act first. The swath is cut into strips along the travel, at least four footprint radii wide, so
// that footprints reach into the strip beside their own at most. A thread works on a strip in the
// elements' order; an element at its side waits for the earlier ones beyond that it may meet:
//
//     | 0   4   8  12 | 1   5   9  13 |     8 waits until 1 has acted, if their footprints meet;
//     |   2   6  10   |   3   7  11   |     4 and 6 wait for nobody
//
// So every cell is changed by the same elements in the same order, whatever the threads do. Strips run
// along the travel so that cells stay with a thread from step to step.
#pragma once

#include "core/thread_pool.hpp"

#include <atomic>
#include <deque>
#include <functional>
#include <vector>

namespace pastoso::brush {

/// An element that acts, where it stands on the canvas and across the travel (Swath).
struct StripPlace {
    int element = 0;
    double x_mm = 0.0, y_mm = 0.0, side_mm = 0.0;
};

class Strips {
  public:
    /// Lets the element act with the tools of this strip. False: it cannot beside others, and has
    /// changed nothing.
    using Act = std::function<bool(int element, int strip)>;

    /// What is to be done next: places in the elements' order, whose footprints reach `radius_mm` far,
    /// in `most_strips` strips or fewer.
    void divide(const std::vector<StripPlace>& places, double radius_mm, int most_strips);

    int count() const { return count_; }

    /// Lets elements act until all have, or until one cannot beside others. Returns whether all have;
    /// else the caller makes way for those of `hindered()`, alone, and calls again. A single strip needs
    /// no pool.
    bool run(core::ThreadPool* pool, const Act& act);

    /// The strips whose next element could not act beside others.
    std::vector<int> hindered() const;

  private:
    struct Turn {
        int element;
        int after_low, after_high;  ///< how many in the strip on either side have to be done before
    };
    /// An element close enough to a side of its strip to meet others beyond.
    struct Neighbour {
        int turn;
        double x_mm, y_mm;
    };
    struct Strip {
        std::vector<Turn> turns;
        std::vector<Neighbour> at_low_side, at_high_side;
        bool hindered = false;
        // On a cache line of their own: others look at them all the time.
        alignas(64) std::atomic<int> done = 0;
        std::atomic<bool> taken = false;
    };

    void append(const StripPlace& place, int strip, double low_mm, double high_mm);
    int turns_before(const std::vector<Neighbour>& beyond, const StripPlace& place) const;
    bool may_act(int strip) const;
    void advance(int strip, const Act& act);
    void work(int first_strip, const Act& act);

    std::deque<Strip> strips_;
    int count_ = 0;
    double meeting_mm_ = 0.0;  ///< distance below which footprints may share cells
    std::atomic<int> strips_left_ = 0;
    std::atomic<bool> halted_ = false;
};

}  // namespace pastoso::brush
