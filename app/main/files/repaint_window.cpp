#include "main/files/repaint_window.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "main/queued_refresh.hpp"
#include "panels/history/recorder_panel.hpp"

#include <cmath>
#include <utility>

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>

namespace pastoso::main {
namespace {

constexpr int kSteps = 1000;

/// Less says little of how long the rest takes.
constexpr double kFirstShare = 0.02;

QString time_left(const session::Repainter::Status& status) {
    if (status.paused) return RepaintWindow::tr("Paused");
    if (status.done < kFirstShare) return {};
    return RepaintWindow::tr("about %1 left")
        .arg(panels::time_words(status.spent_s * (1.0 - status.done) / status.done));
}

}  // namespace

RepaintWindow::RepaintWindow(document::Recording strokes, const std::string& name,
                             const view::CanvasView& like, QWidget* parent)
    : WatchedWindow(
          tr("Painted again at %1 px/mm").arg(appearance::shown_number(strokes.canvas.px_per_mm)), like,
          parent) {
    add_controls(controls());
    repainter_ = std::make_unique<session::Repainter>(
        std::move(strokes), name, queued_refresh(this, [this] { show_published(); }));
    show_published();
}

QWidget* RepaintWindow::controls() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(10);
    const auto button = [&](const char* name, const QString& words) {
        auto* made = new QPushButton(words);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        return made;
    };
    progress_ = new QProgressBar;
    progress_->setObjectName(QStringLiteral("repaint_progress"));
    progress_->setAccessibleName(tr("How much is painted"));
    progress_->setRange(0, kSteps);
    progress_->setFormat(QStringLiteral("%p %"));
    time_ = new QLabel;
    time_->setObjectName(QStringLiteral("repaint_time"));
    time_->setMinimumWidth(time_->fontMetrics().averageCharWidth() * 20);
    pause_ = button("repaint_pause", tr("Pause"));
    cancel_ = button("repaint_cancel", tr("Cancel"));
    save_ = button("repaint_save", tr("Save..."));
    save_->setToolTip(tr("As a painting, or as a picture"));
    put_up_ = button("repaint_put_up", tr("Put it on the easel"));
    connect(pause_, &QPushButton::clicked, this, [this] {
        repainter_->set_paused(!repainter_->status().paused);
        show_published();
    });
    connect(cancel_, &QPushButton::clicked, this, &QDialog::close);
    connect(save_, &QPushButton::clicked, this, [this] { Q_EMIT file_wanted(repainter_->painted()); });
    connect(put_up_, &QPushButton::clicked, this,
            [this] { Q_EMIT easel_wanted(repainter_->painted()); });
    row->addWidget(progress_, 1);
    row->addWidget(time_);
    for (QPushButton* each : {pause_, cancel_, save_, put_up_})
        row->addWidget(each);
    return widget;
}

void RepaintWindow::show_published() {
    if (repainter_ == nullptr) return;
    const session::Repainter::Status status = repainter_->status();
    const bool is_whole = repainter_->painted() != nullptr;
    if (const auto painting = repainter_->snapshot()) canvas().show_snapshot(painting);
    progress_->setValue(static_cast<int>(std::floor(kSteps * status.done)));
    if (!status.error.empty()) {
        time_->setText(tr("It cannot be painted any further"));
        time_->setToolTip(appearance::shown_message(status.error));
    } else {
        time_->setText(is_whole ? tr("Finished") : time_left(status));
    }
    pause_->setText(status.paused ? tr("Go on") : tr("Pause"));
    pause_->setVisible(!is_whole && status.error.empty());
    cancel_->setText(is_whole ? tr("Close") : tr("Cancel"));
    save_->setVisible(is_whole);
    put_up_->setVisible(is_whole);
}

void RepaintWindow::let_go() {
    keep();
    close();
}

std::unique_ptr<session::Repainter> RepaintWindow::take_repainter() {
    if (repainter_ != nullptr) repainter_->cancel();
    return std::move(repainter_);
}

void RepaintWindow::tell(const QString& sentence) {
    time_->setText(sentence);
    time_->setToolTip(sentence);
}

void RepaintWindow::come_to_front() {
    if (isMinimized()) showNormal();
    raise();
    activateWindow();
}

bool RepaintWindow::may_go() {
    if (is_kept_ || repainter_ == nullptr || !repainter_->status().error.empty()) return true;
    const QString question = repainter_->painted() != nullptr
                                 ? tr("The finer painting is in no file yet. Throw it away?")
                                 : tr("It is not painted to its end yet. Give it up?");
    is_kept_ = QMessageBox::question(this, windowTitle(), question) == QMessageBox::Yes;
    return is_kept_;
}

void RepaintWindow::reject() {
    close();
}

void RepaintWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(may_go());
    if (event->isAccepted()) Q_EMIT closes();
}

}  // namespace pastoso::main
