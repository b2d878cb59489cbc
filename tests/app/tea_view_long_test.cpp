// The live view of the glass beside a traced picture of the same moment.
#include "glass/tea_page.hpp"
#include "liquid_files/traced_picture.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/window_parts.hpp"
#include "pigment/image.hpp"
#include "session/liquid_picture.hpp"
#include "window_fixture.hpp"

#include <cstdlib>

#include <QAction>
#include <QColor>

namespace pastoso::tests {
namespace {

class TeaViewBesideAPicture : public WindowTest {
  protected:
    glass::TeaView& view() { return parts().tea.page().view(); }

    void enter() {
        const auto action = [&](commands::Command command) {
            return studio().commands().action(command);
        };
        action(commands::Command::MilkTea)->trigger();
        session::TeaSession& glass = parts().tea.session();
        if (!glass.status().paused) action(commands::Command::LiquidPause)->trigger();
        glass.wait_until_applied();
        settle();
    }

    QImage seen(const std::shared_ptr<const session::TeaSnapshot>& snapshot) {
        view().show_moment(snapshot);
        wait_for([&] { return view().finished(); });
        return view().picture().convertToFormat(QImage::Format_RGB888);
    }

    QImage traced(const session::TeaSnapshot& snapshot, const QSize& size) {
        core::ThreadPool pool;
        trace::PathTracer tracer(
            session::traced_tea(snapshot, view().camera().traced(), trace::MilkBody::Medium, pool),
            {.width = size.width() / 2, .height = size.height() / 2}, pool);
        tracer.add_samples(24);
        const pigment::Image8 shown =
            pigment::encode_srgb8(liquid_files::shown_image(tracer.denoised()));
        return QImage(shown.rgb.data(), shown.width, shown.height, 3 * shown.width,
                      QImage::Format_RGB888)
            .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }

    /// Where the tea is seen.
    QRect tea_in(const QSize& size, const liquid::Cup& cup) {
        const auto at = [&](float side, float z_m) {
            const QPointF place = view().camera().seen_at(
                {cup.axis_m.x + side * cup.floor_radius_m, cup.axis_m.y, z_m}, size);
            return place.toPoint();
        };
        return QRect(at(-0.9F, cup.level_m - 0.01F), at(0.9F, cup.floor_m + 0.004F));
    }

    static double mean_luminance(const QImage& image, const QRect& part) {
        double sum = 0.0;
        for (int y = part.top(); y <= part.bottom(); ++y)
            for (int x = part.left(); x <= part.right(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                const auto linear = [](double value) {
                    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
                };
                sum += 0.2126 * linear(pixel.redF()) + 0.7152 * linear(pixel.greenF()) +
                       0.0722 * linear(pixel.blueF());
            }
        return sum / (static_cast<double>(part.width()) * part.height());
    }
};

TEST_F(TeaViewBesideAPicture, IsAsBright) {
    enter();
    liquid::TeaSettings settings;
    settings.parcels = glass::kLiveParcels;
    core::ThreadPool pool;
    liquid::MilkTea tea(settings);
    liquid::MilkDensities densities(pool);
    for (const double time_s : {0.8, 1.8, 5.0, 14.0}) {
        while (tea.time_s() < time_s - 1e-6)
            tea.step(pool);
        auto snapshot = std::make_shared<session::TeaSnapshot>();
        snapshot->settings = settings;
        snapshot->seen = {tea.steps(), tea.parcels(), tea.dissolved(), tea.pour()};
        snapshot->time_s = tea.time_s();
        session::fill_milk(densities, *snapshot);
        const QImage view_image = seen(snapshot);
        const QImage picture = traced(*snapshot, view_image.size());
        if (const char* folder = std::getenv("PASTOSO_TEST_PICTURES")) {
            const QString stem = QStringLiteral("%1/%2-").arg(folder).arg(time_s);
            view_image.save(stem + QStringLiteral("view.png"));
            picture.save(stem + QStringLiteral("traced.png"));
        }
        const auto expect_as_bright = [&](const QRect& part, double tolerance) {
            const double bright = mean_luminance(picture, part);
            EXPECT_NEAR(mean_luminance(view_image, part), bright, tolerance * bright)
                << time_s << " s, " << part.width() << " x " << part.height();
        };
        // What hardly shows with both side by side. The view has no light that glass and tea gather on
        // the floor: the tea alone may be a little darker.
        expect_as_bright(view_image.rect(), 0.08);
        expect_as_bright(tea_in(view_image.size(), settings.cup), 0.12);
    }
}

}  // namespace
}  // namespace pastoso::tests
