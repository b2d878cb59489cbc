// What is saved is what is loaded, bit by bit, and goes on like what was not saved.
#include "document/canvas.hpp"
#include "document/player.hpp"
#include "document/well_session.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "film/support/support.hpp"
#include "project/mask_bits.hpp"
#include "project/paintings.hpp"
#include "recordings/activity_record.hpp"
#include "recordings/canvas_support.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ProjectRoundTrip : public files::TemporaryFolder {
  protected:
    LoadedProject saved_and_loaded(const Project& project) {
        save_project(folder / "a.pastoso", project, pool);
        return load_project(folder / "a.pastoso", pool);
    }
    core::ThreadPool pool{2};
};

void expect_equal(const film::SolverState& a, const film::SolverState& b) {
    EXPECT_EQ(a.calls, b.calls);
    EXPECT_EQ(a.runoff.thickness, b.runoff.thickness);
    ASSERT_EQ(a.awake.size(), b.awake.size());
    for (std::size_t i = 0; i < a.awake.size(); ++i) {
        EXPECT_EQ(a.awake[i].tile, b.awake[i].tile);
        EXPECT_EQ(recordings::activity_record(a.awake[i].activity),
                  recordings::activity_record(b.awake[i].activity));
    }
    ASSERT_EQ(a.pressures.size(), b.pressures.size());
    for (std::size_t i = 0; i < a.pressures.size(); ++i) {
        EXPECT_EQ(a.pressures[i].tile, b.pressures[i].tile);
        EXPECT_TRUE(std::equal(a.pressures[i].pressure_mm2_s2.read(),
                               a.pressures[i].pressure_mm2_s2.read() + grid::kTileCells,
                               b.pressures[i].pressure_mm2_s2.read()));
    }
}

/// Tiles at their own pace, in the middle of a wait.
int waiting_tiles(const document::PaintingState& state) {
    const auto& awake = state.solver.awake;
    return static_cast<int>(std::count_if(
        awake.begin(), awake.end(), [](const auto& tile) { return tile.activity.waiting_s > 0.0; }));
}

