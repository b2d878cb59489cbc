#include "session/tea_session.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {
namespace {

/// Coarse and quickly made: a surface for the screen. Its volume may be off by some percent.
liquid::MilkSurfaceSettings surface_for_screen() {
    liquid::MilkSurfaceSettings settings;
    settings.parts = 1;
    settings.volume_tolerance = 0.06;
    settings.most_tries = 3;
    return settings;
}

liquid::TeaSettings with_force(liquid::TeaSettings settings, const TeaForce& force) {
    settings.swirl_rad_s2 = force.on ? force.swirl_rad_s2 : 0.0;
    settings.push_m_s2 = force.on ? force.push_m_s2 : 0.0;
    settings.swirl_x_m = force.axis_m.x;
    settings.swirl_y_m = force.axis_m.y;
    return settings;
}

}  // namespace

TeaSession::TeaSession(const liquid::TeaSettings& settings, bool paused, Notify notify,
                       std::size_t budget_bytes)
    : notify_(std::move(notify)), settings_(settings), frames_(budget_bytes), paused_(paused) {
    force_.axis_m = settings.cup.axis_m;
    status_.paused = paused;
    status_.force = force_;
    post(Glass{settings});
    thread_ = std::thread([this] { run(); });
}

TeaSession::~TeaSession() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    work_.notify_all();
    thread_.join();
}

void TeaSession::post(Action action) {
    {
        const std::lock_guard lock(mutex_);
        status_.busy = status_.busy || std::holds_alternative<Glass>(action);
        posted_.push_back(std::move(action));
        ++posted_count_;
    }
    work_.notify_all();
}

std::shared_ptr<const TeaMoment> TeaSession::moment() const {
    const std::lock_guard lock(mutex_);
    return moment_;
}

TeaStatus TeaSession::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

std::vector<std::string> TeaSession::take_errors() {
    const std::lock_guard lock(mutex_);
    return std::exchange(errors_, {});
}

void TeaSession::wait_until_applied() {
    std::unique_lock lock(mutex_);
    const std::uint64_t wanted = posted_count_;
    published_.wait(lock, [&] { return published_count_ >= wanted; });
}

void TeaSession::run() {
    while (wait_for_work()) {
        while (apply_next()) {
        }
        if (runs() && (full_speed_ || Clock::now() >= due_)) step();
        if (changed_ && !may_wait()) publish();
    }
}

/// Sleeps until something is said, a step is due or the session ends; false at the end.
bool TeaSession::wait_for_work() {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return stopping_ || !posted_.empty(); };
    if (!runs())
        work_.wait(lock, ready);
    else if (!full_speed_)
        work_.wait_until(lock, due_, ready);
    return !stopping_;
}

/// A hand that is lifted before a step was made has poured all the same.
bool TeaSession::waits_for_step(const Action& action) const {
    const auto* pour = std::get_if<Pour>(&action);
    return pour != nullptr && !pour->at_m && !hand_has_poured_ && runs();
}

/// False when nothing is left to be applied before the next step.
bool TeaSession::apply_next() {
    Action action;
    {
        const std::lock_guard lock(mutex_);
        if (posted_.empty() || waits_for_step(posted_.front())) return false;
        action = std::move(posted_.front());
        posted_.pop_front();
        ++applied_count_;
    }
    changed_ = true;
    std::visit([this](const auto& what) { apply(what); }, action);
    return true;
}

void TeaSession::refuse(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    errors_.push_back(sentence);
}

/// The glass before stays when there can be none like this.
void TeaSession::apply(const Glass& glass) {
    try {
        auto tea = std::make_unique<liquid::MilkTea>(with_force(glass.settings, force_));
        tea_ = std::move(tea);
        settings_ = glass.settings;
        frames_.clear();
        frames_.keep(0, tea_->parcels(), tea_->dissolved());
        shown_step_.reset();
        hand_m_.reset();
        ++glass_;
        due_ = stepped_at_ = Clock::now();
    } catch (const core::InputError& error) {
        refuse(error.what());
    }
}

void TeaSession::apply(const Numbers& numbers) {
    const liquid::TeaSettings before = std::exchange(settings_, numbers.settings);
    try {
        use_settings();
    } catch (const core::InputError& error) {
        settings_ = before;
        refuse(error.what());
    }
}

void TeaSession::apply(const TeaForce& force) {
    const TeaForce before = std::exchange(force_, force);
    try {
        use_settings();
    } catch (const core::InputError& error) {
        force_ = before;
        refuse(error.what());
    }
}

