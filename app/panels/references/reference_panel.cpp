#include "panels/references/reference_panel.hpp"

#include "appearance/icon.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"
#include "panels/references/reference_view.hpp"

#include <utility>

#include <QAction>
#include <QGridLayout>
#include <QVBoxLayout>

namespace pastoso::panels {

ReferencePanel::ReferencePanel(const std::vector<QAction*>& actions, QWidget* parent)
    : QWidget(parent), board_(new ReferenceView) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(6);
    column->addWidget(board_, 1);
    column->addWidget(button_row(actions));
    add_actions();
    column->addWidget(icon_row(of_chosen_));
    auto* values = new QWidget;
    auto* grid = new QGridLayout(values);
    grid->setContentsMargins(0, 0, 0, 0);
    opacity_ = new ValueRow(grid, QStringLiteral("reference_opacity"), tr("Opacity"),
                            tr("How strongly the chosen picture shows"), {0.0, 100.0, 0, tr(" %")});
    column->addWidget(values);
    connect(opacity_, &ValueRow::chosen, this, [this](double percent) {
        change_chosen([percent](document::Reference& one) { one.look.opacity = 0.01 * percent; });
    });
    connect(board_, &ReferenceView::chosen_changed, this, &ReferencePanel::show_chosen);
    show_chosen();
}

QAction* ReferencePanel::add_action(const char* name, const char* icon, const QString& words,
                                    const QString& hint, std::function<void()> work) {
    auto* action = new QAction(appearance::icon(QString::fromLatin1(icon)), words, this);
    action->setObjectName(QString::fromLatin1(name));
    action->setToolTip(hint);
    connect(action, &QAction::triggered, this, std::move(work));
    of_chosen_.push_back(action);
    return action;
}

QAction* ReferencePanel::add_switch(const char* name, const char* icon, const QString& words,
                                    const QString& hint,
                                    std::function<void(document::Reference& one)> turn_over) {
    QAction* action = add_action(name, icon, words, hint, [this, turn_over = std::move(turn_over)] {
        change_chosen(turn_over);
        board_->finish();
    });
    action->setCheckable(true);
    return action;
}

void ReferencePanel::add_actions() {
    using document::Reference;
    add_action("raise_reference", "raise_layer", tr("Raise"), tr("Above the next picture (PgUp)"),
               [this] { board_->raise_chosen(1); });
    add_action("lower_reference", "lower_layer", tr("Lower"), tr("Below the picture under it (PgDown)"),
               [this] { board_->raise_chosen(-1); });
    mirror_ =
        add_switch("mirror_reference", "mirror_view", tr("Mirror"), tr("Left and right change sides"),
                   [](Reference& one) { one.place.mirrored = !one.place.mirrored; });
    grey_ = add_switch("grey_reference", "value_check", tr("Greys"),
                       tr("Shown in greys as light as its colours"),
                       [](Reference& one) { one.look.grey = !one.look.grey; });
    add_action("remove_reference", "remove_tracing", tr("Take away"),
               tr("Take the chosen picture off the board (Del)"), [this] { board_->remove_chosen(); });
}

void ReferencePanel::change_chosen(const std::function<void(document::Reference& one)>& change) {
    const document::Reference* one = board_->chosen();
    if (one == nullptr) return;
    document::Reference changed = *one;
    change(changed);
    board_->propose({changed.id, changed.place, changed.look});
}

void ReferencePanel::show_chosen() {
    const document::Reference* one = board_->chosen();
    for (QAction* action : of_chosen_)
        action->setEnabled(one != nullptr);
    opacity_->setEnabled(one != nullptr);
    mirror_->setChecked(one != nullptr && one->place.mirrored);
    grey_->setChecked(one != nullptr && one->look.grey);
    if (one != nullptr) opacity_->show_value(100.0 * one->look.opacity);
}

}  // namespace pastoso::panels
