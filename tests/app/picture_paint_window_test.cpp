// Pictures that become paint in the window.
#include "app/window_fixture.hpp"
#include "commands/command_registry.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "main/window_parts.hpp"
#include "project/project.hpp"
#include "project/zip_file.hpp"

#include <QAction>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;

class PicturePaintWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        studio().commands().action(Command::Pause)->trigger();
    }

    static std::string red_png() {
        pigment::Picture picture{40, 40, {}};
        for (int i = 0; i < 1600; ++i)
            picture.rgba.insert(picture.rgba.end(), {200, 30, 20, 255});
        return files::png_file(picture);
    }
    std::string written(const char* name, const std::string& content) const {
        const std::filesystem::path path = folder.path() / name;
        core::write_text_file(path, content);
        return path.string();
    }
    std::vector<std::string> layer_names() {
        std::vector<std::string> names;
        for (const document::Layer& layer : session().capture().painting.value.layers.layers)
            names.push_back(layer.look.name);
        return names;
    }

    TemporaryFolder folder;
};

TEST_F(PicturePaintWindow, APictureIsALayerInTheMiddle) {
    const std::string before = layer_names().front();
    parts().pictures.paint_pictures({QString::fromStdString(written("red.png", red_png()))});
    loaded();
    settle();
    EXPECT_THAT(layer_names(), testing::ElementsAre(before, "red"));
    EXPECT_TRUE(window().isWindowModified());
    const QImage shown = picture();
    const QColor middle = shown.pixelColor(shown.width() / 2, shown.height() / 2);
    EXPECT_GT(middle.red(), 150);
    EXPECT_LT(middle.green(), 90);
    studio().commands().action(Command::Undo)->trigger();
    settle();
    EXPECT_EQ(layer_names().size(), 1U);
}

TEST_F(PicturePaintWindow, APictureOpensAsPaintOnANewCanvas) {
    parts().files.open_painting(QString::fromStdString(written("red.png", red_png())));
    loaded();
    settle();
    EXPECT_THAT(layer_names(), testing::ElementsAre("red"));
    EXPECT_EQ(session().canvas().width_mm, 300.0);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(window().windowTitle().toStdString(), testing::StartsWith("Canvas[*] "));
    mouse_stroke(line_mm({100.0, 100.0}, {200.0, 120.0}));
    settle();
    EXPECT_GT(volume_mm3(), 0.0);
}

TEST_F(PicturePaintWindow, AnOpenRasterFileOpensWithItsLayers) {
    project::ZipWriter archive;
    archive.add("stack.xml", std::string("<image w='60' h='40'><stack><layer name='Two' src='a.png'/>"
                                         "<layer name='One' src='a.png' x='20'/></stack></image>"));
    archive.add("a.png", red_png());
    core::write_aside(folder.path() / "a.ora", [&](core::OutputFile& file) { archive.write(file); });
    parts().files.open_painting(QString::fromStdString((folder.path() / "a.ora").string()));
    loaded();
    settle();
    EXPECT_THAT(layer_names(), testing::ElementsAre("One", "Two"));
}

TEST_F(PicturePaintWindow, WhatIsNoPictureLeavesThePaintingOnTheEasel) {
    const std::uint64_t before = document::state_hash(session().capture().painting);
    const QString none = QString::fromStdString(written("none.png", "none"));
    parts().files.open_painting(none);
    loaded();
    parts().pictures.paint_pictures({none});
    loaded();
    EXPECT_EQ(document::state_hash(session().capture().painting), before);
}

}  // namespace
}  // namespace pastoso::tests
