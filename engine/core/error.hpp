// Bad input: the user's file, argument or device is at fault, and one sentence says where.
#pragma once

#include <stdexcept>
#include <string>

namespace pastoso::core {

/// An error in something the user gave. what() is one complete sentence that names the file or argument,
/// the place in it and the offending value. Nothing has been changed or half-written when it is thrown.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// "FILE, line N: MESSAGE" as an InputError; line 0 leaves the line out.
InputError located_error(const std::string& file, long line, const std::string& message);

}  // namespace pastoso::core