/// Whether a field came back; films are compared by their hash.
struct FieldComparer {
    void operator()(const std::shared_ptr<const document::BareCanvas>& a,
                    const std::shared_ptr<const document::BareCanvas>& b) const {
        EXPECT_EQ(a->settings, b->settings);
    }
    void operator()(const film::FilmState& a, const film::FilmState& b) const {
        EXPECT_EQ(film::state_hash(a), film::state_hash(b));
        EXPECT_EQ(a.consistencies, b.consistencies);
    }
    void operator()(const std::optional<film::FilmState>& a,
                    const std::optional<film::FilmState>& b) const {
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) (*this)(*a, *b);
    }
    void operator()(const document::LayerStack& a, const document::LayerStack& b) const {
        ASSERT_EQ(a.layers.size(), b.layers.size());
        for (std::size_t place = 0; place < a.layers.size(); ++place) {
            EXPECT_EQ(a.layers[place].id, b.layers[place].id);
            EXPECT_EQ(a.layers[place].look, b.layers[place].look);
            if (place != a.active) (*this)(*a.layers[place].inactive, *b.layers[place].inactive);
        }
        EXPECT_EQ(a.groups, b.groups);
        EXPECT_EQ(a.active, b.active);
    }
    void operator()(const std::optional<document::BrushInHand>& a,
                    const std::optional<document::BrushInHand>& b) const {
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) (*this)(*a, *b);
    }
    void operator()(const document::BrushAside& a, const document::BrushAside& b) const {
        ASSERT_EQ(a != nullptr, b != nullptr);
        if (a) (*this)(*a, *b);
    }
    void operator()(const document::BrushInHand& a, const document::BrushInHand& b) const {
        EXPECT_EQ(a.brush.held, b.brush.held);
        EXPECT_EQ(a.brush.consistencies, b.brush.consistencies);
        EXPECT_EQ(a.brush.strokes_begun, b.brush.strokes_begun);
        EXPECT_EQ(a.brush.gathering, b.brush.gathering);
        EXPECT_EQ(a.taken.size_mm, b.taken.size_mm);
        EXPECT_EQ(a.taken.seed, b.taken.seed);
    }
    void operator()(const document::Selection& a, const document::Selection& b) const {
        ASSERT_EQ(a != nullptr, b != nullptr);
        if (a) {
            EXPECT_EQ(mask_content(*a), mask_content(*b));
        }
    }
    void operator()(const document::Masking& a, const document::Masking& b) const {
        (*this)(a.cells, b.cells);
        (*this)(a.tape, b.tape);
    }
    void operator()(const document::SharedTracing& a, const document::SharedTracing& b) const {
        ASSERT_EQ(a != nullptr, b != nullptr);
        if (a) {
            EXPECT_EQ(*a, *b);
        }
    }
    void operator()(const document::SharedReferences& a, const document::SharedReferences& b) const {
        ASSERT_EQ(a != nullptr, b != nullptr);
        if (!a) return;
        EXPECT_EQ(*a, *b);
        for (std::size_t i = 0; i < a->references.size(); ++i)
            EXPECT_EQ(a->references[i].picture->png, b->references[i].picture->png);
    }
    void operator()(const document::CopiedPaint& a, const document::CopiedPaint& b) const {
        ASSERT_EQ(a != nullptr, b != nullptr);
        if (a) (*this)(*a, *b);
    }
    void operator()(const document::PaintFlows& a, const document::PaintFlows& b) const {
        EXPECT_EQ(a.taken, b.taken);
        EXPECT_EQ(a.wiped, b.wiped);
        EXPECT_EQ(a.forgotten_run_off.paint, b.forgotten_run_off.paint);
    }
    void operator()(const brush::HandAids& a, const brush::HandAids& b) const {
        EXPECT_EQ(a.stabiliser, b.stabiliser);
        EXPECT_EQ(a.guide, b.guide);
    }
    void operator()(const auto& a, const auto& b) const { EXPECT_EQ(a, b); }
};

void expect_equal(const document::PaintingState& a, const document::PaintingState& b) {
    EXPECT_EQ(document::state_hash(a), document::state_hash(b));
    EXPECT_EQ(a.tick, b.tick);
    EXPECT_EQ(a.ageing, b.ageing);
    document::for_each_field(FieldComparer{}, a.value, b.value);
    expect_equal(a.solver, b.solver);
    expect_equal(a.well_solver, b.well_solver);
}

TEST_F(ProjectRoundTrip, AnUntouchedCanvasComesBack) {
    document::CanvasSettings settings;
    settings.support = "cotton duck";
    const document::Painting painting(settings, pool);
    const Project project{painting.state(), {settings, {}, 0}};
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    EXPECT_EQ(loaded.strokes, project.strokes);
    EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST_F(ProjectRoundTrip, ABusyPaintingComesBack) {
    const Project project = busy_project(pool);
    const auto& film = project.painting.value.film;
    ASSERT_TRUE(film.worked.is_anywhere());
    ASSERT_TRUE(film.consistencies.are_several());
    ASSERT_GT(film.strata.fixed.thickness + film.strata.evaporated, 0);
    ASSERT_FALSE(project.painting.solver.awake.empty());
    ASSERT_TRUE(project.painting.value.well);
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    EXPECT_EQ(loaded.strokes, project.strokes);
    EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST_F(ProjectRoundTrip, PaintGoesOnToTheSameBitsOnAnyNumberOfThreads) {
    const document::Recording recording = busy_session();
    const std::uint64_t whole = played(recording, recording.end_tick, pool)->state_hash();
    int waiting = 0;
    for (const std::int64_t tick : {26, 52, 85, 130}) {
        const auto painting = played(recording, tick, pool);
        ASSERT_FALSE(painting->stroke_in_progress()) << tick;
        const LoadedProject loaded = saved_and_loaded(project_of(*painting, recording));
        waiting += waiting_tiles(loaded.painting);
        for (const int threads : {1, 2, 3}) {
            core::ThreadPool other(threads);
            document::Painting again(loaded.painting, other);
            document::Recording rest = recording;
            std::erase_if(rest.events, [&](const auto& event) { return event.tick < tick; });
            document::Player player(again, rest);
            while (!player.finished())
                player.play_tick();
            EXPECT_EQ(again.state_hash(), whole) << tick;
        }
    }
    EXPECT_GT(waiting, 0);
}

TEST_F(ProjectRoundTrip, ASelectionComesBackToTheCell) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::SelectArea{{{3, 2}, {40.2, 5}, {31, 28.7}, {12, 20}}});
    const Project project{painting->state(), {}};
    const LoadedProject loaded = saved_and_loaded(project);
    ASSERT_TRUE(loaded.painting.value.selection);
    expect_equal(loaded.painting, project.painting);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {painting.get(), &again})
        for (const document::Action& action :
             document::line_on(document::Surface::Canvas, 2.0, 4, 40, 15))
            one->apply(action);
    EXPECT_EQ(again.state_hash(), painting->state_hash());
}

