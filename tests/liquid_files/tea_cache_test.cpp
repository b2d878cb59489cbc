#include "liquid_files/tea_cache.hpp"

#include "core/hash.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "source_file.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using liquid::TeaFrame;
using testing::HasSubstr;

constexpr std::uint64_t kScene = 0x123456789abcdef0U;
constexpr std::size_t kHeadBytes = 160;

TeaFrame frame_of(int parcels, const grid::BoxShape& shape, bool coldness) {
    TeaFrame frame;
    frame.time_s = 1.25;
    frame.step = 37;
    frame.pour = {0.081F,
                  {{{0.05F, 0.06F}, 0.099F, 0.099F, 0.081F, 0.16F, 0.006F},
                   {{0.03F, 0.04F}, 0.099F, 0.09F, 0.085F, 0.16F, 0.006F}}};
    for (int n = 0; n < parcels; ++n) {
        const auto share = [n](std::uint32_t stream) {
            return core::uniform_noise(static_cast<std::uint32_t>(n), stream);
        };
        frame.parcels.push_back(
            {{share(1), share(2), -share(3)},
             1e-9F * share(4),
             share(5),
             n % 5 - 1,
             {.xx = 1.0F + share(6), .yy = 2.0F, .zz = 3.0F, .xy = -0.5F * share(7)}});
    }
    if (shape.nx == 0) return frame;
    frame.dissolved = grid::BoxField(shape);
    if (coldness) frame.coldness = grid::BoxField(shape);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                frame.dissolved.at(i, j, k) = 0.001F * static_cast<float>(i * j + k);
                if (coldness) frame.coldness.at(i, j, k) = 1.0F / static_cast<float>(1 + i + j + k);
            }
    return frame;
}

void expect_equal(const TeaFrame& a, const TeaFrame& b) {
    EXPECT_EQ(a.time_s, b.time_s);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.parcels, b.parcels);
    EXPECT_EQ(a.dissolved, b.dissolved);
    EXPECT_EQ(a.coldness, b.coldness);
    EXPECT_EQ(a.pour, b.pour);
}

class TeaCacheTest : public files::TemporaryFolder {
  protected:
    std::string complaint(const std::string& bytes) {
        // Not flushed to the disk: there are hundreds.
        std::ofstream(folder / "b.tea", std::ios::binary) << bytes;
        return error_of([&] { read_tea_frame(folder / "b.tea", kScene); });
    }
    std::string written(const TeaFrame& frame) {
        write_tea_frame(folder / "a.tea", frame, kScene);
        return core::read_text_file(folder / "a.tea");
    }
};

TEST_F(TeaCacheTest, FramesComeBackAsTheyWere) {
    for (const TeaFrame& frame :
         {frame_of(100, {7, 5, 3, 0.01F}, true), frame_of(0, {4, 4, 4, 0.02F}, false),
          frame_of(3, {0, 0, 0, 0.0F}, false), frame_of(0, {0, 0, 0, 0.0F}, false)}) {
        written(frame);
        expect_equal(read_tea_frame(folder / "a.tea", kScene), frame);
        EXPECT_TRUE(is_whole_tea_frame(folder / "a.tea", kScene));
    }
}

TEST_F(TeaCacheTest, TheHeadIsAsDocumented) {
    const std::string file = written(frame_of(2, {7, 5, 3, 0.01F}, false));
    EXPECT_EQ(file.substr(0, 16), std::string("PastoTea\3\0\0\0\0\0\0\0", 16));
    EXPECT_EQ(file.substr(16, 8), "\xf0\xde\xbc\x9a\x78\x56\x34\x12");
    EXPECT_EQ(file.substr(40, 12), std::string("\7\0\0\0\5\0\0\0\3\0\0\0", 12));
    EXPECT_EQ(file[56], 2);
    const auto float_at = [&](std::size_t at) {
        float number = 0.0F;
        std::memcpy(&number, file.data() + at, sizeof number);
        return number;
    };
    EXPECT_EQ(float_at(64), 0.05F);
    EXPECT_EQ(float_at(92 + 24), 0.006F);
    EXPECT_EQ(float_at(120), 0.081F);
    EXPECT_EQ(file.substr(144, 8), std::string(8, '\0'));
}

