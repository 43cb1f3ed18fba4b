#include "lesson/formulas/expression.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "lesson/formulas/lua.h"
#include "lesson/formulas/lua_words.h"
#include "lesson/formulas/mathematics.h"
#include "lesson/formulas/names.h"
#include "lesson/tree.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t longest_expression = 4096;  // bytes
constexpr const char* chunk_name = "=";           // keeps the file's name out of Lua's messages
constexpr int deepest_value = 16;

/// One evaluation, which Lua's callbacks receive as their data.
struct Evaluation {
    const Surroundings& surroundings;
    const std::string& source;
    std::span<const std::string> constants;  ///< names allowed in addition to the closed list
    ExpressionLimits limits;
    std::size_t used_bytes = 0;
    int instructions_left = limits.instructions;
    std::optional<Json> value = {};

    bool is_out_of_time() const { return instructions_left <= 0; }
    bool has_room_for(std::size_t bytes) const { return bytes <= limits.memory_bytes - used_bytes; }
};

constexpr int instructions_between_looks = 1000;
constexpr std::size_t bytes_of_an_instruction = 64;  // memory that can be filled in the time that one instruction takes
constexpr const char* takes_too_long = "takes too long";
constexpr const char* needs_too_much_memory = "needs too much memory";

/// Allocates memory for Lua. Growing a block costs instructions, too, so that a chain of copies also reaches the limit.
void* allocate(void* data, void* old, std::size_t old_bytes, std::size_t new_bytes) {
    auto& evaluation = *static_cast<Evaluation*>(data);
    const std::size_t before = old == nullptr ? 0 : old_bytes;  // without `old`, Lua passes the kind of value here
    if (new_bytes == 0) {
        std::free(old);
        evaluation.used_bytes -= before;
        return nullptr;
    }
    if (new_bytes > before) {
        if (evaluation.is_out_of_time() || !evaluation.has_room_for(new_bytes - before)) return nullptr;
        evaluation.instructions_left -= 1 + static_cast<int>(new_bytes / bytes_of_an_instruction);
    }
    void* const memory = std::realloc(old, new_bytes);
    if (memory != nullptr) evaluation.used_bytes = evaluation.used_bytes - before + new_bytes;
    return memory;
}

Evaluation& evaluation_of(lua_State* lua) {
    void* data = nullptr;
    lua_getallocf(lua, &data);
    return *static_cast<Evaluation*>(data);
}

[[noreturn]] void raise(lua_State* lua, const std::string& message) {
    lua_pushlstring(lua, message.data(), message.size());
    lua_error(lua);
    std::abort();  // lua_error does not return
}

void spend(lua_State* lua, int instructions) {
    Evaluation& evaluation = evaluation_of(lua);
    evaluation.instructions_left -= instructions;
    if (evaluation.is_out_of_time()) raise(lua, takes_too_long);
}

void look_at_time(lua_State* lua, lua_Debug*) {
    spend(lua, instructions_between_looks);
}

// ---- JSON to Lua and back ------------------------------------------------------------------------------------------

void push_value(lua_State* lua, const Json& value, const std::string& path);

void push_text(lua_State* lua, std::string_view text) {
    lua_pushlstring(lua, text.data(), text.size());
}

std::string string_at(lua_State* lua, int index) {
    std::size_t bytes = 0;
    const char* const text = lua_tolstring(lua, index, &bytes);
    return {text, bytes};
}

/// Reports a missing member by name and path. Upvalues: the path, and the members' names, one per line.
int refuse_member(lua_State* lua) {
    const std::string path = lua_tostring(lua, lua_upvalueindex(1));
    if (lua_type(lua, 2) != LUA_TSTRING) raise(lua, path + " has named members, not numbered ones");
    const std::string wanted = string_at(lua, 2);
    std::vector<std::string> names;
    std::string all = lua_tostring(lua, lua_upvalueindex(2));
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end + 1) {
        end = all.find('\n', begin);
        names.push_back(all.substr(begin, end - begin));
        if (names.back() == wanted) return 0;  // the member exists, but is null
    }
    raise(lua, path + " has no " + excerpt(wanted) + suggestion(wanted, names));
}

int length_of_list(lua_State* lua) {
    lua_pushinteger(lua, static_cast<lua_Integer>(lua_rawlen(lua, 1)) + (lua_rawgeti(lua, 1, 0) == LUA_TNIL ? 0 : 1));
    return 1;
}

