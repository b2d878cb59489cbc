// Bad input: the user's file, argument or device is at fault, and one sentence says where.
#pragma once

#include "core/message.hpp"

#include <memory>
#include <stdexcept>
#include <string>

namespace pastoso::core {

/// An error in something the user gave: one complete sentence that names the file or argument, the place
/// in it and the offending value; what() is it in English. Nothing has been changed or half-written when
/// it is thrown.
class InputError : public std::runtime_error {
  public:
    template <class... Arguments>
    explicit InputError(Pattern<sizeof...(Arguments)> pattern, const Arguments&... arguments)
        : InputError(core::message(pattern, arguments...)) {}
    explicit InputError(const Message& message)
        : std::runtime_error(message.text()), message_(std::make_shared<const Message>(message)) {}

    const Message& message() const { return *message_; }

  private:
    std::shared_ptr<const Message> message_;  ///< copying an exception must not throw
};

/// "FILE, line N: MESSAGE" as an InputError; line 0 leaves the line out.
InputError located_error(const std::string& file, long line, const Message& message);
template <class... Arguments>
InputError located_error(const std::string& file, long line, Pattern<sizeof...(Arguments)> pattern,
                         const Arguments&... arguments) {
    return located_error(file, line, message(pattern, arguments...));
}

}  // namespace pastoso::core