TEST_F(ProjectRoundTrip, ASoftSelectionComesBackToTheShare) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::SelectArea{{{3, 2}, {40.2, 5}, {31, 28.7}, {12, 20}}});
    painting->apply(document::FeatherSelection{6.0});
    const Project project{painting->state(), {}};
    ASSERT_TRUE(grid::is_soft(*project.painting.value.selection));
    const LoadedProject loaded = saved_and_loaded(project);
    ASSERT_TRUE(loaded.painting.value.selection);
    expect_equal(loaded.painting, project.painting);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {painting.get(), &again})
        for (const document::Action& action :
             document::line_on(document::Surface::Canvas, 2.0, 4, 40, 15))
            one->apply(action);
    EXPECT_EQ(again.state_hash(), painting->state_hash());
}

TEST_F(ProjectRoundTrip, MaskingComesBackToTheCell) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::MaskStripe{{{3, 2}, {31, 12.7}}, 4.0});
    painting->apply(
        document::MaskStripe{.line = {{3, 20}, {31, 22}}, .width_mm = 3.0, .straight_ends = true});
    painting->apply(document::SetLayer{1, {.name = "Below", .bare_locked = true}});
    const Project project{painting->state(), {}};
    const LoadedProject loaded = saved_and_loaded(project);
    ASSERT_TRUE(loaded.painting.value.masking.cells);
    ASSERT_TRUE(loaded.painting.value.masking.tape);
    EXPECT_TRUE(loaded.painting.value.layers.layers[0].look.bare_locked);
    expect_equal(loaded.painting, project.painting);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {painting.get(), &again}) {
        for (const document::Action& action :
             document::line_on(document::Surface::Canvas, 2.0, 4, 40, 15))
            one->apply(action);
        for (int tick = 0; tick < 10; ++tick)
            one->advance_tick();
    }
    EXPECT_EQ(again.state_hash(), painting->state_hash());
}

TEST_F(ProjectRoundTrip, AClippedLayerComesBackWithWhatIsHidden) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::SelectArea{{{2, 2}, {30, 2}, {30, 20}, {2, 20}}});
    painting->apply(document::AddLayer{"Clipped"});
    painting->apply(document::FillWithPaint{.paint = {{{"PY35", 1.0}}}});
    const document::LayerStack& stack = painting->layers();
    painting->apply(
        document::SetLayer{stack.layers[stack.active].id, {.name = "Clipped", .clipped = true}});
    const Project project{painting->state(), {}};
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    const document::LayerStack& again = loaded.painting.value.layers;
    EXPECT_TRUE(again.layers[again.active].look.clipped);
    EXPECT_EQ(film::state_hash(document::Painting(loaded.painting, pool).snapshot().film),
              film::state_hash(painting->snapshot().film));
}

