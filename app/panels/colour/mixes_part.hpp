// The mixes that the painter has words for: "my sky".
#pragma once

#include "tools/paint_shelf.hpp"
#include "tools/swatch.hpp"

#include <vector>

#include <QWidget>

class QLabel;
class QPushButton;

namespace pastoso::panels {

class ChoiceList;

/// A click takes one in hand. A double click or F2 gives it another name, Delete or Backspace takes it
/// away.
class MixesPart : public QWidget {
    Q_OBJECT
  public:
    explicit MixesPart(QWidget* parent = nullptr);

    /// Without a signal.
    void show_mixes(const std::vector<tools::NamedPaint>& mixes, const tools::SwatchView& view);

    /// Whether there is anything to export.
    void allow_export(bool allowed);

    /// Lets the painter type the name of one.
    void ask_name(int index);

  Q_SIGNALS:
    void keep_wanted();
    void taken(int index);
    void renamed(int index, const QString& name);
    void removal_wanted(int index);
    void export_wanted();
    void import_wanted();

  private:
    void remove_current();

    ChoiceList* list_ = nullptr;
    QLabel* none_ = nullptr;  ///< stands in the place of an empty list
    QPushButton* remove_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace pastoso::panels
