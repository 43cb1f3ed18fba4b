#include "cli/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "cli/exit_status.h"
#include "cli/time_limit.h"
#include "platform/file.h"
#include "text/words.h"

namespace viewing {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const std::string& target, const std::string& why) {
    throw Failure(ExitStatus::bad_input, target + ": cannot be written: " + why);
}

std::string reason(int code) {
    return std::generic_category().message(code);
}

std::vector<std::string>& notes() {
    static std::vector<std::string> lines;
    return lines;
}

}  // namespace

void print(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        cannot_write("standard output", reason(errno));
}

void note(const std::string& line) {
    if (std::find(notes().begin(), notes().end(), line) == notes().end()) notes().push_back(line);
}

void print_notes() {
    for (const std::string& line : notes()) std::fprintf(stderr, "%s\n", line.c_str());
}

void Outputs::add(const std::string& target, std::vector<std::uint8_t> bytes) {
    outputs_.push_back({target, std::move(bytes)});
}

void Outputs::add(const std::string& target, std::string_view text) {
    outputs_.push_back({target, {text.begin(), text.end()}});
}

void Outputs::add(WholeFolder folder) {
    folder_.emplace(std::move(folder));
}

void Outputs::write() {
    // Files get their names only when complete, so lift --timeout before writing them. Keep the limit if an output is a
    // pipe, which may block.
    if (std::all_of(outputs_.begin(), outputs_.end(),
                    [](const Output& output) { return is_plain_file(output.target); }))
        TimeLimit::lift();
    std::vector<FileBytes> files;
    for (const Output& output : outputs_)
        if (output.target != "-") files.push_back({output.target, output.bytes});
    value_or_end(write_files(files, [this] {
        for (const Output& output : outputs_)
            if (output.target == "-") print({reinterpret_cast<const char*>(output.bytes.data()), output.bytes.size()});
        if (folder_) value_or_end(folder_->take_name());
    }));
}

void check_output(const std::string& target) {
    if (target == "-") return;
    if (target.empty()) throw Failure(ExitStatus::bad_input, "an output file name must not be empty");
    std::error_code error;
    const fs::file_status there = fs::status(target, error);
    if (there.type() == fs::file_type::none) cannot_write(target, error.message());
    if (fs::is_directory(there)) cannot_write(target, "it is a directory");
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        if (::access(target.c_str(), W_OK) != 0) cannot_write(target, reason(errno));
        return;
    }
    const fs::path file = fs::weakly_canonical(fs::absolute(target, error), error);
    const fs::path folder = file.parent_path();
    if (!fs::is_directory(folder, error)) cannot_write(target, "there is no folder " + folder.string());
    if (::access(folder.c_str(), W_OK) != 0) cannot_write(target, reason(errno));
}

void add_file_if_there(std::vector<FileArgument>& files, const char* option, const std::string& argument) {
    std::error_code error;
    if (fs::exists(argument, error)) files.push_back({option, argument});
}

void check_apart(const Options& options, std::span<const FileArgument> outputs, std::span<const FileArgument> inputs) {
    const auto refuse_same = [&options](const FileArgument& output, const FileArgument& other) {
        if (output.file != "-" && other.file != "-" && are_same_file(output.file, other.file))
            options.refuse(output.option + " and " + other.option +
                           " cannot be the same file: " + one_line(output.file));
    };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (const FileArgument& other : outputs.subspan(i + 1)) {
            if (outputs[i].file == "-" && other.file == "-")
                options.refuse(outputs[i].option + " and " + other.option + " cannot both be standard output");
            refuse_same(outputs[i], other);
        }
        for (const FileArgument& input : inputs) refuse_same(outputs[i], input);
    }
}

void check_outputs(const Options& options, std::span<const FileArgument> outputs,
                   std::span<const FileArgument> inputs) {
    check_apart(options, outputs, inputs);
    for (const FileArgument& output : outputs) check_output(output.file);
}

bool is_plain_file(const std::string& target) {
    std::error_code error;
    const fs::file_status there = fs::status(target, error);
    return target != "-" && (!fs::exists(there) || fs::is_regular_file(there));
}

}  // namespace viewing
