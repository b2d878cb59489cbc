// The colours of a palette of another program, or of a picture, to choose from.
#pragma once

#include "document/paint_recipe.hpp"
#include "pigment/gpl.hpp"
#include "tools/swatch.hpp"

#include <vector>

#include <QWidget>

class QCheckBox;
class QLabel;
class QSpinBox;

namespace pastoso::panels {

class SwatchGrid;

class OpenedPalette : public QWidget {
    Q_OBJECT
  public:
    explicit OpenedPalette(QWidget* parent = nullptr);

    void show_palette(const pigment::ColourPalette& palette);

    /// Shows all paint as it looks there from now on.
    void show_swatches(const tools::SwatchView& view);

  Q_SIGNALS:
    void file_wanted();
    void picture_wanted(int colours);  ///< a palette of so many
    void paint_chosen(const document::PaintRecipe& paint);

  private:
    /// A colour as the paint that a click takes.
    struct Choice {
        document::PaintRecipe paint;
        QString name;  ///< may be empty
    };
    void find_paints();
    void show_patches();

    pigment::ColourPalette palette_;
    std::vector<Choice> choices_;
    tools::SwatchView view_;
    QLabel* name_ = nullptr;
    QSpinBox* count_ = nullptr;
    QCheckBox* from_tubes_ = nullptr;
    SwatchGrid* grid_ = nullptr;
};

}  // namespace pastoso::panels
