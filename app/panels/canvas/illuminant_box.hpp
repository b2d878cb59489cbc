// A choice of the light that the painting is seen in.
#pragma once

#include <QComboBox>

namespace pastoso::panels {

class IlluminantBox : public QComboBox {
    Q_OBJECT
  public:
    explicit IlluminantBox(QWidget* parent = nullptr);

    /// Shows the name of a bundled light or the path of a file, without a signal.
    void show_illuminant(const QString& name_or_path);

  Q_SIGNALS:
    void chosen(const QString& name_or_path);
    void file_wanted();
};

}  // namespace pastoso::panels
