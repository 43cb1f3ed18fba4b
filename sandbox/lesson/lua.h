// Lua's headers for the names that its library exports: Debian 12's has those of C, Debian 13's those of C++.
#pragma once

#ifdef VIEWING_LUA_HAS_CXX_NAMES
#include <lua.h>
//
#include <lauxlib.h>
#include <lualib.h>
#else
#include <lua.hpp>
#endif
