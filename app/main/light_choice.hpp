// In which light, from where, and in which colours of a screen the painting is shown.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QString>

namespace pastoso::panels {
class EaselPanel;
}

namespace pastoso::main {

class LightChoice : public QObject {
    Q_OBJECT
  public:
    LightChoice(Studio& studio, panels::EaselPanel* stand);

    /// A bundled light, by name, or that of a CSV file (pigment/illuminant.hpp). What is none is told,
    /// and the light stays.
    void use(const QString& name_or_path);
    void use_space(pigment::WorkingSpace space);

    /// Moves the lamp over canvas and well, and shows where it is.
    void light_from(double elevation_deg, double azimuth_deg);

    /// Of the light, or the path of its file.
    const QString& name() const { return name_; }

  private:
    void ask();
    void show_under(const pigment::Viewing& viewing);  ///< canvas and well
    void show();

    Studio& studio_;
    panels::EaselPanel* stand_;
    QString name_ = QStringLiteral("D65");
};

}  // namespace pastoso::main
