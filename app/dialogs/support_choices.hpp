// What new canvases are made of, in painters' words.
#pragma once

#include <string>
#include <vector>

#include <QString>

namespace pastoso::dialogs {

struct Support {
    std::string id;  ///< as in document::CanvasSettings
    QString name;
    QString detail;
};

/// Those that new canvases are offered on, the usual one first.
std::vector<Support> supports();

/// A support's name within a sentence; that of an image is "an image".
QString support_words(const std::string& support);

}  // namespace pastoso::dialogs
