// Lua's headers, with the linkage of the installed library: Debian 12's exports C names, Debian 13's exports C++ names.
#pragma once

#ifdef VIEWING_LUA_HAS_CXX_NAMES
#include <lua.h>
//
#include <lauxlib.h>
#include <lualib.h>
#else
#include <lua.hpp>
#endif
