#include "core/base/strict_json.h"

#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t deepest = 16, max_members = 1000, largest_text = std::size_t(64) << 20;
constexpr std::size_t line_width = 110;

/// Builds the value as the text is read, and remembers the way to the present place for messages.
class Builder : public nlohmann::json_sax<Json> {
public:
    Builder(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    Json root;

    bool null() override { return put(nullptr); }
    bool boolean(bool v) override { return put(v); }
    bool number_integer(number_integer_t v) override { return put(v); }
    bool number_unsigned(number_unsigned_t v) override { return put(v); }
    bool number_float(number_float_t v, const string_t&) override { return put(v); }
    bool string(string_t& v) override { return put(std::move(v)); }
    bool binary(binary_t&) override { return false; } // JSON text has none
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& k) override {
        Level& level = levels_.back();
        if (level.value->contains(k))
            throw Error(ErrorCode::syntax, place(k), "the key occurs twice", "keep one of them");
        if (level.value->size() >= max_members)
            throw Error(ErrorCode::limit_exceeded, place(k), "the object has too many keys",
                        "check the file");
        level.key = k;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& e) override {
        const std::size_t at = std::min(position > 0 ? position - 1 : 0, text_.size());
        const std::string_view before = text_.substr(0, at);
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
        const std::string where = name_ + ":" + std::to_string(line) + ":" + std::to_string(at - start + 1);
        const std::string what = e.what();
        if (e.id == 406)
            throw Error(ErrorCode::out_of_range, where,
                        "the number " + printable(token, 30) + " is too large",
                        "write a number of ordinary size");
        if (what.find("UTF-8") != std::string::npos)
            throw Error(ErrorCode::encoding, where, "the text is not UTF-8", "save the file as UTF-8");
        if (what.find("unexpected end of input") != std::string::npos
            || what.find("missing closing quote") != std::string::npos)
            throw Error(ErrorCode::truncated, where, "the file ends within a value", "copy or save it again");
        throw Error(ErrorCode::syntax, where, "not valid JSON near '" + printable(token, 30) + "'",
                    "check commas, quotes and braces");
    }

private:
    struct Level {
        Json* value;
        std::string key; // of the member being read
    };

    std::string place(const std::string& last = {}) const {
        std::string route;
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            const Level& l = levels_[i];
            const bool inner = i + 1 == levels_.size();
            if (l.value->is_array())
                route += "[" + std::to_string(inner ? l.value->size() : l.value->size() - 1) + "]";
            else if (!inner || !last.empty())
                route += (route.empty() ? "" : ".") + printable(inner ? last : l.key, 60);
        }
        return route.empty() ? name_ : name_ + ": " + route;
    }

    template <class T>
    bool put(T&& v) {
        add(Json(std::forward<T>(v)));
        return true;
    }
    Json* add(Json v) {
        if (levels_.empty()) {
            root = std::move(v);
            return &root;
        }
        Level& level = levels_.back();
        if (level.value->is_array()) {
            level.value->push_back(std::move(v));
            return &level.value->back();
        }
        return &((*level.value)[level.key] = std::move(v));
    }
    bool open(Json empty) {
        if (levels_.size() >= deepest)
            throw Error(ErrorCode::limit_exceeded, place(), "objects and lists are nested too deep",
                        "check the file");
        levels_.push_back({add(std::move(empty)), {}});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string_view text_;
    std::string name_;
    std::vector<Level> levels_;
};

/// Errors of what stands within `outer` name the whole way to it.
template <class F>
auto within(const Json& list, std::size_t i, const std::string& key, F&& f) {
    try {
        return f();
    } catch (const Error& e) {
        const std::string outer = list.is_object() ? printable(key, 60) : strict::element({}, i);
        const bool joined = e.where().empty() || e.where().front() == '[';
        throw Error(e.code(), outer + (joined ? "" : ".") + e.where(), e.message(), e.remedy());
    }
}

