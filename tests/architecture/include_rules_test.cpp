// The checker itself, on planted violations.
#include "architecture/include_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using pastoso::tests::include_violations;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(IncludeRules, LowerFoldersAndLibrariesMayBeUsed) {
    EXPECT_THAT(
        include_violations("engine/film/solver.cpp",
                           "#include \"film/solver.hpp\"\n#include <vector>\n#include <glm/glm.hpp>\n"
                           "#include \"core/check.hpp\"\n#include \"grid/shape.hpp\"\n"),
        IsEmpty());
    EXPECT_THAT(include_violations("app/view/canvas_view.cpp",
                                   "#include <QOpenGLWidget>\n#include \"session/paint_session.hpp\"\n"
                                   "#include \"shade/render.hpp\"\n#include \"canvas_view.moc\"\n"),
                IsEmpty());
}

TEST(IncludeRules, HigherFoldersMayNot) {
    EXPECT_THAT(
        include_violations("engine/grid/shape.hpp", "#pragma once\n#include \"film/state.hpp\"\n"),
        ElementsAre("engine/grid/shape.hpp:2: includes film/state.hpp, but grid may not use film"));
    EXPECT_THAT(
        include_violations("app/session/a.cpp", "#include \"panels/b.hpp\"\n"),
        ElementsAre("app/session/a.cpp:1: includes panels/b.hpp, but session may not use panels"));
}

TEST(IncludeRules, NeighboursMayNot) {
    const std::pair<const char*, const char*> kNeighbours[] = {
        {"engine/film/a.cpp", "liquid/b.hpp"},      {"engine/liquid/a.cpp", "film/b.hpp"},
        {"engine/brush/a.cpp", "shade/b.hpp"},      {"engine/grid/a.cpp", "pigment/b.hpp"},
        {"engine/document/a.cpp", "io/b.hpp"},      {"app/commands/a.cpp", "tools/b.hpp"},
        {"app/view/a.cpp", "panels/b.hpp"},         {"app/cli/a.cpp", "session/b.hpp"},
        {"engine/document/a.cpp", "session/b.hpp"},
    };
    for (const auto& [path, name] : kNeighbours) {
        EXPECT_EQ(include_violations(path, "#include \"" + std::string(name) + "\"\n").size(), 1U)
            << path;
    }
}

TEST(IncludeRules, QtStaysInTheWindow) {
    for (const char* name : {"<QString>", "<QtCore/qglobal.h>", "\"QWidget\"",
                             "<qpa/qwindowsysteminterface.h>", "<qopengl.h>", "<private/qrhi_p.h>"}) {
        const std::string text = "#include " + std::string(name) + "\n";
        EXPECT_EQ(include_violations("engine/shade/render.cpp", text).size(), 1U) << name;
        EXPECT_EQ(include_violations("app/cli/main.cpp", text).size(), 1U) << name;
        EXPECT_THAT(include_violations("app/view/a.cpp", text), IsEmpty()) << name;
    }
}

TEST(IncludeRules, OpenImageIoStaysInIo) {
    const char* text = "#include <OpenImageIO/imageio.h>\n";
    EXPECT_THAT(include_violations("engine/io/images_module.cpp", text), IsEmpty());
    EXPECT_EQ(include_violations("engine/shade/render.cpp", text).size(), 1U);
    EXPECT_EQ(include_violations("app/main/main.cpp", text).size(), 1U);
}

TEST(IncludeRules, LittleCmsStaysInIo) {
    const char* text = "#include <lcms2.h>\n";
    EXPECT_THAT(include_violations("engine/io/colour_profile.cpp", text), IsEmpty());
    EXPECT_EQ(include_violations("engine/pigment/colour.cpp", text).size(), 1U);
    EXPECT_EQ(include_violations("app/cli/main.cpp", text).size(), 1U);
}

TEST(IncludeRules, EmbreeStaysInTrace) {
    const char* text = "#include <embree3/rtcore.h>\n";
    EXPECT_THAT(include_violations("engine/trace/triangle_rays.cpp", text), IsEmpty());
    EXPECT_EQ(include_violations("engine/liquid/triangle_mesh.cpp", text).size(), 1U);
    EXPECT_EQ(include_violations("app/cli/main.cpp", text).size(), 1U);
}

TEST(IncludeRules, LibzipStaysInProject) {
    const char* text = "#include <zip.h>\n";
    EXPECT_THAT(include_violations("engine/project/zip_file.cpp", text), IsEmpty());
    EXPECT_EQ(include_violations("engine/io/image.cpp", text).size(), 1U);
    EXPECT_EQ(include_violations("app/cli/main.cpp", text).size(), 1U);
}

TEST(IncludeRules, ZstdStaysInPacking) {
    const char* text = "#include <zstd.h>\n";
    EXPECT_THAT(include_violations("engine/packing/packed_bytes.cpp", text), IsEmpty());
    EXPECT_EQ(include_violations("engine/project/zip_file.cpp", text).size(), 1U);
    EXPECT_EQ(include_violations("app/cli/main.cpp", text).size(), 1U);
}

TEST(IncludeRules, OddlyWrittenIncludesAreSeen) {
    EXPECT_EQ(include_violations("engine/core/a.cpp", "  #  include\"film/state.hpp\" // x\n").size(),
              1U);
    EXPECT_THAT(include_violations("engine/core/a.cpp", "// #include \"film/state.hpp\"\n"), IsEmpty());
}

TEST(IncludeRules, HeadersAreNamedWithTheirFolder) {
    EXPECT_EQ(include_violations("engine/film/a.cpp", "#include \"state.hpp\"\n").size(), 1U);
    EXPECT_EQ(include_violations("engine/film/a.cpp", "#include \"../core/check.hpp\"\n").size(), 1U);
}

TEST(IncludeRules, NewFoldersNeedARule) {
    EXPECT_EQ(include_violations("engine/plasma/a.cpp", "").size(), 1U);
    EXPECT_EQ(include_violations("engine/a.cpp", "").size(), 1U);
}

}  // namespace
