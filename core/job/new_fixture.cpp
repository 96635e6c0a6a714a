#include "core/job/new_fixture.h"

#include "core/base/usual_value.h"
#include "core/strategy/surface/plan_region.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Shares of the stock's size.
constexpr double jaw_width = 0.25, jaw_height = 0.6, strap_length = 0.3, strap_reach = 0.1, strap_width = 0.2,
                 strap_height = 0.12, plate_margin = 0.2, plate_height = 0.15, bolt_diameter = 0.15,
                 block_share = 0.3;

class FixtureMaker {
public:
    explicit FixtureMaker(const Project& project) : project_(project), per_(mm_per(project.unit)) {}

    Fixture box(const char* name, const Vec3& size, const Vec3& bottom) const {
        Fixture f = begun(name, bottom);
        for (int k = 0; k < 3; ++k)
            f.size[std::size_t(k)] = round(size[k]);
        return f;
    }
    Fixture cylinder(const char* name, double diameter, double height, const Vec3& bottom) const {
        Fixture f = begun(name, bottom);
        f.kind = Fixture::Kind::cylinder;
        f.diameter = round(diameter);
        f.height = round(height);
        return f;
    }
    /// A round number of the project's unit, never nothing.
    double round(double mm) const {
        const double least = project_.unit == LengthUnit::inch ? 0.05 : 1;
        return std::max(round_down(mm / per_), least) * per_;
    }

private:
    Fixture begun(const char* name, const Vec3& bottom) const {
        Fixture f;
        ParameterView<Fixture> view(f, fixture_parameters());
        take_usual_values(view, project_.unit);
        f.name = free_fixture_name(project_, name);
        f.unit = project_.unit;
        // Where a stock ends is rarely a round number; this is as near as anyone holds it.
        const double step = project_.unit == LengthUnit::inch ? 1e-4 * per_ : 1e-3;
        for (int k = 0; k < 3; ++k)
            f.translate[std::size_t(k)] = std::round(bottom[k] / step) * step;
        return f;
    }
    const Project& project_;
    double per_;
};

} // namespace

std::string free_fixture_name(const Project& project, const std::string& wish) {
    return free_name(wish, [&](const std::string& name) {
        return std::any_of(project.fixtures.begin(), project.fixtures.end(),
                           [&](const Fixture& f) { return f.name == name; });
    });
}

namespace {

/// A place on the border of a region, and away from it.
struct BorderPlace {
    Vec2 at, out;
};

/// The part's outline near its bottom; where nothing of it faces down or up there, that of all of it.
PlanRegion bottom_outline(const Mesh& part, double below, const Progress& progress) {
    std::vector<char> low(part.facet_count(), 0);
    for (std::size_t f = 0; f < low.size(); ++f)
        low[f] = std::min({part.corner(f, 0).z(), part.corner(f, 1).z(), part.corner(f, 2).z()}) < below;
    PlanRegion region(outline_edges(part, low, progress.part(0, 0.3)), progress.part(0.3, 0.6));
    if (!region.empty()) return region;
    std::fill(low.begin(), low.end(), char(1));
    return PlanRegion(outline_edges(part, low, progress.part(0.6, 0.8)), progress.part(0.8, 1));
}

/// Places along a border, so far apart, that a tab of this width and length may stand on: beside them the
/// border goes on straight, and before them there is nothing.
std::vector<BorderPlace> places_for_tabs(const PlanRegion& region, double width, double length,
                                         double apart) {
    const double straight = 0.1 * width;
    std::vector<BorderPlace> places;
    for (const PlanEdge& edge : region.border()) {
        const Vec2 along = edge[1] - edge[0];
        const double size = along.norm();
        if (!(size > 0)) continue;
        const Vec2 t = along / size, out(t.y(), -t.x());
        const int n = std::max(1, int(size / apart));
        for (int k = 0; k < n; ++k) {
            const Vec2 at = edge[0] + along * ((k + 0.5) / n);
            bool good = true;
            for (const double side : {-0.5, 0.5})
                good = good && std::abs(region.depth(at + side * width * t)) < straight;
            constexpr int looks = 8;
            for (int look = 1; look <= looks && good; ++look)
                good = !region.covers(at + out * (length * look / looks));
            if (good && region.covers(at - 1e-3 * width * out)) places.push_back({at, out});
        }
    }
    return places;
}

/// So many of them that are far from one another: each the farthest from those before it, and the first from
/// the middle of all; then each to the middle of the places that are nearest to it, and not at their end.
std::vector<BorderPlace> far_apart(const std::vector<BorderPlace>& places, std::size_t count) {
    std::vector<BorderPlace> chosen;
    if (places.empty()) return chosen;
    Vec2 middle = Vec2::Zero();
    for (const BorderPlace& p : places)
        middle += p.at / double(places.size());
    std::vector<double> distance;
    distance.reserve(places.size());
    for (const BorderPlace& p : places)
        distance.push_back((p.at - middle).norm());
    while (chosen.size() < count) {
        const auto farthest = std::max_element(distance.begin(), distance.end());
        if (!(*farthest > 0)) break;
        const BorderPlace next = places[std::size_t(farthest - distance.begin())];
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double d = (places[i].at - next.at).norm();
            distance[i] = chosen.empty() ? d : std::min(distance[i], d);
        }
        chosen.push_back(next);
    }
    constexpr int moves = 8; // they rest after some
    for (int move = 0; move < moves; ++move) {
        std::vector<Vec2> sum(chosen.size(), Vec2::Zero());
        std::vector<double> share(chosen.size(), 0);
        std::vector<std::size_t> owner;
        for (const BorderPlace& p : places) {
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < chosen.size(); ++k)
                if ((p.at - chosen[k].at).norm() < (p.at - chosen[nearest].at).norm()) nearest = k;
            owner.push_back(nearest);
            sum[nearest] += p.at;
            share[nearest] += 1;
        }
        std::vector<double> off(chosen.size(), infinity);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t k = owner[i];
            const double d = (places[i].at - sum[k] / share[k]).norm();
            if (d < off[k]) {
                off[k] = d;
                chosen[k] = places[i];
            }
        }
    }
    return chosen;
}

