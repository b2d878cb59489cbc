#include "panels/pen/pen_dialog.hpp"

#include "panels/parts/labels.hpp"
#include "panels/pen/curve_editor.hpp"
#include "panels/pen/mouse_part.hpp"
#include "panels/pen/pen_buttons.hpp"
#include "panels/pen/pen_words.hpp"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using tools::PenDevice;
using tools::ReadyCurve;

constexpr int kListWidth = 264;

/// A column without margins of its own.
QVBoxLayout* column_in(QWidget* part) {
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    return column;
}

}  // namespace

PenDialog::PenDialog(tools::PenSettings settings, QWidget* parent)
    : dialogs::GrowingDialog(parent), settings_(std::move(settings)) {
    setObjectName(QStringLiteral("pen_dialog"));
    setWindowTitle(tr("Pen and tablet"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(16, 16, 16, 14);
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(12);
    auto* curves = new QWidget;
    auto* column = column_in(curves);
    device_name_ = heading(QString());
    column->addWidget(device_name_);
    // Both are as tall: the sheet below must not move under a pen that chooses its own curve.
    parts_ = new QStackedLayout;
    mouse_part_ = new MousePart(settings_.mouse);
    connect(mouse_part_, &MousePart::changed, this, [this](const tools::MouseSettings& mouse) {
        settings_.mouse = mouse;
        change();
    });
    parts_->addWidget(mouse_part_);
    parts_->addWidget(make_curve_part());
    column->addLayout(parts_);
    column->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(make_devices(), 0, 0);
    grid->addWidget(make_buttons_part(), 1, 0);
    grid->addWidget(curves, 0, 1);
    grid->addWidget(make_pad_part(), 1, 1);
    grid->addWidget(buttons, 2, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 1);
    show_devices({});
    list_->setFocus();
}

// ---- what stands where

QWidget* PenDialog::make_devices() {
    auto* part = new QWidget;
    part->setFixedWidth(kListWidth);
    auto* column = column_in(part);
    list_ = new QListWidget;
    list_->setObjectName(QStringLiteral("devices"));
    list_->setAccessibleName(tr("Pens and mouse"));
    connect(list_, &QListWidget::currentRowChanged, this, &PenDialog::show_chosen);
    column->addWidget(heading(tr("Pens and mouse")));
    column->addWidget(list_, 1);
    column->addWidget(note(tr("A pen that is not listed comes here when it touches the sheet below.")));
    return part;
}

QWidget* PenDialog::make_curve_part() {
    curve_part_ = new QWidget;
    auto* column = column_in(curve_part_);
    editor_ = new CurveEditor;
    editor_->setObjectName(QStringLiteral("pressure_curve"));
    editor_->keep_rising();
    connect(editor_, &CurveEditor::edited, this, [this](const tools::CurvePoints& points) {
        brush::DynamicsCurve curve;
        curve.points = points;
        use_curve(curve);
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    const auto add_ready = [&](const char* name, ReadyCurve which, const QString& words,
                               const QString& hint) {
        auto* button = new QPushButton(words);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(hint);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, which] { use_curve(ready_curve(which)); });
        row->addWidget(button);
        return button;
    };
    add_ready("soft", ReadyCurve::Soft, tr("Soft"), tr("A light hand already presses hard"));
    reset_ = add_ready("linear", ReadyCurve::Linear, tr("As it comes"),
                       tr("The pressure as the pen tells it, without a curve"));
    add_ready("firm", ReadyCurve::Firm, tr("Firm"), tr("Only a heavy hand presses hard"));
    row->addStretch(1);
    column->addWidget(
        note(tr("From left to right what the pen tells, upwards what the brush is pressed "
                "with.")));
    column->addWidget(editor_);
    column->addLayout(row);
    return curve_part_;
}

QWidget* PenDialog::make_buttons_part() {
    auto* part = new PenButtons(settings_);
    part->setFixedWidth(kListWidth);
    connect(part, &PenButtons::eraser_chosen, this, [this](const QString& tool) {
        settings_.eraser_tool = tool.toStdString();
        change();
    });
    connect(part, &PenButtons::button_chosen, this,
            [this](tools::PenButton button, const tools::PenAction& action) {
                settings_.buttons[static_cast<std::size_t>(button)] = action;
                change();
            });
    connect(part, &PenButtons::fingers_chosen, this, [this](bool paint) {
        settings_.fingers_paint = paint;
        change();
    });
    connect(part, &PenButtons::mark_chosen, this, [this](bool at_once) {
        settings_.wet_mark = at_once;
        change();
    });
    return part;
}

QWidget* PenDialog::make_pad_part() {
    auto* part = new QWidget;
    auto* column = column_in(part);
    auto* row = new QHBoxLayout;
    auto* wipe = new QPushButton(tr("Wipe"));
    wipe->setObjectName(QStringLiteral("wipe"));
    wipe->setAutoDefault(false);
    row->addWidget(heading(tr("Try it here")));
    row->addStretch(1);
    row->addWidget(wipe);
    pad_ = new PenPad;
    readings_ = note(QString());
    readings_->setObjectName(QStringLiteral("pen_readings"));
    readings_->setTextFormat(Qt::PlainText);
    column->addLayout(row);
    column->addWidget(pad_, 1);
    column->addWidget(readings_);
    connect(wipe, &QPushButton::clicked, pad_, &PenPad::wipe);
    connect(pad_, &PenPad::touched, this, &PenDialog::choose_device);
    connect(pad_, &PenPad::read, this, &PenDialog::show_reading);
    pad_->use(settings_);
    show_reading({});
    return part;
}

// ---- the devices

/// What was chosen stays chosen; at first it is the first pen there is.
void PenDialog::show_devices(const std::vector<PenDevice>& devices) {
    const bool begins = devices_.empty();
    const auto chosen = chosen_device();
    {
        const QSignalBlocker quiet(list_);
        devices_.clear();
        list_->clear();
        list_->addItem(tr("Mouse"));
        for (const PenDevice& device : devices)
            add_device(device);
        for (const auto& [device, curve] : settings_.curves)
            add_device(device);
    }
    choose_device(begins && !devices_.empty() ? std::optional(devices_.front()) : chosen);
}

void PenDialog::add_device(const PenDevice& device) {
    if (std::find(devices_.begin(), devices_.end(), device) != devices_.end()) return;
    devices_.push_back(device);
    list_->addItem(words_of(device));
    list_->item(list_->count() - 1)->setToolTip(words_of(device));
}

std::optional<PenDevice> PenDialog::chosen_device() const {
    const int row = list_->currentRow();
    return row > 0 ? std::optional(devices_[static_cast<std::size_t>(row - 1)]) : std::nullopt;
}

void PenDialog::choose_device(const std::optional<PenDevice>& device) {
    if (device) add_device(*device);
    const auto found =
        device ? std::find(devices_.begin(), devices_.end(), *device) - devices_.begin() + 1 : 0;
    list_->setCurrentRow(static_cast<int>(found));
    show_chosen();
}

void PenDialog::show_chosen() {
    const auto device = chosen_device();
    parts_->setCurrentWidget(device ? curve_part_ : mouse_part_);
    device_name_->setText(device ? tr("Pressure of %1").arg(words_of(*device))
                                 : tr("Pressure of the mouse"));
    if (device) {
        editor_->show_curve(curve_of(settings_, *device));
        reset_->setEnabled(settings_.curves.contains(*device));
    }
}

void PenDialog::use_curve(const brush::DynamicsCurve& curve) {
    const auto device = chosen_device();
    if (!device) return;
    set_curve(*device, curve, settings_);
    show_chosen();
    change();
}

void PenDialog::change() {
    pad_->use(settings_);
    Q_EMIT changed(settings_);
}

void PenDialog::show_reading(const PenReading& reading) {
    readings_->setText(words_of(reading));
}

}  // namespace pastoso::panels