void TeaSession::use_settings() {
    if (tea_ != nullptr) tea_->set_settings(with_force(settings_, force_));
}

void TeaSession::apply(const Pour& pour) {
    hand_m_ = pour.at_m;
    hand_has_poured_ = !pour.at_m;
    if (tea_ != nullptr) tea_->pour_by_hand(pour.at_m);
}

void TeaSession::apply(const Paused& paused) {
    paused_ = paused.paused;
    if (!paused_) shown_step_.reset();
    due_ = stepped_at_ = Clock::now();
}

void TeaSession::apply(const FullSpeed& speed) {
    full_speed_ = speed.full;
    due_ = Clock::now();
}

void TeaSession::apply(const Show& show) {
    if (tea_ == nullptr) return;
    paused_ = true;
    shown_step_ = show.step;
    if (show.step >= tea_->steps()) shown_step_.reset();
}

/// A glass that is too slow to compute runs late and stays late.
void TeaSession::step() {
    constexpr double kNewestShare = 0.1;
    tea_->step(pool_);
    hand_has_poured_ = true;
    frames_.keep(tea_->steps(), tea_->parcels(), tea_->dissolved());
    changed_ = true;
    const auto now = Clock::now();
    const double took_s = std::chrono::duration<double>(now - stepped_at_).count();
    if (took_s > 0.0) steps_per_s_ += kNewestShare * (1.0 / took_s - steps_per_s_);
    stepped_at_ = now;
    const auto length = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(tea_->settings().step_s));
    due_ = std::max(due_ + length, now - length);
}

/// While time passes, no more of it is spent on showing than on stepping, and no more pictures are made
/// than a screen shows.
bool TeaSession::may_wait() const {
    constexpr auto kScreenPeriod = std::chrono::milliseconds(30);
    if (!runs() || applied_count_ != published_count_) return false;
    return Clock::now() - published_at_ <
           std::max<Clock::duration>(2 * publication_cost_,
                                     full_speed_ ? kScreenPeriod : kScreenPeriod / 2);
}

TeaFrame TeaSession::frame_now() const {
    if (shown_step_) return frames_.at(*shown_step_);
    return {tea_->steps(), tea_->parcels(), tea_->dissolved()};
}

/// By hand, or by the recipe.
std::optional<glm::vec2> TeaSession::stream() const {
    if (shown_step_ || paused_) return std::nullopt;
    if (hand_m_) return hand_m_;
    const bool recipe = tea_->time_s() < settings_.pour_s && settings_.milk_m3 > 0.0;
    return recipe ? std::optional(settings_.cup.axis_m) : std::nullopt;
}

void TeaSession::publish() {
    const auto begin = Clock::now();
    std::shared_ptr<TeaMoment> moment;
    if (tea_ != nullptr) {
        moment = std::make_shared<TeaMoment>();
        moment->settings = with_force(settings_, force_);
        moment->seen = frame_now();
        moment->time_s = moment->seen.step * settings_.step_s;
        moment->stream_m = stream();
        moment->milk = surfaces_
                           .make(moment->seen.parcels, settings_.cup, moment->seen.dissolved.shape(),
                                 surface_for_screen())
                           .mesh;
    }
    {
        const std::lock_guard lock(mutex_);
        if (moment != nullptr) moment_ = moment;
        status_ = {.glass = glass_,
                   .step = moment != nullptr ? moment->seen.step : 0,
                   .last_step = tea_ != nullptr ? tea_->steps() : 0,
                   .time_s = moment != nullptr ? moment->time_s : 0.0,
                   .last_s = tea_ != nullptr ? tea_->time_s() : 0.0,
                   .paused = paused_,
                   .full_speed = full_speed_,
                   .pouring = hand_m_.has_value(),
                   .shows_last = !shown_step_,
                   .force = force_,
                   .milk_m3 = tea_ != nullptr ? tea_->poured_m3() : 0.0,
                   .steps_per_s = paused_ ? 0.0 : steps_per_s_,
                   .kept = frames_.steps(),
                   .kept_bytes = frames_.bytes(),
                   .busy = std::any_of(posted_.begin(), posted_.end(), [](const Action& action) {
                       return std::holds_alternative<Glass>(action);
                   })};
    }
    changed_ = false;
    published_at_ = Clock::now();
    publication_cost_ = published_at_ - begin;
    if (notify_) notify_();
    {
        const std::lock_guard lock(mutex_);
        published_count_ = applied_count_;
    }
    published_.notify_all();
}

}  // namespace pastoso::session