/// Reports an index beyond the end of a list. Upvalues: the list's path and length. An element that is null is missing
/// in Lua, too.
int refuse_element(lua_State* lua) {
    const std::string path = lua_tostring(lua, lua_upvalueindex(1));
    const lua_Integer count = lua_tointeger(lua, lua_upvalueindex(2));
    if (lua_type(lua, 2) != LUA_TNUMBER) raise(lua, path + " has numbered members: " + path + "[0]");
    const lua_Number index = lua_tonumber(lua, 2);
    if (index >= 0.0 && index < static_cast<lua_Number>(count) && index == std::floor(index)) return 0;
    raise(lua,
          path + " has " + counted(count, "element") + ", counted from 0, but no [" + shortest_number(index) + "]");
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
    push_text(lua, path);
    push_text(lua, names);
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
    lua_createtable(lua, 0, 2);
    lua_pushcfunction(lua, length_of_list);
    lua_setfield(lua, -2, "__len");
    push_text(lua, path);
    lua_pushinteger(lua, static_cast<lua_Integer>(list.size()));
    lua_pushcclosure(lua, refuse_element, 2);
    lua_setfield(lua, -2, "__index");
    lua_setmetatable(lua, -2);
}

void push_value(lua_State* lua, const Json& value, const std::string& path) {
    luaL_checkstack(lua, 8, "nested too deeply");
    if (value.is_null())
        lua_pushnil(lua);
    else if (value.is_boolean())
        lua_pushboolean(lua, value.get<bool>() ? 1 : 0);
    else if (value.is_number())
        lua_pushnumber(lua, value.get<double>());
    else if (value.is_string())
        push_text(lua, value.get_ref<const std::string&>());
    else if (value.is_object())
        push_object(lua, value, path);
    else
        push_list(lua, value, path);
}

/// Counts the value's conversion to JSON toward the expression's limits: a table may contain another table many times.
void take(lua_State* lua, std::size_t bytes) {
    spend(lua, 1);
    Evaluation& evaluation = evaluation_of(lua);
    if (!evaluation.has_room_for(bytes)) raise(lua, needs_too_much_memory);
    evaluation.used_bytes += bytes;
}

Json text_value(lua_State* lua, int index) {
    take(lua, static_cast<std::size_t>(lua_rawlen(lua, index)));
    std::string text = string_at(lua, index);
    if (!is_utf8(text)) raise(lua, "its value " + excerpt(text) + " is not valid UTF-8");
    return text;
}

Json value_at(lua_State* lua, int index, int depth) {
    take(lua, sizeof(Json));
    switch (lua_type(lua, index)) {
        case LUA_TNIL:
            return nullptr;
        case LUA_TBOOLEAN:
            return lua_toboolean(lua, index) != 0;
        case LUA_TNUMBER:
            return lua_tonumber(lua, index);
        case LUA_TSTRING:
            return text_value(lua, index);
        case LUA_TTABLE:
            break;
        default:
            raise(lua, "its value is a function; is () missing?");
    }
    if (depth == deepest_value) raise(lua, "its value is nested too deeply");
    luaL_checkstack(lua, 4, "nested too deeply");
    const int table = lua_absindex(lua, index);
    Json list = Json::array();
    lua_Integer at = lua_rawgeti(lua, table, 0) == LUA_TNIL ? 1 : 0;
    lua_pop(lua, 1);
    for (; lua_rawgeti(lua, table, at) != LUA_TNIL; ++at) {
        list.push_back(value_at(lua, -1, depth + 1));
        lua_pop(lua, 1);
    }
    lua_pop(lua, 1);
    if (list.empty()) raise(lua, "its value must not be a group of fields or an empty list");
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
    return "unknown name " + excerpt(word) + suggestion(word, names);
}

Json looked_up(lua_State* lua, const std::string& name, std::span<const double> arguments) {
    const Evaluation& evaluation = evaluation_of(lua);
    Result<Json> value = evaluation.surroundings.look_up(name, arguments);
    if (!value) raise(lua, value.error());
    return *std::move(value);
}

int call_measured(lua_State* lua) {
    const std::string name = lua_tostring(lua, lua_upvalueindex(1));
    spend(lua, evaluation_of(lua).limits.measured_call);
    std::vector<double> arguments;
    for (int i = 1, count = lua_gettop(lua); i <= count; ++i) arguments.push_back(luaL_checknumber(lua, i));
    push_value(lua, looked_up(lua, name, arguments), name + "()");
    return 1;
}

