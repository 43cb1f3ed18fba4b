// The man page and completions, generated from the table of commands and options in cli/options.h.
#pragma once

#include <string>

namespace viewing {

std::string man_page();         ///< troff, for section 1
std::string bash_completion();  ///< completes commands, options, files, and the preset names that the program lists
std::string zsh_completion();   ///< does the same, and describes each option

}  // namespace viewing
