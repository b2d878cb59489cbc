#include "panels/pen/curves_panel.hpp"

#include "appearance/shown_number.hpp"
#include "brush/hand_pose.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/curve_editor.hpp"

#include <algorithm>
#include <array>

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
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
        case DynamicsInput::Direction:
            return QObject::tr("Direction of the stroke");
        case DynamicsInput::Distance:
            return QObject::tr("Distance travelled");
        case DynamicsInput::Time:
            return QObject::tr("Time since the touch");
        case DynamicsInput::Fade:
            return QObject::tr("Distance in brush widths");
        case DynamicsInput::StrokeRandom:
            return QObject::tr("Chance, each stroke");
        case DynamicsInput::DabRandom:
            return QObject::tr("Chance along the stroke");
        case DynamicsInput::Wheel:
            return QObject::tr("Wheel");
        case DynamicsInput::Load:
            return QObject::tr("Paint left on the tool");
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
        case DynamicsTarget::Ride:
            return QObject::tr("ride on wet paint");
    }
    return {};
}

QString curve_words(DynamicsInput input, DynamicsTarget target) {
    return QObject::tr("%1: %2").arg(input_words(input), target_words(target));
}

QString input_text(DynamicsInput input, double value) {
    switch (input) {
        case DynamicsInput::Pressure:
            return QObject::tr("%1 % pressure").arg(100.0 * value, 0, 'f', 0);
        case DynamicsInput::Speed:
            return QObject::tr("%1 mm/s").arg(value, 0, 'f', 0);
        case DynamicsInput::Distance:
            return QObject::tr("%1 mm").arg(value, 0, 'f', 0);
        case DynamicsInput::Time:
            return QObject::tr("%1 s").arg(appearance::shown_number(value, 1));
        case DynamicsInput::Fade:
            return QObject::tr("%1 widths").arg(appearance::shown_number(value, 1));
        case DynamicsInput::StrokeRandom:
        case DynamicsInput::DabRandom:
        case DynamicsInput::Wheel:
        case DynamicsInput::Load:
            return QStringLiteral("%1 %").arg(100.0 * value, 0, 'f', 0);
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
            return QStringLiteral("\u00d7 %1").arg(appearance::shown_number(value, 2));
    }
}

constexpr std::array kInputs = {
    DynamicsInput::Pressure, DynamicsInput::Tilt,         DynamicsInput::BarrelRotation,
    DynamicsInput::Wheel,    DynamicsInput::Direction,    DynamicsInput::Speed,
    DynamicsInput::Distance, DynamicsInput::Fade,         DynamicsInput::Time,
    DynamicsInput::Load,     DynamicsInput::StrokeRandom, DynamicsInput::DabRandom};
constexpr std::array kTargets = {DynamicsTarget::Press, DynamicsTarget::Lean,   DynamicsTarget::Rotation,
                                 DynamicsTarget::Reach, DynamicsTarget::Film,   DynamicsTarget::Pickup,
                                 DynamicsTarget::Flow,  DynamicsTarget::Spread, DynamicsTarget::Ride};

QToolButton* small_button(const char* name, const QString& words, const QString& hint) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setText(words);
    button->setToolTip(hint);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    keep_keys_for_canvas(button);
    return button;
}

}  // namespace

CurvesPanel::CurvesPanel(QWidget* parent)
    : QWidget(parent),
      which_(new QComboBox),
      editor_(new CurveEditor),
      reading_(new QLabel),
      addable_(new QMenu(this)),
      add_(small_button("curve_add", tr("Add"),
                        tr("Another curve: what of the hand sets what of the tool"))),
      remove_(small_button("curve_remove", tr("Remove"), tr("Takes this curve away"))),
      reset_(small_button("curve_reset", tr("Reset"), tr("The curve as the tool was kept with"))) {
    auto* column = section(this, tr("How it answers to the hand"));
    which_->setObjectName(QStringLiteral("curve_choice"));
    which_->setToolTip(tr("What of the hand sets what of the tool"));
    which_->setAccessibleName(which_->toolTip());
    which_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    keep_keys_for_canvas(which_);
    reading_->setObjectName(QStringLiteral("curve_reading"));
    addable_->setObjectName(QStringLiteral("curve_addable"));
    add_->setMenu(addable_);
    add_->setPopupMode(QToolButton::InstantPopup);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (QToolButton* button : {add_, remove_, reset_})
        row->addWidget(button);
    column->addWidget(which_);
    column->addWidget(editor_);
    column->addWidget(reading_);
    column->addLayout(row);
    connect(addable_, &QMenu::aboutToShow, this, &CurvesPanel::list_addable);
    connect(remove_, &QToolButton::clicked, this, &CurvesPanel::remove_current);
    connect(which_, &QComboBox::currentIndexChanged, this, &CurvesPanel::show_current);
    connect(editor_, &CurveEditor::edited, this, &CurvesPanel::emit_points);
    connect(editor_, &CurveEditor::read_at, this, &CurvesPanel::read_at);
    connect(reset_, &QToolButton::clicked, this, &CurvesPanel::reset_current);
}

