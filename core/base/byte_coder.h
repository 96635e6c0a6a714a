// Values as bytes, and back. A struct says once, for both directions, what it consists of:
//
//     template <class Coder, CodedAs<Motion> T>
//     void code_fields(Coder& coder, T& m) {
//         auto& [kind, to, pass, point] = m; // does not compile any more when a member is added
//         coder(kind, to, pass, point);
//     }
//
// in a namespace where it is found by its type or by the coder's. Numbers are as the machine has them: the
// bytes are for the program that wrote them. What is shared is written once. A reader trusts no size: it
// never takes more memory than the bytes that are left account for, and never reads beyond them.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/base/vec.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <variant>
#include <vector>

namespace facetmill {

template <class T, class Struct>
concept CodedAs = std::same_as<std::remove_const_t<T>, Struct>;

namespace coding {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Whether a vector's elements are written as they lie in memory: numbers, and arrays of numbers.
template <class T>
inline constexpr bool in_one_piece = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <class T, std::size_t N>
inline constexpr bool in_one_piece<std::array<T, N>> = in_one_piece<T>;

/// Cancellation is looked for once in so many values.
inline constexpr std::size_t values_per_check = 1 << 16;

} // namespace coding

class ByteWriter {
public:
    static constexpr bool reads = false;
    explicit ByteWriter(const Progress& progress = {}) : progress_(progress) {}

    template <class... T>
    void operator()(const T&... values) {
        (put(values), ...);
    }
    /// What readers are given, too, is written as its number alone. To be told before anything is written.
    template <class T>
    void knows(const std::shared_ptr<const T>& object) {
        if (object) number_of(std::type_index(typeid(T)), object.get());
    }
    std::string take() { return std::move(bytes_); }

private:
    void raw(const void* from, std::size_t n) {
        if (++values_ % coding::values_per_check == 0) progress_.check();
        bytes_.append(static_cast<const char*>(from), n);
    }
    /// Numbers from 1; the second is whether it is new.
    std::pair<std::uint64_t, bool> number_of(std::type_index type, const void* object) {
        auto& numbers = shared_[type];
        const auto [it, is_new] = numbers.try_emplace(object, numbers.size() + 1);
        return {it->second, is_new};
    }

    template <class T>
    void put(const T& value) {
        if constexpr (coding::Plain<T>)
            raw(&value, sizeof value);
        else
            code_fields(*this, value);
    }
    template <class T, int Rows, int Columns>
    void put(const Eigen::Matrix<T, Rows, Columns>& m) {
        raw(m.data(), sizeof(T) * std::size_t(Rows * Columns));
    }
    void put(const std::string& text) {
        put(std::uint64_t(text.size()));
        raw(text.data(), text.size());
    }
    template <class T, std::size_t N>
    void put(const std::array<T, N>& values) {
        for (const T& v : values)
            put(v);
    }
    template <class T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t(values.size()));
        if constexpr (coding::in_one_piece<T>)
            raw(values.data(), values.size() * sizeof(T));
        else
            for (const T& v : values)
                put(v);
    }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <class... T>
    void put(const std::variant<T...>& value) {
        put(std::uint64_t(value.index()));
        std::visit(
            [this](const auto& v) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) put(v);
            },
            value);
    }
    template <class T>
    void put(const std::shared_ptr<const T>& object) {
        if (!object) return put(std::uint64_t(0));
        const auto [number, is_new] = number_of(std::type_index(typeid(T)), object.get());
        put(number);
        if (is_new) put(*object);
    }

    Progress progress_;
    std::string bytes_;
    std::map<std::type_index, std::map<const void*, std::uint64_t>> shared_;
    std::size_t values_ = 0;
};

class ByteReader {
public:
    static constexpr bool reads = true;
    explicit ByteReader(std::string_view bytes, const Progress& progress = {})
        : rest_(bytes), progress_(progress) {}