TEST_F(ProjectRoundTrip, ATracingPictureComesBackToThePixel) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::LayTracing{
        std::make_shared<const pigment::Picture>(pigment::Picture{2, 1, {1, 2, 3, 4, 250, 6, 7, 0}}),
        {-2.5, 3, 20, 10}});
    painting->apply(document::SetTracing{{-2.5, 3, 20.25, 10}, 0.7});
    const Project project{painting->state(), {}};
    const LoadedProject loaded = saved_and_loaded(project);
    ASSERT_TRUE(loaded.painting.value.tracing);
    expect_equal(loaded.painting, project.painting);
}

document::SharedReferencePicture reference_picture(std::uint8_t red) {
    const pigment::Picture pixels{3, 1, {red, 2, 3, 4, 250, 6, 7, 0, 8, 9, 10, 255}};
    return std::make_shared<const document::ReferencePicture>(
        document::ReferencePicture{pixels, files::png_file(pixels)});
}

TEST_F(ProjectRoundTrip, TheBoardOfReferencesComesBack) {
    document::Painting painting({.width_mm = 20, .height_mm = 20, .px_per_mm = 4}, pool);
    const auto expect_back = [&] {
        const Project project{painting.state(), {}};
        expect_equal(saved_and_loaded(project).painting, project.painting);
    };
    expect_back();
    for (const document::Action& action : std::vector<document::Action>{
             document::LayReference{"sky.jpg", {-2.5, 3, 20, 0, false}, reference_picture(1)},
             document::LayReference{"hand.png", {400, -3, 20.25, 0, false}, reference_picture(200)},
             document::LayReference{"", {0, 0, 1, 0, false}, reference_picture(30)},
             document::SetReference{2, {400, -3, 21, -12.5, true}, {0.7, true}},
             document::MoveReference{2, 0}, document::RemoveReference{1}, document::RemoveReference{2},
             document::RemoveReference{3}}) {
        painting.apply(action);
        ASSERT_TRUE(painting.state().value.references);
        expect_back();
    }
    painting.apply(document::LayReference{"next", {}, reference_picture(9)});
    EXPECT_EQ(painting.state().value.references->references.front().id, 4U);
}

/// Every colour of a coarse table with every coverage.
pigment::Picture half_transparent_picture() {
    pigment::Picture picture{64, 64, {}};
    for (int i = 0; i < 64 * 64; ++i) {
        const auto level = [](int number) { return static_cast<std::uint8_t>(85 * (number % 4)); };
        picture.rgba.insert(picture.rgba.end(), {level(i), level(i / 4), level(i / 16),
                                                 static_cast<std::uint8_t>(4 * (i / 64))});
    }
    return picture;
}

TEST_F(ProjectRoundTrip, HalfTransparentPicturesComeBack) {
    const auto picture = std::make_shared<const pigment::Picture>(half_transparent_picture());
    document::Painting painting({.width_mm = 20, .height_mm = 20, .px_per_mm = 4}, pool);
    // On the canvas, on one another, on white, moved and merged.
    for (const document::Action& action : std::vector<document::Action>{
             document::PaintPicture{"Once", {0, 0, 16, 16}, picture},
             document::PaintPicture{"Twice", {2, 1, 16, 16}, picture},
             document::TransformLayer{3, {.centre_x_mm = 10, .centre_y_mm = 9, .turn_deg = 31}},
             document::DistortLayer{3, {{2, 2}, 16, 14, {4, 3}, {16, 1}, {19, 17}, {1, 16}}},
             document::RotateCanvas{7.0}, document::DuplicateLayer{3}, document::MergeDown{4}}) {
        painting.apply(action);
        const Project project{painting.state(), {}};
        expect_equal(saved_and_loaded(project).painting, project.painting);
    }
}

