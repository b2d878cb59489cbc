#include "panels/parts/tool_bar.hpp"

#include "panels/parts/section.hpp"
#include "panels/parts/upright.hpp"

#include <utility>

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLayout>
#include <QStyle>
#include <QToolButton>

namespace pastoso::panels {

ToolBar::ToolBar(const QString& title, QWidget* parent) : QToolBar(title, parent) {
    connect(this, &QToolBar::orientationChanged, this, &ToolBar::turn);
}

QToolButton* ToolBar::add_button(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    keep_keys_for_canvas(button);
    addWidget(button);
    buttons_.push_back(button);
    return button;
}

void ToolBar::add_box(QComboBox* box) {
    addWidget(box);
    boxes_.push_back(box);
}

QAction* ToolBar::add_word(const QString& word) {
    return addWidget(new QLabel(word));
}

void ToolBar::say(std::vector<QToolButton*> buttons) {
    words_.push_back({.buttons = std::move(buttons)});
}

void ToolBar::say(QAction* word) {
    words_.push_back({.buttons = {}, .word = word});
}

void ToolBar::show(const Words& words, bool shown) {
    if (words.word != nullptr) words.word->setVisible(shown);
    for (QToolButton* button : words.buttons)
        button->setToolButtonStyle(shown ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

void ToolBar::turn(Qt::Orientation orientation) {
    const bool upright = orientation == Qt::Vertical;
    for (QComboBox* box : boxes_) {
        box->setMaximumWidth(upright ? kUprightWidth_px : QWIDGETSIZE_MAX);
        box->setProperty("upright", upright);
        box->style()->polish(box);
        box->updateGeometry();
    }
    for (QToolButton* button : buttons_)
        button->setSizePolicy(upright ? QSizePolicy::Preferred : QSizePolicy::Fixed, QSizePolicy::Fixed);
    fit_words();
}

void ToolBar::fit_words() {
    if (fitting_) return;
    fitting_ = true;
    for (const Words& words : words_)
        show(words, false);
    for (const Words& words : words_) {
        if (orientation() == Qt::Vertical) break;
        show(words, true);
        layout()->invalidate();
        if (layout()->sizeHint().width() > width()) show(words, false);
    }
    layout()->invalidate();
    fitted_ = layout()->sizeHint();
    fitting_ = false;
}

void ToolBar::resizeEvent(QResizeEvent* event) {
    fit_words();
    QToolBar::resizeEvent(event);
}

/// A box in it may need more room for what it shows now. Fitting asks for a layout itself: where nothing
/// needs another size than after it, that would go on for ever.
bool ToolBar::event(QEvent* event) {
    const bool handled = QToolBar::event(event);
    if (event->type() == QEvent::LayoutRequest && layout()->sizeHint() != fitted_) fit_words();
    return handled;
}

}  // namespace pastoso::panels
