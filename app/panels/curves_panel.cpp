#include "panels/curves_panel.hpp"

#include "brush/hand_pose.hpp"
#include "panels/curve_editor.hpp"
#include "panels/section.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using brush::DynamicsCurve;
using brush::DynamicsInput;
using brush::DynamicsTarget;

QString input_words(DynamicsInput input) {
    switch (input) {
        case DynamicsInput::Pressure:
            return QObject::tr("Pressure");
        case DynamicsInput::Tilt:
            return QObject::tr("Tilt");
        case DynamicsInput::BarrelRotation:
            return QObject::tr("Barrel");
        case DynamicsInput::Speed:
            return QObject::tr("Speed");
    }
    return {};
}

QString target_words(DynamicsTarget target) {
    switch (target) {
        case DynamicsTarget::Press:
            return QObject::tr("how far it is pressed");
        case DynamicsTarget::Lean:
            return QObject::tr("how far it leans");
        case DynamicsTarget::Rotation:
            return QObject::tr("how it is turned");
        case DynamicsTarget::Reach:
            return QObject::tr("reach into hollows");
        case DynamicsTarget::Film:
            return QObject::tr("film that it leaves");
        case DynamicsTarget::Pickup:
            return QObject::tr("paint taken up");
        case DynamicsTarget::Flow:
            return QObject::tr("flow");
        case DynamicsTarget::Spread:
            return QObject::tr("width of the spread");
    }
    return {};
}

QString input_text(DynamicsInput input, double value) {
    switch (input) {
        case DynamicsInput::Pressure:
            return QObject::tr("%1 % pressure").arg(100.0 * value, 0, 'f', 0);
        case DynamicsInput::Speed:
            return QObject::tr("%1 mm/s").arg(value, 0, 'f', 0);
        default:
            return QStringLiteral("%1\u00b0").arg(value, 0, 'f', 0);
    }
}

QString output_text(DynamicsTarget target, double value) {
    switch (target) {
        case DynamicsTarget::Press:
        case DynamicsTarget::Lean:
            return QStringLiteral("%1 %").arg(100.0 * value, 0, 'f', 0);
        case DynamicsTarget::Rotation:
            return QStringLiteral("%1\u00b0").arg(value, 0, 'f', 0);
        default:
            return QStringLiteral("\u00d7 %1").arg(value, 0, 'f', 2);
    }
}

}  // namespace

CurvesPanel::CurvesPanel(QWidget* parent)
    : QWidget(parent),
      which_(new QComboBox),
      editor_(new CurveEditor),
      reading_(new QLabel),
      reset_(new QPushButton(tr("Reset"))) {
    auto* column = section(this, tr("How it answers to the hand"));
    which_->setObjectName(QStringLiteral("curve_choice"));
    which_->setToolTip(tr("What of the hand sets what of the tool"));
    which_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    keep_keys_for_canvas(which_);
    reading_->setObjectName(QStringLiteral("curve_reading"));
    reset_->setObjectName(QStringLiteral("curve_reset"));
    reset_->setToolTip(tr("The curve as the tool was kept with"));
    keep_keys_for_canvas(reset_);
    auto* row = new QHBoxLayout;
    row->addWidget(reading_, 1);
    row->addWidget(reset_);
    column->addWidget(which_);
    column->addWidget(editor_);
    column->addLayout(row);
    connect(which_, &QComboBox::currentIndexChanged, this, &CurvesPanel::show_current);
    connect(editor_, &CurveEditor::edited, this, &CurvesPanel::emit_points);
    connect(editor_, &CurveEditor::read_at, this, &CurvesPanel::read_at);
    connect(reset_, &QPushButton::clicked, this, &CurvesPanel::reset_current);
}

void CurvesPanel::show_preset(const brush::Preset& in_hand, const brush::Preset& kept) {
    if (in_hand == preset_ && kept == kept_) return;
    const bool same_curves =
        in_hand.name == preset_.name && in_hand.dynamics.size() == preset_.dynamics.size();
    preset_ = in_hand;
    kept_ = kept;
    if (!same_curves) list_curves();
    show_current();
}

void CurvesPanel::list_curves() {
    const QSignalBlocker quiet(which_);
    which_->clear();
    for (const DynamicsCurve& curve : preset_.dynamics) {
        which_->addItem(tr("%1: %2").arg(input_words(curve.input), target_words(curve.target)));
    }
    which_->setEnabled(which_->count() > 0);
}

void CurvesPanel::show_current() {
    const int index = which_->currentIndex();
    const bool any = index >= 0 && index < static_cast<int>(preset_.dynamics.size());
    const DynamicsCurve curve =
        any ? preset_.dynamics[static_cast<std::size_t>(index)] : DynamicsCurve{};
    editor_->show_curve(curve);
    editor_->setEnabled(any);
    const DynamicsCurve* kept = any ? kept_curve() : nullptr;
    reset_->setEnabled(kept != nullptr && !(*kept == curve));
    if (any)
        read_at(0.5 * editor_->frame().most_input);
    else
        reading_->setText(tr("This tool has no curves."));
}

const DynamicsCurve* CurvesPanel::kept_curve() const {
    const auto index = static_cast<std::size_t>(which_->currentIndex());
    return index < kept_.dynamics.size() ? &kept_.dynamics[index] : nullptr;
}

void CurvesPanel::read_at(double input) {
    const int index = which_->currentIndex();
    if (index < 0 || editor_->points().empty()) return;
    DynamicsCurve curve = preset_.dynamics[static_cast<std::size_t>(index)];
    curve.points = editor_->points();
    reading_->setText(tr("%1 \u2192 %2")
                          .arg(input_text(curve.input, input),
                               output_text(curve.target, brush::evaluate(curve, input))));
}

void CurvesPanel::emit_points(const std::vector<brush::CurvePoint>& points) {
    const int index = which_->currentIndex();
    if (index < 0) return;
    preset_.dynamics[static_cast<std::size_t>(index)].points = points;
    const DynamicsCurve* kept = kept_curve();
    reset_->setEnabled(kept != nullptr && kept->points != points);
    Q_EMIT edited(preset_);
}

void CurvesPanel::reset_current() {
    const DynamicsCurve* kept = kept_curve();
    if (kept == nullptr) return;
    emit_points(kept->points);
    show_current();
}

}  // namespace pastoso::panels
