#include "glass/tea_panel.hpp"

#include "glass/glass_chooser.hpp"
#include "glass/tea_feel.hpp"
#include "glass/tea_words.hpp"
#include "panels/parts/feel_row.hpp"
#include "panels/parts/fitted_picture.hpp"
#include "panels/parts/fold.hpp"
#include "panels/parts/gallery.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <utility>

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace pastoso::glass {
namespace {

constexpr int kCells[] = {32, 48, 64, 96, 128};
constexpr QSize kRecipePicture(80, 80);

constexpr std::pair<TeaFeel, FeelWords> kFeels[] = {
    {TeaFeel::WarmToColdMilk,
     {"warm_to_cold", QT_TR_NOOP("warm milk"), QT_TR_NOOP("cold milk"),
      QT_TR_NOOP("Warm milk spreads under the surface, cold milk falls to the floor")}},
    {TeaFeel::ThinToCreamy,
     {"thin_to_creamy", QT_TR_NOOP("thin"), QT_TR_NOOP("creamy"),
      QT_TR_NOOP("Thin milk stays below and mixes soon, creamy milk rises in large soft clouds")}},
    {TeaFeel::PouredLowToHigh,
     {"low_to_high", QT_TR_NOOP("poured low"), QT_TR_NOOP("from high"),
      QT_TR_NOOP("Poured low, milk comes to lie on the floor; from high, it stirs the whole glass")}},
    {TeaFeel::HotToIceColdTea,
     {"hot_to_ice_cold", QT_TR_NOOP("hot tea"), QT_TR_NOOP("ice-cold tea"),
      QT_TR_NOOP("Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell")}}};

ValueRow* add_row(QGridLayout* grid, const TeaRow& row) {
    const liquid::TeaNumber& number = number_of(row);
    return add_number(grid, row.shown, number.key, number.least, number.most);
}

}  // namespace

TeaPanel::TeaPanel(const TeaActions& actions, QWidget* parent)
    : QWidget(parent), recipes_(tea_recipes()) {
    setObjectName(QStringLiteral("tea_panel"));
    QVBoxLayout* column = column_of(this);
    add_glass(column, actions);
    add_feels(column);
    add_recipes(column);
    QVBoxLayout* pictures = section_under(column, tr("Pictures"));
    pictures->addWidget(panels::button_row({actions.render}));
    pictures->addWidget(panels::button_row({actions.export_mesh}));
    Fold* numbers = new_numbers_fold();
    add_next_glass(numbers->column());
    add_force(numbers->column(), actions);
    for (const TeaSection& section : tea_sections())
        add_numbers(numbers->column(), section);
    column->addWidget(numbers);
    column->addStretch(1);
    liquid::TeaSettings usual;
    usual.parcels = kLiveParcels;
    show_settings(usual);
    show_force({});
}

void TeaPanel::add_glass(QVBoxLayout* column, const TeaActions& actions) {
    chooser_ = new GlassChooser;
    QVBoxLayout* section = glass_section_under(column, tr("Glass"), actions.glass.back, chooser_);
    section->addWidget(panels::button_row({actions.pour, actions.force}));
    section->addWidget(panels::button_row({actions.new_glass, actions.open, actions.save}));
}

void TeaPanel::add_feels(QVBoxLayout* column) {
    QGridLayout* grid = rows_under(section_under(column, tr("Milk and tea")));
    for (const auto& [feel, words] : kFeels) {
        FeelRow* row = add_feel(grid, words);
        connect(row, &FeelRow::chosen, this,
                [this, feel](double place) { change(with_place(settings_, feel, place)); });
        feels_.push_back(row);
    }
}

void TeaPanel::add_recipes(QVBoxLayout* column) {
    gallery_ = new panels::Gallery(kRecipePicture, 0);
    gallery_->setObjectName(QStringLiteral("tea_recipes"));
    gallery_->setAccessibleName(tr("Recipes"));
    panels::keep_keys_for_canvas(gallery_);
    std::vector<panels::Tile> tiles;
    for (const TeaRecipe& recipe : recipes_)
        tiles.push_back(
            {.name = recipe.words,
             .hint = recipe.hint,
             .picture = panels::fitted(QImage(QString::fromStdString(recipe.picture.string())),
                                       kRecipePicture, devicePixelRatioF())});
    gallery_->show_tiles(tiles);
    section_under(column, tr("Recipes"))->addWidget(gallery_);
    connect(gallery_, &panels::Gallery::chosen, this, [this](int number) {
        Q_EMIT recipe_chosen(recipes_.at(static_cast<std::size_t>(number)).scene);
    });
}

void TeaPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const QMargins margins = layout()->contentsMargins();
    gallery_->fit(event->size().width() - margins.left() - margins.right());
}

