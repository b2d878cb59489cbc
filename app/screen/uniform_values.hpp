// glm's values as Qt hands them to a shader.
#pragma once

#include <QMatrix2x2>
#include <QVector2D>
#include <glm/mat2x2.hpp>

namespace pastoso::screen {

inline QVector2D vector(const glm::dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

inline QMatrix2x2 matrix(const glm::dmat2& m) {
    QMatrix2x2 rows;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            rows(row, column) = static_cast<float>(m[column][row]);
    return rows;
}

}  // namespace pastoso::screen
