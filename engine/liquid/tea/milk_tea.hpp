// Milk poured into a glass of tea: it sinks because it is cold, comes back up ball by ball as it warms,
// bursts under the surface, spreads and dissolves.
//
// Milk is either in parcels, which the tea carries along, or dissolved, a share c of each cell. Both
// together are what has been poured, to rounding, and lift the level. One step of time dt, in parts
// while milk falls in fast:
//     pour; raise the level; u += dt (buoyancy + the painter's force); viscosity, diffusion; make u free
//     of divergence; carry c, the tea's coldness T and the parcels, drawn out, along u; balls; carry u
//     along u; parcels warm (giving a share of their cold to T) and dissolve (giving volume to c).
#pragma once

#include "liquid/flow/flow.hpp"
#include "liquid/tea/milk_balls.hpp"
#include "liquid/tea/milk_jug.hpp"
#include "liquid/tea/parcel_cells.hpp"
#include "liquid/tea/tea_frame.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "liquid/tea/tea_state.hpp"

#include <optional>
#include <vector>

namespace pastoso::liquid {

/// How the equations of a step were solved: of several solutions the worst.
struct TeaStep {
    SolveResult pressure, diffusion;
    float divergence_per_s = 0.0F;  ///< the largest that pressure left in a cell, where it is measured
};

enum class MeasureDivergence { No, Yes };

class MilkTea {
  public:
    /// Tea at rest, without milk. Throws InputError like check_tea().
    explicit MilkTea(const TeaSettings& settings);

    const TeaSettings& settings() const { return settings_; }
    /// Forces, times and diffusion may change while it runs; cup, box, cells and the milk of the recipe
    /// stay as they are. Throws InputError like check_tea(), and when one of those would change.
    void set_settings(const TeaSettings& settings);

    TeaStep step(core::ThreadPool& pool, MeasureDivergence measure = MeasureDivergence::No);

    int steps() const { return steps_; }
    double time_s() const { return steps_ * settings_.step_s; }
    const std::vector<Parcel>& parcels() const { return parcels_; }
    const grid::BoxField& dissolved() const { return dissolved_; }  ///< share of milk in open cells
    const grid::BoxField& coldness() const { return coldness_; }    ///< of the tea, 0 warm, 1 as milk
    const VesselFlow& flow() const { return *flow_; }
    /// Filled up to the level as it stands.
    Cup cup() const { return filled_to(settings_.cup, level_m(settings_, jug_.poured_m3())); }
    SeenPour pour() const { return jug_.seen(settings_); }
    int ball_count() const { return balls_.count(); }
    TeaFrame frame() const;

    /// Tea of the same settings that is brought to this state goes on as this one does, to the last bit.
    TeaState state() const;
    /// Throws InputError when the state is none of such a glass: fields of another shape, parcels that
    /// lie nowhere in it or belong to balls there never were, or too many.
    void set_state(TeaState state);

    /// The milk of the recipe is poured from now on, once more where it was already; or no more of it. A
    /// new glass is poured into.
    void pour_recipe(bool pours) { jug_.pour_recipe(pours, settings_); }
    bool recipe_flows() const { return jug_.recipe_flows(settings_); }

    double poured_m3() const { return jug_.poured_m3(); }
    bool is_full() const { return jug_.is_full(settings_); }
    /// In parcels and dissolved.
    double milk_m3(core::ThreadPool& pool) const;

    /// The painter pours more milk at a place, as fast as the recipe pours its own, until told nullopt.
    /// A place outside the cup is taken to the wall. None is poured once the glass is full, the tea half
    /// milk, or there are kMaxParcels.
    void pour_by_hand(std::optional<glm::vec2> at_m) { jug_.pour_by_hand(at_m, settings_.cup); }

  private:
    int parts_of_step() const;
    void advance(double dt_s, MeasureDivergence measure, core::ThreadPool& pool, TeaStep& worst);
    void fill_flow();
    void raise_level(core::ThreadPool& pool);
    void add_buoyancy(float dt_s, core::ThreadPool& pool);
    SolveResult diffuse(float dt_s, core::ThreadPool& pool);
    void carry(float dt_s, core::ThreadPool& pool);
    void exchange(double dt_s, core::ThreadPool& pool);
    SharedFields shared_fields() { return {&coldness_, &dissolved_, &parcel_milk_, &parcel_coldness_}; }
    /// What a parcel spreads, of a cell's volume.
    static SharedAmounts undissolved(const Parcel& parcel, float per_m3) {
        const float milk = parcel.volume_m3 * per_m3;
        return {0.0F, 0.0F, milk, milk * parcel.coldness};
    }
    float cells_per_m3() const { return static_cast<float>(1.0 / flow_->shape().cell_volume_m3()); }
    void clear_parcel_fields();

    TeaSettings settings_;
    MilkJug jug_;
    Cup flow_cup_;                    ///< as the flow has it
    std::optional<VesselFlow> flow_;  ///< never empty
    grid::BoxField dissolved_, coldness_;
    std::vector<Parcel> parcels_, poured_;  ///< all, and those of a step
    MilkBalls balls_;
    int steps_ = 0;

    /// The milk and the coldness of parcels, as shares of the cells around them.
    grid::BoxField parcel_milk_, parcel_coldness_;
    ParcelSorter sorter_;
};

}  // namespace pastoso::liquid
