// A paint of any colour, what of the tubes comes nearest to it, and the paints that were used before or
// kept.
#pragma once

#include "document/events.hpp"
#include "panels/paint/swatch_grid.hpp"
#include "pigment/hex_colour.hpp"
#include "tools/paint_shelf.hpp"
#include "tools/swatch.hpp"

#include <vector>

#include <QWidget>

class QAction;
class QLabel;
class QPushButton;

namespace pastoso::panels {

class ColourPicker;
class MixesPart;
class OpenedPalette;
class PaintSwatch;

class ColourPanel : public QWidget {
    Q_OBJECT
  public:
    /// `picks` become buttons.
    explicit ColourPanel(const std::vector<QAction*>& picks, QWidget* parent = nullptr);

    /// Shows what the brush is dipped in, without a signal, and remembers it among the recent paints.
    void show_paint(const document::PaintRecipe& paint);

    /// Shows all paint as it looks there from now on.
    void show_swatches(const tools::SwatchView& view);

    /// Shows the colours of a palette to choose from.
    void show_palette(const pigment::ColourPalette& palette);

    /// Adds the palette and the mixes of another painter, with a signal. How many paints are new.
    int add_paints(const tools::PaintShelf& set);

    const tools::PaintShelf& shelf() const { return shelf_; }

    /// As a click on one of its paints does.
    void choose(const document::PaintRecipe& paint) { Q_EMIT paint_chosen(paint); }

    /// Shows the paints of an earlier session, without a signal.
    void show_shelf(const tools::PaintShelf& shelf);

  Q_SIGNALS:
    void paint_chosen(const document::PaintRecipe& paint);
    void palette_wanted();
    void picture_wanted(int colours);  ///< whose palette has so many
    void palette_save_wanted();
    void export_wanted();
    void import_wanted();
    void shelf_changed();
    void refused(const QString& sentence);

  private:
    QWidget* recipe_part();
    QWidget* recent_part();
    QWidget* kept_part();
    QWidget* mixes_part();
    QWidget* palette_part();
    void show_colour(const pigment::Srgb8& colour);
    void show_wanted();
    void show_nearest(const document::PaintRecipe& paint, double difference);
    void show_nearest_paint();
    std::vector<SwatchGrid::Patch> patches_of(const std::vector<document::PaintRecipe>& paints,
                                              const QString& words) const;
    void keep_paint_in_hand();
    void keep_mix_in_hand();
    void remove_kept(int index);
    void show_recent();
    void show_kept();
    void show_mixes();
    void allow_saving();

    document::PaintRecipe in_hand_;
    pigment::Srgb8 wanted_colour_{};
    document::PaintRecipe nearest_paint_;
    double nearest_difference_ = 0.0;  ///< of it to the colour wanted, CIEDE2000
    tools::PaintShelf shelf_;
    tools::SwatchView view_;
    ColourPicker* picker_ = nullptr;
    PaintSwatch* wanted_ = nullptr;
    PaintSwatch* nearest_ = nullptr;
    QLabel* words_ = nullptr;
    QPushButton* use_recipe_ = nullptr;
    SwatchGrid* recent_grid_ = nullptr;
    SwatchGrid* kept_grid_ = nullptr;
    QLabel* kept_hint_ = nullptr;
    QPushButton* save_ = nullptr;
    MixesPart* mixes_ = nullptr;
    OpenedPalette* opened_ = nullptr;
};

}  // namespace pastoso::panels
