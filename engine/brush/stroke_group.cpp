#include "brush/stroke_group.hpp"

#include <cmath>
#include <utility>

namespace pastoso::brush {

StrokeGroup::StrokeGroup(Brush& brush, film::FilmState& film, const HandAids& aids,
                         const Symmetry& symmetry, const grid::Mask* limit, core::ThreadPool* pool)
    : guide_(aids.guide), brush_(brush) {
    for (const Placement& placement : placements(symmetry)) {
        if (strokes_.empty()) {
            strokes_.emplace_back(brush, film, aids, placement, limit, pool);
            continue;
        }
        Brush& copy = copies_.emplace_back(brush);
        if (placement.mirrored) copy.tip = mirrored(std::move(copy.tip));
        strokes_.emplace_back(copy, film, aids, placement, limit, pool);
    }
}

void StrokeGroup::begin(const PenSample& sample) {
    choice_ = GuideChoice(guide_);
    begun_ = false;
    follow(choice_.add(sample));
}

void StrokeGroup::add(const PenSample& sample) {
    follow(choice_.add(sample));
}

void StrokeGroup::end() {
    follow(choice_.end());
    for (Stroke& stroke : strokes_)
        stroke.end();
    brush_.wear(travel_mm_);
}

void StrokeGroup::pass_time(double seconds) {
    if (!begun_) return;
    for (Stroke& stroke : strokes_)
        stroke.pass_time(seconds);
}

std::vector<film::AirJet> StrokeGroup::air_jets() const {
    std::vector<film::AirJet> jets;
    for (const Stroke& stroke : strokes_) {
        if (const auto jet = stroke.air_jet()) jets.push_back(*jet);
    }
    return jets;
}

Contents StrokeGroup::take_thrown_away() {
    Contents sum = brush_.take_thrown_away();
    for (Brush& copy : copies_)
        sum += copy.take_thrown_away();
    return sum;
}

Contents StrokeGroup::copied_paint() const {
    Contents sum;
    for (const Brush& copy : copies_)
        sum += copy.contents();
    return sum;
}

std::vector<grid::Rect> StrokeGroup::take_changed_cells() {
    std::vector<grid::Rect> changed;
    for (Stroke& stroke : strokes_)
        changed.push_back(stroke.take_changed_cells());
    return changed;
}

void StrokeGroup::follow(const std::vector<PenSample>& samples) {
    for (const PenSample& sample : samples) {
        if (begun_)
            add_to_strokes(sample);
        else
            begin_strokes(sample);
    }
}

void StrokeGroup::begin_strokes(const PenSample& sample) {
    begun_ = true;
    last_ = sample;
    for (Stroke& stroke : strokes_) {
        stroke.keep_to(choice_.guide());
        stroke.begin(sample);
    }
}

void StrokeGroup::add_to_strokes(const PenSample& sample) {
    travel_mm_ += std::hypot(sample.x_mm - last_.x_mm, sample.y_mm - last_.y_mm);
    last_ = sample;
    for (Stroke& stroke : strokes_)
        stroke.add(sample);
}

}  // namespace pastoso::brush
