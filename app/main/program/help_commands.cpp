#include "main/program/help_commands.hpp"

#include "core/looking.hpp"
#include "core/resources.hpp"
#include "help/about_dialog.hpp"
#include "help/topic.hpp"
#include "main/program/folder_facts.hpp"
#include "main/program/machine_facts.hpp"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

/// "zh_TW", "sv"; a manual of a language that there is none in is English.
help::Manual manual() {
    const std::filesystem::path folder = core::resource_path("manual");
    const QString name = QLocale().name();
    const bool is_whole = core::is_folder(folder / name.toStdString());
    return {folder, is_whole ? name : name.section(QLatin1Char('_'), 0, 0)};
}

/// What the pointer is over, or else what has the keys; beside a dialog, what in that dialog.
QString topic_here() {
    const QWidget* dialog = QApplication::activeModalWidget();
    for (const QWidget* widget : {static_cast<const QWidget*>(QApplication::widgetAt(QCursor::pos())),
                                  static_cast<const QWidget*>(QApplication::focusWidget()), dialog}) {
        const bool is_meant = dialog == nullptr || widget == dialog || dialog->isAncestorOf(widget);
        const QString topic = is_meant ? help::topic_of(widget) : QString();
        if (!topic.isEmpty()) return topic;
    }
    return {};
}

}  // namespace

HelpCommands::HelpCommands(Studio& studio) : studio_(studio) {
    studio_.commands().on(Command::Manual, [this](bool) { open(); });
    studio_.commands().on(Command::WhatIsNew, [this](bool) { show_news(); });
    studio_.commands().on(Command::About, [this](bool) { show_about(); });
    help::set_topic(studio_.well(), "paint#the-mixing-well");
    qApp->installEventFilter(this);
}

/// A window beside a dialog that keeps others from being used belongs to that dialog.
help::HelpWindow& HelpCommands::window() {
    QWidget* modal = QApplication::activeModalWidget();
    QWidget* parent = modal == nullptr ? &studio_.window() : modal;
    if (window_ != nullptr && window_->parentWidget() != parent) delete window_;
    if (window_ == nullptr) window_ = new help::HelpWindow(manual(), parent);
    return *window_;
}

void HelpCommands::open() {
    const QString topic = topic_here();
    studio_.attempt(QObject::tr("Manual"), [&] { window().open_at(topic); });
}

void HelpCommands::show_news() {
    studio_.attempt(QObject::tr("What is new"), [&] { window().open_news(); });
}

void HelpCommands::show_about() {
    studio_.attempt(QObject::tr("About Pastoso"), [&] {
        const help::Manual pages = manual();
        help::AboutDialog dialog(pages, machine_facts(), folder_facts(), &studio_.window());
        dialog.exec();
    });
}

bool HelpCommands::eventFilter(QObject* receiver, QEvent* event) {
    const bool is_key = event->type() == QEvent::KeyPress && receiver->isWidgetType();
    if (!is_key || QApplication::activeModalWidget() == nullptr) return false;
    const QKeySequence key(static_cast<QKeyEvent*>(event)->keyCombination());
    if (!studio_.commands().action(Command::Manual)->shortcuts().contains(key)) return false;
    open();
    return true;
}

}  // namespace pastoso::main
