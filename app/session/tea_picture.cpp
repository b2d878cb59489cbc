#include "session/tea_picture.hpp"

#include "core/error.hpp"
#include "io/traced_picture.hpp"
#include "trace/tea_scene.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {
namespace {

/// With all the volume of the parcels, twice as fine as the cells.
trace::Scene scene_of(const TeaPictureOrder& order, core::ThreadPool& pool) {
    const TeaMoment& moment = *order.moment;
    const liquid::Cup& cup = moment.settings.cup;
    liquid::MilkSurfaces surfaces(pool);
    liquid::MilkSurface milk = surfaces.make(moment.seen.parcels, cup, moment.seen.dissolved.shape());
    trace::Scene scene = trace::tea_scene(cup, moment.seen.dissolved, std::move(milk.mesh));
    scene.milk_body = order.body;
    scene.camera = order.camera;
    return scene;
}

}  // namespace

TeaPicture::TeaPicture(TeaPictureOrder order, std::function<void()> notify)
    : order_(std::move(order)), notify_(std::move(notify)), began_(std::chrono::steady_clock::now()) {
    thread_ = std::thread([this] { run(); });
}

TeaPicture::~TeaPicture() {
    stopping_ = dropped_ = true;
    thread_.join();
}

TeaPicture::Progress TeaPicture::progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
}

std::shared_ptr<const trace::Picture> TeaPicture::radiance() const {
    const std::lock_guard lock(mutex_);
    return radiance_;
}

std::shared_ptr<const shade::Image8> TeaPicture::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

void TeaPicture::run() {
    try {
        trace();
    } catch (const core::InputError& error) {
        {
            const std::lock_guard lock(mutex_);
            progress_.error = error.what();
            progress_.finished = true;
        }
        notify_();
    }
}

/// More samples are made at a time as the picture gets finer: each time some of them are twice as many.
void TeaPicture::trace() {
    core::ThreadPool pool;
    trace::TeaTracer tracer(scene_of(order_, pool), {.width = order_.width, .height = order_.height},
                            pool);
    while (tracer.samples() < order_.samples && !stopping_) {
        const int wanted = std::clamp(tracer.samples() / 2, 1, order_.samples - tracer.samples());
        tracer.add_samples(wanted, [this] { return stopping_.load(); });
        if (tracer.samples() < order_.samples) publish(tracer.radiance(), tracer.samples(), false);
    }
    if (!dropped_) publish(tracer.denoised(), tracer.samples(), true);
}

void TeaPicture::publish(trace::Picture radiance, int samples, bool finished) {
    auto shown = std::make_shared<const shade::Image8>(shade::encode_srgb8(io::shown_image(radiance)));
    auto shared = std::make_shared<const trace::Picture>(std::move(radiance));
    {
        const std::lock_guard lock(mutex_);
        shown_ = std::move(shown);
        radiance_ = std::move(shared);
        progress_.samples = samples;
        progress_.finished = finished;
        progress_.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }
    notify_();
}

}  // namespace pastoso::session