TEST_F(TeaCacheTest, EveryTruncationIsNoticed) {
    const std::string file = written(frame_of(20, {6, 5, 4, 0.01F}, true));
    for (std::size_t size = 0; size < file.size(); size += size < 2 * kHeadBytes ? 1 : 7) {
        EXPECT_THAT(complaint(file.substr(0, size)), HasSubstr(size < 8 ? "is no frame" : "is damaged"))
            << size;
        EXPECT_FALSE(is_whole_tea_frame(folder / "b.tea", kScene));
    }
    EXPECT_THAT(complaint(file + "x"), HasSubstr("b.tea: is damaged (it is longer"));
}

TEST_F(TeaCacheTest, EveryFlippedBitIsNoticed) {
    const std::string file = written(frame_of(20, {6, 5, 4, 0.01F}, true));
    for (std::size_t at = 0; at < file.size(); at += at < kHeadBytes ? 1 : 3) {
        std::string damaged = file;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        EXPECT_THAT(complaint(damaged), HasSubstr("b.tea: ")) << at;
        EXPECT_FALSE(is_whole_tea_frame(folder / "b.tea", kScene)) << at;
    }
}

TEST_F(TeaCacheTest, SaysWhatAFileIsInstead) {
    std::string file = written(frame_of(2, {3, 3, 3, 0.01F}, false));
    EXPECT_THAT(complaint("{\"format\": 1}"), HasSubstr("b.tea: is no frame of tea."));
    EXPECT_THAT(error_of([&] { read_tea_frame(folder / "a.tea", 1); }),
                HasSubstr("a.tea: belongs to another scene."));
    EXPECT_FALSE(is_whole_tea_frame(folder / "a.tea", 1));
    EXPECT_FALSE(is_whole_tea_frame(folder / "c.tea", kScene));
    file[8] = 4;
    EXPECT_THAT(complaint(file),
                HasSubstr("b.tea: is of version 4, this program reads versions 1 to 3."));
}

TEST_F(TeaCacheTest, WhatIsNotFiniteIsRefused) {
    TeaFrame frame = frame_of(5, {3, 3, 3, 0.01F}, false);
    frame.parcels[3].position_m.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(complaint(written(frame)), HasSubstr("b.tea: holds a parcel (number 3)"));
    frame = frame_of(5, {3, 3, 3, 0.01F}, false);
    frame.parcels[4].shape.xy = 2.0F * frame.parcels[4].shape.xx + 2.0F;
    EXPECT_THAT(complaint(written(frame)), HasSubstr("holds a parcel (number 4) whose shape is none."));
    frame = frame_of(5, {3, 3, 3, 0.01F}, false);
    frame.dissolved.at(1, 1, 1) = std::numeric_limits<float>::infinity();
    EXPECT_THAT(complaint(written(frame)), HasSubstr("holds a value of a cell that is not finite"));
}

TEST_F(TeaCacheTest, StreamsThatNoneCouldBeAreRefused) {
    const TeaFrame sound = frame_of(2, {3, 3, 3, 0.01F}, false);
    const auto refuses = [&](std::size_t at, float value) {
        std::string file = written(sound);
        std::memcpy(file.data() + at, &value, sizeof value);
        core::Hash64 hash;
        hash.add(std::span<const char>(file.data(), kHeadBytes - 8));
        hash.add(std::span<const char>(file.data() + kHeadBytes, file.size() - kHeadBytes));
        const std::uint64_t sum = hash.value();
        std::memcpy(file.data() + kHeadBytes - 8, &sum, sizeof sum);
        EXPECT_THAT(complaint(file), HasSubstr("holds sizes or times that no frame has.")) << at;
    };
    refuses(64 + 8, 0.05F);  // a lip below its stream
    refuses(64 + 20, 0.0F);  // that does not flow
    refuses(92 + 24, std::numeric_limits<float>::infinity());
    refuses(120, -1.0F);
}

