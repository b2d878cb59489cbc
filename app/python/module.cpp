// The module pastoso._engine: what the Python package `pastoso` is made of.
#include "core/isa_request.hpp"
#include "core/resources.hpp"
#include "core/version.hpp"
#include "python/bindings.hpp"
#include "python/errors.hpp"

#include <string>

PYBIND11_MODULE(_engine, module) {
    namespace python = pastoso::python;
    module.doc() = "The engine of Pastoso; the package pastoso is what to import.";
    python::add_errors(module);
    pastoso::core::check_isa_request();
    module.attr("version") = pastoso::core::version();
    module.def(
        "set_installed_prefix",
        [](const std::string& prefix) { pastoso::core::set_installed_prefix(prefix); },
        pybind11::arg("prefix"),
        "Names the folder that holds share/pastoso and lib/pastoso; before anything is read.");
    python::add_film(module);
    python::add_painting(module);
    python::add_tea(module);
    python::add_tank(module);
    python::add_validation(module);
    python::add_catalogue(module);
}
