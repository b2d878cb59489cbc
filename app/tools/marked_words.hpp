// Marks words that a window shows translated, where Qt is not known; packaging/words.sh finds them.
#pragma once

/// Translated in the context of the namespace that it stands in, "pastoso::tools" for example.
#define PASTOSO_WORDS(text) text
