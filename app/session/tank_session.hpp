// A tank of liquid that lives on its own thread.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"
#include "session/liquid_session.hpp"
#include "session/tank_frames.hpp"
#include "tank/liquid_tank.hpp"

#include <memory>

namespace pastoso::session {

inline constexpr double kTankMoment_s = 1.0 / 60.0;  ///< between moments that are kept

/// What stays while the liquid moves.
struct TankPlace {
    tank::TankScene scene;  ///< with a drain in any case
    std::shared_ptr<const tank::Domain> domain;
};

/// The wind as the hand sets it.
struct TankWind {
    bool on = false;
    double speed_m_s = 3.0;
    double direction_deg = 0.0;
    double drag_per_s = 4.0;
    friend bool operator==(const TankWind&, const TankWind&) = default;
};

/// The tank at one moment. It never changes.
struct TankSnapshot {
    std::shared_ptr<const TankPlace> place;
    TankSeen seen;
    liquid::SampledField far_m;  ///< as far_level()
    bool drains_open = false;
    bool waits = false;  ///< until it is taken (TankSession::set_waiting)
};

struct TankStatus : LiquidStatus {
    TankWind wind;
    bool drains_open = false;
    double volume_m3 = 0.0;  ///< as shown
};

class TankSession : public LiquidSession {
  public:
    /// Fills a tank, and lets its time pass unless it is paused. A scene that is none is told as an
    /// error, and there is no tank until new_tank() gives another.
    TankSession(const tank::TankScene& scene, bool paused, Notify notify,
                std::size_t budget_bytes = kBudget_bytes);
    ~TankSession() override;

    /// Another tank in place of what is there. A scene without drains gets one in its floor, which is
    /// shut at first; wind and drains are as the scene has them.
    void new_tank(const tank::TankScene& scene);
    /// A tank once more from its beginning: wind and drains stay as the hand has set them.
    void start_again(const tank::TankScene& scene);

    /// Liquid of that form appears where there is none yet; how much of it is milk.
    void add_sphere(const tank::Sphere& sphere, float milk);
    void set_wind(const TankWind& wind);
    void open_drains(bool open);
    /// All of tank_numbers() that may change while the liquid moves.
    void set_numbers(const tank::TankScene& numbers);

    /// Whether the liquid waits at every moment, kTankMoment_s apart, until that is taken: so that none
    /// is missed, however slow what is done with it. What the hand does holds meanwhile.
    void set_waiting(bool waits);
    /// Goes on; nothing happens when another moment waits.
    void take(const std::shared_ptr<const TankSnapshot>& snapshot);

    /// The latest moment, and what is said of that very one.
    struct Published {
        TankStatus status;
        std::shared_ptr<const TankSnapshot> snapshot;  ///< null before the first
    };
    Published published() const;
    TankStatus status() const { return published().status; }
    std::shared_ptr<const TankSnapshot> snapshot() const;

    /// All that is kept by now, and of which tank.
    struct Kept {
        std::shared_ptr<const TankPlace> place;
        TankFrames frames;
    };
    Kept kept() const;

  private:
    bool has_liquid() const override { return tank_ != nullptr; }
    bool waits() const override { return waits_ && !taken_ && stands_at_moment(); }
    double step_liquid() override;
    int last_step() const override { return moments_; }
    void make_moment(LiquidStatus& status) override;
    void give_moment() override;

    void make_tank(const tank::TankScene& scene);
    void let_blow(const TankWind& wind);
    void let_drain(bool open);
    TankSeen seen_now();
    bool stands_at_moment() const;

    // Of the session's thread alone.
    std::unique_ptr<tank::LiquidTank> tank_;
    std::shared_ptr<const TankPlace> place_;
    TankFrames frames_;
    TankWind wind_;
    bool drains_open_ = false;
    int moments_ = 0;                     ///< that were reached
    bool waits_ = false, taken_ = false;  ///< at every moment; this one is taken
    std::shared_ptr<const TankSnapshot> made_;

    // Under the mutex.
    std::shared_ptr<const TankSnapshot> snapshot_;
    TankFrames given_frames_;
    TankStatus seen_;  ///< but for what all liquids have
};

/// The surface of the liquid as triangles, closed where the liquid meets solids and the tank's walls, or
/// `reach_m` within those (tank::TankSurfaces).
liquid::TriangleMesh liquid_surface(const TankPlace& place, const TankSeen& seen, float reach_m,
                                    core::ThreadPool& pool);

/// Liquid at rest would stand so high, about.
float rest_level_m(const TankSnapshot& snapshot);

float longest_side_m(const tank::TankScene& scene);

/// The scene with a drain in its floor, where it has none and there is room for one.
tank::TankScene with_drain(tank::TankScene scene);

}  // namespace pastoso::session
