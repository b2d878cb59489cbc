#include "dialogs/unfinished_words.hpp"

#include "appearance/shown_number.hpp"
#include "appearance/shown_time.hpp"
#include "dialogs/recovery_dialog.hpp"

#include <filesystem>

#include <QDateTime>
#include <QPainter>

namespace pastoso::dialogs {
namespace {

QString time_of(const journal::Unfinished& painting) {
    const auto seconds = std::chrono::system_clock::to_time_t(painting.last_painted);
    return appearance::shown_time(QDateTime::fromSecsSinceEpoch(seconds));
}

}  // namespace

QString unfinished_name(const journal::Unfinished& painting) {
    if (painting.painting.empty()) return RecoveryDialog::tr("A painting without a name");
    return QString::fromStdString(std::filesystem::path(painting.painting).filename().string());
}

QString unfinished_words(const journal::Unfinished& painting) {
    if (!painting.fault.empty())
        return RecoveryDialog::tr("A painting that cannot be read\n%1").arg(time_of(painting));
    return RecoveryDialog::tr("%1\n%2\n%3 × %4 mm, %n change(s) not saved", nullptr,
                              static_cast<int>(painting.changes))
        .arg(unfinished_name(painting), time_of(painting))
        .arg(appearance::shown_number(painting.canvas.width_mm))
        .arg(appearance::shown_number(painting.canvas.height_mm));
}

QPixmap unfinished_picture(const journal::Unfinished& painting, int side_px, double pixel_ratio) {
    QPixmap square(QSize(side_px, side_px) * pixel_ratio);
    square.fill(Qt::transparent);
    QPixmap picture;
    const std::string& file = painting.thumbnail;
    if (picture.loadFromData(reinterpret_cast<const uchar*>(file.data()),
                             static_cast<uint>(file.size()))) {
        picture = picture.scaled(square.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
        QPainter(&square).drawPixmap((square.width() - picture.width()) / 2,
                                     (square.height() - picture.height()) / 2, picture);
    }
    square.setDevicePixelRatio(pixel_ratio);
    return square;
}

}  // namespace pastoso::dialogs
