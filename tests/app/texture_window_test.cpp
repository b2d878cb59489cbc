// Texture paste in the real window: chosen in a dialog, laid on the layer, one step for Undo.
#include "app/selection_fixture.hpp"
#include "core/text_file.hpp"
#include "dialogs/texture_dialog.hpp"
#include "files/image.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using dialogs::ChosenTexture;
using testing::HasSubstr;

class TextureWindow : public SelectionFixture {
  protected:
    dialogs::TextureDialog& opened() {
        give(Command::LayTexture);
        return *window().findChild<dialogs::TextureDialog*>();
    }
    template <class Widget>
    static Widget& part(dialogs::TextureDialog& dialog, const char* name) {
        return *dialog.findChild<Widget*>(QString::fromLatin1(name));
    }
    static void choose(dialogs::TextureDialog& dialog, ChosenTexture::Form form) {
        part<QComboBox>(dialog, "form").setCurrentIndex(static_cast<int>(form));
    }
    /// It is closed and gone.
    void lay(dialogs::TextureDialog& dialog) {
        dialog.accept();
        settle();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        session().wait_until_applied();
    }
    document::LayTexture last() {
        session().wait_until_applied();
        return std::get<document::LayTexture>(session().recording().events.back().action);
    }
    /// Its left half is black, its right half white.
    QString written_picture() {
        const std::filesystem::path path = folder.path() / "relief.png";
        pigment::Picture picture{40, 20, {}};
        for (int i = 0; i < 800; ++i) {
            const std::uint8_t level = i % 40 < 20 ? 0 : 255;
            picture.rgba.insert(picture.rgba.end(), {level, level, level, 255});
        }
        core::write_text_file(path, files::png_file(picture));
        return QString::fromStdString(path.string());
    }
    double paste_mm(double x_mm, double y_mm) {
        session().wait_until_applied();
        const auto painting = session().snapshot();
        const int x = static_cast<int>(x_mm / painting->film.cell_mm);
        const int y = static_cast<int>(y_mm / painting->film.cell_mm);
        return painting->film.support_mm.at(x, y) - painting->bare->support_mm.at(x, y);
    }

    TemporaryFolder folder;
};

TEST_F(TextureWindow, SandIsLaidOfThePaintInHand) {
    dialogs::TextureDialog& dialog = opened();
    EXPECT_FALSE(part<QPushButton>(dialog, "picture").isVisibleTo(&dialog));
    part<QDoubleSpinBox>(dialog, "grain_mm").setValue(1.5);
    lay(dialog);
    EXPECT_EQ(last().paint, studio().easel().hand().paint);
    const auto sand = std::get<layers::SandTexture>(last().texture);
    EXPECT_EQ(sand.grain_mm, 1.5);
    EXPECT_GT(paste_mm(20.0, 20.0), 0.2);
    EXPECT_EQ(volume_mm3(), 0.0) << "nothing of it is wet";
    EXPECT_THAT(told(), HasSubstr("whole canvas"));
    give(Command::Undo);
    EXPECT_EQ(paste_mm(20.0, 20.0), 0.0);
}

TEST_F(TextureWindow, PasteKeepsToTheSelection) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    dialogs::TextureDialog& dialog = opened();
    choose(dialog, ChosenTexture::Form::Knifed);
    EXPECT_FALSE(part<QDoubleSpinBox>(dialog, "grain_mm").isVisibleTo(&dialog));
    part<QDoubleSpinBox>(dialog, "height_mm").setValue(1.0);
    part<QDoubleSpinBox>(dialog, "direction").setValue(45.0);
    lay(dialog);
    const auto paste = std::get<layers::KnifedTexture>(last().texture);
    EXPECT_EQ(paste.height_mm, 1.0);
    EXPECT_EQ(paste.direction_deg, 45.0);
    EXPECT_GT(paste_mm(25.0, 20.0), 0.03);
    EXPECT_EQ(paste_mm(50.0, 20.0), 0.0);
    EXPECT_THAT(told(), HasSubstr("selected"));
}

TEST_F(TextureWindow, AnotherReliefIsThereForTheAsking) {
    dialogs::TextureDialog& dialog = opened();
    const auto before = dialog.chosen().sand;
    auto& piece = part<QLabel>(dialog, "piece");
    const QImage shown = piece.pixmap(Qt::ReturnByValue).toImage();
    part<QPushButton>(dialog, "another").click();
    EXPECT_NE(dialog.chosen().sand.seed, before.seed);
    EXPECT_NE(piece.pixmap(Qt::ReturnByValue).toImage(), shown);
    const auto seed = dialog.chosen().sand.seed;
    lay(dialog);
    EXPECT_EQ(std::get<layers::SandTexture>(last().texture).seed, seed);
    EXPECT_NE(opened().chosen().sand.seed, seed) << "a second coat is not the first one again";
}

