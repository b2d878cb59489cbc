// A button that says which tubes are shown, with a menu of the painter's sets of tubes.
#pragma once

#include <QStringList>
#include <QToolButton>

namespace pastoso::panels {

class TubeMenu : public QToolButton {
    Q_OBJECT
  public:
    explicit TubeMenu(QWidget* parent = nullptr);

    /// `chosen` is one of the names, or empty for all tubes.
    void show_sets(const QStringList& names, const QString& chosen);

    const QStringList& names() const { return names_; }
    const QString& chosen() const { return chosen_; }

  Q_SIGNALS:
    void chosen_set(const QString& name);  ///< empty: all tubes
    void save_wanted();
    void rename_wanted();
    void removal_wanted();
    void squeeze_wanted();
    void last_palette_wanted();
    void export_wanted();  ///< of all sets
    void import_wanted();

  private:
    void fill();

    QStringList names_;
    QString chosen_;
};

}  // namespace pastoso::panels
