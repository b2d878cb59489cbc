#include "panels/pen/guides_panel.hpp"

#include "document/actions/actions.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/guide_boxes.hpp"
#include "panels/pen/laid_guide_part.hpp"

#include <cmath>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr double kFarthest_mm = 5000.0;

void enable(std::initializer_list<QWidget*> widgets, bool enabled) {
    for (QWidget* widget : widgets)
        widget->setEnabled(enabled);
}

}  // namespace

GuidesPanel::GuidesPanel(const GuideActions& actions, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(symmetry_part(actions));
    laid_ = new LaidGuidePart;
    column->addWidget(laid_);
    column->addWidget(button_row({actions.snap, actions.handles, actions.remove}));
    column->addStretch(1);
    connect(laid_, &LaidGuidePart::kind_chosen, this, &GuidesPanel::kind_chosen);
    connect(laid_, &LaidGuidePart::guide_chosen, this, &GuidesPanel::guide_chosen);
    show_hand({});
}

QWidget* GuidesPanel::symmetry_part(const GuideActions& actions) {
    auto* part = new QWidget;
    auto* column = section(part, tr("Mirrors and copies"));
    column->addWidget(button_row({actions.upright, actions.level}));
    QFormLayout* form = form_in(column);
    const QString mm = tr(" mm"), degrees = QStringLiteral("\u00b0");
    copies_ = add_number(form, QStringLiteral("copies"), tr("Copies"), 1, document::kMostCopies, {});
    centre_x_ = add_number(form, QStringLiteral("symmetry_x"), tr("From the left"), -kFarthest_mm,
                           kFarthest_mm, mm);
    centre_y_ = add_number(form, QStringLiteral("symmetry_y"), tr("From above"), -kFarthest_mm,
                           kFarthest_mm, mm);
    axis_ = add_number(form, QStringLiteral("symmetry_axis"), tr("Axis"), -180, 180, degrees);
    for (QDoubleSpinBox* box : {copies_, centre_x_, centre_y_, axis_}) {
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this] { Q_EMIT symmetry_chosen(symmetry()); });
    }
    return part;
}

brush::Symmetry GuidesPanel::symmetry() const {
    brush::Symmetry result = shown_.symmetry;
    result.centre_x_mm = centre_x_->value();
    result.centre_y_mm = centre_y_->value();
    result.axis_deg = axis_->value();
    result.count = static_cast<int>(copies_->value());
    return result;
}

void GuidesPanel::show_hand(const tools::Hand& hand) {
    shown_ = hand;
    const brush::Symmetry& symmetry = hand.symmetry;
    show_number(copies_, symmetry.count);
    show_number(centre_x_, symmetry.centre_x_mm);
    show_number(centre_y_, symmetry.centre_y_mm);
    show_number(axis_, std::remainder(symmetry.axis_deg, 360.0));
    enable({centre_x_, centre_y_}, symmetry.mirror || symmetry.count > 1);
    enable({axis_}, symmetry.mirror);
    laid_->show_guide(hand.laid);
}

}  // namespace pastoso::panels
