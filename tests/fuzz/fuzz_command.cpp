// libFuzzer: passes arbitrary lines as arguments to a command that neither draws nor runs other commands. The command
// must end with a documented status other than that of an internal error, and write nothing outside the working folder.
#include "cli/command_line.h"
#include "fuzz.h"
#include "ui/monkey/confined.h"

using namespace viewing;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    fuzz::check(test::confine_to(std::filesystem::current_path()));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const char* const commands[] = {"state", "params", "matrices", "presets"};
    if (size == 0) return 0;
    std::vector<std::string> arguments{commands[data[0] % std::size(commands)]};
    const std::string_view text = fuzz::as_text(data + 1, size - 1);
    // `--timeout` would end the process, and standard input belongs to the fuzzer.
    if (text.find("--t") != text.npos || text.find('-') == text.size() - 1) return 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        arguments.emplace_back(text.substr(begin, end - begin));
        if (arguments.back() == "-") return 0;
        begin = end + 1;
    }
    const int status = run_command_line(arguments);
    fuzz::check(status >= 0 && status < 9);
    return 0;
}
