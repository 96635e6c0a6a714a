#include "core/strategy/scallop/middle_lines.h"

#include "core/strategy/scallop/field_marks.h"

#include <algorithm>
#include <array>

namespace facetmill {

namespace {

/// Places of a line are means over so many to either side.
constexpr std::size_t mean_over = 3;

class MiddleLines {
public:
    MiddleLines(const ScallopField& field, const std::vector<double>& heights, std::vector<char> marks)
        : field_(field), heights_(heights), marks_(std::move(marks)), seen_(marks_.size(), 0) {
        const auto columns = std::ptrdiff_t(field.columns());
        // Counter-clockwise from the right: those beside at even numbers, those across at odd ones.
        round_ = {1, columns + 1, columns, columns - 1, -1, -columns - 1, -columns, -columns + 1};
    }

    std::vector<FieldContour> run(double spot, const Progress& progress) {
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            const int c = int(i % std::size_t(field_.columns())), r = int(i / std::size_t(field_.columns()));
            if (c == 0 || r == 0 || c + 1 == field_.columns() || r + 1 == field_.rows()) marks_[i] = 0;
            if (marks_[i]) places_.push_back(i);
        }
        std::vector<FieldContour> lines = spots(spot, progress);
        thin(progress);
        // Branches from their ends, then between where they meet, then loops.
        for (const int pass : {0, 1, 2})
            for (const std::size_t i : places_) {
                progress.check();
                const std::size_t n = near(i).size();
                if (pass == 0 && n != 1) continue;
                if (pass == 1 && n < 3) continue;
                if (pass == 2 && (n != 2 || seen_[i])) continue;
                for (const std::size_t next : near(i))
                    if (!seen_[next] && !(seen_[i] && n == 1) && !(next < i && near(next).size() > 2))
                        follow(i, next, 0.3 * spot, lines);
            }
        return lines;
    }

private:
    std::size_t at(std::size_t i, std::size_t k) const {
        return std::size_t(std::ptrdiff_t(i) + round_[k % round_.size()]);
    }
    bool marked(std::size_t i, std::size_t k) const { return marks_[at(i, k)] != 0; }

    /// Neighbours on the line: those across only where none beside leads there.
    std::vector<std::size_t> near(std::size_t i) const {
        std::vector<std::size_t> all;
        for (std::size_t k = 0; k < round_.size(); ++k)
            if (marked(i, k) && (k % 2 == 0 || (!marked(i, k + 7) && !marked(i, k + 1))))
                all.push_back(at(i, k));
        return all;
    }

    bool may_go(std::size_t i, bool second) const {
        int count = 0, changes = 0;
        for (std::size_t k = 0; k < round_.size(); ++k) {
            count += marked(i, k);
            changes += !marked(i, k) && marked(i, k + 1);
        }
        if (count < 2 || count > 6 || changes != 1) return false;
        const bool east = marked(i, 0), north = marked(i, 2), west = marked(i, 4), south = marked(i, 6);
        return second ? !(north && east && west) && !(north && south && west)
                      : !(north && east && south) && !(east && south && west);
    }

    void thin(const Progress& progress) {
        std::vector<std::size_t> gone;
        for (bool changed = true; changed;) {
            changed = false;
            for (const bool second : {false, true}) {
                progress.check();
                gone.clear();
                for (const std::size_t i : places_)
                    if (may_go(i, second)) gone.push_back(i);
                for (const std::size_t i : gone)
                    marks_[i] = 0;
                if (gone.empty()) continue;
                changed = true;
                places_.erase(
                    std::remove_if(places_.begin(), places_.end(), [&](std::size_t i) { return !marks_[i]; }),
                    places_.end());
            }
        }
    }

    /// What is no longer or wider than `spot` gets a short line over its highest place.
    std::vector<FieldContour> spots(double spot, const Progress& progress) {
        std::vector<FieldContour> lines;
        for (const std::vector<std::size_t>& piece : connected(field_, marks_)) {
            progress.check();
            Vec2 lo = field_.place(piece.front()), hi = lo;
            std::size_t top = piece.front();
            for (const std::size_t i : piece) {
                lo = lo.cwiseMin(field_.place(i));
                hi = hi.cwiseMax(field_.place(i));
                if (heights_[i] > heights_[top]) top = i;
            }
            const Vec2 size = hi - lo;
            if (size.maxCoeff() > spot) continue;
            for (const std::size_t i : piece)
                marks_[i] = 0;
            const Vec2 half = 0.15 * spot * (size.x() >= size.y() ? Vec2(1, 0) : Vec2(0, 1));
            FieldContour line;
            line.places = {field_.place(top) - half, field_.place(top), field_.place(top) + half};
            lines.push_back(std::move(line));
        }
        places_.erase(
            std::remove_if(places_.begin(), places_.end(), [&](std::size_t i) { return !marks_[i]; }),
            places_.end());
        return lines;
    }

    void follow(std::size_t first, std::size_t next, double shortest, std::vector<FieldContour>& lines) {
        FieldContour line;
        std::size_t before = first, here = next;
        const std::size_t at_first = near(first).size();
        seen_[first] = at_first < 3;
        line.places.push_back(field_.place(first));
        for (;;) {
            line.places.push_back(field_.place(here));
            const std::vector<std::size_t> on = near(here);
            if (on.size() != 2) {
                if (on.size() < 2) seen_[here] = 1;
                break;
            }
            seen_[here] = 1;
            const std::size_t after = on[0] == before ? on[1] : on[0];
            before = here;
            here = after;
            if (here == first) {
                line.closed = at_first == 2;
                if (!line.closed) line.places.push_back(field_.place(first));
                break;
            }
            if (seen_[here] && near(here).size() == 2) break;
        }
        double length = 0;
        for (std::size_t i = 1; i < line.places.size(); ++i)
            length += (line.places[i] - line.places[i - 1]).norm();
        if (!line.closed && length < shortest) return;
        if (line.closed && line.places.size() < 4) line.closed = false;
        smooth(line);
        lines.push_back(std::move(line));
    }

    static void smooth(FieldContour& line) {
        const std::vector<Vec2> raw = line.places;
        const std::size_t n = raw.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t by =
                line.closed ? std::min(mean_over, (n - 1) / 2) : std::min({mean_over, i, n - 1 - i});
            Vec2 sum = raw[i];
            for (std::size_t k = 1; k <= by; ++k)
                sum += raw[(i + k) % n] + raw[(i + n - k) % n];
            line.places[i] = sum / double(2 * by + 1);
        }
    }

    const ScallopField& field_;
    const std::vector<double>& heights_;
    std::vector<char> marks_, seen_;
    std::vector<std::size_t> places_;
    std::array<std::ptrdiff_t, 8> round_{};
};

} // namespace

std::vector<FieldContour> middle_lines(const ScallopField& field, const std::vector<double>& heights,
                                       std::vector<char> marks, double spot, const Progress& progress) {
    return MiddleLines(field, heights, std::move(marks)).run(spot, progress);
}

} // namespace facetmill
