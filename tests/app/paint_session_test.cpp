#include "session/paint_session.hpp"

#include "core/error.hpp"
#include "core/message_text.hpp"
#include "document/player.hpp"
#include "patience.hpp"
#include "recordings/recording_json.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

using namespace document;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

CanvasSettings small_canvas() {
    CanvasSettings canvas;
    canvas.width_mm = 40.0;
    canvas.height_mm = 30.0;
    canvas.px_per_mm = 2.0;
    return canvas;
}

std::unique_ptr<PaintSession> start_session(PaintSession::Notify notify = {}) {
    auto pool = std::make_unique<core::ThreadPool>(2);
    auto painting = std::make_unique<Painting>(small_canvas(), *pool);
    return std::make_unique<PaintSession>(std::move(pool), std::move(painting), std::move(notify));
}

/// A session whose window fails as `fail` does, once it is told to.
struct FailingWindow {
    explicit FailingWindow(std::function<void()> fail)
        : session(start_session([this, fail = std::move(fail)] {
              if (fails.exchange(false)) fail();
          })) {}
    std::atomic<bool> fails = false;
    std::unique_ptr<PaintSession> session;
};

void take_loaded_brush(PaintSession& session) {
    session.post(UseMedium{"soft-body acrylic"});
    session.post(TakeBrush{"Flat bristle 20", 8.0, 1});
    LoadPaint dip;
    dip.paint.ingredients = {{"PB29", 1.0}};
    session.post(dip);
}

brush::PenSample sample_at(double time_s, double x_mm, double y_mm) {
    brush::PenSample sample;
    sample.time_s = time_s;
    sample.x_mm = x_mm;
    sample.y_mm = y_mm;
    return sample;
}

/// A stroke from left to right at this height.
void post_stroke(PaintSession& session, double start_s, double y_mm) {
    session.post(PenDown{sample_at(start_s, 6.0, y_mm)});
    for (int i = 1; i <= 25; ++i)
        session.post(PenMove{sample_at(start_s + 0.01 * i, 6.0 + i, y_mm)});
    session.post(PenUp{});
}

std::int64_t paint_on(const PaintSession& session) {
    return film::totals(session.snapshot()->film).thickness;
}

/// Stops paint time and waits until no tick is under way any more.
void hold_still(PaintSession& session) {
    session.set_paused(true);
    session.post(PenUp{});
    session.wait_until_applied();
}

TEST(PaintSession, StartsWithAnEmptyCanvasThatCanBeShownAtOnce) {
    const auto session = start_session();
    ASSERT_NE(session->snapshot(), nullptr);
    EXPECT_EQ(session->snapshot()->film.shape, (grid::Shape{80, 60}));
    EXPECT_EQ(paint_on(*session), 0);
    EXPECT_FALSE(session->status().can_undo);
}

TEST(PaintSession, AStrokeThroughTheQueueLeavesPaint) {
    const auto session = start_session();
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 15.0);
    session->wait_until_applied();
    EXPECT_GT(film::volume_mm3(paint_on(*session), session->snapshot()->film.cell_mm), 1.0);
    EXPECT_TRUE(session->status().can_undo);
    EXPECT_FALSE(session->status().stroke_in_progress);
    EXPECT_EQ(session->status().strokes, 1);
    EXPECT_TRUE(session->take_errors().empty());
}

TEST(PaintSession, AStrokeFromBesideIsAStepAsSoonAsItTouches) {
    const auto session = start_session();
    hold_still(*session);
    take_loaded_brush(*session);
    session->post(PenDown{sample_at(0.0, -60.0, 15.0), Surface::Canvas, true});
    session->wait_until_applied();
    const std::size_t before = session->steps()->past.size();
    for (int i = 1; i <= 25; ++i)
        session->post(PenMove{sample_at(0.01 * i, -60.0 + 4.0 * i, 15.0)});
    session->wait_until_applied();
    EXPECT_TRUE(session->status().stroke_in_progress);
    EXPECT_EQ(session->steps()->past.size(), before + 1);
    session->post(PenUp{});
    session->wait_until_applied();
    EXPECT_EQ(session->steps()->past.size(), before + 1);
}

TEST(PaintSession, LayersArePublishedOnlyWhenSomethingAboutThemChanges) {
    const auto session = start_session();
    take_loaded_brush(*session);
    session->post(AddLayer{"Glaze"});
    session->wait_until_applied();
    const auto two = session->snapshot();
    ASSERT_EQ(two->layers->layers.size(), 2U);
    EXPECT_EQ(two->layers->layers[1].look.name, "Glaze");
    ASSERT_NE(two->active, nullptr);
    post_stroke(*session, 0.0, 15.0);
    session->wait_until_applied();
    const auto painted = session->snapshot();
    EXPECT_EQ(painted->layers, two->layers);
    EXPECT_GT(film::totals(*painted->active).thickness, 0);
    session->post(SetLayer{2, {.name = "Glaze", .locked = true}});
    session->wait_until_applied();
    EXPECT_NE(session->snapshot()->layers, two->layers);
    EXPECT_TRUE(session->snapshot()->layers->layers[1].look.locked);
    EXPECT_FALSE(two->layers->layers[1].look.locked);
}

