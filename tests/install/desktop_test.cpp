// What desktops are told, held against their own programs.
#include "core/text_file.hpp"
#include "core/version.hpp"
#include "install/installed.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::install {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kId = "org.pastoso.Pastoso";

class Desktop : public Installed {
  protected:
    void SetUp() override {
        Installed::SetUp();
        install(folder / "moved");
    }

    std::string shared(const std::string& name) const { return path("moved/share/" + name); }

    std::string value_of(const std::string& file, const std::string& key) const {
        const std::string text = "\n" + core::read_text_file(shared(file));
        const std::size_t place = text.find("\n" + key + "=");
        if (place == std::string::npos) return "";
        const std::size_t begin = place + key.size() + 2;
        return text.substr(begin, text.find('\n', begin) - begin);
    }

    /// As programs of GNOME and Xfce see it.
    std::string type_of(const std::string& file) const {
        const std::string told =
            run("/usr/bin/gio", {"info", "-a", "standard::content-type", path(file)}).output;
        const std::string key = "standard::content-type: ";
        const std::size_t begin = told.find(key);
        if (begin == std::string::npos) return told;
        return told.substr(begin + key.size(), told.find('\n', begin) - begin - key.size());
    }

    void expect_accepted(const std::string& program, const std::vector<std::string>& arguments) const {
        const cli::RunResult result = run(program, arguments);
        EXPECT_EQ(result.status, 0) << program << ": " << result.output << result.errors;
    }
};

TEST_F(Desktop, ItsFilesAreValid) {
    const std::string id = kId;
    expect_accepted("/usr/bin/desktop-file-validate", {shared("applications/" + id + ".desktop")});
    expect_accepted("/usr/bin/appstreamcli",
                    {"validate", "--no-net", shared("metainfo/" + id + ".metainfo.xml")});
    EXPECT_THAT(core::read_text_file(shared("metainfo/" + id + ".metainfo.xml")),
                HasSubstr(std::string("version=\"") + core::version() + "\""));
}

TEST_F(Desktop, ItsFilesNameWhatIsInstalled) {
    const std::string id = kId;
    const std::string entry = "applications/" + id + ".desktop",
                      thumbnailer = "thumbnailers/" + id + ".thumbnailer";
    for (const std::string& program : {value_of(entry, "TryExec"), value_of(thumbnailer, "TryExec")})
        EXPECT_TRUE(std::filesystem::exists(folder / "moved" / "bin" / program)) << program;
    EXPECT_EQ(value_of(entry, "Icon"), id);
    EXPECT_TRUE(std::filesystem::exists(shared("icons/hicolor/scalable/apps/" + id + ".svg")));
    for (const std::string size : {"16", "22", "24", "32", "48", "64", "128", "256", "512"}) {
        const std::string png =
            core::read_text_file(shared("icons/hicolor/" + size + "x" + size + "/apps/" + id + ".png"));
        const auto side =
            static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]);
        EXPECT_EQ(std::to_string(side), size);
    }
    // Its screenshots are pictures of the manual.
    EXPECT_THAT(core::read_text_file(shared("metainfo/" + id + ".metainfo.xml")),
                HasSubstr("/docs/manual/pictures/window.png</image>"));
    EXPECT_TRUE(std::filesystem::exists(shared("doc/pastoso/docs/manual/pictures/window.png")));
}

TEST_F(Desktop, PaintingsHaveATypeThatIsToldByNameAndByContent) {
    ASSERT_EQ(run(path("moved/bin/pastoso-cli"),
                  cli::small({"replay", short_recording(), "--save", path("a.pastoso"), "-q"}))
                  .status,
              0);
    std::filesystem::copy_file(path("a.pastoso"), path("nameless"));
    std::filesystem::copy_file(path("a.pastoso"), path("a.ora"));
    expect_accepted("/usr/bin/update-mime-database", {"-V", shared("mime")});
    EXPECT_EQ(type_of("a.pastoso"), "application/x-pastoso");
    EXPECT_EQ(type_of("nameless"), "application/x-pastoso");
    EXPECT_EQ(type_of("a.ora"), "image/openraster");
    // Programs that open what a painting is a kind of are offered for it: those of zip archives can, those
    // of OpenRaster files go by the ending of its name.
    const std::string kinds = core::read_text_file(shared("mime/subclasses"));
    EXPECT_THAT(kinds, HasSubstr("application/x-pastoso application/zip\n"));
    EXPECT_THAT(kinds, Not(HasSubstr("application/x-pastoso image/openraster\n")));
}

TEST_F(Desktop, FileManagersGetSmallPictures) {
    ASSERT_EQ(run(path("moved/bin/pastoso-cli"),
                  cli::small({"replay", short_recording(), "--save", path("a b.pastoso"), "-q"}))
                  .status,
              0);
    std::string line = value_of(std::string("thumbnailers/") + kId + ".thumbnailer", "Exec");
    for (const auto& [sign, word] :
         {std::pair<std::string, std::string>{"%i", "'" + path("a b.pastoso") + "'"},
          {"%o", "'" + path("out") + "'"},
          {"%s", "32"}})
        line.replace(line.find(sign), 2, word);
    expect_accepted("/bin/sh", {"-c", "PATH=" + path("moved/bin") + ":$PATH; " + line});
    EXPECT_THAT(core::read_text_file(path("out")), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace pastoso::install
