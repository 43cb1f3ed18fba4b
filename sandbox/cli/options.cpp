#include "cli/options.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <variant>

#include "cli/option_values.h"
#include "cli/output.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t help_width = 100;
constexpr std::size_t names_width = 28;

/// If set, a command lists its options here instead of running. It is a thread-local global because run() has no
/// parameter for it.
thread_local std::vector<OptionDescription>* wanted_descriptions = nullptr;

/// Returns, for example, "-o, --output OUT.png".
std::string shown_names(const OptionDescription& option) {
    std::string shown;
    for (const std::string& name : option.names) shown += (shown.empty() ? "" : ", ") + name;
    return shown + (option.value_name.empty() ? "" : " " + option.value_name);
}

/// Whether a word is an option, as opposed to "-", "--" or a number.
bool is_option(const std::string& word) {
    const std::size_t name = word.starts_with("--") ? 2 : 1;
    return word.starts_with('-') && word.size() > name && std::isalpha(static_cast<unsigned char>(word[name])) != 0;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent) {
    return in_lines(text, help_width, std::string(indent, ' '), indent);
}

std::string exit_status_table(const std::string& digits) {
    std::string table = "Exit status:\n";
    for (const char digit : digits)
        table += std::string("  ") + digit + "  " + meaning(static_cast<ExitStatus>(digit - '0')) + "\n";
    return table;
}

std::vector<OptionDescription> options_of(const Command& command) {
    std::vector<OptionDescription> descriptions;
    wanted_descriptions = &descriptions;
    command.run(command, {});
    wanted_descriptions = nullptr;
    return descriptions;
}

struct Options::Parser {
    using Target = std::variant<bool*, std::optional<std::string>*, std::vector<std::string>*>;
    struct Option {
        std::vector<std::string> names;  ///< messages use the last one
        Target target;
        bool is_doubled = false;
    };
    struct Positional {
        std::string name;
        std::string* target;
    };
    struct Leftover {
        std::string word;
        bool is_option;
    };

    explicit Parser(const Command& parsed) : command(parsed) { names = {"-h", "--help"}; }

    void add(const char* option_names, const char* value_name, const Target& target, const char* help) {
        Option option{{}, target};
        std::istringstream parts(option_names);
        for (std::string name; std::getline(parts, name, ',');) option.names.push_back(name);
        names.insert(names.end(), option.names.begin(), option.names.end());
        entries.push_back({group, option.names, value_name, help});
        options.push_back(std::move(option));
    }

    Option* find(const std::string& name) {
        const auto has_name = [&name](const Option& option) {
            return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
        };
        const auto found = std::find_if(options.begin(), options.end(), has_name);
        return found == options.end() ? nullptr : &*found;
    }

    std::string help() const;
    void take(const Arguments& arguments, const Options& owner);
    void take_positional(const std::string& word, const Options& owner);
    void check_leftovers(const Options& owner) const;

    const Command& command;
    std::string group = "Options";
    std::vector<OptionDescription> entries;
    std::vector<std::string> names;  ///< of all options
    std::vector<Option> options;
    std::vector<Positional> positionals;
    std::size_t taken = 0;                        ///< number of filled positionals
    std::vector<std::string>* further = nullptr;  ///< takes all arguments after the positionals
    std::vector<Leftover> leftovers;              ///< arguments that fit neither an option nor a positional
};

std::string Options::Parser::help() const {
    std::string text = "viewing-sandbox " + std::string(command.name) + ": " + command.about + "\n\n";
    text += "Usage: viewing-sandbox " + std::string(command.name) + " " + command.synopsis + "\n\n";
    text += wrapped(command.details, 0);

    std::string last_group;
    for (const OptionDescription& entry : entries) {
        if (entry.group != last_group) text += "\n" + entry.group + ":\n";
        last_group = entry.group;
        const std::string names_of_entry = shown_names(entry);
        const std::size_t shown = character_count(names_of_entry) + 2;
        const std::string explanation = wrapped(entry.help, names_width);
        text += "  " + names_of_entry;
        text += shown < names_width ? std::string(names_width - shown, ' ') : "\n" + std::string(names_width, ' ');
        text += explanation.substr(names_width);
    }

    text += "\nExamples:\n";
    std::istringstream examples(command.examples);
    for (std::string example; std::getline(examples, example);)
        text += "  viewing-sandbox" + (example.empty() ? "" : " " + example) + "\n";
    return text + "\n" + exit_status_table(command.statuses);
}

