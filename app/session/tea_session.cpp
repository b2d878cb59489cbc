#include "session/tea_session.hpp"

#include "liquid/tea/milk_depth.hpp"
#include "trace/scene.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace pastoso::session {
namespace {

constexpr int kSeenCells = 96;  ///< of the milk, along each side of the box

liquid::TeaSettings with_force(liquid::TeaSettings settings, const TeaForce& force) {
    settings.swirl_rad_s2 = force.on ? force.swirl_rad_s2 : 0.0;
    settings.push_m_s2 = force.on ? force.push_m_s2 : 0.0;
    settings.swirl_x_m = force.axis_m.x;
    settings.swirl_y_m = force.axis_m.y;
    return settings;
}

/// What is interpolated reaches to the middles of the next cells.
void find_milk(const grid::BoxField& share, glm::vec3& low_m, glm::vec3& high_m) {
    const grid::BoxShape& shape = share.shape();
    glm::ivec3 low(shape.nx, shape.ny, shape.nz), high(-1);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j) {
            const float* row = share.row(j, k);
            const auto some = [](float part) { return part > 0.0F; };
            const auto first = static_cast<int>(std::find_if(row, row + shape.nx, some) - row);
            if (first == shape.nx) continue;
            int last = shape.nx - 1;
            while (!some(row[last]))
                --last;
            low = glm::min(low, glm::ivec3(first, j, k));
            high = glm::max(high, glm::ivec3(last, j, k));
        }
    const bool none = high.x < 0;
    low_m = none ? glm::vec3(0.0F) : shape.cell_m * (glm::vec3(low) - 0.5F);
    high_m = none ? glm::vec3(0.0F) : shape.cell_m * (glm::vec3(high) + 1.5F);
}

}  // namespace

void fill_milk(liquid::MilkDensities& densities, TeaSnapshot& snapshot) {
    const liquid::TeaSettings& settings = snapshot.settings;
    liquid::MilkDensitySettings density = liquid::even_density(settings);
    density.cells = kSeenCells;
    const TeaFrame& seen = snapshot.seen;
    snapshot.milk_share = densities.make(seen.parcels, seen.dissolved, snapshot.cup(), density).dense();
    find_milk(snapshot.milk_share, snapshot.milk_low_m, snapshot.milk_high_m);
    const grid::BoxField coarse = liquid::halved(snapshot.milk_share);
    snapshot.to_lamp_m = liquid::milk_depth_m(coarse, trace::Lamp{}.towards);
    snapshot.to_level_m = liquid::milk_depth_m(coarse, {0.0F, 0.0F, 1.0F});
}

TeaSession::TeaSession(const liquid::TeaSettings& settings, bool paused, Notify notify,
                       std::size_t budget_bytes)
    : LiquidSession(paused, std::move(notify)), settings_(settings), frames_(budget_bytes) {
    force_.axis_m = settings.cup.axis_m;
    seen_.force = force_;
    new_glass(settings);
    begin();
}

TeaSession::~TeaSession() {
    end();
}

TeaSession::Published TeaSession::published() const {
    const std::lock_guard lock(mutex());
    Published published{seen_, snapshot_};
    static_cast<LiquidStatus&>(published.status) = status_locked();
    return published;
}

std::shared_ptr<const TeaSnapshot> TeaSession::snapshot() const {
    const std::lock_guard lock(mutex());
    return snapshot_;
}

void TeaSession::new_glass(const liquid::TeaSettings& settings) {
    post({.apply = [this, settings] { make_glass(settings); }, .makes_glass = true});
}

/// The glass before stays when there can be none like this.
void TeaSession::make_glass(const liquid::TeaSettings& settings) {
    tea_ = std::make_unique<liquid::MilkTea>(with_force(settings, force_));
    tea_->pour_recipe(false);
    settings_ = settings;
    frames_.clear();
    frames_.keep(tea_->steps(), tea_->parcels(), tea_->dissolved(), tea_->pour());
    hand_m_.reset();
    glass_made();
}

void TeaSession::set_numbers(const liquid::TeaSettings& settings) {
    post({[this, settings] {
        const liquid::TeaSettings before = std::exchange(settings_, settings);
        try {
            use_settings();
        } catch (...) {
            settings_ = before;
            throw;
        }
    }});
}

void TeaSession::set_force(const TeaForce& force) {
    post({[this, force] {
        const TeaForce before = std::exchange(force_, force);
        try {
            use_settings();
        } catch (...) {
            force_ = before;
            throw;
        }
    }});
}

/// A recipe that has ended does not go on because it lasts longer now.
void TeaSession::use_settings() {
    if (tea_ == nullptr) return;
    const bool flows = tea_->recipe_flows();
    tea_->set_settings(with_force(settings_, force_));
    if (!flows) tea_->pour_recipe(false);
}

void TeaSession::pour_recipe(bool pours) {
    post({[this, pours] {
        if (tea_ != nullptr) tea_->pour_recipe(pours);
    }});
}

/// Clear tea that nothing moves looks the same for ever.
bool TeaSession::waits() const {
    return tea_->steps() == 0 && !tea_->recipe_flows() && !hand_m_ && hand_has_poured_ && !force_.on;
}

/// A hand that is lifted before a step was made has poured all the same.
void TeaSession::pour(std::optional<glm::vec2> at_m) {
    post({.apply =
              [this, at_m] {
                  hand_m_ = at_m;
                  hand_has_poured_ = !at_m;
                  if (tea_ != nullptr) tea_->pour_by_hand(at_m);
              },
          .waits_for_step = !at_m});
}

double TeaSession::step_liquid() {
    tea_->step(pool());
    hand_has_poured_ = true;
    frames_.keep(tea_->steps(), tea_->parcels(), tea_->dissolved(), tea_->pour());
    return tea_->settings().step_s;
}

TeaFrame TeaSession::frame_now() const {
    if (shown_step()) return frames_.at(*shown_step());
    return {tea_->steps(), tea_->parcels(), tea_->dissolved(), tea_->pour()};
}

void TeaSession::make_moment(LiquidStatus& status) {
    auto snapshot = std::make_shared<TeaSnapshot>();
    snapshot->settings = with_force(settings_, force_);
    snapshot->seen = frame_now();
    snapshot->time_s = snapshot->seen.step * settings_.step_s;
    fill_milk(densities_, *snapshot);
    status.step = snapshot->seen.step;
    status.last_step = tea_->steps();
    status.time_s = snapshot->time_s;
    status.last_s = tea_->time_s();
    status.kept = frames_.steps();
    status.kept_bytes = frames_.bytes();
    made_ = std::move(snapshot);
}

void TeaSession::give_moment() {
    if (made_ != nullptr) snapshot_ = std::exchange(made_, nullptr);
    seen_.pouring = hand_m_.has_value();
    seen_.recipe_flows = tea_ != nullptr && tea_->recipe_flows();
    seen_.full = tea_ != nullptr && tea_->is_full();
    seen_.at_rest = tea_ != nullptr && waits();
    seen_.force = force_;
    seen_.milk_m3 = tea_ != nullptr ? tea_->poured_m3() : 0.0;
}

}  // namespace pastoso::session
