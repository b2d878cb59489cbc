#include "start/start_page.hpp"

#include "appearance/focus_loop.hpp"
#include "start/examples_section.hpp"
#include "start/new_canvas_section.hpp"
#include "start/recent_section.hpp"
#include "start/unfinished_section.hpp"

#include <algorithm>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace pastoso::start {
namespace {

/// So much of the canvas is seen around the page: it can be painted on.
constexpr int kAround_px = 36, kLeastAround_px = 10;
constexpr int kWidest_px = 760, kNarrow_px = 640, kMargin = 20;

/// Shortcuts of the window would act on the painting behind the page.
bool is_plain(const QKeyEvent& key) {
    const Qt::KeyboardModifiers others = key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    return others == Qt::NoModifier && (key.key() < Qt::Key_F1 || key.key() > Qt::Key_F35);
}

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QFrame(parent),
      unfinished_(new UnfinishedSection),
      new_canvas_(new NewCanvasSection),
      recent_(new RecentSection),
      examples_(new ExamplesSection),
      paint_(new QPushButton),
      easel_words_(new QLabel),
      at_start_(new QCheckBox(tr("Show this page at start"))),
      scrolled_(new QScrollArea) {
    setObjectName(QStringLiteral("start_page"));
    setAccessibleName(tr("Start page"));
    setStyleSheet(QStringLiteral(
        "QFrame#start_page { background: palette(window); border: 1px solid palette(mid); "
        "border-radius: 9px; }"));
    setAttribute(Qt::WA_NoMousePropagation);  // a click beside its buttons is no stroke
    setCursor(Qt::ArrowCursor);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);
    column->setSpacing(0);
    scrolled_->setFrameShape(QFrame::NoFrame);
    scrolled_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled_->setFocusPolicy(Qt::NoFocus);
    scrolled_->setWidgetResizable(true);
    scrolled_->setWidget(make_content());
    column->addWidget(scrolled_, 1);
    column->addLayout(make_foot());
    hide();
}

QWidget* StartPage::make_content() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(kMargin, kMargin, kMargin, 10);
    column->setSpacing(16);
    column->addWidget(unfinished_);
    column->addLayout(make_greeting());
    column->addWidget(new_canvas_);
    column->addWidget(recent_);
    column->addWidget(examples_);
    column->addStretch(1);
    return content;
}

QLayout* StartPage::make_greeting() {
    QFont large = paint_->font();
    large.setPointSizeF(1.25 * large.pointSizeF());
    large.setBold(true);
    paint_->setObjectName(QStringLiteral("start_painting"));
    paint_->setFont(large);
    paint_->setMinimumHeight(48);
    paint_->setDefault(true);
    connect(paint_, &QPushButton::clicked, this, &StartPage::dismissed);
    easel_words_->setObjectName(QStringLiteral("reading"));
    easel_words_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->setSpacing(14);
    row->addWidget(paint_);
    row->addWidget(easel_words_, 1);
    return row;
}

QLayout* StartPage::make_foot() {
    at_start_->setObjectName(QStringLiteral("show_at_start"));
    at_start_->setChecked(true);
    auto* hint = new QLabel(tr("Esc closes it; \"Start page\" in the \"File\" menu brings it back."));
    hint->setObjectName(QStringLiteral("reading"));
    hint->setWordWrap(true);
    hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kMargin, 8, kMargin, 10);
    row->addWidget(at_start_);
    row->addWidget(hint, 1);
    return row;
}

void StartPage::open(const QRect& place, const document::CanvasSettings& on_easel, bool begun,
                     double live_px_per_mm, const std::vector<std::filesystem::path>& recent,
                     const std::vector<journal::Unfinished>& unfinished) {
    paint_->setText(begun ? tr("Back to the painting") : tr("Start painting"));
    easel_words_->setText(
        begun ? tr("The painting stands on the easel as you left it.")
              : tr("A canvas of %1, %2, is ready. You can also just paint on it.")
                    .arg(dialogs::support_words(on_easel.support), size_words(on_easel)));
    new_canvas_->propose(on_easel, live_px_per_mm);
    unfinished_->show_paintings(unfinished);
    recent_->show_paintings(recent);
    lie_on(place);
    scrolled_->verticalScrollBar()->setValue(0);
    show();
    raise();
    paint_->setFocus(Qt::OtherFocusReason);
}

void StartPage::show_recent(const std::vector<std::filesystem::path>& recent) {
    recent_->show_paintings(recent);
    fit();
}

void StartPage::show_unfinished(const std::vector<journal::Unfinished>& unfinished) {
    unfinished_->show_paintings(unfinished);
    fit();
}

void StartPage::lie_on(const QRect& place) {
    place_ = place;
    fit();
}

/// In the middle of its place, as high as what it holds; the rest is scrolled to.
void StartPage::fit() {
    const int around = place_.width() >= kNarrow_px + 2 * kAround_px ? kAround_px : kLeastAround_px;
    const int width = std::min(kWidest_px, place_.width() - 2 * around);
    const int inner = width - 2 - 2 * kMargin - scrolled_->verticalScrollBar()->sizeHint().width();
    new_canvas_->fit(inner);
    recent_->fit(inner);
    examples_->fit(inner);
    QWidget* content = scrolled_->widget();
    content->layout()->invalidate();
    content->layout()->activate();
    const QLayoutItem* foot_row = layout()->itemAt(1);
    const int foot = foot_row->hasHeightForWidth() ? foot_row->heightForWidth(width - 2)
                                                   : foot_row->sizeHint().height();
    const int wanted = content->layout()->totalHeightForWidth(inner + 2 * kMargin) + foot + 4;
    const QSize size(width, std::min(wanted, place_.height() - 2 * kLeastAround_px));
    setGeometry(QRect(place_.center() - QPoint(size.width() / 2, size.height() / 2), size));
}

void StartPage::set_shown_at_start(bool shown) {
    at_start_->setChecked(shown);
}

bool StartPage::shown_at_start() const {
    return at_start_->isChecked();
}

/// What was never shown before knows neither its style nor its fonts.
void StartPage::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    fit();
}

bool StartPage::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && is_plain(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QFrame::event(event);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        Q_EMIT dismissed();
    else
        QFrame::keyPressEvent(event);
}

/// What lies behind the page is out of reach until it is closed.
bool StartPage::focusNextPrevChild(bool next) {
    return appearance::focus_within(*this, next);
}

}  // namespace pastoso::start
