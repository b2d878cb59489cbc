#include "session/tank_session.hpp"

#include "session/far_level.hpp"
#include "tank/tank_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::session {
namespace {

constexpr int kArrowsAlong = 16;       ///< the longest side
constexpr float kSlowest_m_s = 1e-3F;  ///< that is shown
constexpr double kRounding_s = 1e-7;   ///< what is left of a moment by rounding is no step
constexpr float kDrainShare = 0.11F;   ///< of the floor's shorter side: its radius
constexpr float kDrainHeight_cells = 1.5F;

TankWind wind_of(const tank::TankScene& scene) {
    TankWind wind;
    wind.on = scene.wind.speed_m_s > 0.0;
    if (wind.on) wind.speed_m_s = scene.wind.speed_m_s;
    wind.direction_deg = scene.wind.direction_deg;
    wind.drag_per_s = scene.wind.drag_per_s;
    return wind;
}

std::vector<FlowArrow> arrows_of(const tank::LiquidTank& tank, const tank::TankFrame& frame) {
    const grid::BoxShape& shape = tank.shape();
    const liquid::VelocityField& u = tank.velocity();
    const int apart = (std::max({shape.nx, shape.ny, shape.nz}) + kArrowsAlong - 1) / kArrowsAlong;
    std::vector<FlowArrow> arrows;
    for (int k = apart / 2; k < shape.nz; k += apart)
        for (int j = apart / 2; j < shape.ny; j += apart)
            for (int i = apart / 2; i < shape.nx; i += apart) {
                if (frame.level_m.at(i + 1, j + 1, k + 1) >= 0.0F) continue;
                const glm::vec3 velocity_m_s = 0.5F * glm::vec3(u.x.at(i, j, k) + u.x.at(i + 1, j, k),
                                                                u.y.at(i, j, k) + u.y.at(i, j + 1, k),
                                                                u.z.at(i, j, k) + u.z.at(i, j, k + 1));
                if (glm::length(velocity_m_s) > kSlowest_m_s)
                    arrows.push_back({(glm::vec3(i, j, k) + 0.5F) * shape.cell_m, velocity_m_s});
            }
    return arrows;
}

}  // namespace

TankSession::TankSession(const tank::TankScene& scene, bool paused, Notify notify,
                         std::size_t budget_bytes)
    : LiquidSession(paused, std::move(notify)), frames_(budget_bytes), given_frames_(budget_bytes) {
    new_tank(scene);
    begin();
}

TankSession::~TankSession() {
    end();
}

TankSession::Published TankSession::published() const {
    const std::lock_guard lock(mutex());
    Published published{seen_, snapshot_};
    static_cast<LiquidStatus&>(published.status) = status_locked();
    return published;
}

std::shared_ptr<const TankSnapshot> TankSession::snapshot() const {
    const std::lock_guard lock(mutex());
    return snapshot_;
}

TankSession::Kept TankSession::kept() const {
    const std::lock_guard lock(mutex());
    return {snapshot_ != nullptr ? snapshot_->place : nullptr, given_frames_};
}

void TankSession::new_tank(const tank::TankScene& scene) {
    post({.apply = [this, scene] { make_tank(scene); }, .makes_glass = true});
}

void TankSession::start_again(const tank::TankScene& scene) {
    post({.apply =
              [this, scene] {
                  const TankWind wind = wind_;
                  const bool open = drains_open_;
                  make_tank(scene);
                  let_blow(wind);
                  let_drain(open);
              },
          .makes_glass = true});
}

/// The tank before stays when there can be none like this.
void TankSession::make_tank(const tank::TankScene& scene) {
    tank::check_tank(scene);
    const tank::TankScene used = with_drain(scene);
    auto made = std::make_unique<tank::LiquidTank>(used);
    tank_ = std::move(made);
    drains_open_ = !scene.drains.empty();
    tank_->open_drains(drains_open_);
    place_ = std::make_shared<const TankPlace>(TankPlace{used, tank_->shared_domain()});
    wind_ = wind_of(scene);
    moments_ = 0;
    taken_ = false;
    frames_.clear();
    frames_.keep(seen_now());
    glass_made();
}

void TankSession::add_sphere(const tank::Sphere& sphere, float milk) {
    post({[this, sphere, milk] {
        if (tank_ == nullptr) return;
        tank_->add({.shape = {sphere}, .milk = milk}, pool());
        show_last();
    }});
}

void TankSession::set_wind(const TankWind& wind) {
    post({[this, wind] { let_blow(wind); }});
}

void TankSession::let_blow(const TankWind& wind) {
    tank::Wind blowing;
    blowing.speed_m_s = wind.on ? wind.speed_m_s : 0.0;
    blowing.direction_deg = wind.direction_deg;
    blowing.drag_per_s = wind.drag_per_s;
    if (tank_ != nullptr) tank_->set_wind(blowing);
    wind_ = wind;
}

void TankSession::open_drains(bool open) {
    post({[this, open] { let_drain(open); }});
}

void TankSession::let_drain(bool open) {
    drains_open_ = open;
    if (tank_ != nullptr) tank_->open_drains(open);
}

