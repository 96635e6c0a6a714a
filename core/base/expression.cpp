#include "core/base/expression.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/vec.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr int deepest_bracket = 50; ///< brackets in brackets

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '"' || c == '%'
           || static_cast<unsigned char>(c) >= 0x80;
}

/// A plain number, or one in the core's unit of the field.
struct Value {
    double number = 0;
    bool measured = false;
};

class Reader {
public:
    Reader(std::string_view text, Quantity quantity, LengthUnit unit, const NamedLengths& names,
           const std::string& where)
        : text_(text), quantity_(quantity), per_(core_per_edge(quantity, unit)), names_(names),
          where_(where) {}

    double run() {
        skip();
        if (at_ < text_.size() && text_[at_] == '=') ++at_;
        const Value value = sum(0);
        skip();
        if (at_ < text_.size()) fail("'" + printable(text_.substr(at_, 20)) + "' is left over");
        const double number = value.measured ? value.number : value.number * per_;
        if (!std::isfinite(number)) fail("it has no value");
        return number;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorCode::wrong_type, where_, what,
                    "enter a number, or something like 25.4/2 or 1/4 in");
    }
    void skip() {
        while (at_ < text_.size() && text_[at_] == ' ')
            ++at_;
    }
    bool take(char c) {
        skip();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    Value in_unit(Value v) const { return v.measured ? v : Value{v.number * per_, true}; }

    Value sum(int depth) {
        Value v = product(depth);
        for (;;) {
            const bool plus = take('+');
            if (!plus && !take('-')) return v;
            Value other = product(depth);
            if (v.measured != other.measured) {
                v = in_unit(v);
                other = in_unit(other);
            }
            v.number += plus ? other.number : -other.number;
        }
    }

    Value product(int depth) {
        Value v = factor(depth);
        for (;;) {
            v = with_unit(v);
            const bool times = take('*');
            if (!times && !take('/')) return v;
            const Value other = factor(depth);
            if (times) {
                if (v.measured && other.measured) fail("two measures are multiplied");
                v = {v.number * other.number, v.measured || other.measured};
            } else {
                // In "3 / 1 in" the unit is that of the whole fraction, so here only names are measured.
                if (other.measured && !v.measured) fail("a number is divided by a measure");
                if (other.number == 0) fail("it divides by 0");
                v = {v.number / other.number, v.measured && !other.measured};
            }
        }
    }

    Value factor(int depth) {
        if (depth > deepest_bracket) fail("there are too many brackets");
        if (take('-')) {
            const Value v = factor(depth + 1);
            return {-v.number, v.measured};
        }
        if (take('+')) return factor(depth + 1);
        if (take('(')) {
            const Value v = sum(depth + 1);
            if (!take(')')) fail("a bracket is not closed");
            return v;
        }
        skip();
        if (at_ >= text_.size()) fail("it ends where a number is missing");
        if (is_digit(text_[at_]) || text_[at_] == '.') return {number(), false};
        const std::string name = word();
        if (name.empty()) fail("'" + printable(text_.substr(at_, 1)) + "' is out of place");
        return named(name);
    }

    double plain() {
        const std::size_t begin = at_;
        while (at_ < text_.size()
               && (is_digit(text_[at_]) || text_[at_] == '.'
                   || ((text_[at_] == 'e' || text_[at_] == 'E') && at_ + 1 < text_.size()
                       && (is_digit(text_[at_ + 1])
                           || (at_ + 2 < text_.size() && (text_[at_ + 1] == '-' || text_[at_ + 1] == '+')
                               && is_digit(text_[at_ + 2]))))
                   || ((text_[at_] == '-' || text_[at_] == '+') && at_ > begin
                       && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E'))))
            ++at_;
        double value = 0;
        if (!parse_number(text_.substr(begin, at_ - begin), value))
            fail("'" + printable(text_.substr(begin, at_ - begin)) + "' is no number");
        return value;
    }

    /// Also "1 1/4".
    double number() {
        const double whole = plain();
        const std::size_t back = at_;
        skip();
        if (at_ > back && at_ < text_.size() && is_digit(text_[at_])) {
            const double above = plain();
            if (!take('/')) fail("a sign is missing between two numbers");
            skip();
            const double below = plain();
            if (below == 0) fail("it divides by 0");
            return whole + above / below;
        }
        at_ = back;
        return whole;
    }

    std::string word() {
        skip();
        const std::size_t begin = at_;
        while (at_ < text_.size()
               && (is_letter(text_[at_]) || (at_ > begin && (is_digit(text_[at_]) || text_[at_] == '.'))))
            ++at_;
        return std::string(text_.substr(begin, at_ - begin));
    }

    /// A unit behind a product, if there is one.
    Value with_unit(Value v) {
        const std::size_t back = at_;
        std::string name = word();
        if (name.empty()) return v;
        // "mm/min" is one word.
        if (const std::size_t slash = at_; take('/')) {
            const std::string second = word();
            if (second == "min" || second == "minute")
                name += "/min";
            else
                at_ = slash;
        }
        const std::optional<double> per = unit_factor(name);
        if (!per) {
            at_ = back;
            fail("'" + printable(name, 30) + "' is no unit that this field can have");
        }
        if (v.measured) fail("'" + printable(name, 30) + "' stands behind what has a unit already");
        return {v.number * *per, true};
    }

    std::optional<double> unit_factor(std::string name) const {
        name = in_small_letters(std::move(name));
        if (quantity_ == Quantity::length || quantity_ == Quantity::feed) {
            std::string length = name;
            if (quantity_ == Quantity::feed) {
                if (name == "ipm") return mm_per_inch;
                if (name == "mmpm") return 1;
                if (!name.ends_with("/min")) return std::nullopt;
                length = name.substr(0, name.size() - 4);
            }
            for (const LengthUnit u : mesh_units)
                if (length == unit_name(u)) return mm_per(u);
            if (length == "\"" || length == "inch") return mm_per_inch;
            if (length == "µm" || length == "um") return 1e-3;
        }
        if (quantity_ == Quantity::angle) {
            if (name == "°" || name == "deg") return radians(1);
            if (name == "rad") return 1;
        }
        if (quantity_ == Quantity::time && (name == "s" || name == "sec")) return 1;
        if (quantity_ == Quantity::time && name == "min") return 60;
        if (quantity_ == Quantity::rotation && (name == "rpm" || name == "1/min")) return 1;
        if (quantity_ == Quantity::ratio && name == "%") return 0.01;
        return std::nullopt;
    }

    Value named(const std::string& name) const {
        const auto found =
            std::find_if(names_.begin(), names_.end(), [&](const NamedLength& n) { return n.name == name; });
        if (found == names_.end()) {
            std::string known;
            for (const NamedLength& n : names_)
                known += (known.empty() ? "" : ", ") + n.name;
            throw Error(ErrorCode::wrong_type, where_, "'" + printable(name, 30) + "' is no name",
                        known.empty() ? "enter a number" : "use one of " + known);
        }
        if (quantity_ != Quantity::length)
            fail("'" + printable(name, 30) + "' is a length, the field has none");
        return {found->value, true};
    }

    std::string_view text_;
    Quantity quantity_;
    double per_;
    const NamedLengths& names_;
    const std::string& where_;
    std::size_t at_ = 0;
};

} // namespace

double evaluate(std::string_view text, Quantity quantity, LengthUnit unit, const NamedLengths& names,
                const std::string& where) {
    return Reader(text, quantity, unit, names, where).run();
}

} // namespace facetmill
