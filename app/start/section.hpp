// Small shared pieces of the start page.
#pragma once

#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::start {

inline QLabel* heading(const QString& words) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("heading"));
    return label;
}

/// The column in which a section's heading stands above what it offers.
inline QVBoxLayout* section_column(QWidget* section) {
    auto* column = new QVBoxLayout(section);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    return column;
}

}  // namespace pastoso::start
