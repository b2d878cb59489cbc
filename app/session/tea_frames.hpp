// Moments of a glass of milk tea, kept in memory to be looked at again.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/tea/milk_stream.hpp"
#include "liquid/tea/parcel.hpp"
#include "session/kept_frames.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pastoso::session {

/// What is seen of a moment: where the milk is, in parcels and dissolved.
struct TeaFrame {
    int step = 0;  ///< of the simulation
    std::vector<liquid::Parcel> parcels;
    grid::BoxField dissolved;
    liquid::SeenPour pour;
};

/// As KeptFrames.
class TeaFrames {
  public:
    explicit TeaFrames(std::size_t budget_bytes) : kept_(budget_bytes) {}

    void clear() { kept_.clear(); }
    void keep(int step, const std::vector<liquid::Parcel>& parcels, const grid::BoxField& dissolved,
              const liquid::SeenPour& pour);
    std::vector<int> steps() const { return kept_.steps(); }

    /// Milk is kept in 1/65535 of a cell, and parcels without their coldness and balls.
    TeaFrame at(int step) const;

    std::size_t bytes() const { return kept_.bytes(); }
    int interval() const { return kept_.interval(); }

  private:
    struct PackedParcel {
        glm::vec3 position_m;
        float volume_m3;
        liquid::ParcelShape shape;
    };
    struct Packed {
        int step = 0;
        std::vector<PackedParcel> parcels;
        std::vector<std::uint16_t> dissolved;
        liquid::SeenPour pour;
        std::size_t bytes() const {
            return parcels.size() * sizeof(PackedParcel) + dissolved.size() * sizeof(std::uint16_t);
        }
    };

    KeptFrames<Packed> kept_;
    grid::BoxShape shape_;
};

}  // namespace pastoso::session