void Options::Parser::take_positional(const std::string& word, const Options& owner) {
    const bool is_wanted = taken < positionals.size();
    if (word.empty())
        owner.refuse((is_wanted ? positionals[taken].name : "an argument") +
                     " is empty; for allowed values see viewing-sandbox " + command.name + " --help");
    if (is_wanted)
        *positionals[taken++].target = word;
    else if (further != nullptr)
        further->push_back(word);
    else
        leftovers.push_back({word, false});
}

/// Assigns words to targets: "--name value", "--name=value", "-n value" and "-nvalue". An option takes the next word as
/// its value, whatever it looks like; "--" ends the options.
void Options::Parser::take(const Arguments& arguments, const Options& owner) {
    bool has_options = true;
    for (auto word = arguments.begin(); word != arguments.end(); ++word) {
        if (has_options && *word == "--") {
            has_options = false;
            continue;
        }
        if (!has_options || !is_option(*word)) {
            take_positional(*word, owner);
            continue;
        }
        const bool is_long = word->starts_with("--");
        const std::size_t end = std::min(is_long ? word->find('=') : 2, word->size());
        Option* const option = find(word->substr(0, end));
        if (option == nullptr) {
            leftovers.push_back({*word, true});
            continue;
        }
        if (bool* const* flag = std::get_if<bool*>(&option->target)) {
            if (end < word->size()) owner.refuse(option->names.back() + ": takes no value");
            **flag = true;
            continue;
        }
        std::string value;
        if (end < word->size()) {
            value = word->substr(end + (is_long ? 1 : 0));
        } else {
            if (++word == arguments.end())
                owner.refuse(option->names.back() + ": needs a value; see viewing-sandbox " + command.name + " --help");
            value = *word;
        }
        if (auto* const* texts = std::get_if<std::vector<std::string>*>(&option->target)) {
            (*texts)->push_back(value);
        } else {
            auto& text = *std::get<std::optional<std::string>*>(option->target);
            option->is_doubled = text.has_value();
            text = value;
        }
    }
}

void Options::Parser::check_leftovers(const Options& owner) const {
    for (const auto& [left, is_unknown_option] : leftovers) {
        if (is_unknown_option) {
            const std::string name = one_line(left.substr(0, left.find('=')));
            const std::string hint = name.starts_with("--") ? suggestion(name, names) : "";
            owner.refuse(name + ": no such option" + hint + "; see viewing-sandbox " + command.name + " --help");
        }
        owner.refuse("\"" + one_line(left) + "\": unexpected argument; usage: viewing-sandbox " + command.name + " " +
                     command.synopsis);
    }
}

Options::Options(const Command& command) : parser_(std::make_unique<Parser>(command)) {}
Options::~Options() = default;

void Options::group(const char* title) {
    parser_->group = title;
}

void Options::positional(const char* name, std::string& value, const char* help) {
    parser_->positionals.push_back({name, &value});
    parser_->entries.push_back({parser_->group, {name}, "", help, true});
}

void Options::positionals(const char* name, std::vector<std::string>& values, const char* help) {
    parser_->further = &values;
    parser_->entries.push_back({parser_->group, {name}, "", help, true});
}

void Options::text(const char* names, const char* value_name, std::optional<std::string>& value, const char* help) {
    parser_->add(names, value_name, &value, help);
}

void Options::texts(const char* names, const char* value_name, std::vector<std::string>& values, const char* help) {
    parser_->add(names, value_name, &values, help);
}

void Options::flag(const char* names, bool& value, const char* help) {
    parser_->add(names, "", &value, help);
}

void Options::keep_what_is_done(unsigned grace_s, const char* help) {
    grace_s_ = grace_s;
    timeout_help_ = help;
}

bool Options::parse(const Arguments& arguments) {
    std::optional<std::string> timeout;
    group("Running");
    text("--timeout", "S", timeout, timeout_help_);
    if (wanted_descriptions != nullptr) {
        *wanted_descriptions = parser_->entries;
        return false;
    }
    // Help takes precedence over any error.
    const auto last = std::find(arguments.begin(), arguments.end(), "--");
    const bool asks =
        std::find(arguments.begin(), last, "--help") != last || std::find(arguments.begin(), last, "-h") != last;
    if (asks) {
        print(parser_->help());
        return false;
    }
    parser_->take(arguments, *this);
    parser_->check_leftovers(*this);
    for (const Parser::Option& option : parser_->options)
        if (option.is_doubled) refuse(option.names.back() + ": given more than once");
    if (timeout) limit_.emplace(number_option(*this, "--timeout", *timeout, 0.001, 86400.0), grace_s_);
    return true;
}

void Options::refuse(const std::string& what) const {
    throw Failure(ExitStatus::bad_input, std::string(parser_->command.name) + ": " + what);
}

}  // namespace viewing
