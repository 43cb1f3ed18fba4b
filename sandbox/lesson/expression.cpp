#include "lesson/expression.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <lua.hpp>
#include <memory>
#include <set>

#include "lesson/mathematics.h"
#include "lesson/names.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t longest_expression = 4096;  // bytes
constexpr const char* chunk_name = "=";           // no file and no line in Lua's messages
constexpr int deepest_value = 16;

/// What Lua's callbacks know of the evaluation they belong to.
struct Evaluation {
    const Surroundings& surroundings;
    const std::string& source;
    ExpressionLimits limits;
    std::size_t used_bytes = 0;
    int instructions_left = 0;
    std::optional<Json> value;
};

constexpr int instructions_between_looks = 1000;

void* allocate(void* data, void* old, std::size_t old_bytes, std::size_t new_bytes) {
    auto& evaluation = *static_cast<Evaluation*>(data);
    const std::size_t before = old == nullptr ? 0 : old_bytes;  // without an old one Lua tells a kind of value there
    if (new_bytes == 0) {
        std::free(old);
        evaluation.used_bytes -= before;
        return nullptr;
    }
    if (evaluation.used_bytes - before + new_bytes > evaluation.limits.memory_bytes) return nullptr;
    void* const memory = std::realloc(old, new_bytes);
    if (memory != nullptr) evaluation.used_bytes = evaluation.used_bytes - before + new_bytes;
    return memory;
}

Evaluation& evaluation_of(lua_State* lua) {
    void* data = nullptr;
    lua_getallocf(lua, &data);
    return *static_cast<Evaluation*>(data);
}

void look_at_time(lua_State* lua, lua_Debug*) {
    int& left = evaluation_of(lua).instructions_left;
    left -= instructions_between_looks;
    if (left <= 0) luaL_error(lua, "takes too long");
}

[[noreturn]] void raise(lua_State* lua, const std::string& message) {
    lua_pushlstring(lua, message.data(), message.size());
    lua_error(lua);
    std::abort();  // lua_error does not return
}

// ---- JSON to Lua and back ------------------------------------------------------------------------------------------

void push_value(lua_State* lua, const Json& value, const std::string& path);

/// An object's table knows its own path, so that a member that is not there is told by name. Its upvalues: the path and
/// the members' names, one a line.
int refuse_member(lua_State* lua) {
    const std::string path = lua_tostring(lua, lua_upvalueindex(1));
    if (lua_type(lua, 2) != LUA_TSTRING) raise(lua, path + " has names, no numbers, for its members");
    const std::string wanted = lua_tostring(lua, 2);
    std::vector<std::string> names;
    std::string all = lua_tostring(lua, lua_upvalueindex(2));
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end + 1) {
        end = all.find('\n', begin);
        names.push_back(all.substr(begin, end - begin));
        if (names.back() == wanted) return 0;  // it is null
    }
    raise(lua, path + " has no " + excerpt(wanted) + suggestion(wanted, names));
}

int length_of_list(lua_State* lua) {
    lua_pushinteger(lua, static_cast<lua_Integer>(lua_rawlen(lua, 1)) + (lua_rawgeti(lua, 1, 0) == LUA_TNIL ? 0 : 1));
    return 1;
}

void push_object(lua_State* lua, const Json& object, const std::string& path) {
    lua_createtable(lua, 0, static_cast<int>(object.size()));
    std::string names;
    for (const auto& [key, member] : object.items()) {
        push_value(lua, member, path + "." + key);
        lua_setfield(lua, -2, key.c_str());
        names += key + "\n";
    }
    lua_createtable(lua, 0, 1);
    lua_pushlstring(lua, path.data(), path.size());
    lua_pushlstring(lua, names.data(), names.size());
    lua_pushcclosure(lua, refuse_member, 2);
    lua_setfield(lua, -2, "__index");
    lua_setmetatable(lua, -2);
}

void push_list(lua_State* lua, const Json& list, const std::string& path) {
    lua_createtable(lua, static_cast<int>(list.size()), 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
        push_value(lua, list[i], path + "[" + std::to_string(i) + "]");
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i));
    }
    lua_createtable(lua, 0, 1);
    lua_pushcfunction(lua, length_of_list);
    lua_setfield(lua, -2, "__len");
    lua_setmetatable(lua, -2);
}

void push_value(lua_State* lua, const Json& value, const std::string& path) {
    luaL_checkstack(lua, 8, "too deep");
    if (value.is_null())
        lua_pushnil(lua);
    else if (value.is_boolean())
        lua_pushboolean(lua, value.get<bool>() ? 1 : 0);
    else if (value.is_number())
        lua_pushnumber(lua, value.get<double>());
    else if (value.is_string())
        lua_pushstring(lua, value.get_ref<const std::string&>().c_str());
    else if (value.is_object())
        push_object(lua, value, path);
    else
        push_list(lua, value, path);
}

