// The pages that are made from the table of commands and options. Read cli/options.h for the table.
#pragma once

#include <string>

namespace viewing {

std::string man_page();         ///< troff, for section 1
std::string bash_completion();  ///< commands, options, files, and names of presets asked from the program itself
std::string zsh_completion();   ///< the same with what each option does

}  // namespace viewing
