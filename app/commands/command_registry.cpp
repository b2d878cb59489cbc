#include "commands/command_registry.hpp"

#include "appearance/icon.hpp"
#include "commands/command_names.hpp"
#include "commands/command_words.hpp"
#include "core/check.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>

namespace pastoso::commands {
namespace {

void show_keys(QAction* action, const QList<QKeySequence>& keys) {
    action->setShortcuts(keys);
    const QString hint = action->statusTip();
    action->setToolTip(
        keys.isEmpty()
            ? hint
            : QStringLiteral("%1  (%2)").arg(hint, keys.front().toString(QKeySequence::NativeText)));
}

}  // namespace

CommandRegistry::CommandRegistry(QObject* owner) {
    for (const CommandText& text : command_list()) {
        auto* action = new QAction(words_of(text.words), owner);
        // Qt would leave "(N)" of mnemonics that stand behind the words.
        action->setIconText(plain_words(text.words));
        action->setStatusTip(words_of(text.hint));
        action->setCheckable(text.checkable);
        action->setIcon(appearance::icon(QString::fromUtf8(name_of(text.command))));
        action->setIconVisibleInMenu(!text.checkable);  // menus show either the icon or the check mark
        actions_[text.command] = action;
        on(text.command, [this, command = text.command](bool) { note(command); });
    }
    use_keys(bindings_);
    set_mode(mode_);
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
        if (menu == nullptr) menus_.push_back(menu = bar->addMenu(words_of(text.menu)));
        if (text.starts_group) menu->addSeparator();
        menu->addAction(action(text.command));
    }
}

/// Qt keeps what is said of an invisible action's being enabled until it is seen again.
void CommandRegistry::set_mode(Mode mode) {
    mode_ = mode;
    for (const CommandText& text : command_list())
        action(text.command)->setVisible(meet(text.mode, mode));
    for (QMenu* menu : menus_) {
        const QList<QAction*> actions = menu->actions();
        menu->menuAction()->setVisible(std::any_of(
            actions.begin(), actions.end(),
            [](const QAction* action) { return action->isVisible() && !action->isSeparator(); }));
    }
}

/// First taken from all, so that none has a key at any moment that another has still.
void CommandRegistry::use_keys(const KeyBindings& bindings) {
    bindings_ = bindings;
    for (const auto& [command, action] : actions_)
        action->setShortcuts(QList<QKeySequence>());
    for (const auto& [command, action] : actions_)
        show_keys(action, bindings_.keys(command));
}

/// Looking for a command is none that is looked for.
void CommandRegistry::note(Command command) {
    if (command == Command::FindCommand) return;
    std::erase(recent_, command);
    recent_.insert(recent_.begin(), command);
}

}  // namespace pastoso::commands
