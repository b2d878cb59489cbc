// Asks for the name of what a painter keeps.
#pragma once

#include <optional>

#include <QString>
#include <QStringList>

class QWidget;

namespace pastoso::dialogs {

struct AskedName {
    QString title;
    QString label;  ///< what the name is of
    QString proposal;
    QStringList choices{};  ///< where the name of one may be chosen as well
};

/// Never empty and without spaces at its ends: OK waits for a name. Nothing where it is given up.
std::optional<QString> ask_name(const AskedName& asked, QWidget* parent);

}  // namespace pastoso::dialogs
