// The man page and completions, generated from the table of commands and options in cli/options.h.
#pragma once

#include <string>

namespace viewing {

std::string man_page();         ///< troff, for section 1
std::string bash_completion();  ///< commands, options, files, and preset names, which it gets from the program
std::string zsh_completion();   ///< the same, with a description of each option

}  // namespace viewing
