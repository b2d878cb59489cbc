#include "main/studio.hpp"

#include "appearance/shown_message.hpp"
#include "graphics/opengl_support.hpp"
#include "main/program/application.hpp"
#include "main/queued_refresh.hpp"

#include <utility>

#include <QAction>
#include <QMainWindow>
#include <QMessageBox>
#include <QStatusBar>

namespace pastoso::main {

Studio::Studio(QMainWindow& window)
    : window_(window),
      commands_(&window),
      easel_(std::make_unique<tools::Easel>(
          tools::Hand{}, [this](const document::Action& action) { post(action); },
          [this] { session_->note_hand(); })),
      canvas_(new view::CanvasView),
      well_(new view::CanvasView(document::Surface::Well)),
      on_canvas_(new interactions::OnCanvas(canvas_, *easel_, document::Surface::Canvas)),
      on_well_(new interactions::OnCanvas(well_, *easel_, document::Surface::Well)),
      ending_([](auto& session) { session.reset(); },
              [tell = teller()](auto&, const core::Message& fault) { tell(fault); }) {
    if (auto* application = qobject_cast<Application*>(QCoreApplication::instance()))
        connect(application, &Application::failed, this, &Studio::report_refusal, Qt::QueuedConnection);
    const std::string& problem = graphics::opengl_support().problem;
    if (!problem.empty()) note_fall_back(QString::fromStdString(problem));
    for (view::CanvasView* view : views())
        connect(view, &view::CanvasView::fell_back, this, &Studio::note_fall_back);
    constexpr int kReadingTime_ms = 12000;
    connect(&messages_, &panels::MessageLog::passed, this, [this](const QString& sentence) {
        window_.statusBar()->showMessage(sentence, kReadingTime_ms);
    });
}

void Studio::put_up(std::unique_ptr<core::ThreadPool> pool, std::unique_ptr<document::Painting> painting,
                    document::Recording past, std::unique_ptr<journal::JournalWriter> journal,
                    session::PaintSession::BeginJournal begin_journal) {
    if (session_) {
        Q_EMIT session_ends();
        session_->discard_journal();
    }
    for (const panels::Matter matter :
         {panels::Matter::Saving, panels::Matter::Opening, panels::Matter::Notes})
        messages_.solve(matter);
    if (session_) ending_.add(std::move(session_));
    session_ = std::make_unique<session::PaintSession>(
        std::move(pool), std::move(painting), queued_refresh(this, [this] { show_published(); }),
        std::move(past), commands_.action(commands::Command::Pause)->isChecked(), std::move(journal),
        std::move(begin_journal));
    session_->measure(times_);
    on_canvas_->paint.forget_posted();
    Q_EMIT session_begun();
}

void Studio::post(const document::Action& action) {
    on_canvas_->paint.note_posted(action, session_->post(action));
}

void Studio::measure(std::shared_ptr<session::FrameTimes> times) {
    const bool first = times_ == nullptr;
    times_ = std::move(times);
    session_->measure(times_);
    if (!first) return;
    connect(canvas_, &view::CanvasView::pointer_heard, this,
            [this](double device_ms) { times_->heard(device_ms, session::FrameTimes::Clock::now()); });
    connect(&on_canvas_->paint, &interactions::Paint::marked, this, [this] { times_->marked(); });
    connect(canvas_, &view::CanvasView::frame_came, this,
            [this] { times_->presented(canvas_->shown(), session::FrameTimes::Clock::now()); });
}

void Studio::show_published() {
    const auto snapshot = session_->snapshot();
    const session::Status status = session_->status();
    Q_EMIT published(snapshot, status);
    easel_->lend_brush(status.replaying);
    if (status.failed) commands_.action(commands::Command::Pause)->setChecked(true);
    for (const core::Message& error : session_->take_errors())
        report_refusal(appearance::shown_message(error));
}

void Studio::catch_up() {
    session_->wait_until_applied();
    show_published();
}

void Studio::choose_paint(const document::PaintRecipe& paint) {
    easel_->choose_paint(paint);
    show_hand();
}

void Studio::note_fall_back(const QString& sentence) {
    messages_.raise(
        {panels::Matter::Screen,
         tr("%1 From now on the processor draws the canvas, which is slower.").arg(sentence)});
}

void Studio::report(const QString& sentence) {
    messages_.add(sentence);
}

void Studio::report_refusal(const QString& sentence) {
    report(appearance::as_sentence(sentence));
}

void Studio::report_notes(const QString& file, const std::vector<core::Message>& notes) {
    using panels::Matter;
    if (notes.size() == 1) {
        messages_.raise({Matter::Notes, appearance::shown_sentence(notes.front())});
        return;
    }
    for (const core::Message& note : notes)
        report(appearance::shown_sentence(note));
    if (notes.empty()) return;
    QAction* show = commands_.action(commands::Command::MessagesPanel);
    messages_.raise({Matter::Notes,
                     tr("%1 is open, and %n note(s) tell what is not as it was in the file.", nullptr,
                        static_cast<int>(notes.size()))
                         .arg(file),
                     tr("Show them"), [show] { show->trigger(); }});
}

bool Studio::attempt(const Work& work) {
    const core::Message fault = core::fault_of(work);
    if (!fault.empty()) report(appearance::shown_sentence(fault));
    return fault.empty();
}

bool Studio::attempt(const QString& title, const Work& work) {
    const core::Message fault = core::fault_of(work);
    if (fault.empty()) return true;
    report(appearance::shown_sentence(fault));
    QMessageBox::warning(&window_, title, appearance::shown_sentence(fault));
    return false;
}

core::Tell Studio::teller() {
    return [this](const core::Message& sentence) {
        QMetaObject::invokeMethod(
            this, [this, told = appearance::shown_message(sentence)] { report_refusal(told); },
            Qt::QueuedConnection);
    };
}

}  // namespace pastoso::main