Json value_at(lua_State* lua, int index, int depth) {
    switch (lua_type(lua, index)) {
        case LUA_TNIL:
            return nullptr;
        case LUA_TBOOLEAN:
            return lua_toboolean(lua, index) != 0;
        case LUA_TNUMBER:
            return lua_tonumber(lua, index);
        case LUA_TSTRING:
            return std::string(lua_tostring(lua, index));
        case LUA_TTABLE:
            break;
        default:
            raise(lua, "its value is a function; is () missing?");
    }
    if (depth == deepest_value) raise(lua, "its value is too deep");
    luaL_checkstack(lua, 4, "too deep");
    const int table = lua_absindex(lua, index);
    Json list = Json::array();
    lua_Integer at = lua_rawgeti(lua, table, 0) == LUA_TNIL ? 1 : 0;
    lua_pop(lua, 1);
    for (; lua_rawgeti(lua, table, at) != LUA_TNIL; ++at) {
        list.push_back(value_at(lua, -1, depth + 1));
        lua_pop(lua, 1);
    }
    lua_pop(lua, 1);
    if (list.empty()) raise(lua, "its value is a group of fields or an empty list");
    return list;
}

// ---- names ---------------------------------------------------------------------------------------------------------

const ExpressionName* expression_name(std::string_view word) {
    const std::vector<ExpressionName>& names = expression_names();
    const auto at = std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.name == word; });
    return at == names.end() ? nullptr : &*at;
}

std::string unknown_name(const std::string& word) {
    std::vector<std::string> names;
    for (const ExpressionName& name : expression_names()) names.push_back(name.name);
    return "there is no name " + excerpt(word) + suggestion(word, names);
}

Json looked_up(lua_State* lua, const std::string& name, std::span<const double> arguments) {
    const Evaluation& evaluation = evaluation_of(lua);
    Result<Json> value = evaluation.surroundings.look_up(name, arguments);
    if (!value) raise(lua, value.error());
    return *std::move(value);
}

int call_measured(lua_State* lua) {
    const std::string name = lua_tostring(lua, lua_upvalueindex(1));
    std::vector<double> arguments;
    for (int i = 1, count = lua_gettop(lua); i <= count; ++i) arguments.push_back(luaL_checknumber(lua, i));
    push_value(lua, looked_up(lua, name, arguments), name + "()");
    return 1;
}

/// A name that is no mathematics: asked for when the expression comes to it.
int find_name(lua_State* lua) {
    const std::string word = lua_type(lua, 2) == LUA_TSTRING ? lua_tostring(lua, 2) : "";
    const Json& constants = evaluation_of(lua).surroundings.constants;
    if (const auto constant = constants.find(word); constant != constants.end()) {
        push_value(lua, *constant, word);
        return 1;
    }
    const ExpressionName* const name = expression_name(word);
    if (!name) raise(lua, unknown_name(word));
    if (word == "answer") {
        push_value(lua, evaluation_of(lua).surroundings.answer, word);
    } else if (name->kind == NameKind::measured) {
        lua_pushlstring(lua, word.data(), word.size());
        lua_pushcclosure(lua, call_measured, 1);
    } else {
        push_value(lua, looked_up(lua, word, {}), word);
    }
    return 1;
}

int refuse_assignment(lua_State* lua) {
    return luaL_error(lua, "an expression changes nothing: no =");
}

/// Everything inside one protected call, so that no memory for the next table is an error like others.
int run(lua_State* lua) {
    Evaluation& evaluation = evaluation_of(lua);
    const std::string source = "return " + evaluation.source;
    if (luaL_loadbufferx(lua, source.data(), source.size(), chunk_name, "t") != LUA_OK) lua_error(lua);
    lua_createtable(lua, 0, 40);
    add_mathematics(lua);
    lua_createtable(lua, 0, 2);
    lua_pushcfunction(lua, find_name);
    lua_setfield(lua, -2, "__index");
    lua_pushcfunction(lua, refuse_assignment);
    lua_setfield(lua, -2, "__newindex");
    lua_setmetatable(lua, -2);
    lua_setupvalue(lua, -2, 1);  // the expression's _ENV
    lua_sethook(lua, look_at_time, LUA_MASKCOUNT, instructions_between_looks);
    lua_call(lua, 0, 1);
    evaluation.value = value_at(lua, -1, 0);
    return 0;
}