TEST_F(ProjectRoundTrip, TexturesComeBackAndReplay) {
    document::Recording recording = busy_session();
    const document::PaintRecipe white{{{"PW6", 1.0}}};
    for (const layers::Texture& texture :
         {layers::Texture(layers::SandTexture{0.7, 3}), layers::Texture(layers::KnifedTexture{}),
          layers::Texture(layers::PressedTexture{
              {2, 2, 12, 12},
              0.4,
              true,
              std::make_shared<const pigment::Picture>(half_transparent_picture())})})
        recording.events.push_back({recording.end_tick, document::LayTexture{white, texture}});
    recording.end_tick += 20;
    const auto painting = played(recording, recording.end_tick, pool);
    const Project project = project_of(*painting, recording);
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    EXPECT_EQ(loaded.strokes, project.strokes);
    EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
              painting->state_hash());
}

TEST_F(ProjectRoundTrip, AdjustedDryPaintComesBackAndReplays) {
    document::Recording recording = busy_session();
    const document::PaintRecipe red{{{"PR108", 1.0}}};
    for (const document::Action& action :
         {document::Action(document::LayTexture{red, layers::SandTexture{0.7, 3}}),
          document::Action(document::AdjustDryPaint{{{{"PB29", 1.0}}}, layers::PaintExchange{0.4}}),
          document::Action(document::AdjustDryPaint{{{{"PY35", 1.0}}}, layers::Glaze{0.0125}})})
        recording.events.push_back({recording.end_tick, action});
    recording.end_tick += 20;
    const auto painting = played(recording, recording.end_tick, pool);
    const Project project = project_of(*painting, recording);
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    EXPECT_EQ(loaded.strokes, project.strokes);
    EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
              painting->state_hash());
}

TEST_F(ProjectRoundTrip, ACanvasThatWasCutComesBackAndReplays) {
    document::Recording recording = busy_session();
    recording.events.push_back({recording.end_tick, document::ResizeCanvas{-7, 4, 50, 31}});
    recording.end_tick += 20;
    for (const char* support : {"linen", "panel"}) {
        recording.canvas.support = support;
        const auto painting = played(recording, recording.end_tick, pool);
        const Project project = project_of(*painting, recording);
        const LoadedProject loaded = saved_and_loaded(project);
        expect_equal(loaded.painting, project.painting);
        EXPECT_EQ(loaded.strokes, project.strokes);
        EXPECT_THAT(loaded.notes, IsEmpty());
        EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
                  painting->state_hash());
    }
}

TEST_F(ProjectRoundTrip, ACanvasThatWasTurnedComesBackAndReplays) {
    document::Recording recording = busy_session();
    recording.events.push_back({recording.end_tick, document::ResizeCanvas{-7, 4, 50, 31}});
    recording.events.push_back({recording.end_tick, document::TurnCanvas{{true, 1}}});
    recording.end_tick += 20;
    for (const char* support : {"medium linen", "gesso panel"}) {
        recording.canvas.support = support;
        const auto painting = played(recording, recording.end_tick, pool);
        const Project project = project_of(*painting, recording);
        const LoadedProject loaded = saved_and_loaded(project);
        expect_equal(loaded.painting, project.painting);
        EXPECT_THAT(loaded.notes, IsEmpty()) << "the cloth that is made anew is the same";
        EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
                  painting->state_hash());
        document::Painting again(loaded.painting, pool), kept(project.painting, pool);
        for (document::Painting* one : {&again, &kept}) {
            one->apply(document::TurnCanvas{{false, 3}});
            one->apply(document::ResizeCanvas{-3, -3, 60, 60});
            one->advance_tick();
        }
        EXPECT_EQ(again.state_hash(), kept.state_hash());
    }
}

