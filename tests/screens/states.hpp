// The states of the program that pictures are taken of.
#pragma once

#include "camera.hpp"

#include <QString>

namespace pastoso::screens {

// Of the painting that is on the easel; all of them leave it as it was.
void take_views(Camera& camera);
void take_panels(Camera& camera);
void take_popups(Camera& camera);
void take_dialogs(Camera& camera);
void take_lights(Camera& camera);
void take_layer_tools(Camera& camera);
void take_replay(Camera& camera);
void take_accidents(Camera& camera);
void take_light_theme(Camera& camera);
void take_tea(Camera& camera);
void take_tank(Camera& camera);

/// Puts up a bare canvas, and paints on it.
void take_fresh_canvas(Camera& camera, const QString& traced);

/// A corner of the window in another language, which it speaks from then on.
QPixmap foreign_window(const QString& language, const QString& painting);

}  // namespace pastoso::screens
