// The checker itself, on planted violations of a page of its own.
#include "architecture/include_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kPage =
    "| level | folder | is | may use |\n"
    "| --- | --- | --- | --- |\n"
    "| 0 | `engine/core` | | - |\n"
    "| 1 | `engine/grid` | | core |\n"
    "| 1 | `engine/pigment` | | core |\n"
    "| 2 | `engine/film` | | grid, pigment |\n"
    "| - | `app/cli` | | engine |\n"
    "| a | `app/session` | | engine |\n"
    "| b | `app/commands`, `app/tools` | | session |\n"
    "| c | `app/view` | | commands, tools |\n"
    "\n"
    "| library | headers | known to |\n"
    "| --- | --- | --- |\n"
    "| the system | `unistd.h`, `sys/*` | all |\n"
    "| glm | `glm/*` | all |\n"
    "| LittleCMS | `lcms2*` | pigment |\n"
    "| Qt | `Q*`, `qpa/*`, `private/q*`, `q*.h` | all of app but cli |\n";

std::vector<std::string> violations(std::string_view path, std::string_view text) {
    return include_violations(read_architecture_page(kPage), path, text);
}

TEST(IncludeRules, LowerFoldersAndLibrariesMayBeUsed) {
    EXPECT_THAT(
        violations("engine/film/large/solver.cpp",
                   "#include \"film/solver.hpp\"\n#include <vector>\n#include <glm/glm.hpp>\n"
                   "#include \"core/check.hpp\"\n#include \"grid/shape.hpp\"\n#include <sys/file.h>\n"),
        IsEmpty());
    EXPECT_THAT(violations("app/view/canvas_view.cpp",
                           "#include <QOpenGLWidget>\n#include \"session/paint_session.hpp\"\n"
                           "#include \"film/state.hpp\"\n#include \"canvas_view.moc\"\n"),
                IsEmpty());
}

TEST(IncludeRules, HigherFoldersMayNot) {
    EXPECT_THAT(
        violations("engine/grid/shape.hpp", "#pragma once\n#include \"film/state.hpp\"\n"),
        ElementsAre("engine/grid/shape.hpp:2: includes film/state.hpp, but grid may not use film"));
    EXPECT_THAT(violations("app/session/a.cpp", "#include \"view/b.hpp\"\n"),
                ElementsAre("app/session/a.cpp:1: includes view/b.hpp, but session may not use view"));
}

TEST(IncludeRules, NeighboursMayNot) {
    const std::pair<const char*, const char*> kNeighbours[] = {
        {"engine/grid/a.cpp", "pigment/b.hpp"},
        {"engine/film/a.cpp", "session/b.hpp"},
        {"app/commands/a.cpp", "tools/b.hpp"},
        {"app/cli/a.cpp", "session/b.hpp"},
    };
    for (const auto& [path, name] : kNeighbours)
        EXPECT_EQ(violations(path, "#include \"" + std::string(name) + "\"\n").size(), 1U) << path;
}

TEST(IncludeRules, LibrariesStayWhereTheirRowSays) {
    for (const char* name : {"<QString>", "<QtCore/qglobal.h>", "\"QWidget\"",
                             "<qpa/qwindowsysteminterface.h>", "<qopengl.h>", "<private/qrhi_p.h>"}) {
        const std::string text = "#include " + std::string(name) + "\n";
        EXPECT_EQ(violations("engine/film/a.cpp", text).size(), 1U) << name;
        EXPECT_EQ(violations("app/cli/main.cpp", text).size(), 1U) << name;
        EXPECT_THAT(violations("app/view/a.cpp", text), IsEmpty()) << name;
    }
    const char* text = "#include <lcms2_plugin.h>\n";
    EXPECT_THAT(violations("engine/pigment/a.cpp", text), IsEmpty());
    EXPECT_THAT(
        violations("engine/film/a.cpp", text),
        ElementsAre("engine/film/a.cpp:1: includes lcms2_plugin.h, but film may not know LittleCMS"));
}

TEST(IncludeRules, LibrariesNeedARow) {
    EXPECT_EQ(violations("engine/film/a.cpp", "#include <boost/array.hpp>\n").size(), 1U);
    EXPECT_EQ(violations("engine/film/a.cpp", "#include <zip.h>\n").size(), 1U);
}

TEST(IncludeRules, OddlyWrittenIncludesAreSeen) {
    EXPECT_EQ(violations("engine/core/a.cpp", "  #  include\"film/state.hpp\" // x\n").size(), 1U);
    EXPECT_THAT(violations("engine/core/a.cpp", "// #include \"film/state.hpp\"\n"), IsEmpty());
}

TEST(IncludeRules, HeadersAreNamedWithTheirFolder) {
    EXPECT_EQ(violations("engine/film/a.cpp", "#include \"state.hpp\"\n").size(), 1U);
    EXPECT_EQ(violations("engine/film/a.cpp", "#include \"../core/check.hpp\"\n").size(), 1U);
}

TEST(IncludeRules, NewFoldersNeedARow) {
    EXPECT_EQ(violations("engine/plasma/a.cpp", "").size(), 1U);
    EXPECT_EQ(violations("engine/a.cpp", "").size(), 1U);
}

}  // namespace
}  // namespace pastoso::tests