/// On one line, a blank after ',' and ':'.
std::string one_line(const Json& value) {
    if (value.is_string()) return json_text(value.get_ref<const std::string&>(), {});
    if (!value.is_structured() || value.empty()) return value.dump();
    const bool object = value.is_object();
    std::string text(object ? "{ " : "[");
    std::size_t i = 0;
    for (auto it = value.begin(); it != value.end(); ++it, ++i) {
        const std::string key = object ? it.key() : std::string();
        if (i > 0) text += ", ";
        text += within(value, i, key,
                       [&] { return (object ? json_text(key, {}) + ": " : std::string()) + one_line(*it); });
    }
    return text + (object ? " }" : "]");
}

void write(std::string& out, const Json& value, std::size_t indent) {
    const std::string flat = one_line(value);
    if (!value.is_structured() || value.empty() || (indent > 0 && indent + flat.size() < line_width)) {
        out += flat;
        return;
    }
    const bool object = value.is_object();
    out += object ? "{\n" : "[\n";
    for (auto it = value.begin(); it != value.end(); ++it) {
        if (it != value.begin()) out += ",\n";
        out.append(indent + 2, ' ');
        if (object) out += json_text(it.key(), {}) + ": ";
        write(out, *it, indent + 2);
    }
    out += '\n';
    out.append(indent, ' ');
    out += object ? '}' : ']';
}

} // namespace

Json parse_strict_json(std::string_view text, const std::string& name) {
    if (text.size() > largest_text)
        throw Error(ErrorCode::limit_exceeded, name, "the file is too large for a project or a machine",
                    "name a .facetmill or a .json file");
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")
        || text.find('\0') != std::string_view::npos)
        throw Error(ErrorCode::encoding, name, "the file is not UTF-8 text (UTF-16 or binary)",
                    "save it as UTF-8");
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    Builder builder(text, name);
    Json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder.root);
}

std::string pretty_json(const Json& value) {
    std::string out;
    write(out, value, 0);
    out += '\n';
    return out;
}

std::string json_type_name(const Json& value) {
    if (value.is_null()) return "null";
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    if (value.is_string()) return "a text";
    if (value.is_boolean()) return "true or false";
    return "a number";
}

Json json_number(double value, const std::string& where) {
    if (!std::isfinite(value))
        throw Error(ErrorCode::out_of_range, where, "the value is not a finite number", "enter a number");
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 15).ptr;
    std::from_chars(text, end, value);
    if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<long long>(value);
    return value;
}

namespace strict {

std::string member(const std::string& place, const std::string& key) {
    return place.empty() ? key : place + "." + key;
}
std::string element(const std::string& place, std::size_t i) {
    return place + "[" + std::to_string(i) + "]";
}

void wrong_type(const std::string& place, const Json& value, const std::string& expected) {
    throw Error(ErrorCode::wrong_type, place, "the value is " + json_type_name(value),
                "expected " + expected);
}

void expect_object(const Json& value, const std::string& place) {
    if (!value.is_object()) wrong_type(place, value, "an object");
}

const Json& expect_list(const Json& value, const std::string& place) {
    if (!value.is_array()) wrong_type(place, value, "a list");
    return value;
}

const Json& require(const Json& object, const std::string& place, const std::string& key,
                    const std::string& remedy) {
    if (!object.contains(key))
        throw Error(ErrorCode::missing_key, member(place, key), "the key is missing", remedy);
    return object[key];
}

std::string read_text(const Json& value, const std::string& place) {
    if (!value.is_string()) wrong_type(place, value, "a text");
    auto text = value.get<std::string>();
    check_text(text, place);
    return text;
}

void unknown_key(const std::string& key, const std::string& place, const std::vector<std::string>& known) {
    const std::string near = nearest_name(key, known);
    std::string list;
    for (const auto& k : known)
        list += (list.empty() ? "" : ", ") + k;
    throw Error(ErrorCode::unknown_key, member(place, printable(key)), "unknown key",
                near.empty() ? "known keys: " + list : "did you mean '" + near + "'?");
}

} // namespace strict

} // namespace facetmill
