// Paintings that are kept on the disk as they grow, and those that were left unfinished.

#include "core/error.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "journal/recovery.hpp"
#include "main/main_window.hpp"
#include "panels/status_readings.hpp"

#include <utility>

#include <QGuiApplication>
#include <QMessageBox>

namespace pastoso::main {

/// A painting that cannot be kept there is painted nevertheless, and the painter knows.
std::unique_ptr<journal::JournalWriter> MainWindow::new_journal(const journal::Beginning& beginning) {
    const std::filesystem::path root = journal::journals_path();
    if (!keeps_journal_ || root.empty()) return nullptr;
    try {
        return std::make_unique<journal::JournalWriter>(root, beginning);
    } catch (const std::exception& failure) {
        report(QString::fromUtf8(failure.what()));
        return nullptr;
    }
}

void MainWindow::recover_painting(const std::filesystem::path& folder) {
    auto claim = journal::Claim::on(folder);
    if (!claim) throw core::InputError(folder.string() + ": another program is at it.");
    auto pool = std::make_unique<core::ThreadPool>();
    journal::Recovered recovered = journal::recover(folder, *pool);
    auto painting = std::make_unique<document::Painting>(recovered.painting, *pool);
    core::ThreadPool& threads = *pool;
    // Until the painting stands in a journal of its own, the old one stays.
    start_session(std::move(pool), std::move(painting), recovered.strokes,
                  {.painting = recovered.file,
                   .write_start =
                       [&](const std::filesystem::path& start) {
                           project::save_project(start, recovered, threads);
                       },
                   .is_saved = false});
    path_ = QString::fromStdString(recovered.file);
    saved_changes_ = -1;
    show_title();
    setWindowModified(true);
    take_up_hand(recovered.strokes);
    readings_->show_canvas(session_->canvas());
    show_published();
    for (const std::string& note : recovered.notes)
        report(QString::fromStdString(note));
    if (session_->has_journal()) claim->discard();
}

void MainWindow::offer_recovery() {
    auto paintings = journal::unfinished_paintings(journal::journals_path());
    if (paintings.empty()) return;
    dialogs::RecoveryDialog dialog(std::move(paintings), this);
    if (dialog.exec() != QDialog::Accepted) return;
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    QString fault;
    try {
        recover_painting(dialog.chosen().folder);
    } catch (const core::InputError& error) {
        fault = QString::fromUtf8(error.what());
    }
    QGuiApplication::restoreOverrideCursor();
    if (!fault.isEmpty()) QMessageBox::warning(this, tr("Recover"), fault);
}

}  // namespace pastoso::main
