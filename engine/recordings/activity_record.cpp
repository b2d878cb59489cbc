#include "recordings/activity_record.hpp"

#include <bit>

namespace pastoso::recordings {
namespace {

constexpr std::uint32_t kMeasured = 1, kChanged = 2;

/// Waits end after about a second, windows after half a second and a step.
constexpr double kLongestWait_s = 10.0;
constexpr float kLongestWindow_s = 10.0F;
/// Generous bounds of what a tile's paint can do; what counts is that they are finite.
constexpr float kLargest = 1e6F;

class RecordWriter {
  public:
    explicit RecordWriter(ActivityRecord& record) : record_(record) {}
    void put(std::uint32_t word) { record_[next_++] = word; }
    void put(float value) { put(std::bit_cast<std::uint32_t>(value)); }
    void put(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        put(static_cast<std::uint32_t>(bits));
        put(static_cast<std::uint32_t>(bits >> 32));
    }

  private:
    ActivityRecord& record_;
    std::size_t next_ = 0;
};

class RecordReader {
  public:
    explicit RecordReader(const ActivityRecord& record) : record_(record) {}
    std::uint32_t word() { return record_[next_++]; }
    float number() { return std::bit_cast<float>(word()); }
    double long_number() {
        const std::uint64_t low = word();
        return std::bit_cast<double>(low | std::uint64_t{word()} << 32);
    }

  private:
    const ActivityRecord& record_;
    std::size_t next_ = 0;
};

bool is_amount(float value) {
    return value >= 0.0F && value <= kLargest;
}

}  // namespace

ActivityRecord activity_record(const film::TileActivity& activity) {
    ActivityRecord record{};
    RecordWriter words(record);
    words.put((activity.measured ? kMeasured : 0U) | (activity.changed_from_outside ? kChanged : 0U));
    words.put(activity.waiting_s);
    words.put(activity.window_s);
    words.put(activity.motion.largest_mm);
    for (const float near_mm : activity.motion.near_side_mm)
        words.put(near_mm);
    for (const float speed_mm_s : activity.side_speeds_mm_s)
        words.put(speed_mm_s);
    words.put(activity.extremes.mobility);
    words.put(activity.extremes.thickness_mm);
    words.put(activity.extremes.speed_mm_s);
    words.put(activity.extremes.seen_speed_mm_s);
    return record;
}

film::TileActivity activity_of(const ActivityRecord& record) {
    RecordReader words(record);
    film::TileActivity activity;
    activity.awake = true;
    const std::uint32_t flags = words.word();
    activity.measured = (flags & kMeasured) != 0;
    activity.changed_from_outside = (flags & kChanged) != 0;
    activity.waiting_s = words.long_number();
    activity.window_s = words.number();
    activity.motion.largest_mm = words.number();
    for (float& near_mm : activity.motion.near_side_mm)
        near_mm = words.number();
    for (float& speed_mm_s : activity.side_speeds_mm_s)
        speed_mm_s = words.number();
    activity.extremes.mobility = words.number();
    activity.extremes.thickness_mm = words.number();
    activity.extremes.speed_mm_s = words.number();
    activity.extremes.seen_speed_mm_s = words.number();
    return activity;
}

bool is_possible(const film::TileActivity& activity) {
    bool possible = activity.waiting_s >= 0.0 && activity.waiting_s <= kLongestWait_s &&
                    activity.window_s >= 0.0F && activity.window_s <= kLongestWindow_s;
    possible = possible && is_amount(activity.motion.largest_mm) &&
               is_amount(activity.extremes.mobility) && is_amount(activity.extremes.thickness_mm) &&
               is_amount(activity.extremes.speed_mm_s) && is_amount(activity.extremes.seen_speed_mm_s);
    for (int side = 0; side < film::kSideCount; ++side)
        possible = possible && is_amount(activity.motion.near_side_mm[side]) &&
                   is_amount(activity.side_speeds_mm_s[side]);
    return possible;
}

}  // namespace pastoso::recordings
