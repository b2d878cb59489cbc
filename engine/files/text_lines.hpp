// A text that is read line by line and word by word, where every complaint names its line.
#pragma once

#include "core/message.hpp"

#include <string>
#include <string_view>

namespace pastoso::files {

/// Text and name outlive it. Lines end in LF or CR LF; words are what spaces and tabs part.
class TextLines {
  public:
    TextLines(std::string_view text, const std::string& file) : rest_(text), file_(&file) {}

    /// Goes to the next line; false when there is none.
    bool next();

    /// The next word of this line; empty at its end.
    std::string_view word();

    /// The next word as a finite number of single precision. Throws InputError when it is none.
    float number();

    /// Throws InputError "FILE, line N: MESSAGE".
    [[noreturn]] void fail(const core::Message& message) const;
    template <class... Arguments>
    [[noreturn]] void fail(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        fail(core::message(pattern, arguments...));
    }

  private:
    std::string_view rest_, line_;
    const std::string* file_;
    long line_number_ = 0;
};

/// A word in quotes as a message may show it: not too long, and without what is no printable ASCII.
std::string quoted(std::string_view word);

}  // namespace pastoso::files
