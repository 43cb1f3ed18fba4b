#include "cli/options.h"

#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <deque>
#include <sstream>

#include "cli/output.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t help_width = 100;
constexpr std::size_t names_width = 28;

/// One line of the help.
struct Entry {
    std::string group, names, help;
};

/// Bytes that begin a character: what takes room on the terminal.
std::size_t shown_length(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent) {
    std::istringstream words(text);
    std::string result, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && indent + shown_length(line) + 1 + shown_length(word) > help_width) {
            result += std::string(indent, ' ') + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + std::string(indent, ' ') + line + "\n";
}

std::string exit_status_table(const std::string& digits) {
    std::string table = "Exit status:\n";
    for (const char digit : digits)
        table += std::string("  ") + digit + "  " + meaning(static_cast<ExitStatus>(digit - '0')) + "\n";
    return table;
}

/// CLI11 collects texts; one value too many is noticed here, so that every message has the same form.
struct Options::Parser {
    struct Text {
        std::string name;
        std::vector<std::string> given;
        std::optional<std::string>* target;
    };

    explicit Parser(const Command& parsed) : command(parsed) {
        app.set_help_flag();
        app.allow_extras();
        app.add_flag("-h,--help", help_wanted);
        names.insert(names.end(), {"-h", "--help"});
    }

    void add(const char* option_names, const char* value_name, const char* help) {
        std::istringstream parts(option_names);
        std::string shown;
        for (std::string name; std::getline(parts, name, ',');) {
            shown += (shown.empty() ? "" : ", ") + name;
            if (name.starts_with('-')) names.push_back(name);
        }
        if (*value_name != '\0') shown += " " + std::string(value_name);
        entries.push_back({group, shown, help});
    }

    std::string help() const;
    void check_leftovers(const Options& options) const;

    const Command& command;
    CLI::App app;
    bool help_wanted = false;
    std::string group = "Options";
    std::vector<Entry> entries;
    std::vector<std::string> names;
    std::deque<Text> texts;  // CLI11 keeps references into it
};

std::string Options::Parser::help() const {
    std::string text = "viewing-sandbox " + std::string(command.name) + ": " + command.about + "\n\n";
    text += "Usage: viewing-sandbox " + std::string(command.name) + " " + command.synopsis + "\n\n";
    text += wrapped(command.details, 0);

    std::string last_group;
    for (const Entry& entry : entries) {
        if (entry.group != last_group) text += "\n" + entry.group + ":\n";
        last_group = entry.group;
        const std::size_t shown = shown_length(entry.names) + 2;
        const std::string explanation = wrapped(entry.help, names_width);
        text += "  " + entry.names;
        text += shown < names_width ? std::string(names_width - shown, ' ') : "\n" + std::string(names_width, ' ');
        text += explanation.substr(names_width);
    }

    text += "\nExamples:\n";
    std::istringstream examples(command.examples);
    for (std::string example; std::getline(examples, example);)
        text += "  viewing-sandbox" + (example.empty() ? "" : " " + example) + "\n";
    return text + "\n" + exit_status_table(command.statuses);
}

/// What no option and no positional took.
void Options::Parser::check_leftovers(const Options& options) const {
    for (const std::string& left : app.remaining()) {
        if (left.size() > 1 && left.starts_with('-') && left != "--") {
            const std::string name = one_line(left.substr(0, left.find('=')));
            const std::string hint = name.starts_with("--") ? suggestion(name, names) : "";
            options.refuse(name + ": no such option" + hint + "; see viewing-sandbox " + command.name + " --help");
        }
        options.refuse("\"" + one_line(left) + "\": one argument too many; usage: viewing-sandbox " + command.name +
                       " " + command.synopsis);
    }
}

Options::Options(const Command& command) : parser_(std::make_unique<Parser>(command)) {}
Options::~Options() = default;

void Options::group(const char* title) {
    parser_->group = title;
}

void Options::positional(const char* name, std::string& value, const char* help) {
    parser_->app.add_option(name, value);
    parser_->add(name, "", help);
}

void Options::text(const char* names, const char* value_name, std::optional<std::string>& value, const char* help) {
    parser_->texts.push_back({names, {}, &value});
    parser_->app.add_option(names, parser_->texts.back().given)->allow_extra_args(false);
    parser_->add(names, value_name, help);
}

void Options::texts(const char* names, const char* value_name, std::vector<std::string>& values, const char* help) {
    parser_->app.add_option(names, values)->allow_extra_args(false);
    parser_->add(names, value_name, help);
}

void Options::flag(const char* names, bool& value, const char* help) {
    parser_->app.add_flag(names, value);
    parser_->add(names, "", help);
}

bool Options::parse(const Arguments& arguments) {
    // A wish for help comes before whatever else may be wrong.
    const auto last = std::find(arguments.begin(), arguments.end(), "--");
    const bool asks =
        std::find(arguments.begin(), last, "--help") != last || std::find(arguments.begin(), last, "-h") != last;
    if (asks) {
        print(parser_->help());
        return false;
    }
    try {
        parser_->app.parse(Arguments(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ArgumentMismatch& missing) {
        const std::string what = missing.what();
        refuse(what.substr(0, what.find(':')) + ": its value is missing; see viewing-sandbox " + parser_->command.name +
               " --help");
    } catch (const CLI::ParseError& other) {
        refuse(other.what());
    }
    parser_->check_leftovers(*this);
    for (const Parser::Text& text : parser_->texts) {
        if (text.given.size() > 1) refuse(text.name.substr(text.name.find(',') + 1) + ": given more than once");
        if (!text.given.empty()) *text.target = text.given.front();
    }
    return true;
}

void Options::refuse(const std::string& what) const {
    throw Failure(ExitStatus::bad_input, std::string(parser_->command.name) + ": " + what);
}

}  // namespace viewing
