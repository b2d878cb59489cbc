// Files that are damaged, foreign, hostile or of another version: one sentence each, and nothing else.
#include "core/error.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class BadProject : public files::TemporaryFolder {
  protected:
    void SetUp() override {
        files::TemporaryFolder::SetUp();
        file = file_of(busy_project(pool), folder, pool);
    }

    std::string error_of(std::span<const std::byte> bytes) {
        try {
            parse_project(bytes, "it.pastoso", pool);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }
    /// With a change to the index.
    std::string error_of_index(const std::string& from, const std::string& to) {
        return error_of(changed(file, "pastoso/index.json",
                                [&](std::string& index) { index = replaced(index, from, to); }));
    }
    std::string error_of_entry(const std::string& entry, const std::string& content) {
        return error_of(changed(file, entry, [&](std::string& old) { old = content; }));
    }
    std::string error_of_painting(const Project& project) {
        return error_of(unseen_file_of(project, folder, pool));
    }

    core::ThreadPool pool{2};
    Bytes file;
};

TEST_F(BadProject, TheGoodFileIsGood) {
    EXPECT_EQ(error_of(file), "");
    EXPECT_EQ(error_of(archive_of(entries_of(file))), "");
    // Another program may have compressed the entries.
    EXPECT_EQ(error_of(archive_of(entries_of(file), true)), "");
}

TEST_F(BadProject, WhatIsNoProjectIsToldSo) {
    EXPECT_EQ(error_of({}), "it.pastoso: is no painting of Pastoso.");
    EXPECT_THAT(error_of(packing::bytes_of(std::string(5000, 'x'))),
                HasSubstr("is no painting of Pastoso"));
    EXPECT_EQ(error_of(archive_of({{"a.txt", "hello"}})), "it.pastoso: is no painting of Pastoso.");
    EXPECT_EQ(error_of(archive_of({{"mimetype", "application/x-krita"}})),
              "it.pastoso: is no painting of Pastoso.");
    EXPECT_EQ(error_of(archive_of({{"mimetype", "image/openraster"}, {"stack.xml", "<image/>"}})),
              "it.pastoso: is an OpenRaster picture of another program; it holds no wet paint.");
}

TEST_F(BadProject, MissingFilesAndFoldersAreToldOfByName) {
    EXPECT_THROW(load_project(folder / "none.pastoso", pool), core::InputError);
    try {
        load_project(folder, pool);
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_EQ(std::string(error.what()), folder.string() + ": is a folder, not a file.");
    }
}

TEST_F(BadProject, ATruncatedFileIsRefusedWhereverItEnds) {
    for (std::size_t length = 0; length < file.size(); length += file.size() / 40)
        EXPECT_NE(error_of(std::span(file).first(length)), "") << length;
    EXPECT_NE(error_of(std::span(file).first(file.size() - 1)), "");
}

TEST_F(BadProject, OtherVersionsAreRefused) {
    EXPECT_EQ(
        error_of_index("\"version\":13", "\"version\":14"),
        "it.pastoso, pastoso/index.json: this was written by a newer Pastoso (project format 14; this "
        "program reads up to 13).");
    EXPECT_THAT(error_of_index("\"version\":13", "\"version\":0"),
                HasSubstr("version: 0 is not between"));
    EXPECT_THAT(error_of_index("pastoso-project", "pastoso-scene"), HasSubstr("this is no painting"));
}

TEST_F(BadProject, AnIndexThatSaysTooMuchOrTooLittleIsRefused) {
    EXPECT_THAT(error_of_index("\"evaporated\":", "\"evaported\":"),
                HasSubstr("no such entry as \"evaported\""));
    EXPECT_THAT(error_of_index("\"tick\":", "\"tock\":"), HasSubstr("tock"));
    EXPECT_THAT(error_of_index("\"kind\":\"paint\"", "\"kind\":\"magic\""),
                HasSubstr("tile_entries[1].kind: there is no such kind of tiles as \"magic\"."));
    EXPECT_THAT(error_of_index("\"layers\":[", "\"layers\":[{},"),
                HasSubstr("layers[0]: the entry \"name\" is missing."));
    EXPECT_THAT(error_of_index("\"support_form\":\"levels\"", "\"support_form\":\"loose\""),
                HasSubstr("support_form: expected \"levels\" or \"fine\"."));
    EXPECT_THAT(error_of_entry("pastoso/index.json", "{\"format\""), HasSubstr("not valid JSON"));
    EXPECT_THAT(error_of_entry("pastoso/index.json", std::string(2'000'000, '[')),
                HasSubstr("nested more than 64 deep"));
    EXPECT_THAT(error_of_entry("pastoso/setup.json", std::string(2'000'000, '[')),
                HasSubstr("nested more than 64 deep"));
}

