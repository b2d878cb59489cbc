// The part of ProjectFiles that keeps paintings on the disk as they grow, and finds those that were left
// unfinished.

#include "appearance/shown_message.hpp"
#include "commands/file_stamp.hpp"
#include "core/disk.hpp"
#include "core/error.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "journal/recovery.hpp"
#include "main/files/journal_starts.hpp"
#include "main/files/project_files.hpp"

#include <chrono>
#include <sys/stat.h>
#include <utility>

#include <QFileInfo>
#include <QLocale>
#include <QMainWindow>
#include <QPointer>

namespace pastoso::main {

namespace {

using panels::Matter;

/// On the disk that holds that folder.
QString free_room(const std::filesystem::path& folder) {
    const auto bytes = core::free_bytes(folder);
    return bytes ? QLocale().formattedDataSize(static_cast<qint64>(*bytes)) : QStringLiteral("?");
}

/// Nobody else has written to the file after the journal.
bool is_as_left(const std::filesystem::path& file, const std::filesystem::path& journal) {
    struct stat known {};
    return ::stat(file.c_str(), &known) == 0 &&
           std::chrono::system_clock::from_time_t(known.st_mtime) <= journal::last_written(journal);
}

}  // namespace

/// A painting out of the journal in which it was left, in this program's hands.
struct ProjectFiles::RecoveredPainting {
    journal::Claim claim;
    std::shared_ptr<const journal::Recovered> state;
    std::optional<commands::FileStamp> stamp;  ///< of its file
    SharedPainting painting;

    static RecoveredPainting from(const std::filesystem::path& folder, const JournalTerms& terms,
                                  const core::Progress& progress);
};

ProjectFiles::RecoveredPainting ProjectFiles::RecoveredPainting::from(
    const std::filesystem::path& folder, const JournalTerms& terms, const core::Progress& progress) {
    auto claim = journal::Claim::on(folder);
    if (!claim) throw core::InputError("%1: another program is at it.", folder.string());
    auto pool = std::make_unique<core::ThreadPool>();
    const auto state =
        std::make_shared<const journal::Recovered>(journal::recover(folder, *pool, progress));
    // Of a file that was written to since, any content is another one.
    const auto stamp =
        is_as_left(state->file, folder) ? commands::stamp_of(state->file) : commands::FileStamp{};
    auto painting = std::make_shared<PreparedPainting>(
        made_of(state->painting, state->strokes, std::move(pool)),
        journal::Beginning{
            .painting = state->file, .write_start = saved_start(state), .is_saved = false},
        terms);
    return {std::move(*claim), state, stamp, std::move(painting)};
}

JournalTerms ProjectFiles::journal_terms() {
    const std::uint64_t number = ++journals_;
    if (!keeps_journal_) return {.number = number};
    // The journal outlives these files, but not the studio.
    const auto told = [studio = &studio_, files = QPointer(this),
                       number](const journal::Trouble& trouble) {
        QMetaObject::invokeMethod(
            studio,
            [files, number, trouble] {
                if (files != nullptr && files->journal_ == number) files->show_trouble(trouble);
            },
            Qt::QueuedConnection);
    };
    return {journal::journals_path(), told, number};
}

/// Says where, how much, and what to do.
void ProjectFiles::show_trouble(const journal::Trouble& trouble) {
    if (trouble.reason.empty()) {
        if (studio_.messages().solve(Matter::Journal))
            studio_.report(tr("What you paint is kept again."));
        return;
    }
    const std::filesystem::path root = journal::journals_path();
    const QString place = QString::fromStdString(root.string());
    const QString reason = appearance::shown_message(trouble.reason);
    QString sentence;
    if (trouble.strokes_are_kept)
        sentence = tr("Should the program fail, this painting would come back slowly, from its strokes "
                      "alone: %1 %2 are free there. Make room; you can paint on.")
                       .arg(reason, free_room(root));
    else if (trouble.disk_is_full)
        sentence =
            tr("The disk is full: what you paint now would be lost if the program failed. It is "
               "kept in %1, where %2 are free and %3 wait to be written. Make room there, or save "
               "the painting to another disk. You can paint on; as soon as there is room, all of "
               "it is kept again.")
                .arg(place, free_room(root),
                     QLocale().formattedDataSize(static_cast<qint64>(trouble.waiting_bytes)));
    else
        sentence = tr("What you paint now would be lost if the program failed: %1 %2 are free there. "
                      "Make room, or save the painting to another disk. You can paint on; as soon as it "
                      "can be, all of it is kept again.")
                       .arg(reason, free_room(root));
    studio_.messages().raise({Matter::Journal, sentence});
}

void ProjectFiles::recover_painting(const std::filesystem::path& folder) {
    make(tr("Recovering the painting"),
         [this, folder, terms = journal_terms()](const core::Progress& progress) {
             const auto found =
                 std::make_shared<RecoveredPainting>(RecoveredPainting::from(folder, terms, progress));
             return [this, found] { put_up_recovered(*found); };
         });
}

/// Until the painting stands in a journal of its own, the old one stays.
void ProjectFiles::put_up_recovered(RecoveredPainting& found) {
    put_up(*found.painting);
    path_ = QString::fromStdString(found.state->file);
    stamp_ = found.stamp;
    show_unsaved();
    take_up_hand(found.state->strokes);
    studio_.show_published();
    studio_.report_notes(path_.isEmpty() ? tr("The painting") : QFileInfo(path_).fileName(),
                         found.state->notes);
    if (studio_.session().has_journal()) found.claim.discard();
}

void ProjectFiles::offer_recovery() {
    std::vector<journal::Unfinished> paintings;
    studio_.attempt([&] { paintings = journal::unfinished_paintings(journal::journals_path()); });
    if (paintings.empty()) return;
    dialogs::RecoveryDialog dialog(std::move(paintings), &studio_.window());
    if (dialog.exec() == QDialog::Accepted) ask_to_recover(dialog.chosen().folder);
}

}  // namespace pastoso::main