void CurvesPanel::show_preset(const brush::Preset& in_hand, const brush::Preset& kept) {
    if (in_hand == preset_ && kept == kept_) return;
    const bool same_tool = in_hand.name == preset_.name;
    preset_ = in_hand;
    kept_ = kept;
    list_curves(same_tool ? which_->currentIndex() : 0);
}

/// Chooses the curve of that index, or the last before it that there is.
void CurvesPanel::list_curves(int chosen) {
    {
        const QSignalBlocker quiet(which_);
        which_->clear();
        for (const DynamicsCurve& curve : preset_.dynamics)
            which_->addItem(curve_words(curve.input, curve.target));
        which_->setCurrentIndex(std::min(std::max(chosen, 0), which_->count() - 1));
        which_->setEnabled(which_->count() > 0);
    }
    show_current();
}

void CurvesPanel::show_current() {
    const int index = which_->currentIndex();
    const bool any = index >= 0 && index < static_cast<int>(preset_.dynamics.size());
    const DynamicsCurve curve =
        any ? preset_.dynamics[static_cast<std::size_t>(index)] : DynamicsCurve{};
    editor_->show_curve(curve);
    editor_->setEnabled(any);
    remove_->setEnabled(any);
    const DynamicsCurve* kept = any ? kept_curve() : nullptr;
    reset_->setEnabled(kept != nullptr && !(*kept == curve));
    if (any)
        read_at(0.5 * editor_->frame().most_input);
    else
        reading_->setText(tr("This tool has no curves."));
}

/// The current curve as the tool was kept with it, or null: it stands at another place where curves were
/// added or removed.
const DynamicsCurve* CurvesPanel::kept_curve() const {
    const auto index = static_cast<std::size_t>(which_->currentIndex());
    const DynamicsCurve& current = preset_.dynamics[index];
    const auto& kept = kept_.dynamics;
    const auto alike = [&](const DynamicsCurve& curve) {
        return curve.input == current.input && curve.target == current.target;
    };
    if (index < kept.size() && alike(kept[index])) return &kept[index];
    const int found = tools::find_curve(kept, current.input, current.target);
    return found < 0 ? nullptr : &kept[static_cast<std::size_t>(found)];
}

// ---- adding and removing

/// A menu for every input; what is there already cannot be chosen again.
void CurvesPanel::list_addable() {
    addable_->clear();
    for (const DynamicsInput input : kInputs) {
        QMenu* menu = addable_->addMenu(input_words(input));
        for (const DynamicsTarget target : kTargets) {
            if (!tools::matters(input, target, preset_.kind)) continue;
            QAction* action = menu->addAction(target_words(target), this,
                                              [this, input, target] { add(input, target); });
            action->setEnabled(tools::find_curve(preset_.dynamics, input, target) < 0);
        }
    }
}

/// A curve that the tool was kept with comes back as it was.
void CurvesPanel::add(DynamicsInput input, DynamicsTarget target) {
    const int added = tools::add_curve(preset_.dynamics, input, target);
    const int kept = tools::find_curve(kept_.dynamics, input, target);
    if (kept >= 0)
        preset_.dynamics[static_cast<std::size_t>(added)] =
            kept_.dynamics[static_cast<std::size_t>(kept)];
    list_curves(added);
    Q_EMIT edited(preset_);
}

void CurvesPanel::remove_current() {
    const int index = which_->currentIndex();
    if (index < 0) return;
    preset_.dynamics.erase(preset_.dynamics.begin() + index);
    list_curves(index);
    Q_EMIT edited(preset_);
}

// ---- the current curve

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