TEST_F(ProjectRoundTrip, ACanvasThatWasScaledComesBackAndReplays) {
    document::Recording recording = busy_session();
    recording.events.push_back({recording.end_tick, document::ResizeCanvas{-7, 4, 50, 31}});
    recording.events.push_back({recording.end_tick, document::ScaleCanvas{1.25, 0.9, 1.6}});
    recording.end_tick += 20;
    for (const char* support : {"medium linen", "gesso panel"}) {
        recording.canvas.support = support;
        const auto painting = played(recording, recording.end_tick, pool);
        const Project project = project_of(*painting, recording);
        const LoadedProject loaded = saved_and_loaded(project);
        expect_equal(loaded.painting, project.painting);
        EXPECT_THAT(loaded.notes, IsEmpty()) << "the cloth that is made anew is the same";
        EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
                  painting->state_hash());
        document::Painting again(loaded.painting, pool), kept(project.painting, pool);
        for (document::Painting* one : {&again, &kept}) {
            one->apply(document::ScaleCanvas{1.0, 1.0, 0.5});
            one->advance_tick();
        }
        EXPECT_EQ(again.state_hash(), kept.state_hash());
    }
}

TEST_F(ProjectRoundTrip, ACanvasThatWasRotatedComesBackAndReplays) {
    document::Recording recording = busy_session();
    recording.events.push_back(
        {recording.end_tick,
         document::DistortLayer{1, {{5, 5}, 20, 15, {8, 6}, {24, 3}, {30, 22}, {4, 20}}}});
    recording.events.push_back({recording.end_tick, document::RotateCanvas{-21.5}});
    recording.end_tick += 20;
    for (const char* support : {"medium linen", "gesso panel"}) {
        recording.canvas.support = support;
        const auto painting = played(recording, recording.end_tick, pool);
        const Project project = project_of(*painting, recording);
        const LoadedProject loaded = saved_and_loaded(project);
        expect_equal(loaded.painting, project.painting);
        EXPECT_THAT(loaded.notes, IsEmpty()) << "the cloth that is made anew is the same";
        EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
                  painting->state_hash());
        document::Painting again(loaded.painting, pool), kept(project.painting, pool);
        for (document::Painting* one : {&again, &kept}) {
            one->apply(document::RotateCanvas{4.0, true});
            one->advance_tick();
        }
        EXPECT_EQ(again.state_hash(), kept.state_hash());
    }
}

TEST_F(ProjectRoundTrip, CopiedPaintIsPastedAfterwardsAlike) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::SelectArea{{{3, 2}, {40.2, 5}, {31, 28.7}, {12, 20}}});
    painting->apply(document::CopyPaint{1});
    painting->apply(document::ResizeCanvas{-4, 3, 30, 40});  // what was copied keeps its size
    const Project project{painting->state(), {}};
    ASSERT_TRUE(film::has_wet_paint(*project.painting.value.copied));
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {painting.get(), &again})
        one->apply(document::PastePaint{"Copy", 3.0, -2.0});
    EXPECT_EQ(again.state_hash(), painting->state_hash());
}

TEST_F(ProjectRoundTrip, PaintThatWasCopiedInCellsOfAnotherSizeIsKept) {
    auto painting = played(busy_session(), 85, pool);
    painting->apply(document::CopyPaint{1});
    painting->apply(document::ScaleCanvas{1.0, 1.0, 1.5});
    const Project project{painting->state(), {}};
    ASSERT_NE(project.painting.value.copied->cell_mm, project.painting.value.film.cell_mm);
    const LoadedProject loaded = saved_and_loaded(project);
    expect_equal(loaded.painting, project.painting);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {painting.get(), &again})
        one->apply(document::PastePaint{"Copy"});
    EXPECT_EQ(again.state_hash(), painting->state_hash());
}

TEST_F(ProjectRoundTrip, TheStrokesReplayToThePainting) {
    const Project project = busy_project(pool);
    const LoadedProject loaded = saved_and_loaded(project);
    EXPECT_EQ(played(loaded.strokes, loaded.strokes.end_tick, pool)->state_hash(),
              document::state_hash(project.painting));
}

