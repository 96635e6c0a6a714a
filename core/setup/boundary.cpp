#include "core/setup/boundary.h"

#include "core/base/text.h"
#include "core/setup/tool.h"

#include <algorithm>
#include <charconv>

namespace facetmill {

const ParameterTable<CurveCorner>& curve_corner_parameters() {
    static const auto table = [] {
        ParameterTable<CurveCorner> t;
        t.add(&CurveCorner::at, {.key = "at",
                                 .label = "Place",
                                 .help = "A corner of the curve.",
                                 .kind = ParameterKind::triple,
                                 .quantity = Quantity::length,
                                 .minimum = -1e6,
                                 .maximum = 1e6,
                                 .stage = Stage::contact});
        return t;
    }();
    return table;
}

const ParameterTable<Boundary>& boundary_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<Boundary> t;
        t.add(&Boundary::name, {.key = "name",
                                .label = "Name",
                                .help = "Operations name the boundary by it.",
                                .kind = K::text,
                                .stage = Stage::contact});
        t.add_choice(&Boundary::kind,
                     {.key = "kind",
                      .label = "Kind",
                      .help = "What makes the region: painted facets, a range of slope, a "
                              "closed curve drawn on the part, the part's outline, what a tool leaves, "
                              "or faces of a STEP or IGES file.",
                      .words = {"facets", "slope", "curve", "silhouette", "rest", "faces"},
                      .stage = Stage::contact});
        t.add(&Boundary::facets, {.key = "facets",
                                  .label = "Facets",
                                  .help = "Numbers of the painted facets, counted from 0 in the part's file: "
                                          "0-57, 60.",
                                  .kind = K::text,
                                  .stage = Stage::contact});
        t.add(&Boundary::of_facets, {.key = "of_facets",
                                     .label = "Of so many",
                                     .help = "How many facets the part had when they were painted. Where it "
                                             "has another number now, they are no longer known.",
                                     .kind = K::integer,
                                     .quantity = Quantity::count,
                                     .minimum = 0,
                                     .maximum = 4e9,
                                     .stage = Stage::contact});
        t.add(&Boundary::faces,
              {.key = "faces",
               .label = "Faces",
               .help = "Numbers of faces of the part's file, counted from 0: 0-3, 7. They are "
                       "the same however finely the file is tessellated.",
               .kind = K::text,
               .stage = Stage::contact});
        t.add(&Boundary::slope, {.key = "slope",
                                 .label = "Slope",
                                 .help = "From and to: 0 is level, 90 an upright wall, more an underside.",
                                 .kind = K::pair,
                                 .quantity = Quantity::angle,
                                 .minimum = 0,
                                 .maximum = pi,
                                 .ordered = true,
                                 .stage = Stage::contact});
        t.add_records(&Boundary::curve, curve_list,
                      {.label = "Curve",
                       .help = "Corners of a closed curve, which is looked at along Z.",
                       .stage = Stage::contact,
                       .nouns = {"corner", "corners"}});
        t.add(&Boundary::tool,
              {.key = "tool",
               .label = "Left by",
               .help = "Number of the tool. The region is what it leaves of the part where it "
                       "has been everywhere: hollows narrower than it, inner edges.",
               .kind = K::integer,
               .quantity = Quantity::count,
               .minimum = 0,
               .maximum = largest_tool_number,
               .stage = Stage::contact});
        t.add(&Boundary::more_than, {.key = "more_than",
                                     .label = "More than",
                                     .help = "What the tool leaves counts where it is thicker than that.",
                                     .kind = K::number,
                                     .quantity = Quantity::length,
                                     .minimum = 0,
                                     .maximum = 1e3,
                                     .open_minimum = true,
                                     .stage = Stage::contact});
        t.add(&Boundary::offset, {.key = "offset",
                                  .label = "Offset",
                                  .help = "Moves the border outward by so much, inward below 0.",
                                  .kind = K::number,
                                  .quantity = Quantity::length,
                                  .minimum = -1e4,
                                  .maximum = 1e4,
                                  .stage = Stage::contact});
        t.add(&Boundary::invert, {.key = "invert",
                                  .label = "Invert",
                                  .help = "All but that: what was inside is outside.",
                                  .kind = K::boolean,
                                  .stage = Stage::contact});
        return t;
    }();
    return table;
}

const std::string& boundary_kind_name(Boundary::Kind kind) {
    return boundary_parameters().find("kind")->info.words[std::size_t(kind)];
}

const std::vector<std::string>& boundary_keys(Boundary::Kind kind) {
    static const std::array<std::vector<std::string>, 6> keys = {{
        {"name", "kind", "facets", "of_facets", "invert"},
        {"name", "kind", "slope", "invert"},
        {"name", "kind", "curve", "offset", "invert"},
        {"name", "kind", "offset", "invert"},
        {"name", "kind", "tool", "more_than", "offset", "invert"},
        {"name", "kind", "faces", "invert"},
    }};
    return keys[std::size_t(kind)];
}

std::string facet_ranges_text(const std::vector<Index>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        if (!text.empty()) text += ", ";
        text += std::to_string(numbers[i]);
        if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
        i = end;
    }
    return text;
}

namespace {

/// What is counted: "facet", and what to do where there is no such.
struct Counted {
    std::string one, several, remedy;
};

std::vector<Index> number_ranges(const std::string& text, std::size_t count, const Counted& counted) {
    std::vector<Index> numbers;
    const char *at = text.data(), *const end = at + text.size();
    const auto skip = [&] {
        while (at < end && *at == ' ')
            ++at;
    };
    const auto wrong = [&](std::size_t from) -> Error {
        return Error(ErrorCode::syntax, counted.several,
                     "'" + printable(text.substr(from, 20)) + "' is no number or range of " + counted.several,
                     "write numbers and ranges in ascending order, as 0-57, 60");
    };
    const auto number = [&] {
        const auto from = std::size_t(at - text.data());
        std::uint64_t n = 0;
        const auto [next, error] = std::from_chars(at, end, n);
        if (error != std::errc()) throw wrong(from);
        if (n >= count)
            throw Error(ErrorCode::out_of_range, counted.several,
                        "there is no " + counted.one + " " + std::to_string(n) + ": the part has "
                            + std::to_string(count),
                        counted.remedy);
        at = next;
        return Index(n);
    };
    for (skip(); at < end; skip()) {
        const auto from = std::size_t(at - text.data());
        const Index first = number();
        Index last = first;
        if (at < end && *at == '-') {
            ++at;
            last = number();
        }
        if (last < first || (!numbers.empty() && first <= numbers.back())) throw wrong(from);
        for (Index n = first; n <= last; ++n)
            numbers.push_back(n);
        skip();
        if (at == end) break;
        if (*at != ',') throw wrong(from);
        ++at;
    }
    return numbers;
}

} // namespace

std::vector<Index> facet_ranges(const std::string& text, std::size_t count) {
    return number_ranges(text, count, {"facet", "facets", "paint the boundary anew"});
}

std::vector<Index> face_ranges(const std::string& text, std::size_t count) {
    return number_ranges(text, count, {"face", "faces", "name faces of the part's file"});
}

} // namespace facetmill
