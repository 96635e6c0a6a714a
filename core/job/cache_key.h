// Exact text of values, by which results are known that were worked out before.
#pragma once

#include "core/base/parameter.h"

#include <charconv>
#include <string>
#include <string_view>

namespace facetmill {

class Key {
public:
    Key& add(std::string_view text) {
        text_ += std::to_string(text.size());
        text_ += ':';
        text_ += text;
        return *this;
    }
    Key& add(double v) {
        char buffer[40];
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::hex).ptr;
        return add(std::string_view(buffer, std::size_t(end - buffer)));
    }
    template <std::size_t N>
    Key& add(const std::array<double, N>& values) {
        for (double v : values)
            add(v);
        return *this;
    }
    Key& add(const Vec3& v) { return add(v.x()).add(v.y()).add(v.z()); }
    Key& add_value(const ParameterValue& value) {
        add(std::to_string(value.index()));
        std::visit(
            [this](const auto& v) {
                using T = std::decay_t<decltype(v)>;
                if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, long>)
                    add(std::to_string(long(v)));
                else if constexpr (std::is_same_v<T, std::string>)
                    add(std::string_view(v));
                else if constexpr (std::is_same_v<T, ParameterRecords>)
                    add_records(v);
                else
                    add(v);
            },
            value);
        return *this;
    }
    /// All parameters whose change makes `last` or a stage before it stale.
    Key& add_up_to(Stage last, const Parameterized& values) {
        for (const ParameterInfo* info : values.parameters())
            if (info->stage <= last) add(std::string_view(info->key)).add_value(values.get(info->key));
        return *this;
    }
    template <class Struct>
    Key& add_up_to(Stage last, const Struct& values, const ParameterTable<Struct>& table) {
        Struct copy = values;
        return add_up_to(last, ParameterView<Struct>(copy, table));
    }
    const std::string& text() const { return text_; }

private:
    void add_records(const ParameterRecords& records) {
        add(std::to_string(records.all.size()));
        for (const auto& record : records.all)
            for (const ParameterValue& value : record)
                add_value(value);
    }

    std::string text_;
};

} // namespace facetmill
