// Internal to lesson/: the vectors and matrices of expressions, as functions for Lua.
#pragma once

#include <span>
#include <string_view>

struct lua_State;

namespace viewing {

struct MathematicsName {
    std::string_view name, form, help;
};
std::span<const MathematicsName> mathematics_names();

/// Adds all names to the table on top of Lua's stack.
void add_mathematics(lua_State* lua);

}  // namespace viewing
