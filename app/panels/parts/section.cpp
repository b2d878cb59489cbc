#include "panels/parts/section.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// Tells Qt that a key is no shortcut here.
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

}  // namespace

QVBoxLayout* section(QWidget* panel, const QString& heading) {
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* label = new QLabel(heading);
    label->setObjectName(QStringLiteral("heading"));
    column->addWidget(label);
    return column;
}

void keep_keys_for_canvas(QWidget* widget) {
    widget->setFocusPolicy(Qt::TabFocus);
}

void keep_own_keys(QWidget* widget, const std::vector<QKeyCombination>& keys) {
    widget->installEventFilter(new OwnKeys(widget, keys));
}

QToolButton* action_button(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    keep_keys_for_canvas(button);
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
