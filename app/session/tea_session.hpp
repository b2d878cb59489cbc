// A glass of milk tea that lives on its own thread.
#pragma once

#include "liquid/tea/milk_density.hpp"
#include "liquid/tea/milk_tea.hpp"
#include "session/liquid_session.hpp"
#include "session/tea_frames.hpp"

#include <memory>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::session {

/// The glass at one moment. It never changes.
struct TeaSnapshot {
    liquid::TeaSettings settings;
    TeaFrame seen;
    double time_s = 0.0;
    grid::BoxField milk_share;  ///< parcels and dissolved milk, as fine as the view shows them
    grid::BoxField to_lamp_m, to_level_m;  ///< milk in the way of light (milk_depth.hpp), half as fine
    glm::vec3 milk_low_m{0.0F}, milk_high_m{0.0F};  ///< corners of a box in which all the milk is

    /// Filled as it is seen.
    liquid::Cup cup() const { return liquid::cup_in(seen.pour, settings.cup); }
};

/// Makes the milk's fields out of the settings and what is seen.
void fill_milk(liquid::MilkDensities& densities, TeaSnapshot& snapshot);

/// What the painter stirs with. While it is off, the settings of the glass have no force.
struct TeaForce {
    bool on = false;
    double swirl_rad_s2 = 8.0;
    double push_m_s2 = 0.2;
    glm::dvec2 axis_m{0.05};
    friend bool operator==(const TeaForce&, const TeaForce&) = default;
};

struct TeaStatus : LiquidStatus {
    bool pouring = false;       ///< by hand
    bool recipe_flows = false;  ///< its milk is poured
    bool full = false;          ///< no more milk fits
    bool at_rest = false;       ///< clear tea: no time passes until something is done to it
    TeaForce force;
    double milk_m3 = 0.0;  ///< poured so far
};

class TeaSession : public LiquidSession {
  public:
    /// Fills a glass, which rests as after new_glass(). Settings that are none are told as an error, and
    /// there is no glass until new_glass() gives others.
    TeaSession(const liquid::TeaSettings& settings, bool paused, Notify notify,
               std::size_t budget_bytes = kBudget_bytes);
    ~TeaSession() override;

    /// Clear tea in place of what is there. It rests: its time begins when milk is poured or the force
    /// is on. The force stays.
    void new_glass(const liquid::TeaSettings& settings);

    /// Other numbers from now on, as MilkTea::set_settings(); those of the force are not looked at.
    void set_numbers(const liquid::TeaSettings& settings);
    void set_force(const TeaForce& force);

    /// The recipe's milk is poured into the middle from now on, whatever was poured before; or no more
    /// of it.
    void pour_recipe(bool pours);

    /// Milk is poured there, until told nothing. However short that is, some is poured.
    void pour(std::optional<glm::vec2> at_m);

    /// The latest moment, and what is said of that very one.
    struct Published {
        TeaStatus status;
        std::shared_ptr<const TeaSnapshot> snapshot;  ///< null before the first
    };
    Published published() const;
    TeaStatus status() const { return published().status; }
    std::shared_ptr<const TeaSnapshot> snapshot() const;

  private:
    bool has_liquid() const override { return tea_ != nullptr; }
    double step_liquid() override;
    bool owes_step() const override { return !hand_has_poured_; }
    bool waits() const override;
    int last_step() const override { return tea_->steps(); }
    void make_moment(LiquidStatus& status) override;
    void give_moment() override;

    void make_glass(const liquid::TeaSettings& settings);
    void use_settings();
    TeaFrame frame_now() const;

    // Of the session's thread alone.
    liquid::MilkDensities densities_{pool()};
    std::unique_ptr<liquid::MilkTea> tea_;
    liquid::TeaSettings settings_;  ///< without the force
    TeaForce force_;
    TeaFrames frames_;
    std::optional<glm::vec2> hand_m_;
    bool hand_has_poured_ = true;  ///< since it was told to
    std::shared_ptr<const TeaSnapshot> made_;

    // Under the mutex.
    std::shared_ptr<const TeaSnapshot> snapshot_;
    TeaStatus seen_;  ///< but for what all liquids have
};

}  // namespace pastoso::session
