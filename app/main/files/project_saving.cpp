// The part of ProjectFiles that saves, and asks first where something would be lost by it.

#include "commands/painting_version.hpp"
#include "commands/recent_paintings.hpp"
#include "dialogs/replace_question.hpp"
#include "main/files/project_files.hpp"
#include "main/wait_cursor.hpp"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>

namespace pastoso::main {
namespace {

using panels::Matter;

QString with_ending(const QString& path) {
    return path.endsWith(QStringLiteral(".pastoso")) ? path : path + QStringLiteral(".pastoso");
}

bool same_file(const QString& a, const QString& b) {
    return QFileInfo(a).absoluteFilePath() == QFileInfo(b).absoluteFilePath();
}

}  // namespace

void ProjectFiles::save_painting(const QString& path, core::Replaced replaced) {
    Q_EMIT about_to_keep();
    saver_.wait();
    session::Capture capture = studio_.session().capture();
    studio_.report(tr("Saving %1...").arg(path));
    Saving saving{.path = path, .changes = capture.changes, .journal_events = capture.journal_events};
    saving.number = saver_.save(std::move(capture.painting), std::move(capture.record), path, replaced);
    saving_ = saving;
}

/// Of a painting that is not on the easel any more, only what became of its file is told.
void ProjectFiles::end_saving(const commands::SaveOutcome& outcome) {
    const bool is_ours = saving_ && saving_->number == outcome.number;
    const auto saving = is_ours ? std::exchange(saving_, std::nullopt) : std::nullopt;
    if (!outcome.error.isEmpty() && !saving) return studio_.report(outcome.error);
    if (!outcome.error.isEmpty()) {
        studio_.messages().raise(
            {Matter::Saving,
             tr("%1 The painting is not saved: make room or choose another place, and save again.")
                 .arg(outcome.error),
             tr("Save as..."), [this] { ask_save_painting(); }});
        return;
    }
    commands::remember_painting(outcome.path.toStdString());
    studio_.report(tr("Saved %1.").arg(outcome.path));
    if (!saving) return;
    studio_.messages().solve(Matter::Saving);
    studio_.session().note_saved(outcome.path.toStdString(), saving->journal_events);
    path_ = outcome.path;
    stamp_ = outcome.stamp;
    saved_changes_ = saving->changes;
    show_title();
    show_modified();
}

/// Why the painter is asked before that file is replaced; empty: nothing speaks against it.
QString ProjectFiles::objection_to(const QString& path) const {
    const std::filesystem::path file = path.toStdString();
    if (stamp_ && same_file(path, path_)) {
        const auto found = commands::stamp_of(file);
        if (found && found != stamp_)
            return tr("Another program has changed %1 since you opened or saved it here. Replacing it "
                      "loses what was changed there.")
                .arg(path);
    }
    if (core::is_write_protected(file))
        return tr("%1 is protected against being written to.").arg(path);
    return {};
}

bool ProjectFiles::save_to(const QString& path) {
    saver_.wait();
    const QString objection = objection_to(path);
    if (!objection.isEmpty()) {
        switch (dialogs::ask_replacing(objection, &studio_.window())) {
            case dialogs::Replacing::Cancel:
                return false;
            case dialogs::Replacing::SaveAs:
                return ask_save_painting();
            case dialogs::Replacing::Replace:
                break;
        }
    }
    const auto agreed = objection.isEmpty() ? core::Replaced::Writable : core::Replaced::Any;
    return studio_.attempt(tr("Save"), [&] { save_painting(path, agreed); });
}

bool ProjectFiles::save() {
    const QString file = saving_ ? saving_->path : path_;
    return file.isEmpty() ? ask_save_painting() : save_to(file);
}

/// A file that has come to have that name meanwhile stays.
void ProjectFiles::save_version() {
    saver_.wait();
    if (path_.isEmpty()) {
        ask_save_painting();
        return;
    }
    studio_.attempt(tr("Save a version"), [this] {
        const std::filesystem::path next = commands::next_version(path_.toStdString());
        save_painting(QString::fromStdString(next.string()), core::Replaced::None);
    });
}

bool ProjectFiles::ask_save_painting() {
    const QString proposal = path_.isEmpty() ? tr("painting.pastoso") : path_;
    QFileDialog dialog(&studio_.window(), tr("Save"), proposal, tr("Paintings (*.pastoso)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pastoso"));
    dialog.selectFile(proposal);
    if (dialog.exec() != QDialog::Accepted) return false;
    return save_to(with_ending(dialog.selectedFiles().front()));
}

/// Saving ends a stroke in progress, so it waits for the hand; who paints is asked nothing.
void ProjectFiles::save_by_itself() {
    const session::Status status = studio_.session().status();
    const std::int64_t kept = saving_ ? saving_->changes : saved_changes_;
    const bool needed = !path_.isEmpty() && status.changes != kept;
    save_waits_ = needed && status.stroke_in_progress;
    if (!needed || save_waits_) return;
    saver_.wait();
    const QString objection = objection_to(path_);
    if (objection.isEmpty()) {
        studio_.attempt([this] { save_painting(path_); });
        return;
    }
    studio_.messages().raise({Matter::Saving,
                              tr("%1 The painting was not saved by itself.").arg(objection),
                              tr("Save..."), [this] { save(); }});
}

/// Whether nothing would be lost with this painting, or the painter agrees to lose it.
bool ProjectFiles::may_discard() {
    Q_EMIT about_to_keep();
    studio_.session().wait_until_applied();
    saver_.wait();
    if (studio_.session().status().changes == saved_changes_) return true;
    QMessageBox question(QMessageBox::Question, tr("Pastoso"),
                         tr("The painting on the easel has changes that are not saved."),
                         QMessageBox::Save | QMessageBox::Cancel, &studio_.window());
    question.addButton(tr("Discard them"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Cancel) return false;
    if (answer != QMessageBox::Save) return true;
    if (!save()) return false;
    const WaitCursor waiting;
    return saver_.wait().isEmpty();
}

}  // namespace pastoso::main
