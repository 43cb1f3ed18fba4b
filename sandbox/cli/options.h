// What one command takes, declared once: parsed, and printed as the command's --help. By hand, since every message is
// the program's own and a library would only split words.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/time_limit.h"

namespace viewing {

/// One option or positional of a command, as it was declared.
struct OptionDescription {
    std::string group;
    std::vector<std::string> names;  ///< "-o", "--output"; of a positional its name
    std::string value_name;          ///< "WxH"; "" for a flag and for a positional
    std::string help;
    bool is_positional = false;
};

/// All that a command takes, in the order of its help; the command itself does nothing.
std::vector<OptionDescription> options_of(const Command& command);

class Options {
public:
    explicit Options(const Command& command);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// The options declared after this stand under this title in the help.
    void group(const char* title);

    // `names` as "-o,--output"; `value_name` stands behind them in the help. Targets must outlive parse().
    void positional(const char* name, std::string& value, const char* help);
    void positionals(const char* name, std::vector<std::string>& values, const char* help);
    void text(const char* names, const char* value_name, std::optional<std::string>& value, const char* help);
    void texts(const char* names, const char* value_name, std::vector<std::string>& values, const char* help);
    void flag(const char* names, bool& value, const char* help);

    /// When the time of --timeout has run out the command writes what it has (TimeLimit::has_run_out), for which it has
    /// `grace_s` more seconds. `help` is what --help says of it. Before parse().
    void keep_what_is_done(unsigned grace_s, const char* help);

    /// Fills the targets, and starts the clock of --timeout, which every command has. False when --help was asked for
    /// and printed instead. Throws Failure for an unknown option (with the nearest known one), a missing value, one
    /// argument too many.
    [[nodiscard]] bool parse(const Arguments& arguments);

    /// "snapshot: --size: must be …": ends the command as bad usage.
    [[noreturn]] void refuse(const std::string& what) const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::optional<TimeLimit> limit_;  ///< as long as the command lives
    unsigned grace_s_ = 0;
    const char* timeout_help_ = "Exit 8 when the command is not done after so many seconds";
};

/// Text wrapped at the help's width, every line indented; words are separated by single spaces.
std::string wrapped(const std::string& text, std::size_t indent);

/// The rows of the exit statuses whose digits are given.
std::string exit_status_table(const std::string& digits);

}  // namespace viewing