/// The widest cutter of the setup's operations, mm.
double widest_cutter(const Project& project) {
    double widest = 0;
    for (const auto& operation : project.operations)
        for (const Tool& tool : project.tools)
            if (tool.number == operation->common().tool) widest = std::max(widest, tool.diameter);
    return widest;
}

} // namespace

std::vector<Fixture> new_tabs(const Project& project, const Mesh& part, const Box3& stock, std::size_t count,
                              const Progress& progress) {
    constexpr double height_share = 0.2, max_width = 0.15; // of the height of the stock, of the part's size
    constexpr double usual_height = 2, usual_width = 6;    // mm, where there is room
    const FixtureMaker make(project);
    const Box3 box = part.box();
    const double bottom = std::max(box.lo.z(), stock.lo.z());
    const double height = make.round(std::min(usual_height, height_share * stock.size().z()));
    const double width = make.round(
        std::min(std::max(usual_width, 2 * height), max_width * std::max(box.size().x(), box.size().y())));
    const double length = make.round(1.5 * std::max(widest_cutter(project), usual_height) + 2 * height);
    const PlanRegion region = bottom_outline(part, box.lo.z() + height, progress);
    const double inside = std::min(height, 0.25 * length); // of the part, for what is tilted there
    std::vector<Fixture> tabs;
    Project named = project; // takes the new names one by one
    for (const BorderPlace& place : far_apart(places_for_tabs(region, width, length, 0.5 * width), count)) {
        const Vec2 middle = place.at + place.out * (0.5 * length - inside);
        Fixture tab = make.box("Tab", {length, width, height}, {middle.x(), middle.y(), bottom});
        tab.name = free_fixture_name(named, tab.name);
        tab.kind = Fixture::Kind::tab;
        constexpr double turn_step = 1e-2; // degrees
        tab.rotate[2] =
            radians(std::round(degrees(std::atan2(place.out.y(), place.out.x())) / turn_step) * turn_step);
        named.fixtures.push_back(tab);
        tabs.push_back(std::move(tab));
    }
    return tabs;
}

std::vector<Fixture> new_fixtures(const Project& project, NewFixture what, const Mesh& part,
                                  const Box3& stock) {
    const FixtureMaker make(project);
    const Vec3 size = stock.size(), middle = stock.center();
    switch (what) {
    case NewFixture::vice: {
        const Vec3 jaw(1.2 * size.x(), jaw_width * size.y(), jaw_height * size.z());
        const double half = 0.5 * make.round(jaw.y());
        return {make.box("Front jaw", jaw, {middle.x(), stock.lo.y() - half, stock.lo.z()}),
                make.box("Rear jaw", jaw, {middle.x(), stock.hi.y() + half, stock.lo.z()})};
    }
    case NewFixture::clamp: {
        const Vec3 strap(strap_length * size.x(), strap_width * size.y(),
                         std::max(strap_height * size.x(), 0.2 * size.z()));
        const double beside = 0.5 * make.round(strap.x()) - strap_reach * size.x();
        return {make.box("Clamp", strap, {stock.lo.x() - beside, middle.y(), stock.hi.z()})};
    }
    case NewFixture::plate: {
        const double margin = plate_margin * std::max(size.x(), size.y());
        const Vec3 plate(size.x() + 2 * margin, size.y() + 2 * margin,
                         plate_height * std::min(size.x(), size.y()));
        return {make.box("Plate", plate, {middle.x(), middle.y(), stock.lo.z() - make.round(plate.z())})};
    }
    case NewFixture::box: {
        const Vec3 block = block_share * size;
        return {
            make.box("Block", block, {stock.hi.x() + 0.5 * make.round(block.x()), middle.y(), stock.lo.z()})};
    }
    case NewFixture::tabs:
        return new_tabs(project, part, stock, usual_tabs, Progress());
    case NewFixture::cylinder: {
        const double diameter = bolt_diameter * std::min(size.x(), size.y());
        return {make.cylinder("Bolt", diameter, size.z(),
                              {stock.hi.x() + 0.5 * make.round(diameter), middle.y(), stock.lo.z()})};
    }
    }
    return {};
}

} // namespace facetmill
