// The options of one command, which are declared once, parsed from the command line and printed as its --help. The
// parser is hand-written: all messages are the program's own, so a library would do no more than split words.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/time_limit.h"

namespace viewing {

/// One option or positional of a command, as declared.
struct OptionDescription {
    std::string group;
    std::vector<std::string> names;  ///< "-o", "--output"; for a positional, its name
    std::string value_name;          ///< "WxH"; "" for a flag or a positional
    std::string help;
    bool is_positional = false;
};

/// Returns all options of a command, in the order of its help. Does not run the command.
std::vector<OptionDescription> options_of(const Command& command);

class Options {
public:
    explicit Options(const Command& command);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// Lists the options declared after this call under this title in the help.
    void group(const char* title);

    // `names` is a list such as "-o,--output"; `value_name` follows it in the help. Targets must outlive parse().
    void positional(const char* name, std::string& value, const char* help);
    void positionals(const char* name, std::vector<std::string>& values, const char* help);
    void text(const char* names, const char* value_name, std::optional<std::string>& value, const char* help);
    void texts(const char* names, const char* value_name, std::vector<std::string>& values, const char* help);
    void flag(const char* names, bool& value, const char* help);

    /// After --timeout expires (TimeLimit::has_run_out), gives the command `grace_s` more seconds to write the results
    /// that it has so far. `help` is the help text of --timeout. Call before parse().
    void keep_what_is_done(unsigned grace_s, const char* help);

    /// Fills the targets and starts the clock of --timeout, which every command has. If --help was given, prints it and
    /// returns false. Throws Failure for an unknown option (suggesting the nearest known one), a missing value or an
    /// extra argument.
    [[nodiscard]] bool parse(const Arguments& arguments);

    /// Ends the command with a usage error: "snapshot: --size: must be …".
    [[noreturn]] void refuse(const std::string& what) const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::optional<TimeLimit> limit_;  ///< lives as long as the command
    unsigned grace_s_ = 0;
    const char* timeout_help_ = "Exits with status 8 if the command takes longer than S seconds";
};

/// Wraps text to the help's width and indents every line; words are separated by single spaces.
std::string wrapped(const std::string& text, std::size_t indent);

/// Returns the table of the exit statuses with these digits.
std::string exit_status_table(const std::string& digits);

}  // namespace viewing
