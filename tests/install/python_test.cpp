// The Python package as it is installed: it finds what it needs wherever it is moved.
#include "core/text_file.hpp"
#include "install/installed.hpp"

#include <gmock/gmock.h>

namespace pastoso::install {
namespace {

TEST_F(Installed, PythonPaintsWhatTheProgramPaints) {
    install(folder / "moved", {"cli", "python"});
    const std::vector<std::string> painting = cli::small(
        {"replay", short_recording(), "-q", "-o", path("program.webp"), "--save", path("a.pastoso")});
    ASSERT_EQ(run(path("moved/bin/pastoso-cli"), painting).status, 0);
    const std::string script = "import pastoso; pastoso.Painting.open('" + path("a.pastoso") +
                               "').save('" + path("python.webp") + "')";
    const cli::RunResult painted =
        run("/usr/bin/env",
            {"PYTHONDONTWRITEBYTECODE=1", "PYTHONPATH=" + path("moved/lib/python3/dist-packages"),
             "/usr/bin/python3", "-c", script});
    ASSERT_EQ(painted.status, 0) << painted.errors;
    EXPECT_EQ(core::read_text_file(path("python.webp")), core::read_text_file(path("program.webp")));
}

TEST_F(Installed, PythonHasWhatTypeCheckersReadAndExamples) {
    install(folder / "moved", {"python"});
    for (const char* file :
         {"lib/python3/dist-packages/pastoso/__init__.py",
          "lib/python3/dist-packages/pastoso/_engine.pyi", "lib/python3/dist-packages/pastoso/py.typed",
          "share/doc/python3-pastoso/examples/paint_photograph.py",
          "share/doc/python3-pastoso/examples/robot_strokes.csv"})
        EXPECT_TRUE(std::filesystem::is_regular_file(folder / "moved" / file)) << file;
}

}  // namespace
}  // namespace pastoso::install