void TeaPanel::add_next_glass(QVBoxLayout* column) {
    QGridLayout* grid = rows_under(section_under(column, tr("The next glass")));
    cells_ = new QComboBox;
    cells_->setObjectName(QStringLiteral("cells"));
    cells_->setToolTip(
        tr("Parts that each side of the next glass is divided into: twice as many take sixteen "
           "times as long; balls rise from 64 on"));
    for (const int cells : kCells)
        cells_->addItem(QString::number(cells), cells);
    panels::keep_keys_for_canvas(cells_);
    parcels_ = new QSpinBox;
    parcels_->setObjectName(QStringLiteral("parcels"));
    parcels_->setRange(1, liquid::kMaxParcels);
    parcels_->setSingleStep(1000);
    parcels_->setAlignment(Qt::AlignRight);
    parcels_->setKeyboardTracking(false);
    parcels_->setToolTip(tr("Drops that the next glass' milk is made of"));
    const auto add = [&](const QString& words, QWidget* number) {
        auto* label = new QLabel(words);
        label->setObjectName(QStringLiteral("reading"));
        label->setToolTip(number->toolTip());
        const int row = grid->rowCount();
        grid->addWidget(label, row, 0);
        grid->addWidget(number, row, 1, 1, 2);
    };
    add(tr("Fineness"), cells_);
    add(tr("Drops of milk"), parcels_);
    milk_ = add_row(grid, poured_milk());
    connect(cells_, &QComboBox::activated, this,
            [this] { settings_.cells = cells_->currentData().toInt(); });
    connect(parcels_, &QSpinBox::valueChanged, this, [this](int count) { settings_.parcels = count; });
    connect(milk_, &ValueRow::chosen, this,
            [this](double ml) { settings_.milk_m3 = ml / poured_milk().shown.scale; });
}

void TeaPanel::add_force(QVBoxLayout* column, const TeaActions& actions) {
    QVBoxLayout* section = section_under(column, tr("Force"));
    section->addWidget(panels::button_row({actions.reverse}));
    section->addWidget(
        panels::icon_row({actions.left, actions.right, actions.away, actions.near, actions.recentre}));
    QGridLayout* grid = rows_under(section);
    swirl_ = new ValueRow(grid, QStringLiteral("swirl_rad_s2"), tr("Around the axis"),
                          tr("How fast the stirring gets faster; below 0 it goes the other way round"),
                          {-1e3, 1e3, 1, tr(" rad/s²"), false, {{-20.0, 20.0}}});
    push_ = new ValueRow(grid, QStringLiteral("push_m_s2"), tr("Downwards"),
                         tr("A push down along the axis; below 0 it goes up"),
                         {-1e3, 1e3, 2, tr(" m/s²"), false, {{-2.0, 2.0}}});
    connect(swirl_, &ValueRow::chosen, this, [this](double value) {
        force_.swirl_rad_s2 = value;
        Q_EMIT force_changed(force_);
    });
    connect(push_, &ValueRow::chosen, this, [this](double value) {
        force_.push_m_s2 = value;
        Q_EMIT force_changed(force_);
    });
}

void TeaPanel::add_numbers(QVBoxLayout* column, const TeaSection& section) {
    QGridLayout* grid = rows_under(section_under(column, words_of(section.heading)));
    for (const TeaRow& row : section.rows) {
        ValueRow* shown = add_row(grid, row);
        connect(shown, &ValueRow::chosen, this, [this, &row](double value) {
            liquid::TeaSettings settings = settings_;
            settings.*row.value = value / row.shown.scale;
            change(settings);
        });
        shown_.push_back({&row, shown});
    }
}

void TeaPanel::change(const liquid::TeaSettings& settings) {
    show_settings(settings);
    Q_EMIT numbers_changed(settings_);
}

void TeaPanel::show_settings(const liquid::TeaSettings& settings) {
    settings_ = settings;
    const QSignalBlocker quiet_cells(cells_), quiet_parcels(parcels_);
    if (cells_->findData(settings.cells) < 0)
        cells_->addItem(QString::number(settings.cells), settings.cells);
    cells_->setCurrentIndex(cells_->findData(settings.cells));
    parcels_->setValue(settings.parcels);
    milk_->show_value(poured_milk().shown.scale * settings.milk_m3);
    for (std::size_t i = 0; i < feels_.size(); ++i)
        feels_[i]->show_place(tools::feel_place(settings, numbers_of(kFeels[i].first)));
    for (const Shown& shown : shown_)
        shown.widget->show_value(shown.row->shown.scale * settings.*shown.row->value);
}

void TeaPanel::show_force(const session::TeaForce& force) {
    force_ = force;
    swirl_->show_value(force.swirl_rad_s2);
    push_->show_value(force.push_m_s2);
}

}  // namespace pastoso::glass
