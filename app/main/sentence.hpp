// The engine's sentences, which begin small, since many stand behind the name of a file.
#pragma once

#include <string>

#include <QString>

namespace pastoso::main {

/// As a sentence of its own.
inline QString sentence_of(const std::string& fault) {
    QString sentence = QString::fromStdString(fault);
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    return sentence;
}

}  // namespace pastoso::main
