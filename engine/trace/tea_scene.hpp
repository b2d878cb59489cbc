// The picture of a glass of milk tea at one moment.
#pragma once

#include "liquid/tea/milk_density.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid/tea/tea_frame.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// How milk that has not dissolved is drawn.
enum class MilkBody {
    Medium,   ///< as a share of the liquid, like milk that has dissolved
    Surface,  ///< as a dull body around the parcels
};

/// Keeps its working memory from one frame to the next.
class TeaScenes {
  public:
    explicit TeaScenes(core::ThreadPool& pool) : densities_(pool), surfaces_(pool) {}

    /// The usual table, light and camera, and in the cup of the settings the milk of a frame of theirs.
    Scene make(const liquid::TeaFrame& frame, const liquid::TeaSettings& settings,
               MilkBody body = MilkBody::Medium);

  private:
    liquid::MilkDensities densities_;
    liquid::MilkSurfaces surfaces_;
};

}  // namespace pastoso::trace