/// Looks up a name that is not a mathematical function or constant. Lua calls this when the evaluation reaches the
/// name.
int find_name(lua_State* lua) {
    constexpr int instructions_of_search = 10;
    spend(lua, instructions_of_search);
    const std::string word = lua_type(lua, 2) == LUA_TSTRING ? string_at(lua, 2) : "";
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
        push_text(lua, word);
        lua_pushcclosure(lua, call_measured, 1);
    } else {
        push_value(lua, looked_up(lua, word, {}), word);
    }
    return 1;
}

int refuse_assignment(lua_State* lua) {
    return luaL_error(lua, "an expression cannot assign: remove the =");
}

/// Pushes the expression onto Lua's stack, as a function.
void load(lua_State* lua) {
    const Evaluation& evaluation = evaluation_of(lua);
    spend(lua, static_cast<int>(evaluation.source.size()));
    const std::string source = "return " + evaluation.source;
    if (luaL_loadbufferx(lua, source.data(), source.size(), chunk_name, "t") != LUA_OK) lua_error(lua);
    if (!evaluation.limits.closed_list) return;
    for (const std::string& word : words_of_source(evaluation.source)) {
        if (is_word_of_values(word) || expression_name(word)) continue;
        if (is_word_of_lua(word))
            raise(
                lua,
                word + " is not allowed: the only Lua keywords in an expression are and, or, not, true, false and nil");
        const std::span<const std::string> constants = evaluation.constants;
        if (std::find(constants.begin(), constants.end(), word) == constants.end()) raise(lua, unknown_name(word));
    }
}

int load_only(lua_State* lua) {
    load(lua);
    return 0;
}

/// Runs everything in one protected call, so that running out of memory is an error like any other.
int run(lua_State* lua) {
    load(lua);
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
    evaluation_of(lua).value = value_at(lua, -1, 0);
    return 0;
}

/// Removes the line number from Lua's message, since there is only one line.
std::string without_place(std::string message) {
    const std::size_t place = message.find(":1: ");
    if (place != std::string::npos && place <= 1) message.erase(0, place + 4);
    return one_line(message);
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
    const auto no_memory = [&] { return Error{evaluation.is_out_of_time() ? takes_too_long : needs_too_much_memory}; };
    const std::unique_ptr<lua_State, Close> lua(lua_newstate(allocate, &evaluation));
    if (!lua) return no_memory();
    lua_pushcfunction(lua.get(), function);
    const int status = lua_pcall(lua.get(), 0, 0, 0);
    if (status == LUA_OK) return std::monostate{};
    if (status == LUA_ERRMEM) return no_memory();
    const char* const message = lua_tostring(lua.get(), -1);
    return Error{without_place(message ? message : "cannot be evaluated")};
}

}  // namespace

bool is_constant_name(const std::string& word) {
    const ExpressionName* const name = expression_name(word);
    return has_form_of_name(word) && !is_word_of_lua(word) && !(name && name->kind == NameKind::mathematics);
}

Status check_expression(const std::string& expression, std::span<const std::string> constants) {
    if (Status fine = check_length(expression); !fine) return fine;
    const Surroundings nothing;
    Evaluation evaluation{nothing, expression, constants, {}};
    return protectedly(evaluation, load_only);
}

bool is_measured(const std::string& expression) {
    const std::vector<std::string> words = words_of_source(expression);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        const ExpressionName* const name = expression_name(word);
        return name && name->kind == NameKind::measured;
    });
}

Result<Json> evaluate(const std::string& expression, const Surroundings& surroundings, const ExpressionLimits& limits) {
    if (const Status fine = check_length(expression); !fine) return Error{fine.error()};
    const std::vector<std::string> constants = keys_of(surroundings.constants);
    Evaluation evaluation{surroundings, expression, constants, limits};
    if (const Status done = protectedly(evaluation, run); !done) return Error{done.error()};
    return *std::move(evaluation.value);
}

Result<bool> holds(const std::string& expression, const Surroundings& surroundings, const ExpressionLimits& limits) {
    const Result<Json> value = evaluate(expression, surroundings, limits);
    if (!value) return Error{value.error()};
    if (!value->is_boolean()) return Error{"must be true or false, got " + describe(*value)};
    return value->get<bool>();
}

}  // namespace viewing
