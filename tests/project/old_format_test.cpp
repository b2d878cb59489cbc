// Files that earlier versions of the program wrote.
#include "document/player.hpp"
#include "project/project.hpp"
#include "shade/render.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

class OldFormat : public testing::Test {
  protected:
    shade::Image8 picture(const film::FilmState& film) {
        return shade::encode_srgb8(
            shade::render(film, document::kPrimedGround, film.shape.cells(), {}, pool));
    }
    /// Mean difference of the pixels' values.
    static double difference(const shade::Image8& a, const shade::Image8& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.rgb.size(); ++i)
            sum += std::abs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i]));
        return sum / static_cast<double>(a.rgb.size());
    }
    core::ThreadPool pool{1};
};

TEST_F(OldFormat, OneShowsThePaintingThatWasSaved) {
    const LoadedProject old = load_project(PASTOSO_SOURCE_DIR "/tests/project/format-1.pastoso", pool);
    EXPECT_THAT(old.notes, testing::IsEmpty());
    const film::FilmState& film = old.painting.canvas.film;
    EXPECT_FALSE(film.strata.optics.is_background(0));
    document::Painting again(old.strokes.canvas, pool);
    document::Player player(again, old.strokes);
    while (!player.finished())
        player.play_tick();
    ASSERT_EQ(film.shape, again.film().shape);
    // A half of 255 steps: the solver may have changed since, red under blue may not have become
    // another.
    EXPECT_LT(difference(picture(film), picture(again.film())), 0.5);
}

}  // namespace
}  // namespace pastoso::project
