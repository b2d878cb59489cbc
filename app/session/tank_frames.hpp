// Moments of a tank, kept in memory to be looked at again.
#pragma once

#include "packing/packed_bytes.hpp"
#include "session/kept_frames.hpp"
#include "tank/tank_frame.hpp"

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::session {

/// The liquid there moves like this.
struct FlowArrow {
    glm::vec3 from_m, velocity_m_s;
};

/// What is seen of a moment.
struct TankSeen {
    int step = 0;  ///< counts the moments that can be kept, kTankMoment_s apart
    double time_s = 0.0;
    double volume_m3 = 0.0;
    liquid::SampledField level_m;  ///< as TankFrame::level_m
    grid::BoxField milk;           ///< as TankFrame::milk
    std::vector<FlowArrow> arrows;
};

/// As KeptFrames. Copies share what they hold.
class TankFrames {
  public:
    explicit TankFrames(std::size_t budget_bytes) : kept_(budget_bytes) {}

    void clear() { kept_.clear(); }
    bool wants(int step) const { return kept_.wants(step); }
    /// All of one tank.
    void keep(const TankSeen& seen);
    std::vector<int> steps() const { return kept_.steps(); }

    /// Levels are kept in 1/8000 of a cell, milk in 1/255.
    TankSeen at(int step) const;

    std::size_t bytes() const { return kept_.bytes(); }

  private:
    struct Content {
        double time_s = 0.0, volume_m3 = 0.0;
        packing::Bytes level, milk;
        std::vector<FlowArrow> arrows;
    };
    struct Packed {
        int step = 0;
        std::shared_ptr<const Content> content;
        std::size_t bytes() const {
            return content->level.size() + content->milk.size() +
                   content->arrows.size() * sizeof(FlowArrow);
        }
    };

    KeptFrames<Packed> kept_;
    liquid::Lattice lattice_;
    grid::BoxShape shape_;
};

}  // namespace pastoso::session
