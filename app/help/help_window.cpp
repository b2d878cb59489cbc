#include "help/help_window.hpp"

#include <utility>

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>

namespace pastoso::help {
namespace {

constexpr int kTopicRole = Qt::UserRole;

QString topic_of_section(const QString& page, const Section& section) {
    return section.level == 1 ? page : page + QLatin1Char('#') + section.anchor;
}

QToolButton* way_button(const QString& words, Qt::ArrowType arrow, const QKeySequence& key) {
    auto* button = new QToolButton;
    button->setArrowType(arrow);
    button->setAutoRaise(true);
    button->setToolTip(words);
    button->setAccessibleName(words);
    button->setShortcut(key);
    button->setEnabled(false);
    return button;
}

}  // namespace

HelpWindow::HelpWindow(Manual manual, QWidget* parent)
    : QWidget(parent, Qt::Window),
      manual_(std::move(manual)),
      view_(new HelpView(manual_)),
      words_(new QLineEdit),
      contents_(new QTreeWidget),
      found_(new QListWidget),
      side_(new QStackedWidget) {
    setObjectName(QStringLiteral("help_window"));
    setWindowTitle(tr("Manual"));
    words_->setObjectName(QStringLiteral("help_words"));
    words_->setPlaceholderText(tr("Search the manual"));
    words_->setAccessibleName(words_->placeholderText());
    words_->setClearButtonEnabled(true);
    contents_->setObjectName(QStringLiteral("help_contents"));
    contents_->setAccessibleName(tr("Pages of the manual"));
    contents_->setHeaderHidden(true);
    found_->setObjectName(QStringLiteral("help_found"));
    found_->setAccessibleName(tr("What was found"));
    found_->setWordWrap(true);
    found_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    side_->addWidget(contents_);
    side_->addWidget(found_);
    make_bar();
    fill_contents();
    connect(words_, &QLineEdit::textChanged, this, &HelpWindow::search);
    connect(contents_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item != nullptr) view_->show_topic(item->data(0, kTopicRole).toString());
    });
    connect(found_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item != nullptr) view_->show_topic(item->data(kTopicRole).toString());
    });
    connect(view_, &QTextBrowser::historyChanged, this, &HelpWindow::mark_page);
    resize(960, 640);
}

void HelpWindow::make_bar() {
    auto* back = way_button(tr("Back"), Qt::LeftArrow, QKeySequence::Back);
    auto* forward = way_button(tr("Forward"), Qt::RightArrow, QKeySequence::Forward);
    connect(back, &QToolButton::clicked, view_, &QTextBrowser::backward);
    connect(forward, &QToolButton::clicked, view_, &QTextBrowser::forward);
    connect(view_, &QTextBrowser::backwardAvailable, back, &QToolButton::setEnabled);
    connect(view_, &QTextBrowser::forwardAvailable, forward, &QToolButton::setEnabled);
    auto* bar = new QHBoxLayout;
    bar->addWidget(back);
    bar->addWidget(forward);
    bar->addWidget(words_, 1);
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(10, 10, 10, 10);
    column->addLayout(bar);
    column->addWidget(side_, 1);
    auto* halves = new QSplitter;
    halves->addWidget(left);
    halves->addWidget(view_);
    halves->setStretchFactor(1, 1);
    halves->setSizes({280, 680});
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(halves);
}

void HelpWindow::fill_contents() {
    for (const Page& page : manual_.pages()) {
        auto* item = new QTreeWidgetItem(contents_, {page.title()});
        item->setData(0, kTopicRole, page.name);
        for (const Section& section : page.sections) {
            if (section.level != 2) continue;
            auto* part = new QTreeWidgetItem(item, {section.heading});
            part->setData(0, kTopicRole, topic_of_section(page.name, section));
        }
    }
}

/// Where a link has led to.
void HelpWindow::mark_page() {
    const QString name = view_->page_name();
    for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = contents_->topLevelItem(i);
        if (item->data(0, kTopicRole).toString() != name) continue;
        const QTreeWidgetItem* current = contents_->currentItem();
        if (current == item || (current != nullptr && current->parent() == item)) return;
        const QSignalBlocker blocker(contents_);
        contents_->setCurrentItem(item);
        contents_->expandItem(item);
    }
}

void HelpWindow::search(const QString& words) {
    found_->clear();
    for (const Found& one : manual_.find(words)) {
        const QString heading = one.section.level == 1
                                    ? one.title
                                    : one.title + QStringLiteral(" \u203a ") + one.section.heading;
        auto* item = new QListWidgetItem(heading + QLatin1Char('\n') + one.excerpt, found_);
        item->setData(kTopicRole, topic_of_section(one.page, one.section));
    }
    if (found_->count() == 0 && !words.trimmed().isEmpty())
        (new QListWidgetItem(tr("Nothing is found."), found_))->setFlags(Qt::NoItemFlags);
    side_->setCurrentWidget(words.trimmed().isEmpty() ? static_cast<QWidget*>(contents_) : found_);
}

void HelpWindow::open_at(const QString& topic) {
    come_up();
    view_->show_topic(topic);
}

void HelpWindow::open_news() {
    come_up();
    view_->setSource(QUrl::fromLocalFile(path_of(manual_.beside("CHANGELOG.md"))),
                     QTextDocument::MarkdownResource);
}

void HelpWindow::come_up() {
    words_->clear();
    show();
    raise();
    activateWindow();
    view_->setFocus();
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Find))
        words_->setFocus();
    else if (event->key() == Qt::Key_Escape)
        close();
    else
        QWidget::keyPressEvent(event);
}

}  // namespace pastoso::help