TEST_F(TextureWindow, APictureIsPressedIn) {
    dialogs::TextureDialog& dialog = opened();
    choose(dialog, ChosenTexture::Form::Pressed);
    auto* button = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_FALSE(button->isEnabled()) << "no picture yet";
    EXPECT_FALSE(part<QPushButton>(dialog, "another").isVisibleTo(&dialog));
    dialog.choose_picture(written_picture());
    EXPECT_TRUE(button->isEnabled());
    EXPECT_EQ(part<QPushButton>(dialog, "picture").text(), "relief.png");
    part<QDoubleSpinBox>(dialog, "relief_mm").setValue(0.75);
    const auto& piece = part<QLabel>(dialog, "piece");
    wait_for([&] { return piece.isVisibleTo(&dialog); });
    const auto middle_of_piece = [&] {
        const QImage image = piece.pixmap(Qt::ReturnByValue).toImage();
        std::vector<int> greys;
        for (int x = image.width() / 4; x < image.width() * 3 / 4; ++x)
            greys.push_back(qGray(image.pixel(x, image.height() / 2)));
        return greys;
    };
    const std::vector<int> rising = middle_of_piece();
    const int flat = rising.front();
    EXPECT_EQ(*std::min_element(rising.begin(), rising.end()), flat);
    EXPECT_GT(*std::max_element(rising.begin(), rising.end()), flat) << "the step faces the light";
    part<QCheckBox>(dialog, "dark_raised").setChecked(true);
    const std::vector<int> falling = middle_of_piece();
    EXPECT_LT(*std::min_element(falling.begin(), falling.end()), flat - 60);
    dialog.accept();
    loaded();
    settle();
    const document::CanvasSettings& canvas = session().canvas();
    EXPECT_NEAR(paste_mm(0.25 * canvas.width_mm, 0.5 * canvas.height_mm), 0.75, 0.001);
    EXPECT_EQ(paste_mm(0.75 * canvas.width_mm, 0.5 * canvas.height_mm), 0.0);
}

TEST_F(TextureWindow, APictureThatCannotBeReadHasNoPiece) {
    dialogs::TextureDialog& dialog = opened();
    choose(dialog, ChosenTexture::Form::Pressed);
    const auto& piece = part<QLabel>(dialog, "piece");
    EXPECT_FALSE(piece.isVisibleTo(&dialog));
    dialog.choose_picture(written_picture());
    wait_for([&] { return piece.isVisibleTo(&dialog); });
    dialog.choose_picture(QStringLiteral("/nowhere/relief.png"));
    EXPECT_FALSE(piece.isVisibleTo(&dialog));
    choose(dialog, ChosenTexture::Form::Sand);
    EXPECT_TRUE(piece.isVisibleTo(&dialog));
    dialog.reject();
}

TEST_F(TextureWindow, APictureIsPressedIntoWhatIsSelected) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    dialogs::TextureDialog& dialog = opened();
    choose(dialog, ChosenTexture::Form::Pressed);
    dialog.choose_picture(written_picture());
    dialog.accept();
    loaded();
    settle();
    // Twice as wide as high, within 30 x 20 mm.
    const layers::PicturePlace place = std::get<layers::PressedTexture>(last().texture).place;
    EXPECT_NEAR(place.x_mm, 10.0, kSide_mm);
    EXPECT_NEAR(place.y_mm, 12.5, kSide_mm);
    EXPECT_NEAR(place.width_mm, 30.0, 2.0 * kSide_mm);
    EXPECT_NEAR(place.height_mm, 15.0, 2.0 * kSide_mm);
}

TEST_F(TextureWindow, ASoftEdgeGivesAPictureNoMoreRoom) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    studio().easel().select(document::FeatherSelection{3.0});
    settle();
    dialogs::TextureDialog& dialog = opened();
    choose(dialog, ChosenTexture::Form::Pressed);
    dialog.choose_picture(written_picture());
    dialog.accept();
    loaded();
    settle();
    const layers::PicturePlace place = std::get<layers::PressedTexture>(last().texture).place;
    EXPECT_NEAR(place.x_mm, 10.0, kSide_mm);
    EXPECT_NEAR(place.width_mm, 30.0, 2.0 * kSide_mm);
}

}  // namespace
}  // namespace pastoso::tests
