#include "core/strategy/preview/preview_valleys.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Contacts that are nearer than so many cells have not jumped: the cutter rolls.
constexpr double rolled_cells = 3;
/// How often the steps of cells are smoothed.
constexpr int smoothings = 4;

/// Between two neighbouring tips, a border of their cells on which the contact jumps.
class Jumps {
public:
    Jumps(const PreviewField& field, double left) : field_(field), left_(left) {}

    void find(const Progress& progress) {
        const CoarseGrid& grid = field_.grid();
        for (int y = 0; y + 1 < grid.rows; ++y) {
            progress.check();
            for (int x = 0; x + 1 < grid.columns; ++x) {
                const std::size_t i = grid.index(x, y);
                // The border to the right runs up from the corner below it, that above to the right.
                look(i, grid.index(x + 1, y), corner(x, y - 1), corner(x, y));
                look(i, grid.index(x, y + 1), corner(x - 1, y), corner(x, y));
            }
        }
    }

    std::vector<PreviewValley> chains(double shortest) {
        std::vector<PreviewValley> all;
        std::vector<int> ends, others;
        for (const auto& [at, to] : next_)
            (to.size() == 2 ? others : ends).push_back(at);
        for (const auto* some : {&ends, &others})
            for (const int from : *some)
                while (!next_[from].empty())
                    take(from, shortest, all);
        return all;
    }

private:
    /// The corner above and to the right of a cell.
    int corner(int x, int y) const { return (y + 1) * (field_.grid().columns + 1) + x + 1; }
    Vec2 place(int corner) const {
        const int across = field_.grid().columns + 1;
        return field_.grid().origin + field_.grid().cell * Vec2(corner % across - 0.5, corner / across - 0.5);
    }

    void look(std::size_t a, std::size_t b, int from, int to) {
        const CoarseTips& tips = field_.tips();
        const int p = tips.holder(a), q = tips.holder(b);
        if (p < 0 || q < 0 || p == q || (!field_.kept(a) && !field_.kept(b))) return;
        const CoarseGround& ground = tips.ground();
        const Vec2 at = ground.grid().middle(std::size_t(p)), other = ground.grid().middle(std::size_t(q));
        const double apart = (other - at).norm();
        if (apart < rolled_cells * ground.grid().cell || apart > 2.1 * tips.radius()) return;
        // What stays in the middle between the two, below both tips.
        const Vec2 middle = 0.5 * (at + other);
        const int x = ground.grid().column(middle.x()), y = ground.grid().row(middle.y());
        if (!ground.grid().has(x, y)) return;
        const float floor = ground.height()[ground.grid().index(x, y)];
        if (!is_there(floor)) return;
        const double under = std::min(tips.under(a, middle), tips.under(b, middle));
        // Along the normal it is less than upright, by the slope from one to the other.
        const double rise = double(ground.height()[std::size_t(q)] - ground.height()[std::size_t(p)]) / apart;
        if ((under - double(floor)) / std::sqrt(1 + rise * rise) < left_) return;
        next_[from].push_back(to);
        next_[to].push_back(from);
        touches_[{std::min(from, to), std::max(from, to)}] = {0.5 * (place(from) + place(to)),
                                                              (other - at) / apart, 0.5 * apart};
    }

    void take(int from, double shortest, std::vector<PreviewValley>& all) {
        PreviewValley valley;
        int at = from;
        while (!next_[at].empty()) {
            const int to = next_[at].back();
            next_[at].pop_back();
            std::erase(next_[to], at);
            valley.touches.push_back(touches_.at({std::min(at, to), std::max(at, to)}));
            at = to;
            // At a fork the next one begins.
            if (next_[at].size() > 1) break;
        }
        double length = 0;
        for (std::size_t i = 1; i < valley.touches.size(); ++i)
            length += (valley.touches[i].tip - valley.touches[i - 1].tip).norm();
        if (valley.touches.size() < 2 || length < shortest) return;
        smooth(valley.touches);
        all.push_back(std::move(valley));
    }

    static void smooth(std::vector<PreviewTouch>& touches) {
        // Both ways to look across are the same one: with the valley to the left.
        for (std::size_t i = 0; i < touches.size(); ++i) {
            const Vec2 along =
                touches[std::min(i + 1, touches.size() - 1)].tip - touches[i > 0 ? i - 1 : 0].tip;
            if (along.x() * touches[i].across.y() - along.y() * touches[i].across.x() < 0)
                touches[i].across = -touches[i].across;
        }
        for (int r = 0; r < smoothings; ++r) {
            const std::vector<PreviewTouch> old = touches;
            for (std::size_t i = 1; i + 1 < touches.size(); ++i) {
                touches[i].tip = 0.25 * old[i - 1].tip + 0.5 * old[i].tip + 0.25 * old[i + 1].tip;
                const Vec2 across = 0.25 * old[i - 1].across + 0.5 * old[i].across + 0.25 * old[i + 1].across;
                if (across.norm() > 1e-6) touches[i].across = across.normalized();
                touches[i].half = 0.25 * old[i - 1].half + 0.5 * old[i].half + 0.25 * old[i + 1].half;
            }
        }
    }

    const PreviewField& field_;
    double left_;
    std::map<int, std::vector<int>> next_;
    std::map<std::pair<int, int>, PreviewTouch> touches_;
};

} // namespace

std::vector<PreviewValley> preview_valleys(const PreviewField& field, double left, double shortest,
                                           const Progress& progress) {
    Jumps jumps(field, left);
    jumps.find(progress);
    return jumps.chains(shortest);
}

std::vector<PlanLine> valley_lines(const PreviewValley& valley, double left, bool within) {
    std::vector<PlanLine> lines;
    bool was = false;
    for (const PreviewTouch& t : valley.touches) {
        const bool is = !within || std::abs(left) <= t.half;
        if (is && !was) lines.emplace_back();
        if (is) lines.back().push_back(t.tip + left * t.across);
        was = is;
    }
    std::erase_if(lines, [](const PlanLine& line) { return line.size() < 2; });
    return lines;
}

} // namespace facetmill
