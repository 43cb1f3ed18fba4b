#include "packaging/pages.h"

#include <sstream>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "cli/results/file_forms.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Inserts a backslash before each of these characters.
std::string escaped(std::string_view text, std::string_view signs) {
    std::string result;
    for (const char sign : text) {
        if (signs.find(sign) != std::string_view::npos) result += '\\';
        result += sign;
    }
    return result;
}

/// Returns a line of a man page: escapes troff commands, and keeps "-" as the character that a shell expects.
std::string troff(std::string_view text) {
    std::string line;
    for (const char sign : text) line += sign == '\\' ? "\\e" : sign == '-' ? "\\-" : std::string(1, sign);
    return (line.starts_with('.') || line.starts_with('\'') ? "\\&" : "") + line + "\n";
}

std::vector<std::string> lines_of(const char* text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

void describe_option(std::string& page, const OptionDescription& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "" : ", ") + ("\\fB" + escaped(name, "-") + "\\fR");
    if (!option.value_name.empty()) names += " \\fI" + escaped(option.value_name, "-") + "\\fR";
    page += ".TP\n" + names + "\n" + troff(option.help);
}

void describe_command(std::string& page, const Command& command) {
    page += ".SS " + std::string(command.name) + "\n";
    page += ".B viewing\\-sandbox " + std::string(command.name) + "\n" + troff(command.synopsis);
    page += ".PP\n" + troff(command.details);
    for (const OptionDescription& option : options_of(command)) describe_option(page, option);
    page += ".PP\nExamples:\n.PP\n.nf\n";
    for (const std::string& example : lines_of(command.examples))
        page += troff("    viewing-sandbox" + (example.empty() ? "" : " " + example));
    page += ".fi\n";
}

/// Adds a topic of the manual; its title becomes the title of the section.
void describe_topic(std::string& page, const char* topic) {
    bool is_title = true;
    for (const ManualBlock& block : manual_page(topic)) {
        const std::string& text = block.cells.front();
        switch (block.part) {
            case ManualPart::heading:
                page += (is_title ? ".SS " : ".PP\n.B ") + troff(text);
                break;
            case ManualPart::paragraph:
                page += ".PP\n" + troff(text);
                break;
            case ManualPart::item:
                page += ".IP\n" + troff(text);
                break;
            case ManualPart::code:
                page += ".nf\n" + troff("    " + text) + ".fi\n";
                break;
            case ManualPart::row:
                page += ".TP\n" + troff(text) + troff(joined(std::span<const std::string>(block.cells).subspan(1)));
                break;
        }
        is_title = false;
    }
}

/// The completions that a shell offers for an option's value or a positional.
enum class Offer { nothing, files, folders, presets, words };

Offer offer_of(const OptionDescription& option) {
    const std::string& value = option.is_positional ? option.names.front() : option.value_name;
    if (value == "STATE") return Offer::presets;
    if (value == "DIR") return Offer::folders;
    if (value.find("FILE") != std::string::npos || value.find(".png") != std::string::npos) return Offer::files;
    // "json|text", "0|4": offer these words
    if (value.find('|') != std::string::npos && value.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos)
        return Offer::words;
    return Offer::nothing;
}

std::string words_of(std::string value) {
    for (char& sign : value)
        if (sign == '|') sign = ' ';
    return value;
}

std::string joined_names(const std::vector<std::string>& names, std::string_view between) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : std::string(between)) + name;
    return all;
}

/// Quotes a text for a shell, and escapes any "'" in it.
std::string in_quotes(std::string_view text) {
    std::string result = "'";
    for (const char sign : text) result += sign == '\'' ? "'\\''" : std::string(1, sign);
    return result + "'";
}

std::string first_sentence(const std::string& help) {
    return help.substr(0, help.find_first_of(";:"));
}

/// Returns the line of bash that completes the value of an option or a positional.
std::string bash_offer(const OptionDescription& option) {
    switch (offer_of(option)) {
        case Offer::files:
            return "COMPREPLY=($(compgen -f -- \"$word\"))";
        case Offer::folders:
            return "COMPREPLY=($(compgen -d -- \"$word\"))";
        case Offer::presets:
            return "COMPREPLY=($(compgen -f -W \"$(_viewing_sandbox_presets)\" -- \"$word\"))";
        case Offer::words:
            return "COMPREPLY=($(compgen -W '" + words_of(option.value_name) + "' -- \"$word\"))";
        case Offer::nothing:
            break;
    }
    return "COMPREPLY=()";
}

std::string zsh_action(const OptionDescription& option) {
    switch (offer_of(option)) {
        case Offer::files:
            return "_files";
        case Offer::folders:
            return "_files -/";
        case Offer::presets:
            return "_viewing_sandbox_states";
        case Offer::words:
            return "(" + words_of(option.value_name) + ")";
        case Offer::nothing:
            break;
    }
    return " ";
}

constexpr std::string_view presets_in_shell = "viewing-sandbox presets 2>/dev/null | sed -n 's/ — .*//; / (scene)$/!p'";

}  // namespace

