#include "session/liquid_picture.hpp"

#include "liquid_files/traced_picture.hpp"
#include "tank/solid_mesh.hpp"
#include "trace/tank_scene.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {
LiquidPicture::LiquidPicture(LiquidPictureOrder order, std::function<void()> notify)
    : notify_(std::move(notify)),
      began_(std::chrono::steady_clock::now()),
      worker_([this](LiquidPictureOrder& what) { trace(what); },
              [this](LiquidPictureOrder&, const core::Message& fault) { fail(fault); }) {
    worker_.add(std::move(order));
}

LiquidPicture::Progress LiquidPicture::progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
}

std::shared_ptr<const trace::Picture> LiquidPicture::radiance() const {
    const std::lock_guard lock(mutex_);
    return radiance_;
}

std::shared_ptr<const pigment::Image8> LiquidPicture::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

void LiquidPicture::fail(const core::Message& sentence) {
    {
        const std::lock_guard lock(mutex_);
        progress_.error = sentence;
        progress_.finished = true;
    }
    notify_();
}

/// More samples are made at a time as the picture gets finer: each time some of them are twice as many.
void LiquidPicture::trace(const LiquidPictureOrder& order) {
    const auto ends = [this] { return stopping_ || worker_.cancelled(); };
    core::ThreadPool pool;
    const trace::Scene scene = order.scene(pool, order.body);
    trace::PathTracer tracer(scene, {.width = order.width, .height = order.height}, pool);
    while (tracer.samples() < order.samples && !ends()) {
        const int wanted = std::clamp(tracer.samples() / 2, 1, order.samples - tracer.samples());
        tracer.add_samples(wanted, ends);
        if (tracer.samples() < order.samples) publish(tracer.radiance(), tracer.samples(), false);
    }
    if (!worker_.cancelled()) publish(tracer.denoised(), tracer.samples(), true);
}

void LiquidPicture::publish(trace::Picture radiance, int samples, bool finished) {
    auto shown = std::make_shared<const pigment::Image8>(
        pigment::encode_srgb8(liquid_files::shown_image(radiance)));
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

trace::Scene traced_tea(const TeaSnapshot& snapshot, const trace::Camera& camera, trace::MilkBody body,
                        core::ThreadPool& pool) {
    const auto& [step, parcels, dissolved, pour] = snapshot.seen;
    trace::Scene scene = trace::tea_scene(snapshot.settings, parcels, dissolved, pour, body, pool);
    scene.camera = camera;
    return scene;
}

trace::Scene traced_tank(const TankSnapshot& snapshot, const trace::Camera& camera,
                         core::ThreadPool& pool) {
    constexpr int kSolidParts = 3;  // samples along a cell: edges stay sharp
    const grid::BoxField& milk = snapshot.seen.milk;
    const float overlap_m = trace::kTankOverlap_cells * milk.shape().cell_m;
    trace::Scene scene =
        trace::tank_scene(milk, liquid_surface(*snapshot.place, snapshot.seen, overlap_m, pool),
                          tank::solid_mesh(snapshot.place->scene, kSolidParts, pool), 1.0F);
    const float model = trace::tank_model_scale(milk.shape());
    scene.camera.eye_m = model * camera.eye_m;
    scene.camera.target_m = model * camera.target_m;
    scene.camera.field_of_view_deg = camera.field_of_view_deg;
    return scene;
}

}  // namespace pastoso::session