    /// Throws Error(truncated, syntax) where the bytes are none that a writer made of such values.
    template <class... T>
    void operator()(T&... values) {
        (get(values), ...);
    }
    /// In the order in which the writer was told.
    template <class T>
    void knows(const std::shared_ptr<const T>& object) {
        auto& known = shared_[std::type_index(typeid(T))];
        if (object && std::find(known.begin(), known.end(), object) == known.end()) known.push_back(object);
    }
    /// Throws Error(syntax) where something is left.
    void end() const {
        if (!rest_.empty()) damaged(ErrorCode::syntax);
    }

private:
    static constexpr int max_depth = 16; ///< of shared objects in shared objects

    [[noreturn]] static void damaged(ErrorCode code) {
        throw Error(code, "bytes", "they are not what was written", "leave them out");
    }
    void raw(void* to, std::size_t n) {
        if (++values_ % coding::values_per_check == 0) progress_.check();
        if (n > rest_.size()) damaged(ErrorCode::truncated);
        if (n > 0) std::memcpy(to, rest_.data(), n);
        rest_.remove_prefix(n);
    }
    /// A number of things of at least `least` bytes each.
    std::size_t size(std::size_t least) {
        std::uint64_t n = 0;
        get(n);
        if (n > rest_.size() / least) damaged(ErrorCode::truncated);
        return std::size_t(n);
    }

    template <class T>
    void get(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            raw(&byte, 1);
            if (byte > 1) damaged(ErrorCode::syntax);
            value = byte == 1;
        } else if constexpr (coding::Plain<T>)
            raw(&value, sizeof value);
        else
            code_fields(*this, value);
    }
    template <class T, int Rows, int Columns>
    void get(Eigen::Matrix<T, Rows, Columns>& m) {
        raw(m.data(), sizeof(T) * std::size_t(Rows * Columns));
    }
    void get(std::string& text) {
        text.resize(size(1));
        raw(text.data(), text.size());
    }
    template <class T, std::size_t N>
    void get(std::array<T, N>& values) {
        for (T& v : values)
            get(v);
    }
    template <class T>
    void get(std::vector<T>& values) {
        values.clear();
        if constexpr (coding::in_one_piece<T>) {
            values.resize(size(sizeof(T)));
            raw(values.data(), values.size() * sizeof(T));
        } else {
            const std::size_t n = size(1);
            values.reserve(std::min(n, rest_.size() / sizeof(T) + 1));
            for (std::size_t i = 0; i < n; ++i)
                get(values.emplace_back());
        }
    }
    template <class T>
    void get(std::optional<T>& value) {
        bool any = false;
        get(any);
        value.reset();
        if (any) get(value.emplace());
    }
    template <class... T>
    void get(std::variant<T...>& value) {
        std::uint64_t index = 0;
        get(index);
        if (index >= sizeof...(T)) damaged(ErrorCode::syntax);
        get_kind(value, index, std::index_sequence_for<T...>());
    }
    template <class... T, std::size_t... I>
    void get_kind(std::variant<T...>& value, std::uint64_t index, std::index_sequence<I...>) {
        const auto take = [&]<std::size_t K>(std::integral_constant<std::size_t, K>) {
            if (index != K) return;
            auto& v = value.template emplace<K>();
            if constexpr (!std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) get(v);
        };
        (take(std::integral_constant<std::size_t, I>()), ...);
    }
    template <class T>
    void get(std::shared_ptr<const T>& object) {
        std::uint64_t number = 0;
        get(number);
        object = nullptr;
        if (number == 0) return;
        auto& known = shared_[std::type_index(typeid(T))];
        if (number <= known.size()) {
            object = std::static_pointer_cast<const T>(known[std::size_t(number) - 1]);
            if (!object) damaged(ErrorCode::syntax); // it would hold itself
            return;
        }
        if (number != known.size() + 1 || ++depth_ > max_depth) damaged(ErrorCode::syntax);
        known.push_back(nullptr); // it has its number before what it holds
        auto made = std::make_shared<T>();
        get(*made);
        --depth_;
        shared_[std::type_index(typeid(T))][std::size_t(number) - 1] = made;
        object = std::move(made);
    }

    std::string_view rest_;
    Progress progress_;
    std::map<std::type_index, std::vector<std::shared_ptr<const void>>> shared_;
    std::size_t values_ = 0;
    int depth_ = 0;
};

} // namespace facetmill
