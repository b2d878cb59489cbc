// Paint that goes from one painting to another: as bytes, laid down there, and in that one's recording.
#include "recordings/paint_piece.hpp"

#include "core/thread_pool.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"
#include "document/scenes.hpp"
#include "recordings/recording_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

using document::BringPaint;
using document::Painting;
using document::PastePaint;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kRounding = 1e-9;

document::CanvasSettings canvas_of(double width_mm, double height_mm, double px_per_mm) {
    document::CanvasSettings canvas;
    canvas.width_mm = width_mm;
    canvas.height_mm = height_mm;
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

class PieceOfPaint : public testing::Test {
  protected:
    /// Dry paint, and over it wet paint of two media that has flowed for a while.
    void SetUp() override {
        Painting painting(canvas_of(40, 30, 4), pool);
        document::paint_dry_wave(painting);
        painting.apply(document::load_of("PY35"));
        document::paint_wave(painting, 1.0, 12.0);
        painting.apply(document::UseMedium{"heavy-body oil"});
        painting.apply(document::load_of("PR254"));
        document::paint_wave(painting, 2.0, 14.0);
        for (int tick = 0; tick < 5; ++tick)
            painting.advance_tick();
        painting.apply(document::CopyPaint{1});
        copied = painting.snapshot().copied;
        bytes = piece_bytes(*copied);
    }
    std::string refusal(const std::string& of) const {
        return document::error_of([&] { piece_of(of, "the piece"); });
    }
    std::string changed(const std::string& from, const std::string& to) const {
        const std::size_t at = bytes.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return std::string(bytes).replace(at, from.size(), to);
    }
    static void expect_balance(const Painting& painting) {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    /// Another painting, in whose hand another medium is, with the piece on it.
    void paste_into(Painting& other) const {
        other.apply(document::UseMedium{"fluid acrylic"});
        other.apply(BringPaint{piece_of(bytes, "the piece").paint});
        other.apply(PastePaint{"Pasted"});
    }

    core::ThreadPool pool{2};
    document::CopiedPaint copied;
    std::string bytes;
};

TEST_F(PieceOfPaint, ComesBackToTheBit) {
    ASSERT_TRUE(film::has_wet_paint(*copied));
    ASSERT_GT(film::dried_totals(copied->strata).thickness, 0);
    ASSERT_TRUE(copied->media.are_several());
    const PaintPiece piece = piece_of(bytes, "the piece");
    EXPECT_EQ(film::state_hash(*piece.paint), film::state_hash(*copied));
    EXPECT_EQ(piece.paint->consistencies, copied->consistencies);
    EXPECT_EQ(piece_bytes(*piece.paint), bytes);
    EXPECT_LT(bytes.size(), piece.unpacked_bytes / 4);
}

TEST_F(PieceOfPaint, BytesThatAreNoneAreRefused) {
    EXPECT_EQ(refusal(""), "the piece: is no paint that was copied in Pastoso.");
    EXPECT_EQ(refusal("hello"), "the piece: is no paint that was copied in Pastoso.");
    const std::size_t head = bytes.find('\n');
    EXPECT_THAT(refusal(bytes.substr(0, head / 2)), HasSubstr("not valid JSON"));
    EXPECT_THAT(refusal(bytes.substr(0, head)), HasSubstr("0 bytes of paint follow"));
    EXPECT_THAT(refusal(bytes.substr(0, bytes.size() - 1)), HasSubstr("bytes of paint follow"));
    EXPECT_THAT(refusal(bytes + "x"), HasSubstr("bytes of paint follow"));
    std::string damaged = bytes;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    EXPECT_THAT(refusal(damaged), StartsWith("the piece: ")) << "the checksum of its last frame";
}

TEST_F(PieceOfPaint, HeadsThatCannotBeAreRefused) {
    EXPECT_THAT(refusal(changed("\"version\":1", "\"version\":2")), HasSubstr("a newer Pastoso"));
    EXPECT_THAT(refusal(changed("\"cell_mm\":0.25", "\"cell_mm\":-1.0")),
                HasSubstr("no painting has cells of this size"));
    EXPECT_THAT(refusal(changed("\"cells\":[160", "\"cells\":[0")), HasSubstr("surface.cells[0]"));
    EXPECT_THAT(refusal(changed("\"kind\":\"depth\"", "\"kind\":\"width\"")),
                HasSubstr("no such kind of tiles"));
    EXPECT_THAT(refusal(changed("\"evaporated\":0", "\"evaporated\":1000000000000000000")),
                HasSubstr("no canvas holds so much paint"));
}

TEST_F(PieceOfPaint, ItIsTheSamePaintInAnotherPaintingOfItsResolution) {
    document::CanvasSettings settings = canvas_of(50, 35, 4);
    settings.support = "panel";
    Painting other(settings, pool);
    paste_into(other);
    ASSERT_EQ(other.layers().layers.size(), 2U);
    const film::FilmState& pasted = other.film();
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            ASSERT_EQ(pasted.thickness.at(x, y), copied->thickness.at(x, y)) << x << ", " << y;
            ASSERT_EQ(pasted.paint.at(x, y), copied->paint.at(x, y));
            ASSERT_EQ(pasted.strata.optics.at(x, y), copied->strata.optics.at(x, y));
        }
    EXPECT_EQ(film::totals(pasted).thickness, film::totals(*copied).thickness);
    EXPECT_EQ(film::dried_totals(pasted.strata).thickness, film::dried_totals(copied->strata).thickness);
    expect_balance(other);
    for (int tick = 0; tick < 5; ++tick)
        other.advance_tick();
    expect_balance(other);
}

TEST_F(PieceOfPaint, InFinerAndCoarserCellsThereIsAsMuchOfIt) {
    const double wet_mm3 = film::volume_mm3(film::totals(*copied).thickness, copied->cell_mm);
    for (const double px_per_mm : {8.0, 2.0}) {
        Painting other(canvas_of(40, 30, px_per_mm), pool);
        paste_into(other);
        // Every cell is rounded to a whole quantum, and traces are given up.
        EXPECT_NEAR(other.account().canvas.volume_mm3, wet_mm3, 1e-3 * wet_mm3) << px_per_mm;
        expect_balance(other);
    }
}

TEST_F(PieceOfPaint, OfASmallerCanvasItTakesWhatLiesOnIt) {
    Painting other(canvas_of(15, 13, 4), pool);
    paste_into(other);
    for (int y = 0; y < 52; ++y)
        for (int x = 0; x < 60; ++x)
            ASSERT_EQ(other.film().thickness.at(x, y), copied->thickness.at(x, y)) << x << ", " << y;
    EXPECT_GT(other.account().canvas.volume_mm3, 0.0);
    expect_balance(other);
}

TEST_F(PieceOfPaint, UndoTakesBackWhatWasPastedAndKeepsWhatWasBrought) {
    Painting other(canvas_of(40, 30, 4), pool);
    const std::uint64_t bare = other.state_hash();
    other.apply(BringPaint{copied});
    EXPECT_EQ(other.state_hash(), bare);
    EXPECT_TRUE(other.undo_steps().empty());
    other.apply(PastePaint{"Pasted"});
    const std::uint64_t pasted = other.state_hash();
    other.apply(document::Undo{});
    EXPECT_EQ(other.state_hash(), bare);
    other.apply(document::Redo{});
    EXPECT_EQ(other.state_hash(), pasted);
    other.apply(document::Undo{});
    other.apply(PastePaint{"Again"});
    EXPECT_EQ(other.layers().layers.size(), 2U);
    expect_balance(other);
}

TEST_F(PieceOfPaint, ARecordingHoldsItAndReplaysToTheSameBits) {
    document::Recording recording = document::crossing_session();
    recording.events.push_back({44, BringPaint{copied}});
    recording.events.push_back({44, PastePaint{"Pasted", 2.0, 3.0}});
    recording.end_tick = 60;
    const std::string text = recording_to_json(recording);
    EXPECT_THAT(text, HasSubstr("\"version\": 16"));
    const document::Recording read = recording_from_json(text, "file");
    EXPECT_EQ(read, recording);
    const auto hash_on = [&](const document::Recording& what, int threads) {
        core::ThreadPool others(threads);
        Painting painting(what.canvas, others);
        document::Player player(painting, what);
        while (!player.finished())
            player.play_tick();
        expect_balance(painting);
        EXPECT_EQ(painting.layers().layers.size(), 2U);
        return painting.state_hash();
    };
    EXPECT_EQ(hash_on(recording, 1), hash_on(read, 3));
    document::Recording finer = read;
    finer.canvas.px_per_mm = 4.5;
    hash_on(finer, 2);
}

TEST_F(PieceOfPaint, ARecordingSaysWhatIsWrongWithIt) {
    document::Recording recording;
    recording.canvas = canvas_of(40, 30, 4);
    recording.events = {{0, BringPaint{copied}}};
    const std::string text = recording_to_json(recording);
    const auto refused = [&](std::string changed_text) {
        return document::error_of([&] { recording_from_json(changed_text, "file"); });
    };
    const std::size_t paint = text.find("\"eyJm");
    ASSERT_NE(paint, std::string::npos) << "what base64 makes of {\"f";
    EXPECT_THAT(refused(std::string(text).replace(paint + 1, 4, "ey m")),
                HasSubstr("events[0].bring_paint.paint: the copied paint is no base64."));
    EXPECT_THAT(refused(std::string(text).erase(text.find('"', paint + 1) - 400, 400)),
                HasSubstr("file, events[0].bring_paint.paint: the copied paint"));
}

}  // namespace
}  // namespace pastoso::recordings
