// Moments of a glass of milk tea, kept in memory to be looked at again.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/parcel.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace pastoso::session {

/// What is seen of a moment: where the milk is, in parcels and dissolved.
struct TeaFrame {
    int step = 0;  ///< of the simulation
    std::vector<liquid::Parcel> parcels;
    grid::BoxField dissolved;
};

/// Every n-th step is kept, n = 1 at first. When they would take more memory than they may, every second
/// of them goes and n doubles: the whole time of the glass can always be sought, but ever more coarsely.
class TeaFrames {
  public:
    explicit TeaFrames(std::size_t budget_bytes) : budget_bytes_(budget_bytes) {}

    /// Of another glass.
    void clear();

    /// Steps come in their order, the first one with 0.
    void keep(int step, const std::vector<liquid::Parcel>& parcels, const grid::BoxField& dissolved);

    /// The steps that are kept, the first one first.
    std::vector<int> steps() const;

    /// The latest one at or before `step`; there is one. Milk is kept in 1/65535 of a cell, and parcels
    /// without their coldness and balls.
    TeaFrame at(int step) const;

    std::size_t bytes() const;
    int interval() const { return interval_; }

  private:
    struct Packed {
        int step = 0;
        std::vector<glm::vec4> parcels;  ///< place and volume
        std::vector<std::uint16_t> dissolved;
        std::size_t bytes() const {
            return parcels.size() * sizeof(glm::vec4) + dissolved.size() * sizeof(std::uint16_t);
        }
    };

    void thin_out();

    std::size_t budget_bytes_;
    int interval_ = 1;
    grid::BoxShape shape_;
    std::vector<Packed> frames_;
};

}  // namespace pastoso::session
