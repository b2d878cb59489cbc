#include "dialogs/keys_dialog.hpp"

#include "appearance/theme.hpp"
#include "commands/command_search.hpp"
#include "commands/command_words.hpp"
#include "dialogs/key_catcher.hpp"
#include "dialogs/keys_column.hpp"

#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeWidget>

namespace pastoso::dialogs {
namespace {

using commands::Command;
using commands::KeyBindings;

constexpr int kCommandRole = Qt::UserRole + 1;
constexpr int kWordsWidth = 330;

QString text_of(const QKeySequence& key) {
    return key.toString(QKeySequence::NativeText);
}

QString name_in_menu(Command command) {
    const commands::CommandText& text = commands::text_of(command);
    return QStringLiteral("%1 › %2").arg(commands::plain_words(text.menu),
                                         commands::plain_words(text.words));
}

}  // namespace

KeysDialog::KeysDialog(KeyBindings bindings, QWidget* parent)
    : GrowingDialog(parent), bindings_(std::move(bindings)) {
    setWindowTitle(tr("Keys"));
    setObjectName(QStringLiteral("keys_dialog"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 14);
    column->setSpacing(10);
    column->addWidget(make_head());
    column->addWidget(make_tree(), 1);
    column->addWidget(make_chosen());
    column->addWidget(make_question());
    column->addWidget(make_foot());
    resize(660, 700);
    show_keys();
    tree_->setCurrentItem(tree_->topLevelItem(0)->child(0));
    typed_->setFocus();
}

// ---- what stands where

QWidget* KeysDialog::make_head() {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    sets_ = new QComboBox;
    sets_->setObjectName(QStringLiteral("sets"));
    sets_->setAccessibleName(tr("Set of keys"));
    for (const commands::KeySetText& set : commands::key_sets()) {
        sets_->addItem(QCoreApplication::translate("Keys", set.words), static_cast<int>(set.set));
        sets_->setItemData(sets_->count() - 1, QCoreApplication::translate("Keys", set.hint),
                           Qt::ToolTipRole);
    }
    sets_->setCurrentIndex(sets_->findData(static_cast<int>(bindings_.set())));
    sets_->setToolTip(tr("What the keys are to start with; keys of your own stay"));
    connect(sets_, &QComboBox::activated, this, [this] {
        bindings_.choose(static_cast<commands::KeySet>(sets_->currentData().toInt()));
        change();
    });
    typed_ = new QLineEdit;
    typed_->setObjectName(QStringLiteral("typed"));
    typed_->setPlaceholderText(tr("Find by words, or by keys such as Ctrl+J"));
    typed_->setAccessibleName(typed_->placeholderText());
    typed_->setClearButtonEnabled(true);
    connect(typed_, &QLineEdit::textChanged, this, &KeysDialog::filter);
    row->addWidget(sets_);
    row->addWidget(typed_, 1);
    return head;
}

QWidget* KeysDialog::make_tree() {
    tree_ = new QTreeWidget;
    tree_->setObjectName(QStringLiteral("commands"));
    tree_->setAccessibleName(tr("Commands"));
    tree_->setColumnCount(2);
    tree_->setHeaderHidden(true);
    tree_->setRootIsDecorated(false);
    tree_->setIndentation(14);
    tree_->setUniformRowHeights(true);
    tree_->setItemDelegateForColumn(1, new KeysColumn(tree_));
    tree_->header()->resizeSection(0, kWordsWidth);
    std::map<std::string, QTreeWidgetItem*> menus;
    for (const commands::CommandText& text : commands::command_list()) {
        QTreeWidgetItem*& menu = menus[text.menu];
        if (menu == nullptr) {
            menu = new QTreeWidgetItem(tree_, {commands::plain_words(text.menu)});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setForeground(0, appearance::colours().quiet_text);
            menu->setExpanded(true);
        }
        auto* row = new QTreeWidgetItem(menu, {commands::plain_words(text.words)});
        row->setData(0, kCommandRole, static_cast<int>(text.command));
        row->setToolTip(0, commands::words_of(text.hint));
        row->setToolTip(1, tr("Click, and press other keys"));
        rows_[text.command] = row;
    }
    none_ = new QTreeWidgetItem(tree_, {tr("No command has such words or keys.")});
    none_->setFlags(Qt::NoItemFlags);
    none_->setForeground(0, appearance::colours().quiet_text);
    none_->setFirstColumnSpanned(true);
    none_->setHidden(true);
    connect(tree_, &QTreeWidget::currentItemChanged, this,
            [this](const QTreeWidgetItem* now, const QTreeWidgetItem* before) {
                if (now != before) show_chosen();  // it may be but another column
            });
    connect(tree_, &QTreeWidget::itemActivated, this, &KeysDialog::listen_for_chosen);
    connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem*, int column) {
        if (column == 1) listen_for_chosen();
    });
    return tree_;
}

