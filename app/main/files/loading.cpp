#include "main/files/loading.hpp"

#include "appearance/shown_message.hpp"
#include "main/studio.hpp"
#include "panels/parts/work_progress.hpp"

#include <utility>

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QStatusBar>

namespace pastoso::main {
namespace {

using commands::Command;

/// The window and the paint come first.
constexpr int kNice = 3;

/// From one look at what is made to the next.
constexpr int kLook_ms = 50;

}  // namespace

Loading::Loading(Studio& studio)
    : studio_(studio),
      worker_([this](Job& job) { make(job); },
              [this](Job& job, const core::Message& fault) {
                  hand_over(job.number, {{}, fault});
              },
              kNice) {
    QAction* cancels = studio_.commands().action(Command::CancelLoading);
    studio_.commands().on(Command::CancelLoading, [this](bool) {
        if (!busy()) return;
        studio_.report(tr("%1: given up; all is as it was.").arg(words_));
        cancel();
    });
    cancels->setIconText(tr("Cancel"));
    cancels->setEnabled(false);
    progress_ = new panels::WorkProgress(cancels);
    progress_->setObjectName(QStringLiteral("loading_progress"));
    studio_.window().statusBar()->insertPermanentWidget(0, progress_);
    look_.setInterval(kLook_ms);
    connect(&look_, &QTimer::timeout, this, [this] {
        progress_->show_done(done_);
        take();
    });
}

void Loading::replace(const QString& words, Make make) {
    cancel();
    studio_.messages().solve(panels::Matter::Opening);
    words_ = words;
    done_ = 0.0;
    {
        const std::lock_guard lock(mutex_);
        wanted_ = ++begun_;
    }
    progress_->show_work(words, words);
    studio_.commands().action(Command::CancelLoading)->setEnabled(true);
    look_.start();
    worker_.add({begun_, std::move(make)});
}

void Loading::begin(const QString& words, Make make) {
    if (busy()) return studio_.report(tr("%1: wait for it, or cancel it.").arg(words_));
    replace(words, std::move(make));
}

void Loading::cancel() {
    if (busy()) end();
}

/// On the worker's thread.
void Loading::make(Job& job) {
    const auto tell = [this](double done) {
        done_ = done;
        if (watcher_) watcher_(done);
        if (worker_.cancelled()) throw core::GivenUp();
    };
    try {
        tell(0.0);
        hand_over(job.number, {job.make(tell)});
    } catch (const core::GivenUp&) {
        // Nobody waits for it.
    }
}

/// What nobody wants goes here, not on the window's thread.
void Loading::hand_over(std::uint64_t number, Made made) {
    const std::lock_guard lock(mutex_);
    if (number != wanted_) return;
    made_ = std::move(made);
    QMetaObject::invokeMethod(this, &Loading::take, Qt::QueuedConnection);
}

bool Loading::hand_rests() const {
    return QApplication::mouseButtons() == Qt::NoButton && QApplication::modalWindow() == nullptr &&
           QApplication::activePopupWidget() == nullptr &&
           !studio_.session().status().stroke_in_progress;
}

/// Tried again a little later where something is in the way.
void Loading::take() {
    std::optional<Made> made;
    {
        const std::lock_guard lock(mutex_);
        if (!made_ || (made_->fault.empty() && !hand_rests())) return;
        made = std::exchange(made_, std::nullopt);
    }
    look_.stop();
    const std::uint64_t number = wanted_;
    if (made->fault.empty()) made->fault = core::fault_of([&] { made->take_over(); });
    const core::Message fault = made->fault;
    made.reset();
    if (!fault.empty()) fail(fault);
    if (number == wanted_) end();
}

void Loading::end() {
    std::optional<Made> dropped;
    {
        const std::lock_guard lock(mutex_);
        wanted_ = 0;
        dropped.swap(made_);
    }
    worker_.cancel();
    look_.stop();
    progress_->hide();
    studio_.commands().action(Command::CancelLoading)->setEnabled(false);
    Q_EMIT ended();
}

void Loading::fail(const core::Message& fault) {
    const QString sentence = appearance::shown_sentence(fault);
    studio_.messages().raise({panels::Matter::Opening, sentence});
    Q_EMIT failed(sentence);
}

}  // namespace pastoso::main
