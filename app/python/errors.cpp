#include "python/errors.hpp"

#include "core/error.hpp"
#include "core/failed_check.hpp"
#include "core/fault.hpp"
#include "core/printable.hpp"

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace pastoso::python {
namespace {

namespace py = pybind11;

/// The types that translate() raises; they live as long as the interpreter.
PyObject* input_error = nullptr;
PyObject* internal_error = nullptr;

PyObject* add_error(py::module_& module, const char* name, PyObject* base, const char* documentation) {
    const std::string full_name = "pastoso." + std::string(name);
    PyObject* type = PyErr_NewExceptionWithDoc(full_name.c_str(), documentation, base, nullptr);
    if (type == nullptr) throw py::error_already_set();
    module.attr(name) = py::reinterpret_borrow<py::object>(type);
    return type;
}

void raise(PyObject* type, const std::string& sentence) {
    PyErr_SetString(type, core::printable(sentence).c_str());
}

void raise_input_error(const core::InputError& error) {
    py::list arguments;
    for (const core::Message& argument : error.message().arguments())
        arguments.append(argument.text());
    const py::object made =
        py::reinterpret_borrow<py::object>(input_error)(core::printable(error.what()));
    made.attr("code") = error.message().words();
    made.attr("arguments") = arguments;
    PyErr_SetObject(input_error, made.ptr());
}

/// What is not the engine's is left to the next translator.
void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const core::InputError& error) {
        raise_input_error(error);
    } catch (const core::BrokenInvariant& error) {
        raise(internal_error, error.what());
    } catch (const std::bad_alloc&) {
        raise(PyExc_MemoryError, core::caught_fault().text());
    } catch (const std::system_error&) {
        raise(PyExc_OSError, core::caught_fault().text());
    }
}

}  // namespace

void add_errors(py::module_& module) {
    input_error = add_error(
        module, "InputError", PyExc_ValueError,
        "Something that was given is wrong: one sentence names it, the place and the value.\n\n"
        "What was asked for is not done, and everything is as it was before. `code` is the sentence "
        "with\n"
        "places %1, %2, ... and the same whatever it speaks of; `arguments` are the texts at the "
        "places.");
    internal_error = add_error(module, "InternalError", PyExc_RuntimeError,
                               "The engine has found itself at fault: the sentence says where.\n\n"
                               "The object that it happened to refuses all further work.");
    py::register_exception_translator(translate);
    core::throw_failed_checks();
}

}  // namespace pastoso::python
