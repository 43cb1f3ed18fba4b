// Lists all commands and runs one. commands.h declares the commands; each is in its own file.
#include "cli/command_line.h"

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/file_forms.h"
#include "gl/egl_context.h"
#include "state/presets.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::array all_commands{&open_command,    &lesson_command,   &lecture_command, &exercises_command,
                                  &grade_command,   &snapshot_command, &compare_command, &matrices_command,
                                  &inspect_command, &measure_command,  &suite_command,   &sweep_command,
                                  &state_command,   &params_command,   &presets_command, &doctor_command};

std::string main_help() {
    std::string text =
        "viewing-sandbox: experiment with cameras, hidden surfaces, planar shadows and reflections\n\n"
        "Usage: viewing-sandbox [COMMAND] [ARGUMENTS…]\n"
        "       viewing-sandbox [STATE] [--set PATH=VALUE]…      the same as open\n\nCommands:\n";
    for (const Command* command : all_commands) {
        const std::string name = command->name;
        text += "  " + name + std::string(11 - name.size(), ' ') + command->about + "\n";
    }
    text += "\n";
    text += wrapped(
        "STATE is a .json file, the name of a preset, a Wavefront .obj file to view, or - for standard input; the "
        "default is the opening preset. --set changes its fields in the order given; viewing-sandbox params lists "
        "them. Results go to standard output, messages to standard error.",
        0);
    text +=
        "\n" + wrapped(
                   "Limits: 16 MiB for a state or scene, 4 GiB for a mesh file, 50 million triangles for a scene "
                   "(400,000 for the hidden-surface methods, 100,000 for the BSP tree), 16 million pixels for a "
                   "picture. Anything larger is refused before work begins. A state may name scenes and meshes in its "
                   "own folder and among the program's; others need --allow-outside, or your permission in the window.",
                   0);
    text += "\n" + wrapped("Topics (viewing-sandbox help TOPIC): " + joined(manual_topics()) + ".", 0);
    return text +
           "\nOptions:\n"
           "  -h, --help       this text, or, after a command, that command's help\n"
           "  --version        the program's version\n"
           "\nExamples:\n"
           "  viewing-sandbox\n"
           "  viewing-sandbox --set projection.near=0.01 --set depth.format=d16\n"
           "  viewing-sandbox bunny.obj\n"
           "  viewing-sandbox snapshot -o picture.png --size 1920x1080\n"
           "  viewing-sandbox matrices --set light.position=[12,20,0,0] --format latex\n"
           "  viewing-sandbox state > mine.json\n\n" +
           exit_status_table("0123456789");
}

/// Refuses a first word that looks like a misspelled command. Any other first word that is not a command is a STATE.
void refuse_misspelt_command(const std::string& word) {
    std::vector<std::string> names;
    for (const Command* command : all_commands) names.emplace_back(command->name);
    const std::optional<std::string> meant = nearest_name(word, names);
    std::error_code error;
    if (!meant || std::filesystem::exists(word, error)) return;
    for (const NamedFile& preset : presets())
        if (preset.name == word) return;
    throw Failure(ExitStatus::bad_input,
                  one_line(word) + ": not a command, a file or a preset; did you mean the command " + *meant + "?");
}

/// Refuses arguments that are not UTF-8, since the results repeat them and are UTF-8 themselves.
void refuse_what_is_not_utf8(const Arguments& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i)
        if (!is_utf8(arguments[i]))
            throw Failure(ExitStatus::bad_input, "argument " + std::to_string(i + 1) + ": " + one_line(arguments[i]) +
                                                     ": not UTF-8, which all results use; rename the file");
}

/// Prints what the manual and the command's help say about a word; several topics have the name of a command.
ExitStatus help_on(const std::string& topic) {
    const std::string text = manual_text(manual_page(topic));
    print(text);
    if (const Command* command = find_command(topic)) {
        if (!text.empty()) print("\n");
        return command->run(*command, {"--help"});
    }
    if (!text.empty()) return ExitStatus::done;
    const std::span<const char* const> topics = manual_topics();
    throw Failure(ExitStatus::bad_input,
                  one_line(topic) + ": no such command or topic; the topics are " + joined(topics));
}

ExitStatus dispatch(const Arguments& arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    const Arguments rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
    if (first == "help" && !rest.empty()) return help_on(rest.front());
    if (first == "--help" || first == "-h" || first == "help") {
        print(main_help());
        return ExitStatus::done;
    }
    if (first == "--version") {
        print("viewing-sandbox " VIEWING_SANDBOX_VERSION "\n");
        return ExitStatus::done;
    }
    if (const Command* command = find_command(first)) return command->run(*command, rest);
    refuse_misspelt_command(first);
    return open_command.run(open_command, arguments);
}

int end(ExitStatus status, const char* sentence) {
    constexpr std::size_t longest_sentence = 2'000;
    std::fprintf(stderr, "%s\n", without_middle(printable(sentence), longest_sentence).c_str());
    return static_cast<int>(status);
}

}  // namespace

std::span<const Command* const> commands() {
    return all_commands;
}

const Command* find_command(const std::string& name) {
    for (const Command* command : all_commands)
        if (name == command->name) return command;
    return nullptr;
}

int run_command_line(const Arguments& arguments) {
    gl::keep_no_cache_without_a_home();
    try {
        refuse_what_is_not_utf8(arguments);
        const ExitStatus status = dispatch(arguments);
        print_notes();
        return static_cast<int>(status);
    } catch (const Failure& failure) {
        return end(failure.status, failure.what());
    } catch (const std::bad_alloc&) {
        return end(ExitStatus::internal_error, not_enough_memory);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "internal error: ");
        return end(ExitStatus::internal_error, error.what());
    }
}

}  // namespace viewing
