// Numbers in files are those of the C locale, whatever the environment's.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "locale_folder.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

/// For the time of a test.
class Environment {
  public:
    Environment(const char* name, const std::string& value) : name_(name) {
        ::setenv(name, value.c_str(), 1);
    }
    ~Environment() { ::unsetenv(name_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
};

class CliLocale : public CliTest {
  protected:
    /// All files that a few subcommands make, in a folder of this name: of formats that hold no date.
    std::string made(const std::string& name) const {
        std::filesystem::create_directory(path(name));
        const auto in = [&](const std::string& file) { return path(name + "/" + file); };
        const std::string pen = short_recording();
        std::string said;
        const auto run = [&](const std::vector<std::string>& arguments) {
            const RunResult result = run_cli(arguments);
            EXPECT_EQ(result.status, 0) << result.errors;
            std::string output = result.output;
            for (std::size_t at; (at = output.find("/" + name + "/")) != std::string::npos;)
                output.replace(at, name.size() + 2, "/");
            said += output.substr(0, output.find("s of painting in "));
        };
        run(small({"replay", "-q", pen, "--paint", "#C03020", "--light", "LED", "--profile",
                   "DISPLAY-P3", "--save", in("a.pastoso"), "-o", in("A.PNG")}));
        for (const std::string file : {"b.obj", "b.ply", "b.stl", "b.jpg"})
            run({"export", "-q", in("a.pastoso"), "-o", in(file)});
        run({"info", in("a.pastoso")});
        run({"info", "closest", "#7a5c3e"});
        EXPECT_EQ(run_cli({"simulate", "glaze", "-q", "--seconds", "0.1", "-o", in("glaze")}).status, 0);
        return said;
    }
};

TEST_F(CliLocale, FilesAndOutputAreTheSameInEveryLocale) {
    const std::string said = made("c");
    const tests::LocaleFolder locales;
    ASSERT_TRUE(locales.is_whole()) << "needs the package locales";
    for (const std::string name : tests::LocaleFolder::kNames) {
        const Environment locale("LC_ALL", name);
        EXPECT_EQ(made(name), said);
        int files = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path("c"))) {
            if (!entry.is_regular_file()) continue;
            const auto other = folder / name / entry.path().lexically_relative(path("c"));
            EXPECT_TRUE(core::read_text_file(other) == core::read_text_file(entry.path())) << other;
            ++files;
        }
        EXPECT_GT(files, 8);
    }
}

}  // namespace
}  // namespace pastoso::cli
