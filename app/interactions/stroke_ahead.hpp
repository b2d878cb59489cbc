// The part of a stroke that the screen does not show yet: the way of the brush from what it shows to
// where the hand is about to be.
#pragma once

#include "brush/guide_choice.hpp"
#include "brush/hand_path.hpp"
#include "input/pen_forecast.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace pastoso::interactions {

/// Told of the actions of one stroke by their numbers (session::PaintSession::post()), it takes the way
/// that the painting's own brush takes.
class StrokeAhead {
  public:
    /// The hand touches down with a brush that takes `path`.
    void begin(const brush::HandPath& path, const brush::PenSample& sample, std::uint64_t number);
    void add(const brush::PenSample& sample, std::uint64_t number);

    /// The brush has been turned so since the stroke began: document::TurnStroke.
    void turn(double rotation_deg);

    void end(std::uint64_t number);

    /// The hand rests: the brush is expected to come to where it is. False: that is known already.
    bool rest() { return !std::exchange(rests_, true); }

    /// The screen shows the actions up to this one.
    void shown(std::uint64_t number);

    /// The places of the brush, one a step, from the last one that is shown on; none where nothing is
    /// ahead of the screen.
    std::vector<brush::PenSample> places() const;

    /// Whether the brush has touched down on the screen.
    bool is_down() const { return !samples_.empty() && samples_.front().number <= shown_; }

  private:
    struct Told {
        brush::PenSample pen;
        std::uint64_t number;  ///< of the action that told it, or led there
    };
    void follow(const std::vector<brush::PenSample>& samples, std::uint64_t number);
    void take_steps(std::uint64_t number);
    brush::PenSample expected(int number) const;
    std::vector<brush::PathStep> foretold() const;

    std::optional<brush::HandPath> lifted_, path_;  ///< before the stroke; none after it
    brush::GuideChoice choice_;
    bool begun_ = false;                            ///< the path is
    std::vector<Told> samples_;                     ///< of the stroke
    std::deque<Told> places_;                       ///< but for those before the last one shown
    std::uint64_t shown_ = 0;
    input::PenForecast forecast_;
    bool rests_ = true;
};

}  // namespace pastoso::interactions
