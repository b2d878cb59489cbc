// Which tools the list shows: a family, favourites, those used last, or what is named by a few letters.
#pragma once

#include "panels/pen/brush_list.hpp"
#include "tools/brush_shelf.hpp"

#include <vector>

#include <QWidget>

class QComboBox;
class QLineEdit;

namespace pastoso::panels {

struct BrushChoice {
    enum class Kind { All, Favourites, Recent, Own, Family };
    Kind kind = Kind::All;
    QString family{};  ///< where it is one
    QString typed{};   ///< looks through all tools, whatever else is chosen
};

/// Those of the entries that are chosen, in their order; the recent ones with the latest first, and
/// under no heading. Favourites are marked.
std::vector<BrushEntry> chosen_brushes(const std::vector<BrushEntry>& entries,
                                       const tools::BrushShelf& shelf, const BrushChoice& choice);

class BrushFinder : public QWidget {
    Q_OBJECT
  public:
    explicit BrushFinder(QWidget* parent = nullptr);

    /// Offers the families of these tools. What was chosen stays so where it still is there.
    void show_families(const std::vector<BrushEntry>& entries);

    BrushChoice choice() const;

  Q_SIGNALS:
    void changed();
    /// Return was pressed among the letters.
    void first_wanted();

  private:
    QComboBox* folder_;
    QLineEdit* typed_;
};

}  // namespace pastoso::panels
