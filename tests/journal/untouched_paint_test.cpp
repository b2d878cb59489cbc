// Paint that was saved and opened again, or recovered, while another medium was in hand stays what it
// is.
#include "document/media_cases.hpp"
#include "files/temporary_folder.hpp"
#include "journal/journals.hpp"

#include <set>

namespace pastoso::journal {
namespace {

using document::NamedActions;

class UntouchedPaint : public files::TemporaryFolder, public testing::WithParamInterface<NamedActions> {
  protected:
    /// The painting before another medium is taken in hand.
    document::Recording standing() const {
        document::Recording recording = document::standing_oil();
        document::go_on(recording, GetParam().actions);
        return recording;
    }
    film::FilmState paint_before() {
        const document::Recording recording = standing();
        document::Painting painting(recording.canvas, pool);
        document::Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        return document::paint_of(painting, 1);
    }
    document::Recording with(const NamedActions& medium) const {
        document::Recording recording = standing();
        document::go_on(recording, medium.actions, 5);
        return recording;
    }
    void expect_untouched(const document::PaintingState& state) {
        document::Painting again(state, pool);
        document::go_on(again, document::back_to_paint(), 30);
        document::expect_untouched(paint_before(), document::paint_of(again, 1));
    }
    core::ThreadPool pool{1};
};

TEST_P(UntouchedPaint, StaysWhatItIsWhenItIsSavedAndOpened) {
    for (const NamedActions& medium : document::other_media()) {
        SCOPED_TRACE(medium.name);
        const document::Recording recording = with(medium);
        document::Painting painting(recording.canvas, pool);
        document::Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        project::save_project(folder / "a.pastoso", {painting.state(), recording}, pool);
        const project::LoadedProject opened = project::load_project(folder / "a.pastoso", pool);
        expect_untouched(opened.painting);
        EXPECT_EQ(document::state_hash(opened.painting), painting.state_hash());
    }
}

TEST_P(UntouchedPaint, StaysWhatItIsWhenItIsRecovered) {
    for (const NamedActions& medium : document::other_media()) {
        const document::Recording recording = with(medium);
        for (const std::set<std::size_t>& checkpoints :
             {std::set<std::size_t>{}, std::set{recording.events.size()}}) {
            SCOPED_TRACE(medium.name);
            const auto journal = left_behind(folder, recording, checkpoints, pool);
            const Recovered recovered = recover(journal, pool);
            expect_untouched(recovered.painting);
            EXPECT_EQ(document::state_hash(recovered.painting), hash_of_replay(recording, pool));
            std::filesystem::remove_all(journal);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Media, UntouchedPaint, testing::ValuesIn(document::places_of_paint()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pastoso::journal
