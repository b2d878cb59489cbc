#include "camera.hpp"

#include "few_colours.hpp"
#include "main/window_parts.hpp"

#include <algorithm>
#include <cstdio>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QPainter>
#include <QScrollArea>
#include <QTest>
#include <QTimer>

namespace pastoso::screens {
namespace {

constexpr int kPatience_ms = 60000, kOpening_ms = 400, kMoment_ms = 1500, kNext_ms = 200;
constexpr int kPage_px = 960, kGap_px = 8;

QWidget* open_dialog() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->isVisible() && qobject_cast<QDialog*>(widget) != nullptr) return widget;
    return nullptr;
}

}  // namespace

bool wait_for(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience_ms);
}

void pass_time() {
    QTest::qWait(kMoment_ms);
}

void wait_for_painting(main::MainWindow& window) {
    if (!QTest::qWaitFor([&] { return !window.parts().loading.busy(); }, kPatience_ms))
        std::fprintf(stderr, "The painting is still opened.\n");
}

QPixmap with(QPixmap below, const QWidget& ground, QWidget& above) {
    QPainter painter(&below);
    painter.drawPixmap(ground.mapFromGlobal(above.mapToGlobal(QPoint(0, 0))), above.grab());
    return below;
}

QPixmap middle_of(const QPixmap& picture, const QSize& size) {
    return picture.copy(
        {QPoint((picture.width() - size.width()) / 2, (picture.height() - size.height()) / 2), size});
}

QPixmap sheet(const QList<QPixmap>& pictures, int columns) {
    const QSize size = pictures.front().size();
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    QPixmap all(columns * size.width() + (columns - 1) * kGap_px,
                rows * size.height() + (rows - 1) * kGap_px);
    all.fill(Qt::white);
    QPainter painter(&all);
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i)
        painter.drawPixmap((i % columns) * (size.width() + kGap_px),
                           (i / columns) * (size.height() + kGap_px), pictures[i].scaled(size));
    return all;
}

bool write(const QPixmap& picture, const QString& path) {
    QImage image = picture.toImage();
    if (image.width() > kPage_px) image = image.scaledToWidth(kPage_px, Qt::SmoothTransformation);
    constexpr int kSmallest = 0;
    return in_few_colours(image).save(path, "PNG", kSmallest);
}

void Camera::settle() {
    const auto finished = [this] {
        QApplication::processEvents();
        return window_.studio().canvas().finished() &&
               window_.studio().canvas().shown() == window_.studio().session().snapshot().get();
    };
    window_.studio().session().wait_until_applied();
    // What has just been asked for may be no more than on its way to the canvas.
    QTest::qWait(kNext_ms);
    if (!wait_for(finished)) std::fprintf(stderr, "The canvas is still drawn.\n");
}

QPixmap Camera::look() {
    settle();
    return window_.grab();
}

QPixmap Camera::look_at_canvas() {
    settle();
    return QPixmap::fromImage(window_.studio().canvas().picture());
}

void Camera::take_dialog(commands::Command command, const QString& name,
                         const std::function<void(QWidget&)>& prepare) {
    bool taken = false;
    QTimer::singleShot(kOpening_ms, [&] {
        taken = true;
        QWidget* dialog = open_dialog();
        if (dialog == nullptr) {
            complain(name);
            return;
        }
        if (prepare) prepare(*dialog);
        QApplication::processEvents();
        save(dialog->grab(), name);
        dialog->close();
    });
    give(command);
    // Some dialogs stay open while the program goes on.
    if (!wait_for([&taken] { return taken; })) complain(name);
}

/// It floats for the picture, where nothing cuts it off.
void Camera::take_panel(const char* short_name) {
    const QString name = QStringLiteral("panel-") + QLatin1String(short_name);
    auto* panel = window_.findChild<QDockWidget*>(QLatin1String(short_name) + QStringLiteral("_panel"));
    auto* scrolled = panel != nullptr ? qobject_cast<QScrollArea*>(panel->widget()) : nullptr;
    if (scrolled == nullptr) {
        complain(name);
        return;
    }
    constexpr int kTitle_px = 28, kWide_px = 340;
    panel->show();
    panel->setFloating(true);
    const QSize wanted = scrolled->widget()->sizeHint();
    panel->resize(std::max(wanted.width(), kWide_px), wanted.height() + kTitle_px);
    pass_time();
    settle();
    save(panel->grab(), name);
    panel->setFloating(false);
}

void Camera::save(const QPixmap& picture, const QString& name) {
    if (!write(picture, path_of(name))) complain(name);
}

QString Camera::path_of(const QString& name) const {
    return folder_ + QLatin1Char('/') + name + QStringLiteral(".png");
}

void Camera::complain(const QString& name) {
    std::fprintf(stderr, "No picture %s could be taken.\n", qPrintable(name));
    complete_ = false;
}

}  // namespace pastoso::screens