/// Lua's own sentence without the place in the one line that there is.
std::string without_place(std::string message) {
    const std::size_t place = message.find(":1: ");
    if (place != std::string::npos && place <= 1) message.erase(0, place + 4);
    return one_line(message);
}

// ---- before anything runs ------------------------------------------------------------------------------------------

bool starts_word(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool continues_word(char c) {
    return starts_word(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The words of an expression outside of its texts that are neither members (after a point) nor parts of numbers.
std::vector<std::string> words_of(const std::string& source) {
    std::vector<std::string> words;
    char before = ' ';
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '"' || c == '\'') {
            for (++i; i < source.size() && source[i] != c; ++i)
                if (source[i] == '\\') ++i;
            if (i >= source.size()) break;  // without an end
        } else if (continues_word(c)) {
            const std::size_t begin = i;
            while (i + 1 < source.size() && continues_word(source[i + 1])) ++i;
            if (starts_word(c) && before != '.') words.push_back(source.substr(begin, i + 1 - begin));
        }
        if (std::isspace(static_cast<unsigned char>(c)) == 0) before = source[i];
    }
    return words;
}

const std::set<std::string, std::less<>>& words_of_lua() {
    static const std::set<std::string, std::less<>> words = {"and", "false", "nil", "not", "or", "true"};
    return words;
}

Status check_words(const std::string& source, std::span<const std::string> constants) {
    for (const std::string& word : words_of(source)) {
        if (words_of_lua().contains(word) || expression_name(word)) continue;
        if (std::find(constants.begin(), constants.end(), word) != constants.end()) continue;
        return Error{unknown_name(word)};
    }
    return std::monostate{};
}

int load_only(lua_State* lua) {
    const std::string source = "return " + evaluation_of(lua).source;
    if (luaL_loadbufferx(lua, source.data(), source.size(), chunk_name, "t") != LUA_OK) lua_error(lua);
    return 0;
}

struct Close {
    void operator()(lua_State* lua) const { lua_close(lua); }
};

Status check_length(const std::string& expression) {
    if (expression.find_first_not_of(" \t") == std::string::npos) return Error{"is empty"};
    if (expression.size() > longest_expression)
        return Error{"longer than " + std::to_string(longest_expression) + " bytes"};
    return std::monostate{};
}

Status protectedly(Evaluation& evaluation, lua_CFunction function) {
    evaluation.instructions_left = evaluation.limits.instructions;
    const std::unique_ptr<lua_State, Close> lua(lua_newstate(allocate, &evaluation));
    if (!lua) return Error{"needs too much memory"};
    lua_pushcfunction(lua.get(), function);
    const int status = lua_pcall(lua.get(), 0, 0, 0);
    if (status == LUA_OK) return std::monostate{};
    if (status == LUA_ERRMEM) return Error{"needs too much memory"};
    const char* const message = lua_tostring(lua.get(), -1);
    return Error{without_place(message ? message : "cannot be evaluated")};
}

}  // namespace

bool is_constant_name(const std::string& word) {
    static const std::set<std::string, std::less<>> reserved = {
        "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
        "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};
    const ExpressionName* const name = expression_name(word);
    return !word.empty() && starts_word(word.front()) && std::all_of(word.begin(), word.end(), continues_word) &&
           !reserved.contains(word) && !(name && name->kind == NameKind::mathematics);
}

Status check_expression(const std::string& expression, std::span<const std::string> constants) {
    if (Status fine = check_length(expression); !fine) return fine;
    const Surroundings nothing;
    Evaluation evaluation{nothing, expression, {}, 0, 0, {}};
    if (Status read = protectedly(evaluation, load_only); !read) return read;
    return check_words(expression, constants);
}

bool is_measured(const std::string& expression) {
    const std::vector<std::string> words = words_of(expression);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        const ExpressionName* const name = expression_name(word);
        return name && name->kind == NameKind::measured;
    });
}

Result<Json> evaluate(const std::string& expression, const Surroundings& surroundings, const ExpressionLimits& limits) {
    if (const Status fine = check_length(expression); !fine) return Error{fine.error()};
    Evaluation evaluation{surroundings, expression, limits, 0, 0, {}};
    if (Status done = protectedly(evaluation, run); !done) return Error{done.error()};
    return *std::move(evaluation.value);
}

Result<bool> holds(const std::string& expression, const Surroundings& surroundings) {
    const Result<Json> value = evaluate(expression, surroundings);
    if (!value) return Error{value.error()};
    if (!value->is_boolean()) return Error{"must be true or false, is " + describe(*value)};
    return value->get<bool>();
}

}  // namespace viewing
