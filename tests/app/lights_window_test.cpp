// The panel of lamp and varnish: what it says is what canvas, exports and the next start have.
#include "app/window_fixture.hpp"
#include "files/image.hpp"
#include "main/window_parts.hpp"
#include "pigment/illuminant.hpp"
#include "shade/varnish.hpp"

#include <stdexcept>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class LightsWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::LightPanel)->trigger();
    }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void choose(const char* box, int row) {
        auto& combo = find<QComboBox>(box);
        combo.setCurrentIndex(row);
        Q_EMIT combo.activated(row);
    }
    void set(const char* number, double value) { find<QDoubleSpinBox>(number).setValue(value); }
};

TEST_F(LightsWindow, AKeyShowsIt) {
    find<QDockWidget>("light_panel").hide();
    QTest::keyClick(&window(), Qt::Key_F4);
    EXPECT_TRUE(find<QDockWidget>("light_panel").isVisible());
}

TEST_F(LightsWindow, TheNumbersMoveTheLampOverCanvasAndWell) {
    set("lamp_azimuth", 40.0);
    set("lamp_height", 22.0);
    set("lamp_ambient", 55.0);
    for (const view::CanvasView* view : {&canvas(), &studio().well()}) {
        EXPECT_EQ(view->lighting().azimuth_deg, 40.0);
        EXPECT_EQ(view->lighting().elevation_deg, 22.0);
        EXPECT_NEAR(view->lighting().ambient, 0.55, 1e-12);
    }
}

TEST_F(LightsWindow, TheIlluminantIsTheOneOfTheMenu) {
    choose("illuminant", 2);
    EXPECT_EQ(canvas().viewing(), pigment::viewing_under(pigment::find_illuminant("A")));
    EXPECT_TRUE(action(Command::LightA)->isChecked());
    action(Command::LightLed)->trigger();
    EXPECT_EQ(find<QComboBox>("illuminant").currentData().toString(), QStringLiteral("LED"));
}

TEST_F(LightsWindow, VarnishIsLookedThroughAndTakenOff) {
    const shade::Lighting bare = canvas().lighting();
    const pigment::Viewing even = canvas().viewing();
    EXPECT_FALSE(find<QDoubleSpinBox>("varnish_amount").isEnabled());
    choose("varnish", 3);
    EXPECT_TRUE(find<QDoubleSpinBox>("varnish_amount").isEnabled());
    const double gloss = shade::varnish_roughness(shade::Finish::Gloss);
    EXPECT_EQ(canvas().lighting().dry_roughness, gloss);
    EXPECT_EQ(canvas().lighting().wet_roughness, gloss);
    EXPECT_EQ(canvas().viewing(), even);
    set("varnish_yellowing", 60.0);
    EXPECT_EQ(canvas().viewing(),
              shade::varnished(even, shade::Varnish{shade::Finish::Gloss, 1.0, 0.6}));
    choose("varnish", 0);
    EXPECT_EQ(canvas().lighting().dry_roughness, bare.dry_roughness);
    EXPECT_EQ(canvas().lighting().wet_roughness, bare.wet_roughness);
    EXPECT_EQ(canvas().viewing(), even);
}

TEST_F(LightsWindow, APictureIsExportedUnderItsVarnish) {
    mouse_stroke(line_mm({10.0, 20.0}, {50.0, 20.0}));
    action(Command::Pause)->trigger();
    settle();
    const TemporaryFolder folder;
    const auto exported = [&](const char* name) {
        tools::ExportSettings settings;
        parts().exporting.start(settings, folder.path() / name);
        wait_for([this] { return !parts().exporting.exporter().busy(); });
        return files::read_picture(folder.path() / name).picture.rgba;
    };
    const auto bare = exported("bare.png");
    choose("varnish", 3);
    set("varnish_yellowing", 80.0);
    const auto varnished = exported("varnished.png");
    ASSERT_EQ(varnished.size(), bare.size());
    // The bare canvas in the corner turns yellow.
    EXPECT_LT(varnished[2], bare[2] - 30);
    choose("varnish", 0);
    EXPECT_EQ(exported("again.png"), bare);
}

TEST_F(LightsWindow, TheNextStartHasTheSameLampAndVarnish) {
    set("lamp_ambient", 45.0);
    set("lamp_height", 50.0);
    choose("varnish", 2);
    set("varnish_amount", 70.0);
    set("varnish_yellowing", 20.0);
    const shade::Lighting lighting = canvas().lighting();
    const pigment::Viewing viewing = canvas().viewing();
    start_again();
    EXPECT_NEAR(canvas().lighting().ambient, 0.45, 1e-12);
    EXPECT_EQ(canvas().lighting().elevation_deg, 50.0);
    EXPECT_NEAR(canvas().lighting().dry_roughness, lighting.dry_roughness, 1e-12);
    EXPECT_EQ(canvas().viewing(), viewing);
    EXPECT_EQ(find<QComboBox>("varnish").currentText(), QStringLiteral("Satin"));
    EXPECT_EQ(find<QDoubleSpinBox>("varnish_amount").value(), 70.0);
}

TEST_F(LightsWindow, DraggingTheLampMovesTheNumbers) {
    Q_EMIT studio().on_canvas().lamp.dragged(64.0, 200.0);
    EXPECT_EQ(find<QDoubleSpinBox>("lamp_azimuth").value(), 200.0);
    EXPECT_EQ(find<QDoubleSpinBox>("lamp_height").value(), 64.0);
}

}  // namespace
}  // namespace pastoso::tests