std::string man_page() {
    std::string page =
        ".TH VIEWING\\-SANDBOX 1 \"\" \"viewing\\-sandbox " VIEWING_SANDBOX_VERSION "\" \"User Commands\"\n";
    page +=
        ".SH NAME\nviewing\\-sandbox \\- experiment with cameras, hidden surfaces, planar shadows and reflections\n";
    page += ".SH SYNOPSIS\n";
    for (const Command* command : commands())
        page += ".B viewing\\-sandbox " + std::string(command->name) + "\n" + troff(command->synopsis) + ".br\n";
    page += ".SH DESCRIPTION\n" + troff(
                                      "A teaching sandbox for the computer graphics lecture Viewing. Without a command "
                                      "it opens the window; the other commands need no display. STATE is a state file, "
                                      "the name of a preset, a Wavefront file, or - for standard input.");
    page += ".SH COMMANDS\n";
    for (const Command* command : commands()) describe_command(page, *command);
    page += ".SH TOPICS\n";
    for (const char* topic : manual_topics()) describe_topic(page, topic);
    page += ".SH EXIT STATUS\n";
    for (int status = 0; status <= static_cast<int>(ExitStatus::internal_error); ++status)
        page += ".TP\n\\fB" + std::to_string(status) + "\\fR\n" + troff(meaning(static_cast<ExitStatus>(status)));
    page += ".SH ENVIRONMENT\n.TP\n\\fBVIEWING_SANDBOX_ASSETS\\fR\n" +
            troff(
                "The folder with presets, scenes, lessons and exercises, instead of assets beside the program or "
                "../share/viewing-sandbox.");
    return page;
}

std::string bash_completion() {
    std::string names;
    for (const Command* command : commands()) names += std::string(names.empty() ? "" : " ") + command->name;
    std::string text = "# bash completion for viewing-sandbox, generated from its table of options\n\n";
    text += "_viewing_sandbox_presets() { " + std::string(presets_in_shell) + "; }\n\n";
    text += "_viewing_sandbox() {\n    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n";
    text += "    local command=${COMP_WORDS[1]} options=\n";
    text += "    if ((COMP_CWORD == 1)); then\n        COMPREPLY=($(compgen -f -W '" + names +
            " --help --version' -- \"$word\"))\n        return\n    fi\n    case $command in\n";
    for (const Command* command : commands()) {
        const std::vector<OptionDescription> options = options_of(*command);
        std::string all = "-h --help", positional = "COMPREPLY=()";
        text += "        " + std::string(command->name) + ")\n            case $before in\n";
        for (const OptionDescription& option : options) {
            if (option.is_positional) {
                positional = bash_offer(option);
                continue;
            }
            all += " " + joined_names(option.names, " ");
            if (!option.value_name.empty())
                text +=
                    "                " + joined_names(option.names, "|") + ") " + bash_offer(option) + "; return ;;\n";
        }
        text += "            esac\n            options=" + in_quotes(all) + "\n            " + positional +
                "\n            ;;\n";
    }
    text +=
        "    esac\n    [[ $word == -* ]] && COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n    return 0\n}\n\n";
    return text + "complete -o filenames -F _viewing_sandbox viewing-sandbox\n";
}

std::string zsh_completion() {
    std::string text = "#compdef viewing-sandbox\n# generated from the program's table of options\n\n";
    text += "_viewing_sandbox_states() {\n    local -a presets\n    presets=(${(f)\"$(" +
            std::string(presets_in_shell) +
            ")\"})\n    _alternative 'presets:preset:compadd -a presets' 'files:state file:_files'\n}\n\n";
    text += "_viewing_sandbox() {\n    local -a commands\n    commands=(\n";
    for (const Command* command : commands())
        text += "        " + in_quotes(std::string(command->name) + ":" + escaped(command->about, ":")) + "\n";
    text +=
        "    )\n    if ((CURRENT == 2)); then\n        _describe command commands\n        _viewing_sandbox_states\n"
        "        return\n    fi\n    local command=$words[2]\n    shift words\n    ((CURRENT--))\n    case $command "
        "in\n";
    for (const Command* command : commands()) {
        text += "        " + std::string(command->name) + ")\n            _arguments -s \\\n";
        bool has_positional = false;
        for (const OptionDescription& option : options_of(*command)) {
            const std::string help = escaped(first_sentence(option.help), "[]:\\");
            if (option.is_positional) {
                if (has_positional) continue;  // the first one covers all of them
                has_positional = true;
                text += "                " +
                        in_quotes("*:" + escaped(option.names.front(), ":") + ":" + zsh_action(option)) + " \\\n";
                continue;
            }
            for (const std::string& name : option.names) {
                const std::string value =
                    option.value_name.empty() ? "" : ":" + escaped(option.value_name, ":") + ":" + zsh_action(option);
                text += "                " + in_quotes("*" + name + "[" + help + "]" + value) + " \\\n";
            }
        }
        text += "                " + in_quotes("(- *)--help[help for this command]") + "\n            ;;\n";
    }
    return text + "    esac\n}\n\n_viewing_sandbox \"$@\"\n";
}

}  // namespace viewing
