#include "python/traced.hpp"

#include "document/actions/field_checks.hpp"
#include "liquid_files/traced_picture.hpp"
#include "trace/tracer.hpp"

#include <string>
#include <thread>
#include <utility>

namespace pastoso::python {

TracedWish traced_wish(int width, int height, int samples, bool denoised,
                       const pybind11::object& dtype) {
    constexpr double kMostPixels = 16384.0;
    constexpr double kMostSamples = 1 << 20;
    document::check_between("width of the picture", "pixels", width, 1.0, kMostPixels);
    document::check_between("height of the picture", "pixels", height, 1.0, kMostPixels);
    document::check_between("number of samples", "", samples, 1.0, kMostSamples);
    return {width, height, samples, denoised, is_linear(dtype)};
}

RenderedPicture traced(const trace::Scene& scene, const TracedWish& wish, core::ThreadPool& pool,
                       Interruption& interruption) {
    trace::PathTracer tracer(scene, {.width = wish.width, .height = wish.height}, pool);
    // Python hears of signals on the thread that called it, which is one of those that trace.
    const std::thread::id caller = std::this_thread::get_id();
    const auto stop = [&] { return std::this_thread::get_id() == caller && interruption.wanted(); };
    if (!tracer.add_samples(wish.samples, stop)) return {};
    trace::Picture radiance = wish.denoised ? tracer.denoised() : tracer.radiance();
    if (wish.linear)
        return {.linear = {radiance.width, radiance.height, std::move(radiance.rgb)}, .encoded = {}};
    RenderedPicture picture{.linear = liquid_files::shown_image(radiance), .encoded = {}};
    picture.encoded = pigment::encode_srgb8(picture.linear);
    return picture;
}

}  // namespace pastoso::python
