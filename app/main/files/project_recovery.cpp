// The part of ProjectFiles that keeps paintings on the disk as they grow, and finds those that were left
// unfinished.

#include "core/error.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "journal/recovery.hpp"
#include "main/files/project_files.hpp"
#include "project/project.hpp"

#include <utility>

#include <QMainWindow>

namespace pastoso::main {

/// A painting that cannot be kept there is painted nevertheless, and the painter knows.
std::unique_ptr<journal::JournalWriter> ProjectFiles::new_journal(const journal::Beginning& beginning) {
    const std::filesystem::path root = journal::journals_path();
    if (!keeps_journal_ || root.empty()) return nullptr;
    std::unique_ptr<journal::JournalWriter> journal;
    core::guarded(
        [&] { journal = std::make_unique<journal::JournalWriter>(root, beginning); },
        [this](const std::string& fault) { studio_.report_refusal(QString::fromStdString(fault)); });
    return journal;
}

void ProjectFiles::recover_painting(const std::filesystem::path& folder) {
    auto claim = journal::Claim::on(folder);
    if (!claim) throw core::InputError(folder.string() + ": another program is at it.");
    auto pool = std::make_unique<core::ThreadPool>();
    journal::Recovered recovered = journal::recover(folder, *pool);
    auto painting = std::make_unique<document::Painting>(recovered.painting, *pool);
    core::ThreadPool& threads = *pool;
    // Until the painting stands in a journal of its own, the old one stays.
    start(std::move(pool), std::move(painting), recovered.strokes,
          {.painting = recovered.file,
           .write_start =
               [&](const std::filesystem::path& start) {
                   project::save_project(start, recovered, threads);
               },
           .is_saved = false});
    path_ = QString::fromStdString(recovered.file);
    show_unsaved();
    take_up_hand(recovered.strokes);
    studio_.show_published();
    for (const std::string& note : recovered.notes)
        studio_.report(QString::fromStdString(note));
    if (studio_.session().has_journal()) claim->discard();
}

void ProjectFiles::offer_recovery() {
    auto paintings = journal::unfinished_paintings(journal::journals_path());
    if (paintings.empty()) return;
    dialogs::RecoveryDialog dialog(std::move(paintings), &studio_.window());
    if (dialog.exec() != QDialog::Accepted) return;
    ask_to_recover(dialog.chosen().folder);
}

}  // namespace pastoso::main
