#include "cli/run_program.hpp"

#include "core/check.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

void redirect(int stream, const std::filesystem::path& file) {
    const int target = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(target, stream);
    ::close(target);
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<char*> words = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
}

/// A started program whose streams go into files.
class Child {
  public:
    Child(const std::string& name, const std::vector<std::string>& arguments) {
        const std::string program = (core::program_folder() / name).string();
        const std::string caught =
            (std::filesystem::temp_directory_path() / ("pastoso-run-" + std::to_string(::getpid())))
                .string();
        output_ = caught + ".out";
        errors_ = caught + ".err";
        pid_ = ::fork();
        PASTOSO_CHECK_OP(pid_, >=, 0);
        if (pid_ != 0) return;
        redirect(STDOUT_FILENO, output_);
        redirect(STDERR_FILENO, errors_);
        become(program, arguments);
    }

    void send(int signal) const { ::kill(pid_, signal); }
    bool running() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
               info.si_pid == 0;
    }

    RunResult wait() const {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        const RunResult result{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                               core::read_text_file(output_), core::read_text_file(errors_)};
        std::filesystem::remove(output_);
        std::filesystem::remove(errors_);
        return result;
    }

  private:
    pid_t pid_ = -1;
    std::filesystem::path output_, errors_;
};

}  // namespace

RunResult run_program(const std::string& name, const std::vector<std::string>& arguments) {
    return Child(name, arguments).wait();
}

RunResult interrupt_program(const std::string& name, const std::vector<std::string>& arguments,
                            const std::filesystem::path& sign_of_work, int signal) {
    const Child child(name, arguments);
    while (child.running() && !std::filesystem::exists(sign_of_work)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    child.send(signal);
    return child.wait();
}

std::string CliTest::write(const std::string& name, const std::string& text) const {
    core::write_text_file(folder / name, text);
    return path(name);
}

std::string CliTest::short_recording() const {
    std::string text = "# seconds x y pressure\n";
    for (int i = 0; i <= 20; ++i) {
        text += std::to_string(0.01 * i) + " " + std::to_string(10 + i) + " 15 " +
                (i < 20 ? "0.5" : "0") + "\n";
    }
    return write("short.dat", text);
}

void CliTest::expect_refusal(const std::vector<std::string>& arguments, int status,
                             const std::string& sentence) const {
    const std::size_t files = files_in_folder();
    const RunResult run = run_cli(arguments);
    EXPECT_EQ(run.status, status) << run.errors;
    EXPECT_EQ(run.output, "");
    EXPECT_THAT(run.errors, testing::StartsWith("pastoso-cli: "));
    EXPECT_THAT(run.errors, testing::HasSubstr(sentence));
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(files_in_folder(), files);
}

std::vector<std::string> small(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = arguments;
    for (const char* option :
         {"--canvas", "40x30mm", "--px-per-mm", "2", "--seconds", "0.1", "--size-mm", "8"}) {
        all.emplace_back(option);
    }
    return all;
}

}  // namespace pastoso::cli
