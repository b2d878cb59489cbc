#include "panels/parts/section.hpp"

#include "panels/parts/labels.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// Whether a list moves by this key, or its entry is renamed or removed where it can be.
bool is_list_key(const QKeyEvent& key) {
    constexpr std::array kKeys = {Qt::Key_Up,     Qt::Key_Down,      Qt::Key_PageUp, Qt::Key_PageDown,
                                  Qt::Key_Home,   Qt::Key_End,       Qt::Key_Return, Qt::Key_Enter,
                                  Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2};
    return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier &&
           std::find(kKeys.begin(), kKeys.end(), key.key()) != kKeys.end();
}

/// Tells Qt that keys of lists, and letters by which a name is found, are no shortcuts here.
class ListKeys : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* list, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(list, event);
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool own = is_list_key(key) || is_of_name(key);
        if (own) event->accept();
        return own;
    }

  private:
    /// A name begins with a letter; digits and spaces go on with it for as long as Qt's search does.
    bool is_of_name(const QKeyEvent& key) {
        const Qt::KeyboardModifiers others = key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
        if (others != Qt::NoModifier || key.text().isEmpty()) return false;
        const bool goes_on =
            since_typed_.isValid() && !since_typed_.hasExpired(QApplication::keyboardInputInterval());
        const QChar typed = key.text().front();
        const bool is_typed = typed.isLetter() || (goes_on && (typed.isDigit() || typed == u' '));
        if (is_typed) since_typed_.start();
        return is_typed;
    }

    QElapsedTimer since_typed_;
};

/// The same of keys that are named.
class OwnKeys : public QObject {
  public:
    OwnKeys(QWidget* widget, std::vector<QKeyCombination> keys)
        : QObject(widget), keys_(std::move(keys)) {}

    bool eventFilter(QObject* widget, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(widget, event);
        const auto* key = static_cast<const QKeyEvent*>(event);
        const QKeyCombination pressed(key->modifiers() & ~Qt::KeypadModifier, Qt::Key(key->key()));
        const bool own = std::find(keys_.begin(), keys_.end(), pressed) != keys_.end();
        if (own) event->accept();
        return own;
    }

  private:
    std::vector<QKeyCombination> keys_;
};

/// As wide as what it holds needs at that size of text: the words in it change, its width does not.
class Column : public QScrollArea {
  public:
    explicit Column(QWidget* content) {
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setWidgetResizable(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidget(content);
        keep_width();
    }

  protected:
    /// What it holds hears of another font only after it.
    void changeEvent(QEvent* event) override {
        QScrollArea::changeEvent(event);
        if (event->type() == QEvent::FontChange)
            QMetaObject::invokeMethod(this, &Column::keep_width, Qt::QueuedConnection);
    }

  private:
    void keep_width() {
        setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    }
};

}  // namespace

QVBoxLayout* section(QWidget* panel, const QString& words, const std::vector<QToolButton*>& buttons) {
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* head = new QHBoxLayout;
    head->setSpacing(2);
    head->addWidget(heading(words));
    head->addStretch(1);
    for (QToolButton* button : buttons)
        head->addWidget(button);
    column->addLayout(head);
    return column;
}

QScrollArea* scrolled(QWidget* content) {
    return new Column(content);
}

void let_shrink(QComboBox* box) {
    constexpr int kFewestLetters = 6;
    box->setMinimumContentsLength(kFewestLetters);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

void keep_keys_for_canvas(QWidget* widget) {
    widget->setFocusPolicy(Qt::TabFocus);
}

void keep_own_keys(QWidget* widget, const std::vector<QKeyCombination>& keys) {
    widget->installEventFilter(new OwnKeys(widget, keys));
}

void take_keys_of_list(QAbstractItemView* list) {
    list->setFocusPolicy(Qt::StrongFocus);
    list->installEventFilter(new ListKeys(list));
}

QToolButton* action_button(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    keep_keys_for_canvas(button);
    return button;
}

QToolButton* small_button(QAction* action) {
    QToolButton* button = action_button(action);
    button->setProperty("small", true);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return button;
}

QWidget* button_row(const std::vector<QAction*>& actions) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QAction* action : actions)
        layout->addWidget(action_button(action));
    return row;
}

QWidget* icon_row(const std::vector<QAction*>& actions) {
    QWidget* row = button_row(actions);
    for (auto* button : row->findChildren<QToolButton*>())
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    return row;
}

void show_number(QDoubleSpinBox* box, double value) {
    const QSignalBlocker quiet(box);
    box->setValue(value);
}

void fit_to_rows(QListView* list, int rows) {
    const int row_height = list->sizeHintForRow(0);
    list->setFixedHeight(rows * row_height + 2 * list->frameWidth() + 6);
    const bool all_seen = rows >= list->model()->rowCount();
    list->setVerticalScrollBarPolicy(all_seen ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
}

}  // namespace pastoso::panels