TEST_F(BadProject, PaintThatAddsUpToMoreThanCanBeCountedIsRefused) {
    const auto with_counts = [&](const std::string& name, const std::string& count) {
        return error_of(changed(file, "pastoso/index.json", [&](std::string& index) {
            const std::string key = "\"" + name + "\":";
            for (auto at = index.find(key); at != std::string::npos; at = index.find(key, at + 1)) {
                const auto begin = at + key.size();
                index.replace(begin, index.find_first_of(",}", begin) - begin, count);
            }
        }));
    };
    EXPECT_EQ(with_counts("evaporated", "1000"), "");
    EXPECT_THAT(with_counts("evaporated", "2300000000000000000"), HasSubstr("adds up to more than"))
        << "each alone can be counted";
    EXPECT_THAT(with_counts("evaporated", "9223372036854775807"), HasSubstr("evaporated"));
    EXPECT_THAT(with_counts("thickness", "-9223372036854775807"), HasSubstr("thickness"));
    EXPECT_THAT(with_counts("volume_mm3", "1e300"), HasSubstr("volume_mm3: expected an amount"));
}

TEST_F(BadProject, LayersThatCannotBeAreRefused) {
    EXPECT_THAT(error_of_index("\"active\":0", "\"active\":1"),
                HasSubstr("layers: the active layer is none."));
    EXPECT_THAT(error_of_index("\"next_layer\":2", "\"next_layer\":1"),
                HasSubstr("layers: there cannot be a layer 1."));
    EXPECT_THAT(error_of_index("\"groups\":[]", "\"groups\":[{\"id\":3,\"name\":\"x\"}]"),
                HasSubstr("layers: there cannot be a group 3."));
    EXPECT_THAT(error_of_index("\"id\":1", "\"group\":1,\"id\":1"),
                HasSubstr("layers: there is no group 1."));
    EXPECT_THAT(error_of_index("\"id\":1", "\"opacity\":-0.5,\"id\":1"),
                HasSubstr("layers: the opacity of the layer is -0.5"));
    EXPECT_THAT(error_of_index("\"layers\":[", "\"layers\":[],\"x\":["), HasSubstr("\"x\""));
}

TEST_F(BadProject, ATracingPictureThatIsNoneIsRefused) {
    Project project = busy_project(pool);
    project.painting.value.tracing = std::make_shared<const layers::Tracing>(layers::Tracing{
        std::make_shared<const pigment::Picture>(pigment::Picture{1, 1, {9, 9, 9, 255}}), {1, 2, 3, 4}});
    file = file_of(project, folder, pool);
    EXPECT_THAT(error_of_index("\"opacity\":0.5", "\"opacity\":5"),
                HasSubstr("tracing: the opacity of the tracing picture is 5"));
    EXPECT_THAT(error_of_index("\"width_mm\":3.0", "\"width_mm\":-3"),
                HasSubstr("tracing: the width of the picture in mm is -3"));
    EXPECT_THAT(error_of_entry("pastoso/tracing.png", "none"),
                HasSubstr("it.pastoso, pastoso/tracing.png: the picture "));
    Entries entries = entries_of(file);
    std::erase_if(entries, [](const auto& entry) { return entry.first == "pastoso/tracing.png"; });
    EXPECT_THAT(error_of(archive_of(entries)), HasSubstr("pastoso/tracing.png: is missing"));
}

TEST_F(BadProject, ABoardOfReferencesThatIsNoneIsRefused) {
    Project project = busy_project(pool);
    const pigment::Picture pixels{1, 1, {9, 9, 9, 255}};
    const auto picture = std::make_shared<const document::ReferencePicture>(
        document::ReferencePicture{pixels, files::png_file(pixels)});
    project.painting.value.references =
        std::make_shared<const document::ReferenceBoard>(document::ReferenceBoard{
            {{2, "sky", picture, {1, 2, 3, 4, false}, {}}, {1, "hand", picture, {}, {}}}, 3});
    file = file_of(project, folder, pool);
    EXPECT_THAT(error_of_index("\"width_mm\":3.0", "\"width_mm\":0"),
                HasSubstr("references.pictures[0].place: the width of the reference in mm is 0"));
    EXPECT_THAT(error_of_index("\"reference\":1", "\"reference\":2"),
                HasSubstr("references.pictures[1]: there are two references 2"));
    EXPECT_THAT(error_of_index("\"next\":3", "\"next\":2"),
                HasSubstr("references.pictures[0].place: the number 2 has not been given yet"));
    EXPECT_THAT(error_of_index("\"name\":\"sky\"", "\"name\":\"" + std::string(201, 's') + "\""),
                HasSubstr("references.pictures[0].name: the name of a reference has 201 bytes"));
    EXPECT_THAT(error_of_entry("pastoso/references/2.png", "none"),
                HasSubstr("it.pastoso, pastoso/references/2.png: the picture "));
    Entries entries = entries_of(file);
    std::erase_if(entries, [](const auto& entry) { return entry.first == "pastoso/references/1.png"; });
    EXPECT_THAT(error_of(archive_of(entries)), HasSubstr("pastoso/references/1.png: is missing"));
}

