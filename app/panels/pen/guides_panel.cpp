#include "panels/pen/guides_panel.hpp"

#include "core/units.hpp"
#include "document/actions/actions.hpp"
#include "panels/parts/section.hpp"

#include <cmath>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr double kFarthest_mm = 5000.0;

QFormLayout* form_in(QVBoxLayout* column) {
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    column->addLayout(form);
    return form;
}

void enable(std::initializer_list<QWidget*> widgets, bool enabled) {
    for (QWidget* widget : widgets)
        widget->setEnabled(enabled);
}

double angle_deg(const brush::Ruler& ruler) {
    return core::degrees(std::atan2(ruler.y2_mm - ruler.y1_mm, ruler.x2_mm - ruler.x1_mm));
}

}  // namespace

GuidesPanel::GuidesPanel(const GuideActions& actions, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(symmetry_part(actions));
    column->addWidget(ruler_part(actions));
    column->addWidget(ellipse_part(actions));
    column->addWidget(button_row({actions.handles, actions.remove}));
    column->addStretch(1);
    show_hand({});
}

QDoubleSpinBox* GuidesPanel::add_number(QFormLayout* form, const QString& name, const QString& words,
                                        double least, double most, const QString& unit) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(words);
    box->setToolTip(tr("%1: %2 to %3%4").arg(words).arg(least).arg(most).arg(unit));
    box->setRange(least, most);
    box->setDecimals(unit.isEmpty() ? 0 : 1);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    form->addRow(words, box);
    return box;
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

QWidget* GuidesPanel::ruler_part(const GuideActions& actions) {
    auto* part = new QWidget;
    auto* column = section(part, tr("Ruler"));
    column->addWidget(button_row({actions.ruler}));
    QFormLayout* form = form_in(column);
    const QString mm = tr(" mm");
    ruler_x_ = add_number(form, QStringLiteral("ruler_x"), tr("Middle, from the left"), -kFarthest_mm,
                          kFarthest_mm, mm);
    ruler_y_ = add_number(form, QStringLiteral("ruler_y"), tr("Middle, from above"), -kFarthest_mm,
                          kFarthest_mm, mm);
    ruler_angle_ = add_number(form, QStringLiteral("ruler_angle"), tr("Slope"), -180, 180,
                              QStringLiteral("\u00b0"));
    for (QDoubleSpinBox* box : {ruler_x_, ruler_y_, ruler_angle_})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] { Q_EMIT ruler_chosen(ruler()); });
    return part;
}

QWidget* GuidesPanel::ellipse_part(const GuideActions& actions) {
    auto* part = new QWidget;
    auto* column = section(part, tr("Ellipse"));
    column->addWidget(button_row({actions.ellipse}));
    QFormLayout* form = form_in(column);
    const QString mm = tr(" mm");
    ellipse_x_ = add_number(form, QStringLiteral("ellipse_x"), tr("Middle, from the left"),
                            -kFarthest_mm, kFarthest_mm, mm);
    ellipse_y_ = add_number(form, QStringLiteral("ellipse_y"), tr("Middle, from above"), -kFarthest_mm,
                            kFarthest_mm, mm);
    ellipse_width_ = add_number(form, QStringLiteral("ellipse_width"), tr("Width"), 1, kFarthest_mm, mm);
    ellipse_height_ =
        add_number(form, QStringLiteral("ellipse_height"), tr("Height"), 1, kFarthest_mm, mm);
    ellipse_turn_ = add_number(form, QStringLiteral("ellipse_turn"), tr("Turned by"), -180, 180,
                               QStringLiteral("\u00b0"));
    for (QDoubleSpinBox* box : {ellipse_x_, ellipse_y_, ellipse_width_, ellipse_height_, ellipse_turn_})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] { Q_EMIT ellipse_chosen(ellipse()); });
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

/// As long as it was, about its middle.
brush::Ruler GuidesPanel::ruler() const {
    const brush::Ruler before = shown_.ruler.value_or(brush::Ruler{});
    const double half_mm = 0.5 * std::hypot(before.x2_mm - before.x1_mm, before.y2_mm - before.y1_mm);
    const double angle = core::radians(ruler_angle_->value());
    const double x_mm = half_mm * std::cos(angle), y_mm = half_mm * std::sin(angle);
    return {ruler_x_->value() - x_mm, ruler_y_->value() - y_mm, ruler_x_->value() + x_mm,
            ruler_y_->value() + y_mm};
}

brush::EllipseCurve GuidesPanel::ellipse() const {
    return {ellipse_x_->value(), ellipse_y_->value(), 0.5 * ellipse_width_->value(),
            0.5 * ellipse_height_->value(), ellipse_turn_->value()};
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
    enable({ruler_x_, ruler_y_, ruler_angle_}, hand.ruler.has_value());
    enable({ellipse_x_, ellipse_y_, ellipse_width_, ellipse_height_, ellipse_turn_},
           hand.ellipse.has_value());
    if (hand.ruler) {
        show_number(ruler_x_, 0.5 * (hand.ruler->x1_mm + hand.ruler->x2_mm));
        show_number(ruler_y_, 0.5 * (hand.ruler->y1_mm + hand.ruler->y2_mm));
        show_number(ruler_angle_, angle_deg(*hand.ruler));
    }
    if (!hand.ellipse) return;
    show_number(ellipse_x_, hand.ellipse->centre_x_mm);
    show_number(ellipse_y_, hand.ellipse->centre_y_mm);
    show_number(ellipse_width_, 2.0 * hand.ellipse->half_width_mm);
    show_number(ellipse_height_, 2.0 * hand.ellipse->half_height_mm);
    show_number(ellipse_turn_, std::remainder(hand.ellipse->turn_deg, 360.0));
}

}  // namespace pastoso::panels
