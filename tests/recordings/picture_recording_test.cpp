#include "core/error.hpp"
#include "core/random.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "files/image.hpp"
#include "recordings/recording_json.hpp"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

using testing::HasSubstr;

std::shared_ptr<const pigment::Picture> noise(int width, int height) {
    auto picture = std::make_shared<pigment::Picture>();
    picture->width = width;
    picture->height = height;
    for (std::uint32_t i = 0; i < 4U * width * height; ++i)
        picture->rgba.push_back(static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 5)));
    return picture;
}

document::Recording recording() {
    document::Recording painted;
    painted.canvas = {.width_mm = 30, .height_mm = 20, .px_per_mm = 2};
    painted.events = {{3, document::PaintPicture{"Photo \"1\"", {2.5, -1, 12, 8.25}, noise(11, 9)}},
                      {4, document::Undo{}},
                      {5, document::Redo{}}};
    painted.end_tick = 7;
    return painted;
}

std::string sentence_of(const std::string& text) {
    try {
        recording_from_json(text, "file");
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
}

TEST(PictureRecording, IsCompleteByItself) {
    document::Recording early = recording();
    early.arithmetic = 1;
    const std::string text = recording_to_json(early);
    EXPECT_THAT(text, HasSubstr("\"version\": 6"));
    EXPECT_EQ(recording_from_json(text, "file"), early);
}

TEST(PictureRecording, KeepsWhichPicturesCameTogether) {
    document::Recording joined = recording();
    joined.events.insert(joined.events.begin() + 1, joined.events.front());
    std::get<document::PaintPicture>(joined.events[1].action).joins = true;
    const std::string text = recording_to_json(joined);
    EXPECT_THAT(text, HasSubstr("\"version\": 16"));
    EXPECT_EQ(recording_from_json(text, "file"), joined);
    EXPECT_THAT(recording_to_json(recording()), testing::Not(HasSubstr("\"joins\"")));
}

TEST(PictureRecording, KeepsWhatWasTraced) {
    document::Recording traced = recording();
    traced.arithmetic = 1;
    const auto picture = noise(5, 7);
    traced.events = {{1, document::LayTracing{picture, {-3, 2.5, 20, 28}}},
                     {2, document::SetTracing{{1, 2, 3, 4.5}, 0.3}},
                     {3, document::LayTracing{}}};
    const std::string text = recording_to_json(traced);
    EXPECT_THAT(text, HasSubstr("\"version\": 7"));
    EXPECT_EQ(recording_from_json(text, "file"), traced);
    EXPECT_THAT(sentence_of(changed(text, "0.3", "3")),
                HasSubstr("events[1].set_tracing: the opacity of the tracing picture is 3"));
    EXPECT_THAT(sentence_of(changed(text, "\"png\"", "\"gif\"")),
                HasSubstr("file, events[0].lay_tracing"));
}

TEST(PictureRecording, ReferencesAreReadAsTheyAreWritten) {
    document::Recording kept = recording();
    kept.arithmetic = 1;
    const auto pixels = noise(5, 7);
    const auto picture = std::make_shared<const document::ReferencePicture>(
        document::ReferencePicture{*pixels, files::png_file(*pixels)});
    kept.events = {{1, document::LayReference{"sky", {-3, 2.5, 20, 30, true}, picture}},
                   {2, document::SetReference{1, {1, 2, 3, -4.5, false}, {0.3, true}}},
                   {3, document::MoveReference{1, 0}},
                   {4, document::RemoveReference{1}}};
    const std::string text = recording_to_json(kept);
    EXPECT_THAT(text, HasSubstr("\"version\": 14"));
    const document::Recording read = recording_from_json(text, "file");
    EXPECT_EQ(read, kept);
    document::Recording joined = kept;
    std::get<document::LayReference>(joined.events[0].action).joins = true;
    EXPECT_THAT(recording_to_json(joined), HasSubstr("\"version\": 15"));
    EXPECT_EQ(recording_from_json(recording_to_json(joined), "file"), joined);
    EXPECT_EQ(std::get<document::LayReference>(read.events[0].action).picture->png, picture->png);
    EXPECT_THAT(sentence_of(changed(text, "0.3", "3")),
                HasSubstr("events[1].set_reference: the opacity of the reference is 3"));
    EXPECT_THAT(sentence_of(changed(text, "iVBOR", "iVB R")),
                HasSubstr("events[0].lay_reference.png: the picture is no base64."));
}

TEST(PictureRecording, GivesTheSamePainting) {
    core::ThreadPool pool(2);
    const auto played = [&](const document::Recording& recording) {
        document::Painting painting(recording.canvas, pool);
        document::Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        return painting.state_hash();
    };
    EXPECT_EQ(played(recording()), played(recording_from_json(recording_to_json(recording()), "file")));
}

TEST(PictureRecording, SaysWhatIsWrongWithAPicture) {
    const std::string text = recording_to_json(recording());
    const std::size_t png = text.find("iVBOR");
    ASSERT_NE(png, std::string::npos);
    const std::string cut = text.substr(0, png + 400) + text.substr(text.find('"', png));
    EXPECT_THAT(sentence_of(cut), HasSubstr("file, events[0].paint_picture.png: the picture "));
    EXPECT_THAT(sentence_of(changed(text, "iVBOR", "iVB R")), HasSubstr("the picture is no base64."));
    EXPECT_THAT(sentence_of(changed(text, "\"width_mm\":12.0", "\"width_mm\":0.0")),
                HasSubstr("width of the picture in mm is 0"));
    EXPECT_THAT(sentence_of(changed(text, "\"x_mm\":2.5,", "")),
                HasSubstr("paint_picture: the entry \"x_mm\" is missing"));
}

}  // namespace
}  // namespace pastoso::recordings