/// Of a run of version 0.1.0, 0.3 s long: 40 parcels, 8 cells along each side.
TEST_F(TeaCacheTest, FramesOfVersion1HaveRoundParcels) {
    const std::filesystem::path path = tests::source_file("tests/data/liquid/frame-version-1.tea");
    const std::string file = core::read_text_file(path);
    std::uint64_t scene = 0;
    std::memcpy(&scene, file.data() + 16, sizeof scene);
    const TeaFrame frame = read_tea_frame(path, scene);
    EXPECT_EQ(frame.step, 9);
    EXPECT_EQ(frame.dissolved.shape().nx, 8);
    ASSERT_EQ(frame.parcels.size(), 40U);
    for (const liquid::Parcel& parcel : frame.parcels) {
        EXPECT_NEAR(parcel.volume_m3, 26e-6F / 40.0F, 1e-8F);
        EXPECT_EQ(parcel.shape, liquid::ParcelShape());
    }
    EXPECT_EQ(frame.pour, liquid::SeenPour());
    const liquid::Cup cup;
    EXPECT_EQ(liquid::cup_in(frame.pour, cup), cup);
}

TEST_F(TeaCacheTest, SmoothFieldsPackWell) {
    TeaFrame frame = frame_of(0, {64, 64, 64, 0.0016F}, false);
    for (int k = 0; k < 64; ++k)
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i)
                frame.dissolved.at(i, j, k) = k > 12 ? 0.0F : 0.01F;
    EXPECT_LT(written(frame).size(), 20'000U);  // of a megabyte
}

TEST_F(TeaCacheTest, TheIndexTellsWhichFramesAreMissing) {
    const FrameIndex index{"{\"milk\": 26}", kScene, 25.0, 4};
    const auto cache = folder / "cache";
    write_frame_index(cache, kTeaCache, index);
    EXPECT_EQ(read_frame_index(cache, kTeaCache), index);
    EXPECT_EQ(tea_frame_path(cache, 123), cache / "frame_000123.tea");
    const TeaFrame frame = frame_of(2, {3, 3, 3, 0.01F}, false);
    for (const int number : {1, 2, 3})
        write_tea_frame(tea_frame_path(cache, number), frame, number == 3 ? 1 : kScene);
    const std::string first = core::read_text_file(tea_frame_path(cache, 1));
    core::write_text_file(tea_frame_path(cache, 1), first.substr(0, first.size() - 1));
    EXPECT_EQ(whole_tea_frames(cache, index), (std::vector<bool>{false, true, false, false}));
}

TEST_F(TeaCacheTest, AnUnsoundIndexIsRefusedByPlace) {
    write_frame_index(folder, kTeaCache, {"", kScene, 25.0, 4});
    const std::string sound = core::read_text_file(folder / "tea.json");
    const auto complaint_after = [&](const std::string& from, const std::string& to) {
        std::string text = sound;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        core::write_text_file(folder / "tea.json", text);
        return error_of([&] { read_frame_index(folder, kTeaCache); });
    };
    EXPECT_THAT(complaint_after("pastoso-tea-cache", "soup"), HasSubstr("tea.json, format: expected"));
    EXPECT_THAT(complaint_after("\"version\": 1", "\"version\": 2"), HasSubstr("tea.json, version"));
    EXPECT_THAT(complaint_after("25.0", "0.0"), HasSubstr("tea.json, fps: expected a number from 1"));
    EXPECT_THAT(complaint_after("4,", "-4,"), HasSubstr("tea.json, count"));
    EXPECT_THAT(complaint_after("1234", "123x"), HasSubstr("tea.json, scene_hash: expected sixteen"));
    EXPECT_THAT(complaint_after("\"scene\"", "\"scones\""), HasSubstr("tea.json"));
}

}  // namespace
}  // namespace pastoso::liquid_files
