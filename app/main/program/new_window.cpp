#include "main/program/new_window.hpp"

#include <QCoreApplication>
#include <QProcess>

namespace pastoso::main {

NewWindow::NewWindow(Studio& studio)
    : studio_(studio), program_(QCoreApplication::applicationFilePath()) {
    studio_.commands().on(commands::Command::NewWindow, [this](bool) { open({}); });
}

/// What fails in one of them leaves the other as it is.
void NewWindow::open(const QString& file) {
    const QStringList arguments = file.isEmpty() ? QStringList() : QStringList(file);
    if (QProcess::startDetached(program_, arguments)) return;
    studio_.report(tr("%1 cannot be started: there is no other window.").arg(program_));
}

}  // namespace pastoso::main