QWidget* KeysDialog::make_chosen() {
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 2, 0, 0);
    column->setSpacing(7);
    name_ = new QLabel;
    name_->setObjectName(QStringLiteral("heading"));
    hint_ = new QLabel;
    hint_->setWordWrap(true);
    auto* row = new QWidget;
    keys_ = new QHBoxLayout(row);
    keys_->setContentsMargins(0, 0, 0, 0);
    keys_->setSpacing(2);
    add_ = new KeyCatcher(tr("Add a key"));
    add_->setObjectName(QStringLiteral("add_key"));
    connect(add_, &KeyCatcher::caught, this,
            [this](const QKeySequence& key) { catch_key(key, QKeySequence()); });
    reset_ = new QPushButton(tr("As the set has it"));
    reset_->setObjectName(QStringLiteral("reset_one"));
    reset_->setAutoDefault(false);
    connect(reset_, &QPushButton::clicked, this, &KeysDialog::reset_chosen);
    keys_->addWidget(add_);
    keys_->addStretch(1);
    keys_->addWidget(reset_);
    column->addWidget(name_);
    column->addWidget(hint_);
    column->addWidget(row);
    return part;
}

/// Room for it is kept, so that nothing jumps.
QWidget* KeysDialog::make_question() {
    auto* part = new QWidget;
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    sentence_ = new QLabel;
    sentence_->setObjectName(QStringLiteral("sentence"));
    sentence_->setWordWrap(true);
    take_ = new QPushButton;
    take_->setObjectName(QStringLiteral("take"));
    leave_ = new QPushButton(tr("Leave it"));
    leave_->setObjectName(QStringLiteral("leave"));
    leave_->setAutoDefault(false);
    connect(take_, &QPushButton::clicked, this, [this] {
        const auto yes = std::exchange(yes_, nullptr);
        tell(QString());
        if (yes) yes();
    });
    connect(leave_, &QPushButton::clicked, this, [this] { tell(QString()); });
    row->addWidget(sentence_, 1);
    row->addWidget(take_);
    row->addWidget(leave_);
    part->setMinimumHeight(take_->sizeHint().height());
    tell(QString());
    return part;
}

QWidget* KeysDialog::make_foot() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    reset_all_ = buttons->addButton(tr("Forget all my own keys"), QDialogButtonBox::ResetRole);
    reset_all_->setObjectName(QStringLiteral("reset_all"));
    for (QAbstractButton* button : buttons->buttons())
        static_cast<QPushButton*>(button)->setAutoDefault(false);
    connect(reset_all_, &QPushButton::clicked, this, &KeysDialog::reset_all);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

// ---- what is shown

void KeysDialog::filter() {
    const QString typed = typed_->text().trimmed();
    QTreeWidgetItem* first = nullptr;
    for (const commands::CommandText& text : commands::command_list()) {
        QTreeWidgetItem* row = rows_.at(text.command);
        const bool found = typed.isEmpty() || commands::fit(typed, text) > 0 ||
                           row->text(1).contains(typed, Qt::CaseInsensitive);
        row->setHidden(!found);
        if (found && first == nullptr) first = row;
    }
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* menu = tree_->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < menu->childCount(); ++k)
            any = any || !menu->child(k)->isHidden();
        menu->setHidden(!any);
    }
    none_->setHidden(first != nullptr);
    if (first != nullptr && (tree_->currentItem() == nullptr || tree_->currentItem()->isHidden()))
        tree_->setCurrentItem(first);
}

/// The painter's own stand out.
void KeysDialog::show_keys() {
    for (const auto& [command, row] : rows_) {
        row->setText(1, QKeySequence::listToString(bindings_.keys(command), QKeySequence::NativeText));
        QFont font = row->font(0);
        font.setBold(bindings_.is_own(command));
        row->setFont(0, font);
    }
    reset_all_->setEnabled(!bindings_.own().empty());
}