TEST_F(ProjectRoundTrip, TheSamePaintingGivesTheSameBytesAndALoadedOneToo) {
    const Project project = busy_project(pool);
    core::ThreadPool alone(1);
    const auto first = file_of(project, folder, pool);
    EXPECT_EQ(file_of(project, folder, alone), first);
    EXPECT_EQ(file_of(parse_project(first, "it", pool), folder, pool), first);
}

TEST_F(ProjectRoundTrip, TheBrushThatLiesAsideIsSavedWithItsPaint) {
    const Project project = busy_project(pool);
    document::Painting painting(project.painting, pool);
    painting.apply(document::LayBrushAside{{"Eraser 15", 9.0, 7}});
    painting.apply(document::SwapBrushes{});
    const LoadedProject loaded = saved_and_loaded({painting.state(), project.strokes});
    EXPECT_EQ(document::state_hash(loaded.painting), document::state_hash(painting.state()));
    document::Painting opened(loaded.painting, pool);
    EXPECT_EQ(opened.account().brush.volume_mm3, painting.account().brush.volume_mm3);
    EXPECT_GT(opened.account().brush.volume_mm3, 0.0);
    for (document::Painting* each : {&painting, &opened}) {
        each->apply(document::SwapBrushes{});
        each->apply(document::PenDown{{.x_mm = 5.0, .y_mm = 5.0}});
        each->apply(document::PenMove{{.time_s = 0.1, .x_mm = 12.0, .y_mm = 9.0}});
        each->apply(document::PenUp{});
    }
    EXPECT_EQ(opened.state_hash(), painting.state_hash());
}

TEST_F(ProjectRoundTrip, LoadingTellsHowFarItIsAndEndsWithWhatThatThrows) {
    const Project project = busy_project(pool);
    save_project(folder / "a.pastoso", project, pool);
    std::vector<double> shares;
    const LoadedProject loaded =
        load_project(folder / "a.pastoso", pool, [&](double done) { shares.push_back(done); });
    EXPECT_EQ(document::state_hash(loaded.painting), document::state_hash(project.painting));
    ASSERT_GT(shares.size(), 10U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_GT(shares.back(), 0.5);
    EXPECT_LE(shares.back(), 1.0);
    // At any moment, in the middle of the tiles, too.
    for (std::size_t last = 0; last < shares.size(); ++last) {
        std::size_t told = 0;
        const auto give_up = [&](double) {
            if (told++ >= last) throw core::GivenUp();
        };
        EXPECT_THROW(load_project(folder / "a.pastoso", pool, give_up), core::GivenUp) << last;
    }
}

TEST_F(ProjectRoundTrip, AHeightImageIsNotNeededAgain) {
    files::write_image(folder / "bumps.tif",
                       pigment::Image8{3, 2,
                                       std::vector<std::uint8_t>{0, 0, 0, 90, 90, 90, 255, 255, 255, 30,
                                                                 30, 30, 20, 20, 20, 200, 200, 200}});
    document::CanvasSettings settings;
    settings.width_mm = settings.height_mm = 20.0;
    settings.support = "image";
    settings.support_image = (folder / "bumps.tif").string();
    const auto painting = recordings::make_painting(settings, pool);
    save_project(folder / "a.pastoso", {painting->state(), {settings, {}, 0}}, pool);
    painting->apply(document::TurnCanvas{{false, 1}});
    save_project(folder / "turned.pastoso", {painting->state(), {settings, {}, 0}}, pool);
    std::filesystem::remove(folder / "bumps.tif");
    EXPECT_EQ(document::state_hash(load_project(folder / "turned.pastoso", pool).painting),
              painting->state_hash());
    painting->apply(document::Undo{});
    EXPECT_EQ(document::state_hash(load_project(folder / "a.pastoso", pool).painting),
              painting->state_hash());
}

TEST_F(ProjectRoundTrip, ACanvasThatAnotherVersionWeavesOtherwiseIsLoadedWithANote) {
    Project project = busy_project(pool);
    auto& painting = project.painting;
    const grid::Shape& shape = painting.value.film.shape;
    // As if this version made another linen: what lies below paint comes from the file.
    painting.value.bare = std::make_shared<const document::BareCanvas>(document::BareCanvas{
        painting.value.bare->settings,
        film::named_support("panel", shape, painting.value.film.cell_mm, 0.0, pool)});
    const auto own = painting.value.film.support_mm;
    for (int tile = 0; tile < shape.tile_count(); ++tile)
        if (painting.value.film.thickness.is_background(tile) &&
            painting.value.film.strata.optics.is_background(tile))
            painting.value.film.support_mm.replace(tile, painting.value.bare->support_mm.block(tile));
    ASSERT_NE(document::state_hash(painting), 0U);
    const LoadedProject loaded = saved_and_loaded(project);
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        if (painting.value.film.thickness.is_background(tile)) continue;
        const film::TileHeights loaded_tile = loaded.painting.value.film.support_mm.read(tile);
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            ASSERT_EQ(own.read(tile)[cell], loaded_tile[cell]) << "tile " << tile << ", cell " << cell;
    }
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_THAT(loaded.notes.front().text(), HasSubstr("another form of linen"));
}

