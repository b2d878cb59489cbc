#include "crash/crash_guard.hpp"

#include "core/failed_check.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

namespace pastoso::crash {
namespace {

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int kMostFrames = 64;

// All that the report needs is there before anything fails: within a signal, memory can't be asked for.
std::array<char, 4096> report_path{};
std::array<char, 8192> facts_text{};
std::array<char, 1024> exception_text{};
std::array<char, 65536> signal_stack{};

template <std::size_t kSize>
void keep(std::array<char, kSize>& place, const char* text) {
    std::strncpy(place.data(), text, kSize - 1);
}

void write_text(int file, const char* text) {
    std::size_t left = std::strlen(text);
    while (left > 0) {
        const ssize_t written = ::write(file, text, left);
        if (written <= 0) return;
        text += written;
        left -= static_cast<std::size_t>(written);
    }
}

const char* name_of(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV (memory that is not the program's)";
        case SIGBUS:
            return "SIGBUS (memory or a file that went away)";
        case SIGFPE:
            return "SIGFPE (a division by zero)";
        case SIGILL:
            return "SIGILL (an instruction that the processor does not have)";
        default:
            return "SIGABRT (the program gave up)";
    }
}

void write_report(int signal) {
    const int file = ::open(report_path.data(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) return;
    write_text(file, facts_text.data());
    write_text(file, "Ended by: ");
    write_text(file, name_of(signal));
    write_text(file, "\n");
    for (const char* reason : {core::failed_check(), static_cast<const char*>(exception_text.data())}) {
        if (reason[0] == '\0') continue;
        write_text(file, "Reason: ");
        write_text(file, reason);
        write_text(file, "\n");
    }
    write_text(file, "Functions under way:\n");
    std::array<void*, kMostFrames> frames{};
    const int count = ::backtrace(frames.data(), kMostFrames);
    ::backtrace_symbols_fd(frames.data(), count, file);
    ::close(file);
}

/// The signal's own action is back by then, and ends the program.
void on_signal(int signal) {
    write_report(signal);
    ::raise(signal);
}

[[noreturn]] void on_terminate() {
    try {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
        keep(exception_text, error.what());
        std::fprintf(stderr, "pastoso: not caught: %s\n", error.what());
    } catch (...) {
        keep(exception_text, "an exception of an unknown kind");
    }
    std::abort();
}

void catch_signals() {
    stack_t stack{};
    stack.ss_sp = signal_stack.data();
    stack.ss_size = signal_stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
    for (const int signal : kSignals)
        ::sigaction(signal, &action, nullptr);
}

}  // namespace

void note_facts(const std::string& facts) {
    keep(facts_text, facts.c_str());
}

void guard(const std::filesystem::path& folder, const std::string& facts) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return;
    std::array<char, 64> name{};
    const std::time_t now = std::time(nullptr);
    std::tm date{};
    ::gmtime_r(&now, &date);
    std::strftime(name.data(), name.size(), "%Y-%m-%d-%H%M%S-", &date);
    const auto path = folder / (name.data() + std::to_string(::getpid()) + ".txt");
    keep(report_path, path.c_str());
    note_facts(facts);
    std::array<void*, 1> first{};
    ::backtrace(first.data(), 1);  // loads what it needs now
    std::set_terminate(on_terminate);
    catch_signals();
}

}  // namespace pastoso::crash