void KeysDialog::show_chosen() {
    tell(QString());
    while (keys_->itemAt(0)->widget() != add_) {
        QLayoutItem* item = keys_->takeAt(0);
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    first_ = nullptr;
    const auto command = chosen();
    add_->setEnabled(command.has_value());
    reset_->setEnabled(command && bindings_.is_own(*command));
    if (!command) return;
    name_->setText(name_in_menu(*command));
    hint_->setText(commands::words_of(commands::text_of(*command).hint));
    for (const QKeySequence& key : bindings_.keys(*command))
        add_key_button(key);
}

/// Before the button that adds another.
void KeysDialog::add_key_button(const QKeySequence& key) {
    auto* button = new KeyCatcher(text_of(key));
    button->setToolTip(tr("Click, and press other keys in place of these"));
    connect(button, &KeyCatcher::caught, this,
            [this, key](const QKeySequence& other) { catch_key(other, key); });
    auto* drop_it = new QToolButton;
    drop_it->setText(QStringLiteral("×"));
    drop_it->setObjectName(QStringLiteral("drop ") + key.toString());
    drop_it->setToolTip(tr("Take %1 away").arg(text_of(key)));
    connect(drop_it, &QToolButton::clicked, this, [this, key] { drop(key); });
    const int place = keys_->indexOf(add_);
    keys_->insertWidget(place, button);
    keys_->insertWidget(place + 1, drop_it);
    // At once, so that it can have the keyboard.
    button->show();
    if (first_ == nullptr) first_ = button;
}

std::optional<Command> KeysDialog::chosen() const {
    const QTreeWidgetItem* row = tree_->currentItem();
    if (row == nullptr || row->parent() == nullptr) return std::nullopt;
    return static_cast<Command>(row->data(0, kCommandRole).toInt());
}

// ---- what is changed

/// One key is exchanged; where there are several, another is added.
void KeysDialog::listen_for_chosen() {
    const auto command = chosen();
    if (!command) return;
    (first_ != nullptr && bindings_.keys(*command).size() == 1 ? first_ : add_)->listen();
}

void KeysDialog::catch_key(const QKeySequence& key, const QKeySequence& instead_of) {
    const Command command = *chosen();
    if (commands::is_reserved(key))
        return tell(tr("%1 is needed on the canvas itself: it can be given to no command. Choose "
                       "another key.")
                        .arg(text_of(key)));
    KeyBindings::Keys keys = bindings_.keys(command);
    if (keys.contains(key)) return tell(tr("%1 is its key already.").arg(text_of(key)));
    const auto place = keys.indexOf(instead_of);
    if (place >= 0)
        keys[place] = key;
    else
        keys.append(key);
    const auto holder = bindings_.holder(key, commands::text_of(command).mode);
    if (!holder) return give(keys);
    ask(tr("%1 is the key of \"%2\".").arg(text_of(key), name_in_menu(*holder)),
        tr("Take it from there"), [this, keys] { give(keys); });
}

void KeysDialog::give(const KeyBindings::Keys& keys) {
    bindings_.give(*chosen(), keys);
    change();
}

void KeysDialog::drop(const QKeySequence& key) {
    KeyBindings::Keys keys = bindings_.keys(*chosen());
    keys.removeAll(key);
    give(keys);
}

/// A key of the set that the painter gave to another command stays there.
void KeysDialog::reset_chosen() {
    const Command command = *chosen();
    bindings_.reset(command);
    change();
    for (const QKeySequence& key : commands::keys_in(bindings_.set(), command)) {
        const auto holder = bindings_.holder(key, commands::text_of(command).mode);
        if (holder && *holder != command)
            tell(tr("%1 stays with \"%2\", which you gave it to.")
                     .arg(text_of(key), name_in_menu(*holder)));
    }
}

void KeysDialog::reset_all() {
    ask(tr("All keys will be as the set \"%1\" has them.").arg(sets_->currentText()),
        tr("Forget my own"), [this] {
            bindings_.reset_all();
            change();
        });
}

void KeysDialog::change() {
    show_keys();
    show_chosen();
    filter();
    Q_EMIT changed(bindings_);
}

void KeysDialog::tell(const QString& sentence) {
    yes_ = nullptr;
    sentence_->setText(sentence);
    take_->hide();
    leave_->hide();
}

void KeysDialog::ask(const QString& sentence, const QString& action, std::function<void()> yes) {
    tell(sentence);
    yes_ = std::move(yes);
    take_->setText(action);
    take_->show();
    leave_->show();
    take_->setFocus();
}

}  // namespace pastoso::dialogs