void TankSession::set_numbers(const tank::TankScene& numbers) {
    post({[this, numbers] {
        if (tank_ != nullptr) tank_->set_numbers(numbers);
    }});
}

void TankSession::set_waiting(bool waits) {
    post({[this, waits] {
        waits_ = waits;
        taken_ = false;
    }});
}

void TankSession::take(const std::shared_ptr<const TankSnapshot>& snapshot) {
    post({[this, snapshot] {
        if (snapshot->place == place_ && snapshot->seen.step == moments_) taken_ = true;
    }});
}

bool TankSession::stands_at_moment() const {
    return tank_->time_s() - moments_ * kTankMoment_s < kRounding_s;
}

double TankSession::step_liquid() {
    const double before_s = tank_->time_s(), next_s = (moments_ + 1) * kTankMoment_s;
    tank_->step(next_s - before_s, pool());
    if (next_s - tank_->time_s() < kRounding_s) {
        ++moments_;
        taken_ = false;
        if (frames_.wants(moments_)) frames_.keep(seen_now());
    }
    return tank_->time_s() - before_s;
}

TankSeen TankSession::seen_now() {
    tank::TankFrame frame = tank_->frame(1, pool());
    std::vector<FlowArrow> arrows = arrows_of(*tank_, frame);
    return {moments_,
            tank_->time_s(),
            tank_->volume_m3(pool()),
            std::move(frame.level_m),
            std::move(frame.milk),
            std::move(arrows)};
}

void TankSession::make_moment(LiquidStatus& status) {
    auto snapshot = std::make_shared<TankSnapshot>();
    snapshot->place = place_;
    snapshot->seen = shown_step() ? frames_.at(*shown_step()) : seen_now();
    snapshot->far_m = far_level(snapshot->seen.level_m);
    snapshot->drains_open = drains_open_;
    snapshot->waits = waits() && !shown_step();
    status.step = snapshot->seen.step;
    status.last_step = moments_;
    status.time_s = snapshot->seen.time_s;
    status.last_s = tank_->time_s();
    status.kept = frames_.steps();
    status.kept_bytes = frames_.bytes();
    made_ = std::move(snapshot);
}

void TankSession::give_moment() {
    if (made_ != nullptr) snapshot_ = std::exchange(made_, nullptr);
    given_frames_ = frames_;
    seen_.wind = wind_;
    seen_.drains_open = drains_open_;
    seen_.volume_m3 = snapshot_ != nullptr ? snapshot_->seen.volume_m3 : 0.0;
}

liquid::TriangleMesh liquid_surface(const TankPlace& place, const TankSeen& seen, float reach_m,
                                    core::ThreadPool& pool) {
    tank::TankFrame frame;
    frame.level_m = seen.level_m;
    liquid::TriangleMesh mesh;
    tank::TankSurfaces(*place.domain, pool).make(frame, reach_m, mesh);
    return mesh;
}

float rest_level_m(const TankSnapshot& snapshot) {
    const glm::vec3 size_m = snapshot.place->scene.size_m();
    return std::min(static_cast<float>(snapshot.seen.volume_m3) / (size_m.x * size_m.y),
                    0.95F * size_m.z);
}

float longest_side_m(const tank::TankScene& scene) {
    const glm::vec3 size_m = scene.size_m();
    return std::max({size_m.x, size_m.y, size_m.z});
}

tank::TankScene with_drain(tank::TankScene scene) {
    if (!scene.drains.empty()) return scene;
    std::vector<tank::ShapeDistance> solids;
    for (const tank::Shape& solid : scene.solids)
        solids.emplace_back(solid);
    const glm::vec3 size_m = scene.size_m();
    const float radius_m = kDrainShare * std::min(size_m.x, size_m.y);
    const auto cell_m = static_cast<float>(scene.cell_m);
    constexpr int kPlaces = 8;
    std::optional<glm::vec3> best_m;
    float best_way_m = std::numeric_limits<float>::max();
    for (int j = 1; j < kPlaces; ++j)
        for (int i = 1; i < kPlaces; ++i) {
            const glm::vec3 at_m(size_m.x * static_cast<float>(i) / kPlaces,
                                 size_m.y * static_cast<float>(j) / kPlaces, 0.0F);
            const float way_m = glm::length(at_m - 0.5F * glm::vec3(size_m.x, size_m.y, 0.0F));
            const bool free = std::ranges::all_of(solids, [&](const tank::ShapeDistance& solid) {
                return solid(at_m + glm::vec3(0.0F, 0.0F, cell_m)) > 1.1F * radius_m;
            });
            if (!free || way_m >= best_way_m) continue;
            best_m = at_m;
            best_way_m = way_m;
        }
    if (!best_m) return scene;
    const glm::vec3 up(0.0F, 0.0F, cell_m);
    scene.drains.push_back(
        {.shape = {tank::Cylinder{*best_m - up, *best_m + kDrainHeight_cells * up, radius_m}}});
    return scene;
}

}  // namespace pastoso::session
