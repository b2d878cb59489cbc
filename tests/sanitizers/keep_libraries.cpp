// Linked into every program of a build with the address sanitizer: libraries stay loaded until the process ends.
// The leak sanitizer reports at the end, and of an unloaded library (an OpenGL driver, a plug-in) it could
// neither name the functions nor match them with leaks.supp.
extern "C" int dlclose(void*) noexcept { return 0; }
