// Small patches of paint in rows, to choose one from.
#pragma once

#include <vector>

#include <QColor>
#include <QString>
#include <QWidget>

namespace pastoso::panels {

class PaintSwatch;

class SwatchGrid : public QWidget {
    Q_OBJECT
  public:
    explicit SwatchGrid(int columns, QWidget* parent = nullptr);

    struct Patch {
        QColor colour;
        QString words;
    };
    void show_patches(const std::vector<Patch>& patches);

  Q_SIGNALS:
    void patch_clicked(int index);
    void removal_wanted(int index);

  private:
    int columns_;
    std::vector<PaintSwatch*> swatches_;
};

}  // namespace pastoso::panels