TEST_F(ProjectRoundTrip, PaintsOfSomebodyElseDoNotHinderLoading) {
    Project project = busy_project(pool);
    document::LoadPaint load;
    load.paint.ingredients = {{"Aunt Emma's green", 1.0}};
    project.strokes.events.push_back({project.painting.tick, load});
    const LoadedProject loaded = saved_and_loaded(project);
    EXPECT_EQ(loaded.strokes, project.strokes);
    EXPECT_THAT(loaded.notes, IsEmpty());
}

TEST_F(ProjectRoundTrip, StrokesThatCannotBeReadCostOnlyTheirReplay) {
    Project project = busy_project(pool);
    project.strokes.events.push_back({project.painting.tick, document::PenDown{{.pressure = 7.0}}});
    const LoadedProject loaded = saved_and_loaded(project);
    EXPECT_EQ(document::state_hash(loaded.painting), document::state_hash(project.painting));
    EXPECT_THAT(loaded.strokes.events, IsEmpty());
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_THAT(loaded.notes.front().text(), HasSubstr("strokes cannot be replayed"));
}

TEST_F(ProjectRoundTrip, TheSummaryTellsWithoutLoading) {
    const Project project = busy_project(pool);
    save_project(folder / "a.pastoso", project, pool);
    const ProjectSummary summary = project_summary(folder / "a.pastoso");
    EXPECT_EQ(summary.canvas, project.painting.value.bare->settings);
    EXPECT_EQ(summary.tick, project.painting.tick);
    EXPECT_EQ(summary.medium, "house paint");
    EXPECT_EQ(summary.brush, "Round sable 9");
    const auto paint = std::find_if(summary.sizes.begin(), summary.sizes.end(),
                                    [](const KindSize& size) { return size.kind == "paint"; });
    ASSERT_NE(paint, summary.sizes.end());
    EXPECT_EQ(paint->bytes % (64U * 4096U), 0U);
    EXPECT_LT(paint->packed_bytes, paint->bytes / 2);
}

/// Untouched tiles are not in the file, whatever the canvas measures; its pictures are.
TEST_F(ProjectRoundTrip, AnEmptyCanvasOf8192CellsASideIsASmallFile) {
    document::CanvasSettings settings;
    settings.width_mm = settings.height_mm = 2048.0;
    settings.support = "panel";
    const grid::Shape shape = document::canvas_shape(settings);
    ASSERT_EQ(shape.width, 8192);
    const document::Painting painting(settings, film::SupportHeights(shape), pool);
    save_project(folder / "a.pastoso", {painting.state(), {settings, {}, 0}}, pool);
    EXPECT_LT(std::filesystem::file_size(folder / "a.pastoso"), 1'000'000U);
    EXPECT_THAT(project_summary(folder / "a.pastoso").sizes, ElementsAre(testing::_));
}

}  // namespace
}  // namespace pastoso::project
