// Whatever is done once another medium is in hand, paint that nobody touches stays what it is.
#include "document/media_cases.hpp"
#include "document/player.hpp"

#include <tuple>

namespace pastoso::document {
namespace {

/// `next` is the number of the layer that comes next.
std::vector<NamedActions> doings(LayerId next) {
    return {
        {"Nothing", {}},
        {"Undo", {AddLayer{"More"}, Undo{}}},
        {"Redo", {AddLayer{"More"}, Undo{}, Redo{}}},
        {"UndoToTheMediumBefore", {Undo{}, Redo{}}},
        {"Merge", {SelectLayer{1}, SetLayer{1, {.name = "Paint"}}, AddLayer{"More"}, MergeDown{next}}},
        {"Duplicate", {DuplicateLayer{1}}}};
}
constexpr int kDuplicate = 5, kDoings = 6;

class UntouchedPaint : public testing::TestWithParam<std::tuple<NamedActions, int>> {
  protected:
    void expect_it_stays(const std::vector<Action>& other_medium) {
        const auto& [place, doing] = GetParam();
        Painting painting(small_canvas(), pool);
        const Recording recording = standing_oil();
        Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        go_on(painting, place.actions);
        const film::FilmState before = paint_of(painting, 1);
        go_on(painting, other_medium, 5);
        const LayerId next = painting.layers().next_layer;
        go_on(painting, doings(next)[static_cast<std::size_t>(doing)].actions);
        go_on(painting, back_to_paint(), 30);
        expect_untouched(before, paint_of(painting, 1));
        EXPECT_LT(painting.account().volume_error_rel(), 1e-9);
        if (doing != kDuplicate) return;
        go_on(painting, {SelectLayer{next}}, 30);
        expect_untouched(before, paint_of(painting, next));
    }
    core::ThreadPool pool{1};
};

TEST_P(UntouchedPaint, StaysWhatItIs) {
    for (const NamedActions& medium : other_media()) {
        SCOPED_TRACE(medium.name);
        expect_it_stays(medium.actions);
    }
}

std::string name_of(const testing::TestParamInfo<UntouchedPaint::ParamType>& test) {
    const auto doing = static_cast<std::size_t>(std::get<1>(test.param));
    return std::get<0>(test.param).name + doings(2)[doing].name;
}

INSTANTIATE_TEST_SUITE_P(Media, UntouchedPaint,
                         testing::Combine(testing::ValuesIn(places_of_paint()),
                                          testing::Range(0, kDoings)),
                         name_of);

}  // namespace
}  // namespace pastoso::document
