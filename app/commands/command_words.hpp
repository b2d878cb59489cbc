// The words of the commands in the language of the window.
#pragma once

#include <QString>

namespace pastoso::commands {

/// What the list of commands says, with the mnemonic.
QString words_of(const char* text);

/// The same as it is read, without the mark of the mnemonic and the dots.
QString plain_words(const char* text);

}  // namespace pastoso::commands