TEST_F(BadProject, TapeWhereNothingIsMaskedIsRefused) {
    Project project = busy_project(pool);
    document::Painting painting(project.painting, pool);
    painting.apply(
        document::MaskStripe{.line = {{3, 20}, {31, 22}}, .width_mm = 3.0, .straight_ends = true});
    project.painting = painting.state();
    file = file_of(project, folder, pool);
    EXPECT_EQ(error_of(file), "");
    const Bytes without = changed(file, "pastoso/index.json", [](std::string& index) {
        const std::size_t begin = index.find("\"masking\":{");
        index.erase(begin, index.find("},", begin) + 2 - begin);
    });
    EXPECT_EQ(error_of(without),
              "it.pastoso, pastoso/masking-tape.zst: holds a cell that is not masked.");
}

TEST_F(BadProject, AnIndexWithoutReferencesIsReadAsItWas) {
    EXPECT_EQ(error_of_index("\"version\":13", "\"version\":11"), "");
}

TEST_F(BadProject, SizesThatDoNotFitAreRefusedBeforeAnythingIsAllocated) {
    EXPECT_THAT(error_of_index("\"cells\":[180,90]", "\"cells\":[32768,32768]"),
                HasSubstr("the canvas has 32768 x 32768 cells, but 180 x 90"));
    EXPECT_THAT(error_of_index("\"cells\":[180,90]", "\"cells\":[4000000000,90]"),
                HasSubstr("is not between 1 and 32768"));
    EXPECT_THAT(error_of_index("\"tiles\":[[", "\"tiles\":[[5,4000],["), HasSubstr("is not between"));
    const std::string huge =
        "{\"format\":\"pastoso-strokes\",\"version\":3,\"canvas\":{\"width_mm\":5000,"
        "\"height_mm\":5000,\"px_per_mm\":6},\"end_tick\":0,\"events\":[]}";
    EXPECT_THAT(error_of_entry("pastoso/setup.json", huge), HasSubstr("of memory are free"));
}

TEST_F(BadProject, ATileThatComesTwiceIsRefused) {
    const Entries entries = entries_of(file);
    std::string index;
    for (const auto& [name, content] : entries)
        if (name == "pastoso/index.json") index = content;
    const std::size_t begin = index.find("{\"kind\":\"depth\"");
    const std::string entry = index.substr(begin, index.find('}', begin) + 1 - begin);
    EXPECT_THAT(error_of_index(entry, entry + "," + entry), HasSubstr("comes twice"));
}

TEST_F(BadProject, NamesOutsideOfOurFolderAreRefused) {
    EXPECT_THAT(error_of_index("\"entry\":\"pastoso/layer0/depth-000.zst\"",
                               "\"entry\":\"../../../etc/passwd\""),
                HasSubstr("expected a name that begins with pastoso/."));
    EXPECT_THAT(error_of_index("\"entry\":\"pastoso/layer0/depth-000.zst\"",
                               "\"entry\":\"pastoso/../../etc/passwd\""),
                HasSubstr("pastoso/../../etc/passwd: is missing."));
}

TEST_F(BadProject, ZipBombsAreRefused) {
    Entries entries = entries_of(file);
    for (auto& [name, content] : entries)
        if (name == "pastoso/layer0/paint-000.zst") content = std::string(40'000'000, '\0');
    const Bytes bomb = archive_of(entries, true);
    EXPECT_LT(bomb.size(), 2'000'000U);
    EXPECT_THAT(error_of(bomb),
                HasSubstr("pastoso/layer0/paint-000.zst: holds 40000000 bytes, but at most"));
    for (auto& [name, content] : entries)
        if (name == "mimetype") content = std::string(40'000'000, '\0');
    EXPECT_THAT(error_of(archive_of(entries, true)), HasSubstr("mimetype: holds"));
}

TEST_F(BadProject, DamageInAnEntryIsFound) {
    for (const std::string entry : {"pastoso/layer0/paint-000.zst", "pastoso/well/depth-000.zst",
                                    "pastoso/brush.zst", "pastoso/strokes.json.zst"}) {
        const auto flip = [](std::string& content) { content[content.size() / 2] ^= 0x10; };
        const auto shorten = [](std::string& content) { content.pop_back(); };
        EXPECT_THAT(error_of(changed(file, entry, flip)),
                    StartsWith("it.pastoso, " + entry + ": is damaged"));
        EXPECT_THAT(error_of(changed(file, entry, shorten)), HasSubstr(entry + ": is damaged"));
    }
    // A frame that is whole, of other content.
    const std::string other(16384, 'x');
    const Bytes frame = packing::packed(packing::bytes_of(other));
    EXPECT_THAT(error_of_entry("pastoso/layer0/depth-000.zst",
                               {reinterpret_cast<const char*>(frame.data()), frame.size()}),
                HasSubstr("depth-000.zst: is damaged"));
}

