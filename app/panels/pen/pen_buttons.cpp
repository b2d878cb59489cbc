#include "panels/pen/pen_buttons.hpp"

#include "appearance/shown_names.hpp"
#include "commands/command_names.hpp"
#include "commands/command_words.hpp"
#include "panels/parts/labels.hpp"

#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {

using tools::PenButton;
using tools::PenButtonDoes;

PenButtons::PenButtons(const tools::PenSettings& settings, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(heading(tr("Ends and buttons of pens")));
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    const auto add = [&](const QString& words, QComboBox* box) {
        auto* label = new QLabel(words);
        label->setBuddy(box);
        const int row = grid->rowCount();
        grid->addWidget(label, row, 0);
        grid->addWidget(box, row, 1);
    };
    add(tr("Eraser end"), eraser_choice(settings.eraser_tool));
    const auto add_button = [&](const QString& words, const char* name, PenButton button) {
        add(words, button_choice(name, button, settings.action(button)));
    };
    add_button(tr("Lower button"), "lower_button", PenButton::Lower);
    add_button(tr("Upper button"), "upper_button", PenButton::Upper);
    add_button(tr("Third button"), "third_button", PenButton::Third);
    add_button(tr("Wheel forward"), "wheel_forward", PenButton::WheelForward);
    add_button(tr("Wheel back"), "wheel_back", PenButton::WheelBack);
    column->addLayout(grid);
    auto* fingers = new QCheckBox(tr("Fingers paint"));
    fingers->setObjectName(QStringLiteral("fingers_paint"));
    fingers->setToolTip(tr("Otherwise one finger moves the canvas, as two always do"));
    fingers->setChecked(settings.fingers_paint);
    connect(fingers, &QCheckBox::toggled, this, &PenButtons::fingers_chosen);
    column->addWidget(fingers);
    auto* mark = new QCheckBox(tr("Wet mark"));
    mark->setObjectName(QStringLiteral("wet_mark"));
    mark->setToolTip(tr("Shows paint under the pen at once, until the paint itself is on the screen"));
    mark->setChecked(settings.wet_mark);
    connect(mark, &QCheckBox::toggled, this, &PenButtons::mark_chosen);
    column->addWidget(mark);
    column->addStretch(1);
}

/// A wheel gives commands alone.
QComboBox* PenButtons::button_choice(const char* name, PenButton button,
                                     const tools::PenAction& chosen) {
    const bool is_wheel = button == PenButton::WheelForward || button == PenButton::WheelBack;
    const std::pair<PenButtonDoes, QString> choices[] = {
        {PenButtonDoes::Nothing, tr("does nothing")},
        {PenButtonDoes::PickPaint, tr("picks up paint")},
        {PenButtonDoes::PickColour, tr("picks the colour seen")},
        {PenButtonDoes::MoveCanvas, tr("moves the canvas")},
        {PenButtonDoes::PopupPalette, tr("opens the palette")}};
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const auto& [what, words] : choices) {
        if (is_wheel && what != PenButtonDoes::Nothing) continue;
        box->addItem(words, QVariant::fromValue(tools::PenAction{what}));
    }
    box->insertSeparator(box->count());
    for (const commands::CommandText& command : commands::command_list())
        box->addItem(commands::plain_words(command.words),
                     QVariant::fromValue(tools::PenAction{
                         PenButtonDoes::Command, std::string(commands::name_of(command.command))}));
    for (int i = 0; i < box->count(); ++i)
        if (box->itemData(i).isValid() && box->itemData(i).value<tools::PenAction>() == chosen)
            box->setCurrentIndex(i);
    connect(box, &QComboBox::activated, this, [this, box, button] {
        Q_EMIT button_chosen(button, box->currentData().value<tools::PenAction>());
    });
    return box;
}

QComboBox* PenButtons::eraser_choice(const std::string& chosen) {
    auto* box = new QComboBox;
    box->setObjectName(QStringLiteral("eraser_tool"));
    for (const std::string& tool : tools::eraser_tools())
        box->addItem(tr("takes %1").arg(appearance::shown_name(tool)), QString::fromStdString(tool));
    box->addItem(tr("paints like the tip"), QString());
    box->setCurrentIndex(box->findData(QString::fromStdString(chosen)));
    connect(box, &QComboBox::activated, this,
            [this, box] { Q_EMIT eraser_chosen(box->currentData().toString()); });
    return box;
}

}  // namespace pastoso::panels