TEST(PaintSession, ACapturedPaintingGoesOnInAnotherSessionWithItsWholeRecording) {
    auto session = start_session();
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 15.0);
    session->post(PenDown{sample_at(1.0, 6.0, 20.0)});
    const Capture capture = session->capture();
    session.reset();
    const Recording until_then = capture.record.recording();
    EXPECT_EQ(capture.changes, 2);
    // The stroke in progress was ended.
    ASSERT_TRUE(std::holds_alternative<PenUp>(until_then.events.back().action));
    EXPECT_EQ(until_then.end_tick, capture.painting.tick);

    auto pool = std::make_unique<core::ThreadPool>(2);
    auto painting = std::make_unique<Painting>(capture.painting, *pool);
    PaintSession next(std::move(pool), std::move(painting), {}, until_then);
    EXPECT_EQ(next.status().changes, 0);
    EXPECT_GE(next.status().tick, capture.painting.tick);
    post_stroke(next, 2.0, 10.0);
    const Capture later = next.capture();
    EXPECT_EQ(later.changes, 1);

    core::ThreadPool alone(1);
    const Recording whole = later.record.recording();
    Painting replayed(whole.canvas, alone);
    Player player(replayed, whole);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(replayed.state_hash(), document::state_hash(later.painting));
}

TEST(PaintSession, CapturesWhilePaused) {
    const auto session = start_session();
    hold_still(*session);
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 15.0);
    EXPECT_EQ(session->capture().record.recording().events.size(), 1U + 3U + 27U);
}

TEST(PaintSession, UndoTakesTheLastStrokeBackAndRedoBringsItAgain) {
    const auto session = start_session();
    session->set_paused(true);
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 8.0);
    session->wait_until_applied();
    const std::uint64_t one_stroke = film::state_hash(session->snapshot()->film);
    post_stroke(*session, 1.0, 20.0);
    session->wait_until_applied();
    const std::uint64_t two_strokes = film::state_hash(session->snapshot()->film);
    ASSERT_NE(one_stroke, two_strokes);
    session->post(Undo{});
    session->wait_until_applied();
    EXPECT_EQ(film::state_hash(session->snapshot()->film), one_stroke);
    EXPECT_TRUE(session->status().can_redo);
    session->post(Redo{});
    session->wait_until_applied();
    EXPECT_EQ(film::state_hash(session->snapshot()->film), two_strokes);
    session->post(Undo{});
    session->post(Undo{});
    session->wait_until_applied();
    EXPECT_EQ(paint_on(*session), 0);
}

TEST(PaintSession, ItsRecordingReplaysToTheSameBits) {
    const auto session = start_session();
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 15.0);
    session->post(TiltCanvas{80.0, 90.0});
    post_stroke(*session, 0.5, 20.0);
    session->post(Undo{});
    session->wait_until_applied();
    while (session->status().tick < 20)
        std::this_thread::yield();
    hold_still(*session);
    const Recording recording = session->recording();
    const auto snapshot = session->snapshot();

    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(painting.tick(), snapshot->tick);
    EXPECT_EQ(film::state_hash(painting.film()), film::state_hash(snapshot->film));
}

// The hand's own times stay, and the ticks tell all that there is to know of the paint's.
TEST(PaintSession, WhatIsPaintedWhileTimeRunsFasterReplaysToTheSameBits) {
    const auto session = start_session();
    session->set_speed(10.0);
    session->post(UseMedium{"house paint"});
    session->post(TakeBrush{"Flat bristle 20", 8.0, 1});
    LoadPaint dip;
    dip.paint.ingredients = {{"PB29", 1.0}};
    session->post(dip);
    session->post(TiltCanvas{60.0, 90.0});
    post_stroke(*session, 0.0, 8.0);
    ASSERT_TRUE(tests::comes_true([&] { return session->status().tick >= 200; }));
    post_stroke(*session, 0.5, 12.0);
    ASSERT_TRUE(tests::comes_true([&] { return session->status().tick >= 300; }));
    const Capture capture = session->capture();
    const Recording live = capture.record.recording();
    const Recording recording =
        recordings::recording_from_json(recordings::recording_to_json(live), "s");

    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    EXPECT_GT(paint_on(*session), 0);
    EXPECT_EQ(painting.state_hash(), document::state_hash(capture.painting));

    std::vector<double> times_s;
    for (const Event& event : recording.events)
        if (const auto* move = std::get_if<PenMove>(&event.action))
            times_s.push_back(move->sample.time_s);
    ASSERT_EQ(times_s.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i)
        EXPECT_NEAR(times_s[i], i < 25 ? 0.01 * (i + 1) : 0.5 + 0.01 * (i - 24), 1e-9);
}

