// In which light, from where, under which varnish, and in which colours of a screen the painting is
// shown.
#pragma once

#include "main/studio.hpp"
#include "shade/varnish.hpp"

#include <QObject>
#include <QString>

namespace pastoso::panels {
class EaselPanel;
class LightPanel;
}  // namespace pastoso::panels

namespace pastoso::main {

class LightChoice : public QObject {
    Q_OBJECT
  public:
    LightChoice(Studio& studio, panels::EaselPanel* stand, panels::LightPanel* panel);

    /// A bundled light, by name, or that of a CSV file (pigment/illuminant.hpp). What is none is told,
    /// and the light stays.
    void use(const QString& name_or_path);
    void use_space(pigment::WorkingSpace space);

    /// The lamp over canvas and well.
    void use_lamp(const shade::Lighting& lamp);
    const shade::Lighting& lamp() const { return lamp_; }

    /// What canvas and well are looked at through.
    void use_varnish(const shade::Varnish& varnish);
    const shade::Varnish& varnish() const { return varnish_; }

    /// Of the light, or the path of its file.
    const QString& name() const { return name_; }

  private:
    void ask();
    void move_lamp(double elevation_deg, double azimuth_deg);
    void light_views();  ///< canvas and well
    void colour_views();
    void show();
    void connect_commands();
    void connect_panels();

    Studio& studio_;
    panels::EaselPanel* stand_;
    panels::LightPanel* panel_;
    shade::Lighting lamp_;
    shade::Varnish varnish_;
    pigment::Viewing viewing_;
    QString name_ = QStringLiteral("D65");
};

}  // namespace pastoso::main
