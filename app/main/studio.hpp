// What the parts of the window share: the painting that is worked on, the hand that paints it, the views
// that show it, the commands, and the messages in which the painter is told what happens.
#pragma once

#include "commands/command_registry.hpp"
#include "core/fault.hpp"
#include "core/worker.hpp"
#include "interactions/on_canvas.hpp"
#include "panels/messages/message_log.hpp"
#include "session/paint_session.hpp"
#include "tools/easel.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

class QMainWindow;

namespace pastoso::main {

class Studio : public QObject {
    Q_OBJECT
  public:
    /// There is no session before the first put_up(). The views become `window`'s where they are laid
    /// out.
    explicit Studio(QMainWindow& window);

    /// The parent of whatever is asked of the painter.
    QMainWindow& window() { return window_; }
    commands::CommandRegistry& commands() { return commands_; }
    const commands::CommandRegistry& commands() const { return commands_; }
    tools::Easel& easel() { return *easel_; }
    const tools::Easel& easel() const { return *easel_; }
    session::PaintSession& session() { return *session_; }
    const session::PaintSession& session() const { return *session_; }
    view::CanvasView& canvas() { return *canvas_; }
    const view::CanvasView& canvas() const { return *canvas_; }
    view::CanvasView& well() { return *well_; }
    std::array<view::CanvasView*, 2> views() const { return {canvas_, well_}; }

    /// What the pointer does over them.
    interactions::OnCanvas& on_canvas() { return *on_canvas_; }
    const interactions::OnCanvas& on_canvas() const { return *on_canvas_; }
    std::array<interactions::OnCanvas*, 2> on_views() const { return {on_canvas_, on_well_}; }

    /// Puts another painting on the easel in place of the one before, whose journal goes; as
    /// session::PaintSession does it.
    void put_up(std::unique_ptr<core::ThreadPool> pool, std::unique_ptr<document::Painting> painting,
                document::Recording past, std::unique_ptr<journal::JournalWriter> journal,
                session::PaintSession::BeginJournal begin_journal);

    /// The finest cells on which this machine keeps pace with the hand: for new canvases.
    double live_px_per_mm() const { return live_px_per_mm_; }
    void set_live_px_per_mm(double px_per_mm) { live_px_per_mm_ = px_per_mm; }

    /// From now on all sessions tell these how long the painter waits, and the canvas how long what they
    /// publish takes to the screen.
    void measure(std::shared_ptr<session::FrameTimes> times);

    /// Shows what the session has published last.
    void show_published();
    /// Waits until all that was posted is applied, and shows it.
    void catch_up();

    /// Shows what the easel's hand holds, after a change of it.
    void show_hand() { Q_EMIT hand_changed(easel_->hand()); }
    void choose_paint(const document::PaintRecipe& paint);

    /// What the painter is told, and what of it stands.
    panels::MessageLog& messages() { return messages_; }

    /// Tells a sentence, which passes in the status line.
    void report(const QString& sentence);
    /// The same of the engine's, which begin small, since many stand behind the name of a file.
    void report_refusal(const QString& sentence);
    /// The same from any thread, a little later.
    core::Tell teller();

    /// What of a file is not as it was in it: told one by one, and what is only one stands; of more,
    /// how many there are.
    void report_notes(const QString& file, const std::vector<core::Message>& notes);

    using Work = std::function<void()>;
    /// Whatever `work` throws is reported; returns whether it threw nothing.
    bool attempt(const Work& work);
    /// The same for what the painter has just asked for and waits for: told under `title` in a dialog.
    bool attempt(const QString& title, const Work& work);

  Q_SIGNALS:
    void session_ends();   ///< another painting comes
    void session_begun();  ///< it is there, and not shown yet
    void published(const std::shared_ptr<const pastoso::document::Snapshot>& painting,
                   const pastoso::session::Status& status);
    void hand_changed(const pastoso::tools::Hand& hand);

  private:
    void post(const document::Action& action);
    void note_fall_back(const QString& sentence);

    QMainWindow& window_;
    panels::MessageLog messages_;
    commands::CommandRegistry commands_;
    std::unique_ptr<tools::Easel> easel_;
    std::unique_ptr<session::PaintSession> session_;
    std::shared_ptr<session::FrameTimes> times_;
    double live_px_per_mm_ = document::CanvasSettings{}.px_per_mm;
    view::CanvasView* canvas_;
    view::CanvasView* well_;
    interactions::OnCanvas* on_canvas_;  ///< the views' own
    interactions::OnCanvas* on_well_;
    /// Sessions of paintings that have left the easel: their end waits for the tick that they are at.
    core::Worker<std::unique_ptr<session::PaintSession>> ending_;
};

}  // namespace pastoso::main
