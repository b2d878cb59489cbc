#include "commands/command_registry.hpp"

#include "core/check.hpp"

#include <utility>

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>

namespace pastoso::commands {

CommandRegistry::CommandRegistry(QObject* owner) {
    for (const CommandText& text : command_list()) {
        auto* action = new QAction(QString::fromUtf8(text.words), owner);
        action->setShortcuts(QKeySequence::listFromString(QString::fromUtf8(text.keys)));
        const QString hint = QString::fromUtf8(text.hint);
        action->setStatusTip(hint);
        const QString keys = action->shortcut().toString();
        action->setToolTip(keys.isEmpty() ? hint : QStringLiteral("%1  (%2)").arg(hint, keys));
        action->setCheckable(text.checkable);
        actions_[text.command] = action;
    }
}

QAction* CommandRegistry::action(Command command) const {
    const auto found = actions_.find(command);
    PASTOSO_CHECK(found != actions_.end());
    return found->second;
}

void CommandRegistry::on(Command command, std::function<void(bool)> handler) const {
    QAction* source = action(command);
    QObject::connect(source, &QAction::triggered, source, std::move(handler));
}

void CommandRegistry::fill(QMenuBar* bar) const {
    std::map<std::string, QMenu*> menus;
    for (const CommandText& text : command_list()) {
        QMenu*& menu = menus[text.menu];
        if (menu == nullptr) menu = bar->addMenu(QString::fromUtf8(text.menu));
        if (text.starts_group) menu->addSeparator();
        menu->addAction(action(text.command));
    }
}

}  // namespace pastoso::commands
