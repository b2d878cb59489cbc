// A glass of milk tea that lives on its own thread: the window says what is done to it and shows the
// moments that are published. Nothing here knows of widgets.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/milk_surface.hpp"
#include "liquid/milk_tea.hpp"
#include "session/tea_frames.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::session {

/// The glass at one moment. It never changes.
struct TeaMoment {
    liquid::TeaSettings settings;
    TeaFrame seen;
    double time_s = 0.0;
    liquid::TriangleMesh milk;          ///< the surface of the parcels, as coarse as the cells
    std::optional<glm::vec2> stream_m;  ///< where milk is poured right now
};

/// What the painter stirs with. While it is off, the settings of the glass have no force.
struct TeaForce {
    bool on = false;
    double swirl_rad_s2 = 8.0;
    double push_m_s2 = 0.2;
    glm::dvec2 axis_m{0.05};
    friend bool operator==(const TeaForce&, const TeaForce&) = default;
};

struct TeaStatus {
    int glass = 0;                ///< counts the new ones
    int step = 0, last_step = 0;  ///< shown, and reached
    double time_s = 0.0, last_s = 0.0;
    bool paused = false;
    bool full_speed = false;
    bool pouring = false;  ///< by hand
    bool shows_last = true;
    TeaForce force;
    double milk_m3 = 0.0;        ///< poured so far
    double steps_per_s = 0.0;    ///< in about the last second
    std::vector<int> kept;       ///< steps that can be shown
    std::size_t kept_bytes = 0;  ///< what they take
    bool busy = false;           ///< a glass is being made
};

/// Actions are applied in their order, each between two steps. The hand never waits for a step.
class TeaSession {
  public:
    using Notify = std::function<void()>;

    static constexpr std::size_t kBudget_bytes = std::size_t{256} << 20;

    /// Fills a glass, and lets its time pass unless it is paused. Settings that are none are told as an
    /// error, and there is no glass until new_glass() gives others. `notify` is called on the session's
    /// thread when there is something new; it must return at once.
    TeaSession(const liquid::TeaSettings& settings, bool paused, Notify notify,
               std::size_t budget_bytes = kBudget_bytes);
    ~TeaSession();
    TeaSession(const TeaSession&) = delete;
    TeaSession& operator=(const TeaSession&) = delete;

    /// Clear tea in place of what is there. The force stays.
    void new_glass(const liquid::TeaSettings& settings) { post(Glass{settings}); }

    /// Other numbers from now on, as MilkTea::set_settings(); those of the force are not looked at.
    void set_numbers(const liquid::TeaSettings& settings) { post(Numbers{settings}); }
    void set_force(const TeaForce& force) { post(force); }

    /// Milk is poured there, until told nothing. However short that is, some is poured.
    void pour(std::optional<glm::vec2> at_m) { post(Pour{at_m}); }

    /// Going on shows the last step.
    void set_paused(bool paused) { post(Paused{paused}); }

    /// Time passes as fast as it can be computed, otherwise at most as fast as on the wall.
    void set_full_speed(bool full) { post(FullSpeed{full}); }

    /// Shows the kept moment at or before that step, and pauses.
    void show(int step) { post(Show{step}); }

    std::shared_ptr<const TeaMoment> moment() const;  ///< null before the first
    TeaStatus status() const;

    /// What was refused since the last call, a sentence each.
    std::vector<std::string> take_errors();

    /// Waits until what was said before is applied and published.
    void wait_until_applied();

  private:
    using Clock = std::chrono::steady_clock;
    struct Glass {
        liquid::TeaSettings settings;
    };
    struct Numbers {
        liquid::TeaSettings settings;
    };
    struct Pour {
        std::optional<glm::vec2> at_m;
    };
    struct Paused {
        bool paused;
    };
    struct FullSpeed {
        bool full;
    };
    struct Show {
        int step;
    };
    using Action = std::variant<Glass, Numbers, TeaForce, Pour, Paused, FullSpeed, Show>;

    void post(Action action);
    void run();
    bool wait_for_work();
    bool apply_next();
    bool waits_for_step(const Action& action) const;
    void apply(const Glass& glass);
    void apply(const Numbers& numbers);
    void apply(const TeaForce& force);
    void apply(const Pour& pour);
    void apply(const Paused& paused);
    void apply(const FullSpeed& speed);
    void apply(const Show& show);
    void step();
    void use_settings();
    void refuse(const std::string& sentence);
    bool runs() const { return tea_ != nullptr && !paused_; }
    bool may_wait() const;
    void publish();
    TeaFrame frame_now() const;
    std::optional<glm::vec2> stream() const;

    const Notify notify_;

    // Of the session's thread alone.
    core::ThreadPool pool_;
    liquid::MilkSurfaces surfaces_{pool_};
    std::unique_ptr<liquid::MilkTea> tea_;
    liquid::TeaSettings settings_;  ///< without the force
    TeaForce force_;
    TeaFrames frames_;
    int glass_ = 0;
    bool paused_, full_speed_ = false;
    std::optional<glm::vec2> hand_m_;
    bool hand_has_poured_ = true;    ///< since it was told to
    std::optional<int> shown_step_;  ///< none: the last
    bool changed_ = false;
    Clock::time_point due_, published_at_;
    Clock::duration publication_cost_{};
    double steps_per_s_ = 0.0;
    Clock::time_point stepped_at_;

    mutable std::mutex mutex_;
    std::condition_variable work_, published_;
    std::deque<Action> posted_;
    std::vector<std::string> errors_;
    std::shared_ptr<const TeaMoment> moment_;
    TeaStatus status_;
    std::uint64_t posted_count_ = 0, applied_count_ = 0, published_count_ = 0;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace pastoso::session