TEST(PaintSession, TimePassesAsUsualUnderAStroke) {
    const auto session = start_session();
    take_loaded_brush(*session);
    session->set_speed(20.0);
    const auto speed_is = [&](double speed) {
        return tests::comes_true([&] { return session->status().speed == speed; });
    };
    ASSERT_TRUE(speed_is(20.0));
    session->post(PenDown{sample_at(0.0, 6.0, 15.0)});
    session->post(PenMove{sample_at(0.01, 7.0, 15.0)});
    EXPECT_TRUE(speed_is(1.0));
    session->post(PenUp{});
    EXPECT_TRUE(speed_is(20.0));
    session->set_speed(1.0);
    EXPECT_TRUE(speed_is(1.0));
}

/// Ticks are passed together there; what is done falls on the tick of its moment all the same.
TEST(PaintSession, ACanvasAtRestKeepsTime) {
    const auto session = start_session();
    session->wait_until_applied();
    const auto begin = std::chrono::steady_clock::now();
    constexpr std::chrono::milliseconds kStep(180);
    for (int i = 1; i <= 5; ++i) {
        std::this_thread::sleep_until(begin + i * kStep);
        session->post(UseMedium{i % 2 == 0 ? "stand oil" : "soft-body acrylic"});
    }
    session->wait_until_applied();
    const auto events = session->recording().events;
    ASSERT_EQ(events.size(), 5U);
    for (int i = 1; i < 5; ++i) {
        const double passed_s = kTick_s * static_cast<double>(events[i].tick - events[0].tick);
        const double asked_s = 1e-3 * static_cast<double>(i * kStep.count());
        EXPECT_GT(passed_s, 0.5 * asked_s);
    }
}

TEST(PaintSession, APastBringsThePaintsThatAreKnown) {
    auto pool = std::make_unique<core::ThreadPool>(1);
    auto painting =
        std::make_unique<Painting>(CanvasSettings{.width_mm = 20.0, .height_mm = 20.0}, *pool);
    LoadPaint load;
    load.paint.ingredients = {{"PB29", 1.0}, {"Aunt Emma's green", 1.0}};
    const PaintSession session(std::move(pool), std::move(painting), {}, {{}, {{0, load}}, 0});
    EXPECT_THAT(session.paints_used(), ElementsAre("PB29"));
}

TEST(PaintSession, PlayingARecordingPaintsWhatWasRecorded) {
    const auto first = start_session();
    first->set_paused(true);
    take_loaded_brush(*first);
    post_stroke(*first, 0.0, 15.0);
    first->wait_until_applied();

    const auto second = start_session();
    second->play(first->recording().events);
    while (second->status().replaying)
        std::this_thread::yield();
    EXPECT_TRUE(second->take_errors().empty());
    EXPECT_GT(paint_on(*second), 0);
    EXPECT_EQ(second->recording().events.size(), first->recording().events.size());
}

TEST(PaintSession, AHurriedRecordingPaintsTheSameAndShowsLess) {
    const auto first = start_session();
    first->set_paused(true);
    take_loaded_brush(*first);
    post_stroke(*first, 0.0, 15.0);
    first->wait_until_applied();
    Recording recording = first->recording();
    for (document::Event& event : recording.events)
        event.tick = 0;  // a tick may have passed before the pause
    constexpr std::int64_t kLastTick = 400;
    recording.events.push_back({0, TiltCanvas{80.0, 90.0}});
    recording.events.push_back({kLastTick, TiltCanvas{0.0, 90.0}});

    std::atomic<std::int64_t> shown = 0;
    const auto begin = WallClock::now();
    const auto second = start_session([&] { ++shown; });
    second->play(recording.events, true);
    while (second->status().replaying)
        std::this_thread::yield();
    EXPECT_LE(second->steps()->past.size(), 1U) << "they would come faster than they are packed";
    // Not more pictures than a screen shows in that time, however many ticks that was; one more where
    // the session begins, where the recording does and where that ends.
    const std::int64_t pictures = shown;
    EXPECT_LE(pictures, 3 + (WallClock::now() - begin) / std::chrono::milliseconds(16));
    const Capture capture = second->capture();
    const Recording then = capture.record.recording();
    EXPECT_EQ(then.events.size(), recording.events.size());
    EXPECT_EQ(then.events.back().tick - then.events.front().tick, kLastTick);

    core::ThreadPool pool(1);
    Painting painting(then.canvas, pool);
    Player player(painting, then);
    while (!player.finished())
        player.play_tick();
    EXPECT_GT(paint_on(*second), 0);
    EXPECT_EQ(painting.state_hash(), document::state_hash(capture.painting));

    post_stroke(*second, 9.0, 10.0);
    post_stroke(*second, 9.5, 20.0);
    second->wait_until_applied();
    EXPECT_GE(second->steps()->past.size(), 2U) << "now they are kept again";
}