TEST_F(BadProject, ValuesThatCannotBeAreRefusedWithTheirPlace) {
    const Project good = busy_project(pool);
    static constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    static constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const auto with = [&](auto&& change) {
        Project project = good;
        change(project.painting.value.film);
        return error_of_painting(project);
    };
    EXPECT_EQ(
        with([](auto& film) { film.velocity_x.set(70, 30, kNone); }),
        "it.pastoso, pastoso/layer0/velocity_x-000.zst: cell (70, 30) holds a velocity that cannot be.");
    EXPECT_THAT(with([](auto& film) { film.velocity_y.set(3, 80, kInfinite); }),
                HasSubstr("cell (3, 80)"));
    EXPECT_THAT(with([](auto& film) { film.support_mm.set(0, 0, kNone); }),
                HasSubstr("height of the support"));
    EXPECT_THAT(with([](auto& film) { film.support_mm.set(0, 0, -1001.0F); }), HasSubstr("cell (0, 0)"));
    EXPECT_THAT(with([](auto& film) { film.thickness.set(9, 9, -1); }),
                HasSubstr("holds a thickness that"));
    EXPECT_THAT(with([](auto& film) { film.thickness.set(9, 9, film::kMaxThickness_quanta + 1); }),
                HasSubstr("holds a thickness that cannot be"));
    EXPECT_THAT(with([](auto& film) {
                    film::PaintCell cell{};
                    cell[15] = -1;
                    film.paint.set(179, 89, cell);
                }),
                HasSubstr("cell (179, 89) holds an amount of paint"));
    EXPECT_THAT(with([](auto& film) {
                    film.strata.optics.set(1, 2, {60000, 1, 1, 1, 1, 1, 40000});
                }),
                HasSubstr("holds strata that give more light than they get"));
    EXPECT_THAT(with([](auto& film) {
                    film.thickness.set(9, 9, 70000);
                    film.lower.thickness.set(9, 9, 70000);
                }),
                HasSubstr("cell (9, 9) holds a lower stratum that is no part of its paint"));
    EXPECT_THAT(with([](auto& film) { film.strata.soluble_thickness.set(1, 2, -5); }),
                HasSubstr("holds a thickness of dry paint"));
}

TEST_F(BadProject, MotionThatCannotBeIsRefused) {
    const Project good = busy_project(pool);
    const auto with = [&](auto&& change) {
        Project project = good;
        change(project.painting);
        return error_of_painting(project);
    };
    EXPECT_THAT(with([](auto& painting) { painting.solver.awake[0].activity.waiting_s = 1e30; }),
                HasSubstr("moves as no paint can"));
    EXPECT_THAT(with([](auto& painting) {
                    painting.solver.awake[0].activity.extremes.speed_mm_s =
                        std::numeric_limits<float>::quiet_NaN();
                }),
                HasSubstr("moves as no paint can"));
    EXPECT_THAT(with([](auto& painting) {
                    painting.solver.awake[0].activity.window_s = 0.25F;
                    painting.solver.awake[0].window_start = {};
                }),
                HasSubstr("there is no \"window\""));
    EXPECT_THAT(with([](auto& painting) { painting.ageing.drying_s = -1; }),
                HasSubstr("ageing.drying_s"));
    EXPECT_THAT(with([](auto& painting) { painting.tick = -4; }), HasSubstr("tick"));
}

TEST_F(BadProject, ABrushThatCannotBeIsRefused) {
    const Project good = busy_project(pool);
    const auto with = [&](auto&& change) {
        Project project = good;
        change(project.painting.value.brush->brush);
        return error_of_painting(project);
    };
    EXPECT_THAT(
        with([](auto& brush) { brush.held[3].volume_mm3 = std::numeric_limits<double>::quiet_NaN(); }),
        HasSubstr("pastoso/brush.zst: a bristle holds what none can."));
    EXPECT_THAT(with([](auto& brush) { brush.held[3].paint[2] = 1e12; }),
                HasSubstr("holds what none can"));
    EXPECT_THAT(with([](auto& brush) { brush.held.pop_back(); }), HasSubstr("paint of another brush"));
    Project aside = good;
    auto brush = std::make_shared<document::BrushInHand>(*good.painting.value.brush);
    brush->brush.held.pop_back();
    aside.painting.value.brush_aside = brush;
    EXPECT_THAT(
        error_of_painting(aside),
        HasSubstr("pastoso/brush-aside.zst: holds the paint of another brush than the one aside"));
}

}  // namespace
}  // namespace pastoso::project
