// Path tracing of a scene: every sample of a pixel follows light backwards through glass and liquid to a
// lamp or the sky (Kajiya 1986). Samples come in passes, so that a picture can be shown while it gets
// finer; the same bits come out on any number of threads and in any passes. Where there are triangles,
// another instruction set has other last bits (triangle_rays.hpp).
#pragma once

#include "core/thread_pool.hpp"
#include "trace/picture.hpp"
#include "trace/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace pastoso::trace {

struct TraceSettings {
    int width = 800, height = 800;  ///< 1 to 16384
    std::uint32_t seed = 1;
    /// Looks for the lamp from points that scatter, from those in milk straight through glass and liquid
    /// as if they did not bend light, and takes what else there is from photons (photons.hpp). Without
    /// it the lamp is met by chance alone: very noisy, but true (the reference).
    bool seeks_lamp = true;
    /// A sample's largest channel is clipped here, so that rare bright paths leave no dots; > 0.
    float brightest = 6.0F;
    int most_events = 400;  ///< on one path; what is left of its light then is lost. At least 1.
};

class PathTracer {
  public:
    /// Takes what it needs out of the scene; `pool` outlives the tracer. Throws InputError like
    /// check_scene(), and for settings out of their range.
    PathTracer(const Scene& scene, const TraceSettings& settings, core::ThreadPool& pool);
    ~PathTracer();
    PathTracer(PathTracer&&) noexcept;
    PathTracer& operator=(PathTracer&&) noexcept;

    /// Adds samples to every pixel, but to those of tiles that are clean; the first call shoots the
    /// photons before. Between tiles and between batches of photons asks `stop`, if there is one, on any
    /// thread of the pool; after a true answer returns false with some tiles ahead of others. The next
    /// call brings all to samples() + count, as if there had been no stop.
    bool add_samples(int count, const std::function<bool()>& stop = {});

    /// Of the pixel that has fewest, tiles that are clean aside.
    int samples() const;

    /// Segments of paths and shadow rays followed so far.
    std::uint64_t rays() const;

    /// The mean radiance of each pixel as it stands; 0 before the first sample.
    Picture radiance() const;

    /// The same with the noise taken out (denoise.hpp).
    Picture denoised() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace pastoso::trace