TEST(PaintSession, ARefusedActionIsToldInASentenceAndTheSessionGoesOn) {
    const auto session = start_session();
    session->post(TakeBrush{"Toothbrush", 8.0, 1});
    take_loaded_brush(*session);
    post_stroke(*session, 0.0, 15.0);
    session->wait_until_applied();
    EXPECT_THAT(core::texts_of(session->take_errors()), ElementsAre(HasSubstr("Toothbrush")));
    EXPECT_TRUE(session->take_errors().empty());
    EXPECT_GT(paint_on(*session), 0);
    // What was refused is not part of the recording.
    for (const Event& event : session->recording().events) {
        const auto* brush = std::get_if<TakeBrush>(&event.action);
        EXPECT_TRUE(brush == nullptr || brush->preset != "Toothbrush");
    }
}

TEST(PaintSession, PauseStopsThePaintButNotTheBrush) {
    const auto session = start_session();
    take_loaded_brush(*session);
    hold_still(*session);
    const std::int64_t tick = session->status().tick;
    post_stroke(*session, 0.0, 15.0);
    session->wait_until_applied();
    EXPECT_EQ(session->status().tick, tick);
    EXPECT_GT(paint_on(*session), 0);
    session->set_paused(false);
    while (session->status().tick == tick)
        std::this_thread::yield();
}

TEST(PaintSession, SnapshotsStayAsTheyWere) {
    const auto session = start_session();
    take_loaded_brush(*session);
    session->wait_until_applied();
    const auto before = session->snapshot();
    const std::uint64_t hash = film::state_hash(before->film);
    post_stroke(*session, 0.0, 15.0);
    session->wait_until_applied();
    EXPECT_EQ(film::state_hash(before->film), hash);
    EXPECT_NE(film::state_hash(session->snapshot()->film), hash);
}

TEST(PaintSession, ActionsFromManyThreadsAreAllApplied) {
    std::atomic<int> notifications = 0;
    const auto session = start_session([&] { ++notifications; });
    constexpr int kThreads = 4;
    constexpr int kTilts = 50;
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < kTilts; ++i)
                session->post(TiltCanvas{static_cast<double>(i), 90.0 * t});
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    session->wait_until_applied();
    EXPECT_EQ(session->recording().events.size(), static_cast<std::size_t>(kThreads * kTilts));
    // The word of it comes a moment after the last action was applied.
    while (notifications == 0)
        std::this_thread::yield();
}

TEST(PaintSession, EndsCleanlyInTheMiddleOfAStroke) {
    const auto session = start_session();
    take_loaded_brush(*session);
    session->post(PenDown{sample_at(0.0, 10.0, 10.0)});
    for (int i = 0; i < 200; ++i)
        session->post(PenMove{sample_at(0.01 * i, 10.0 + 0.1 * i, 10.0)});
}

TEST(PaintSession, WhateverFailsIsToldAndThePaintStandsStill) {
    const std::vector<std::pair<std::function<void()>, const char*>> failures{
        {[] { throw core::InputError("a: no."); }, "a: no."},
        {[] { throw std::bad_alloc(); }, "memory ran out"},
        {[] { std::filesystem::create_directory("/missing/more"); }, "/missing/more: "},
        {[] { throw std::runtime_error("broken"); }, "(broken)"},
        {[] { throw 7; }, "unknown kind"},
    };
    for (const auto& [fail, sentence] : failures) {
        FailingWindow window(fail);
        PaintSession& session = *window.session;
        window.fails = true;
        take_loaded_brush(session);
        session.wait_until_applied();
        EXPECT_THAT(core::texts_of(session.take_errors()), ElementsAre(HasSubstr(sentence)));
        EXPECT_TRUE(session.status().failed && session.status().paused);
        post_stroke(session, 0.0, 15.0);
        EXPECT_EQ(session.capture().record.recording().events.size(), 30U);
        session.set_paused(false);
        EXPECT_FALSE(session.status().failed);
        const std::int64_t tick = session.status().tick;
        while (session.status().tick < tick + 2)
            std::this_thread::yield();
        EXPECT_THAT(session.take_errors(), ElementsAre());
    }
}

}  // namespace
}  // namespace pastoso::session
