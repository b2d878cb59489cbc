#include "main/liquids/tank_recorder.hpp"

#include "appearance/shown_message.hpp"
#include "files/image.hpp"
#include "glass/tank_view.hpp"
#include "main/liquids/tank_surface_file.hpp"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QImage>
#include <QRegularExpression>

namespace pastoso::main {
namespace {

/// The liquid comes first.
constexpr int kNice = 6;

/// One more than the largest number of such files in the folder.
int next_number(const QString& folder, const QString& ending) {
    static const QRegularExpression kNumbered(QStringLiteral("^liquid_(\\d{4,9})\\."));
    int next = 1;
    for (const QString& name :
         QDir(folder).entryList({QStringLiteral("liquid_*.") + ending}, QDir::Files))
        if (const auto match = kNumbered.match(name); match.hasMatch())
            next = std::max(next, match.captured(1).toInt() + 1);
    return next;
}

pigment::Image8 image_of(const QImage& picture) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    pigment::Image8 image{rgb.width(), rgb.height(), {}};
    for (int y = 0; y < rgb.height(); ++y)
        image.rgb.insert(image.rgb.end(), rgb.constScanLine(y),
                         rgb.constScanLine(y) + 3 * std::ptrdiff_t{rgb.width()});
    return image;
}

bool is_same(const session::TankSnapshot& a, const session::TankSnapshot& b) {
    return a.place == b.place && a.seen.step == b.seen.step;
}

}  // namespace

TankRecorder::TankRecorder(session::TankSession& session, glass::TankView& view)
    : session_(session),
      view_(view),
      worker_(
          [this](Order& order) {
              order.write(order.file);
              tell_done(order.what, {});
          },
          [this](Order& order, const core::Message& fault) { tell_done(order.what, fault); }, kNice) {
    // It comes while a frame is drawn.
    connect(&view_, &glass::TankView::picture_finished, this, &TankRecorder::proceed,
            Qt::QueuedConnection);
}

void TankRecorder::start(Recorded what, const QString& folder) {
    if (records(what)) return;
    const bool pictures = what == Recorded::Pictures;
    Series begun;
    begun.folder = folder;
    begun.ending = pictures ? QStringLiteral("png") : QStringLiteral("obj");
    begun.next = next_number(folder, begun.ending);
    series(what) = std::move(begun);
    if (pictures) view_.set_hurried(true);
    session_.set_waiting(true);
    Q_EMIT progressed();
}

void TankRecorder::stop(Recorded what) {
    std::optional<Series>& stopped = series(what);
    if (!stopped) return;
    stopped->stopping = true;
    if (!stopped->writing) file_done(what, {});
}

void TankRecorder::look(std::shared_ptr<const session::TankSnapshot> snapshot) {
    snapshot_ = std::move(snapshot);
    proceed();
}

void TankRecorder::proceed() {
    if (snapshot_ == nullptr || !snapshot_->waits) return;
    bool all_have_it = true;
    for (const Recorded what : kRecorded)
        if (series(what) && !take(what)) all_have_it = false;
    if (all_have_it) session_.take(std::exchange(snapshot_, nullptr));
}

/// False when the moment has to wait: for the file before, or for the view.
bool TankRecorder::take(Recorded what) {
    Series& recorded = *series(what);
    if (recorded.stopping || (recorded.taken != nullptr && is_same(*recorded.taken, *snapshot_)))
        return true;
    const bool seen = view_.finished() && view_.shown() == snapshot_.get();
    if (recorded.writing || (what == Recorded::Pictures && !seen)) return false;
    recorded.taken = snapshot_;
    recorded.writing = true;
    const QString name = QStringLiteral("%1/liquid_%2.%3")
                             .arg(recorded.folder)
                             .arg(recorded.next++, 4, 10, QLatin1Char('0'))
                             .arg(recorded.ending);
    worker_.add({what, writer(what), name.toStdString()});
    return true;
}

void TankRecorder::tell_done(Recorded what, const core::Message& error) {
    QMetaObject::invokeMethod(
        this, [this, what, error = appearance::shown_message(error)] { file_done(what, error); },
        Qt::QueuedConnection);
}

/// What is to be done on the other thread.
TankRecorder::Write TankRecorder::writer(Recorded what) {
    if (what == Recorded::Pictures)
        return [picture = view_.picture()](const std::filesystem::path& file) {
            files::write_image(file, image_of(picture));
        };
    return [this, snapshot = snapshot_](const std::filesystem::path& file) {
        core::ThreadPool pool;
        write_tank_surface(*snapshot->place, snapshot->seen, file, pool,
                           [this] { return worker_.cancelled(); });
    };
}

void TankRecorder::file_done(Recorded what, const QString& error) {
    Series& recorded = *series(what);
    if (!error.isEmpty()) return end(what, error);
    if (std::exchange(recorded.writing, false)) ++recorded.written;
    Q_EMIT progressed();
    if (!recorded.stopping) return proceed();
    const int count = recorded.written;
    end(what, (what == Recorded::Pictures ? tr("%n picture(s) are in %1.", nullptr, count)
                                          : tr("%n surface(s) are in %1.", nullptr, count))
                  .arg(recorded.folder));
}

void TankRecorder::end(Recorded what, const QString& told) {
    series(what).reset();
    if (what == Recorded::Pictures) view_.set_hurried(false);
    if (std::ranges::none_of(kRecorded, [this](Recorded any) { return records(any); }))
        session_.set_waiting(false);
    else
        proceed();
    Q_EMIT ended(what, told);
}

}  // namespace pastoso::main
