#include "panels/pen/pen_buttons.hpp"

#include "appearance/shown_names.hpp"
#include "panels/parts/labels.hpp"

#include <utility>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {

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
    add(tr("Lower button"),
        button_choice("lower_button", &tools::PenSettings::lower_button, settings.lower_button));
    add(tr("Upper button"),
        button_choice("upper_button", &tools::PenSettings::upper_button, settings.upper_button));
    column->addLayout(grid);
    column->addStretch(1);
}

QComboBox* PenButtons::button_choice(const char* name, Button button, PenButtonDoes chosen) {
    const std::pair<PenButtonDoes, QString> choices[] = {
        {PenButtonDoes::PickPaint, tr("picks up paint")},
        {PenButtonDoes::PickColour, tr("picks the colour seen")},
        {PenButtonDoes::MoveCanvas, tr("moves the canvas")},
        {PenButtonDoes::PopupPalette, tr("opens the palette")},
        {PenButtonDoes::Nothing, tr("does nothing")}};
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    for (const auto& [what, words] : choices)
        box->addItem(words, static_cast<int>(what));
    box->setCurrentIndex(box->findData(static_cast<int>(chosen)));
    connect(box, &QComboBox::activated, this, [this, box, button] {
        Q_EMIT button_chosen(button, static_cast<PenButtonDoes>(box->currentData().toInt()));
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
