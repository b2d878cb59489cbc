// Which tools the list shows: a family, favourites, a tag, those used last, or what is named by a few
// letters.
#pragma once

#include "panels/pen/brush_list.hpp"
#include "tools/brush_shelf.hpp"

#include <vector>

#include <QWidget>

class QComboBox;
class QLineEdit;

namespace pastoso::panels {

struct BrushChoice {
    enum class Kind { All, Favourites, Recent, Own, Family, Tag };
    Kind kind = Kind::All;
    QString name{};   ///< of the family or the tag, where it is one
    QString typed{};  ///< looks through all tools, whatever else is chosen
};

/// Those of the entries that are chosen, each family in the painter's order. Favourites and tags in
/// their own order, the recent ones with the latest first, under no heading. Favourites are marked.
std::vector<BrushEntry> chosen_brushes(const std::vector<BrushEntry>& entries,
                                       const tools::BrushShelf& shelf, const BrushChoice& choice);

class BrushFinder : public QWidget {
    Q_OBJECT
  public:
    explicit BrushFinder(QWidget* parent = nullptr);

    /// Offers the families of these tools, and these tags. What was chosen stays so where it still is
    /// there.
    void show_folders(const std::vector<BrushEntry>& entries, const std::vector<tools::BrushTag>& tags);

    BrushChoice choice() const;

    /// What would be listed where nothing is; empty where that needs no word.
    QString words_of_none() const;

  Q_SIGNALS:
    void changed();
    /// Return was pressed among the letters.
    void first_wanted();

  private:
    void add_folder(const QString& words, BrushChoice::Kind kind, const QString& name = {});

    QComboBox* folder_;
    QLineEdit* typed_;
};

}  // namespace pastoso::panels
