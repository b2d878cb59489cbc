#include "dialogs/command_palette.hpp"

#include "commands/command_search.hpp"
#include "commands/command_words.hpp"
#include "dialogs/command_delegate.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <QAction>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace pastoso::dialogs {
namespace {

using commands::Command;

constexpr int kWidth = 560, kRows = 10, kFromTop = 48;

/// The latest, then the others in the order of the menus.
std::vector<Command> all_of(const commands::CommandRegistry& commands) {
    std::vector<Command> all = commands.recent();
    for (const commands::CommandText& text : commands::command_list())
        if (std::find(all.begin(), all.end(), text.command) == all.end()) all.push_back(text.command);
    return all;
}

}  // namespace

CommandPalette::CommandPalette(const commands::CommandRegistry& commands, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      commands_(commands),
      typed_(new QLineEdit),
      list_(new QListView),
      hint_(new QLabel),
      model_(new QStandardItemModel(this)) {
    setObjectName(QStringLiteral("command_palette"));
    typed_->setObjectName(QStringLiteral("typed"));
    typed_->setPlaceholderText(tr("What do you want to do?"));
    typed_->setAccessibleName(typed_->placeholderText());
    typed_->setClearButtonEnabled(true);
    typed_->installEventFilter(this);
    list_->setModel(model_);
    list_->setItemDelegate(new CommandDelegate(list_));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setUniformItemSizes(true);
    list_->setMouseTracking(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    hint_->setObjectName(QStringLiteral("reading"));
    hint_->setContentsMargins(6, 0, 6, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(7);
    column->addWidget(typed_);
    column->addWidget(list_);
    column->addWidget(hint_);
    setFixedWidth(kWidth);
    setFocusProxy(typed_);
    connect(typed_, &QLineEdit::textChanged, this, &CommandPalette::list);
    connect(list_, &QListView::entered, list_, &QListView::setCurrentIndex);
    connect(list_, &QListView::clicked, this, &CommandPalette::run);
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &CommandPalette::show_hint);
}

void CommandPalette::open_over(const QWidget& place) {
    if (offers_of_) offers_ = offers_of_();
    typed_->clear();
    list();
    move(place.mapToGlobal(QPoint((place.width() - kWidth) / 2, kFromTop)));
    show();
    typed_->setFocus(Qt::PopupFocusReason);
}

void CommandPalette::list() {
    model_->clear();
    if (typed_->text().trimmed().isEmpty()) {
        std::vector<Command> all = all_of(commands_);
        std::stable_partition(all.begin(), all.end(), [this](Command command) {
            return commands_.action(command)->isEnabled();
        });
        for (const Command command : all)
            add(command);
    } else {
        list_found();
    }
    list_->setCurrentIndex(model_->index(0, 0));
    list_->scrollToTop();
    fit_height();
    show_hint();
}

/// What can be given now stands above what cannot, and what fits better above what fits worse.
void CommandPalette::list_found() {
    struct Row {
        bool can = true;
        int fit = 0;
        std::function<void()> add;
    };
    std::vector<Row> rows;
    for (const commands::Found& found : commands::find_with_fit(typed_->text()))
        rows.push_back({commands_.action(found.command)->isEnabled(), found.fit,
                        [this, command = found.command] { add(command); }});
    for (std::size_t i = 0; i < offers_.size(); ++i) {
        const Offer& offer = offers_[i];
        const int fit = commands::fit_of_name(typed_->text(), offer.words, offer.kind, offer.synonyms);
        if (fit > 0) rows.push_back({offer.can, fit, [this, i] { add(i); }});
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::pair(a.can, a.fit) > std::pair(b.can, b.fit);
    });
    for (const Row& row : rows)
        row.add();
}

/// As tall as what was found, up to so many rows.
void CommandPalette::fit_height() {
    constexpr int kFrame = 6;
    const int rows = std::clamp(model_->rowCount(), 1, kRows);
    list_->setFixedHeight(rows * CommandDelegate::row_height(list_->fontMetrics()) + kFrame);
    adjustSize();
}

void CommandPalette::add(Command command) {
    const commands::CommandText& text = commands::text_of(command);
    const QAction* action = commands_.action(command);
    auto* item = new QStandardItem(commands::plain_words(text.words));
    item->setData(static_cast<int>(command), CommandDelegate::kCommand);
    item->setData(commands::plain_words(text.menu), CommandDelegate::kMenu);
    item->setData(QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText),
                  CommandDelegate::kKeys);
    item->setData(action->isCheckable() && action->isChecked(), CommandDelegate::kChecked);
    item->setData(commands::words_of(text.hint), CommandDelegate::kHint);
    item->setEnabled(action->isEnabled());
    model_->appendRow(item);
}

void CommandPalette::add(std::size_t offer) {
    auto* item = new QStandardItem(offers_[offer].words);
    item->setData(static_cast<int>(offer), CommandDelegate::kOffer);
    item->setData(offers_[offer].kind, CommandDelegate::kMenu);
    item->setData(offers_[offer].hint, CommandDelegate::kHint);
    item->setEnabled(offers_[offer].can);
    model_->appendRow(item);
}

void CommandPalette::show_hint() {
    const QModelIndex row = list_->currentIndex();
    if (!row.isValid()) return hint_->setText(tr("Nothing of that name. Fewer letters find more."));
    const QString hint = row.data(CommandDelegate::kHint).toString();
    const bool can = row.flags().testFlag(Qt::ItemIsEnabled);
    hint_->setText(
        fontMetrics().elidedText(can ? hint : tr("Not now: %1").arg(hint), Qt::ElideRight, kWidth - 40));
}

/// The list is gone before the command is given, which may ask something itself.
void CommandPalette::run() {
    const QModelIndex row = list_->currentIndex();
    if (!row.isValid() || !row.flags().testFlag(Qt::ItemIsEnabled)) return;
    if (const QVariant offer = row.data(CommandDelegate::kOffer); offer.isValid()) {
        hide();
        offers_[static_cast<std::size_t>(offer.toInt())].take();
        return;
    }
    QAction* action =
        commands_.action(static_cast<Command>(row.data(CommandDelegate::kCommand).toInt()));
    hide();
    QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
}

bool CommandPalette::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(object, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const auto step = [this](int rows) {
        const int last = model_->rowCount() - 1;
        if (last < 0) return true;
        const int wanted = list_->currentIndex().row() + rows;
        list_->setCurrentIndex(model_->index(std::clamp(wanted, 0, last), 0));
        return true;
    };
    switch (key->key()) {
        case Qt::Key_Down:
            return step(1);
        case Qt::Key_Up:
            return step(-1);
        case Qt::Key_PageDown:
            return step(kRows);
        case Qt::Key_PageUp:
            return step(-kRows);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            run();
            return true;
        case Qt::Key_Escape:
            hide();
            return true;
        default:
            return QFrame::eventFilter(object, event);
    }
}

}  // namespace pastoso::dialogs
