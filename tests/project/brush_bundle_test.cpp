// Bundles of tools: written and read back; what is wrong with one is told in a sentence.
#include "project/brush_bundle.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "project/zip_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

constexpr const char* kGoodManifest =
    R"({"format": "pastoso-brushes", "version": 1, "presets": ["a.json"]})";

class Bundle : public testing::Test {
  protected:
    std::filesystem::path path() const { return folder_.path() / "mine.zip"; }

    struct Entry {
        const char* name;
        std::string content;
    };
    std::string error_of(const std::vector<Entry>& entries) const {
        ZipWriter archive;
        for (const Entry& entry : entries)
            archive.add(entry.name, entry.content);
        core::write_aside(path(), [&](core::OutputFile& file) { archive.write(file); });
        return error();
    }
    std::string error() const {
        try {
            read_brush_bundle(path());
            return "";
        } catch (const core::InputError& error) {
            return error.what();
        }
    }
    static std::string preset(const char* name) {
        brush::Preset preset = brush::find_preset("flat");
        preset.name = name;
        return brush::preset_to_json(preset);
    }

    tests::TemporaryFolder folder_;
};

TEST_F(Bundle, HoldsWhatWasPutIntoIt) {
    const BrushBundle bundle{brush::bundled_presets(), {{"hair", {"Fan 26", "Mine"}}, {"first", {}}}};
    write_brush_bundle(bundle, path());
    EXPECT_EQ(read_brush_bundle(path()), bundle);
    write_brush_bundle({}, path());
    EXPECT_EQ(read_brush_bundle(path()), BrushBundle{});
}

TEST_F(Bundle, OfTheSameToolsIsTheSameFile) {
    write_brush_bundle({brush::bundled_presets()}, path());
    const std::string first = core::read_text_file(path());
    write_brush_bundle({brush::bundled_presets()}, path());
    EXPECT_EQ(core::read_text_file(path()), first);
}

TEST_F(Bundle, WithoutTagsOlderProgramsCanReadIt) {
    const auto version = [&] {
        const Bytes manifest = ZipReader(path()).read("manifest.json", 1U << 20);
        const std::string text(reinterpret_cast<const char*>(manifest.data()), manifest.size());
        return text.substr(text.find("\"version\""), 12);
    };
    write_brush_bundle({brush::bundled_presets()}, path());
    EXPECT_EQ(version(), "\"version\": 1");
    write_brush_bundle({brush::bundled_presets(), {{"hair", {"Mine"}}}}, path());
    EXPECT_EQ(version(), "\"version\": 2");
}

TEST_F(Bundle, TellsWhichTagIsWrong) {
    const auto error_of_tags = [&](const std::string& tags) {
        return error_of(
            {{"manifest.json",
              R"({"format": "pastoso-brushes", "version": 2, "presets": [], "tags": )" + tags + "}"}});
    };
    EXPECT_EQ(error_of_tags(R"([{"name": "hair", "tools": ["Mine"]}])"), "");
    EXPECT_THAT(error_of_tags(R"([{"name": " ", "tools": []}])"),
                HasSubstr("mine.zip, manifest.json, tags[0].name: a tag needs a name."));
    EXPECT_THAT(error_of_tags(R"([{"name": "a", "tools": []}, {"name": "a", "tools": []}])"),
                HasSubstr("tags[1].name: \"a\" is there twice."));
    EXPECT_THAT(error_of_tags(R"([{"name": "a"}])"), HasSubstr("tools"));
    EXPECT_THAT(error_of_tags(R"([{"name": "a", "tools": [3]}])"), HasSubstr("tags[0].tools[0]"));
}

TEST_F(Bundle, IsReadWhoeverMadeIt) {
    EXPECT_EQ(error_of({{"a.json", preset("A")}, {"manifest.json", kGoodManifest}}), "");
}

TEST_F(Bundle, ThatIsNoneIsRefused) {
    core::write_text_file(path(), "not a zip archive");
    EXPECT_THAT(error(), HasSubstr("mine.zip"));
    EXPECT_THAT(error_of({{"a.json", preset("A")}}), HasSubstr("mine.zip: is no bundle of tools"));
    EXPECT_THAT(error_of({{"manifest.json", R"({"format": "other", "version": 1, "presets": []})"}}),
                HasSubstr("mine.zip, manifest.json"));
    EXPECT_THAT(
        error_of({{"manifest.json", R"({"format": "pastoso-brushes", "version": 3, "presets": []})"}}),
        HasSubstr("bundle format"));
    EXPECT_THAT(error_of({{"manifest.json", "{"}}), HasSubstr("mine.zip, manifest.json"));
}

TEST_F(Bundle, TellsWhichToolIsWrong) {
    EXPECT_THAT(error_of({{"manifest.json", kGoodManifest}}), HasSubstr("mine.zip, a.json"));
    EXPECT_THAT(error_of({{"manifest.json", kGoodManifest}, {"a.json", "{\"version\": 4}"}}),
                HasSubstr("mine.zip, a.json: kind is missing"));
    EXPECT_THAT(error_of({{"manifest.json", kGoodManifest}, {"a.json", std::string(2U << 20, ' ')}}),
                HasSubstr("mine.zip, a.json"));
    EXPECT_THAT(
        error_of({{"manifest.json",
                   R"({"format": "pastoso-brushes", "version": 1, "presets": ["a.json", "b.json"]})"},
                  {"a.json", preset("Mine")},
                  {"b.json", preset("MINE")}}),
        HasSubstr("mine.zip, b.json: name is \"MINE\", which another tool of the bundle has"));
}

}  // namespace
}  // namespace pastoso::project
