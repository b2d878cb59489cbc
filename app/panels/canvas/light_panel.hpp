// The lamp over the painting, the light it gives, and the varnish that is looked through.
#pragma once

#include "shade/varnish.hpp"

#include <QWidget>

class QComboBox;
class QLabel;

namespace pastoso::panels {

class IlluminantBox;
class LightDial;
class ValueRow;

class LightPanel : public QWidget {
    Q_OBJECT
  public:
    explicit LightPanel(QWidget* parent = nullptr);

    /// Without a signal.
    void show_lamp(const shade::Lighting& lamp);
    void show_varnish(const shade::Varnish& varnish);

    /// The name of a bundled light or the path of a file, without a signal.
    void show_illuminant(const QString& name_or_path);

  Q_SIGNALS:
    void lamp_changed(const shade::Lighting& lamp);
    void varnish_chosen(const shade::Varnish& varnish);
    void illuminant_chosen(const QString& name_or_path);
    void illuminant_file_wanted();

  private:
    QWidget* lamp_section();
    QWidget* varnish_section();
    void change_varnish(double shade::Varnish::*part, double percent);
    void enable_varnish();

    shade::Lighting lamp_;
    shade::Varnish varnish_;
    LightDial* dial_ = nullptr;
    ValueRow *azimuth_ = nullptr, *elevation_ = nullptr, *ambient_ = nullptr;
    IlluminantBox* illuminant_ = nullptr;
    QComboBox* finish_ = nullptr;
    ValueRow *amount_ = nullptr, *yellowing_ = nullptr;
};

}  // namespace pastoso::panels
