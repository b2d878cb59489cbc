#include "dialogs/transform_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "dialogs/length_box.hpp"
#include "document/actions/actions.hpp"

#include <algorithm>
#include <cmath>

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

namespace pastoso::dialogs {
namespace {

constexpr double kPercent = 100.0;
constexpr int kDecimals = 2;

void show_number(QDoubleSpinBox* box, double value) {
    const QSignalBlocker quiet(box);
    box->setValue(value);
}

QDoubleSpinBox* box_of(const char* name, const QString& unit) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setSuffix(unit);
    return box;
}

void show_check(QToolButton* button, bool checked) {
    const QSignalBlocker quiet(button);
    button->setChecked(checked);
}

bool reaches_beyond(const tools::TransformFrame& frame, const QSizeF& canvas_mm) {
    return std::any_of(tools::kFrameHandles.begin(), tools::kFrameHandles.end(), [&](const auto& side) {
        const glm::dvec2 place = tools::handle_mm(frame, side);
        return place.x < 0.0 || place.y < 0.0 || place.x > canvas_mm.width() ||
               place.y > canvas_mm.height();
    });
}

}  // namespace

TransformDialog::TransformDialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm,
                                 QWidget* parent)
    // A tool window leaves the keys of the window below it as they are.
    : GrowingDialog(parent, Qt::Tool),
      frame_(frame),
      canvas_mm_(canvas_mm),
      outcome_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Transform"));
    constexpr double kFar_mm = document::kMaxPenPosition_mm;
    constexpr double kLeast = kPercent * document::kLeastScale, kMost = kPercent * document::kMostScale;
    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 14, 18, 14);
    form->setSpacing(9);
    const QString mm = tr(" mm"), percent = tr(" %"), degrees = tr("°");
    move_x_ = add_number(form, new UnitBox(read_length_mm, QStringLiteral("move_x"), mm),
                         tr("Move right"), {-kFar_mm, kFar_mm});
    move_y_ = add_number(form, new UnitBox(read_length_mm, QStringLiteral("move_y"), mm),
                         tr("Move down"), {-kFar_mm, kFar_mm});
    width_ = add_number(form, box_of("width", percent), tr("Width"), {kLeast, kMost});
    height_ = add_number(form, box_of("height", percent), tr("Height"), {kLeast, kMost});
    turn_ = add_number(form, box_of("turn", degrees), tr("Turn"), {-180.0, 180.0});
    turn_->setWrapping(true);
    turn_->setToolTip(tr("Clockwise, about the middle of the frame"));
    mirror_x_ = make_mirror(QStringLiteral("mirror_x"), tr("Left–right"),
                            tr("Left and right of the paint change places, before it is turned"));
    mirror_y_ = make_mirror(QStringLiteral("mirror_y"), tr("Up–down"),
                            tr("Above and below change places, before the paint is turned"));
    auto* mirrors = new QHBoxLayout;
    mirrors->addWidget(mirror_x_);
    mirrors->addWidget(mirror_y_);
    form->addRow(tr("Mirror"), mirrors);
    auto* corners =
        new QLabel(tr("Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, "
                      "arrows move it, with Shift by ten pixels."));
    corners->setObjectName(QStringLiteral("corners"));
    corners->setWordWrap(true);
    form->addRow(tr("Corners"), corners);
    outcome_->setObjectName(QStringLiteral("outcome"));
    outcome_->setWordWrap(true);
    outcome_->setMinimumHeight(2 * outcome_->fontMetrics().lineSpacing());
    outcome_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    form->addRow(outcome_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Apply"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons_);
    show_frame(frame);
}

QDoubleSpinBox* TransformDialog::add_number(QFormLayout* form, QDoubleSpinBox* box, const QString& words,
                                            std::pair<double, double> range) {
    box->setRange(range.first, range.second);
    box->setDecimals(kDecimals);
    box->setStepType(QAbstractSpinBox::DefaultStepType);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TransformDialog::read_numbers);
    form->addRow(words, box);
    return box;
}

QToolButton* TransformDialog::make_mirror(const QString& name, const QString& words,
                                          const QString& hint) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(words);
    button->setToolTip(hint);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::toggled, this, &TransformDialog::read_numbers);
    return button;
}

void TransformDialog::read_numbers() {
    const auto scale = [](const QDoubleSpinBox* box, double shown, const QToolButton* mirror) {
        const double size = unrounded(*box, kPercent * std::abs(shown)) / kPercent;
        return mirror->isChecked() ? -size : size;
    };
    frame_.move_mm = {unrounded(*move_x_, frame_.move_mm.x), unrounded(*move_y_, frame_.move_mm.y)};
    frame_.scale = {scale(width_, frame_.scale.x, mirror_x_), scale(height_, frame_.scale.y, mirror_y_)};
    frame_.turn_deg = unrounded(*turn_, frame_.turn_deg);
    show_outcome();
    Q_EMIT changed(frame_);
}

void TransformDialog::show_frame(const tools::TransformFrame& frame) {
    frame_ = frame;
    show_number(move_x_, frame.move_mm.x);
    show_number(move_y_, frame.move_mm.y);
    show_number(width_, kPercent * std::abs(frame.scale.x));
    show_number(height_, kPercent * std::abs(frame.scale.y));
    show_number(turn_, frame.turn_deg);
    show_check(mirror_x_, frame.scale.x < 0.0);
    show_check(mirror_y_, frame.scale.y < 0.0);
    show_outcome();
}

/// What there is more or less of afterwards.
void TransformDialog::show_outcome() {
    const core::Message problem = tools::problem_of(frame_);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem.empty());
    if (!problem.empty()) return outcome_->setText(appearance::shown_message(problem));
    const double share = tools::area_growth(frame_);
    const double percent = kPercent * share;
    QString words = share == 1.0 ? tr("The paint keeps its thickness and its amount.")
                                 : tr("The paint keeps its thickness: %1 % of it will be there.")
                                       .arg(appearance::shown_number(percent, percent < 9.95 ? 1 : 0));
    if (reaches_beyond(frame_, canvas_mm_))
        words += QLatin1Char(' ') + tr("What comes beyond the canvas is wiped off.");
    outcome_->setText(words);
}

}  // namespace pastoso::dialogs
