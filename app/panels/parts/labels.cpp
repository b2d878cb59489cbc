#include "panels/parts/labels.hpp"

#include <QCoreApplication>
#include <QLabel>

namespace pastoso::panels {

QLabel* heading(const QString& words) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("heading"));
    return label;
}

QLabel* note(const QString& words) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("reading"));
    label->setWordWrap(true);
    return label;
}

QString translated(const char* words) {
    return QCoreApplication::translate("pastoso::panels", words);
}

}  // namespace pastoso::panels
