#include "core/job/new_fixture.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Shares of the stock's size.
constexpr double jaw_width = 0.25, jaw_height = 0.6, strap_length = 0.3, strap_reach = 0.1, strap_width = 0.2,
                 strap_height = 0.12, plate_margin = 0.2, plate_height = 0.15, bolt_diameter = 0.15,
                 block_share = 0.3;
/// The clearance of new fixtures in mm and inch: what a hand sets a clamp to, with something to spare.
constexpr double usual_clearance_mm = 2, usual_clearance_inch = 0.08;

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
        f.name = free_fixture_name(project_, name);
        f.unit = project_.unit;
        f.clearance = (project_.unit == LengthUnit::inch ? usual_clearance_inch : usual_clearance_mm) * per_;
        // Where a stock ends is rarely a round number; a micrometre is as near as anyone holds it.
        for (int k = 0; k < 3; ++k)
            f.translate[std::size_t(k)] = std::round(bottom[k] * 1e3) * 1e-3;
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

std::vector<Fixture> new_fixtures(const Project& project, NewFixture what, const Box3& stock) {
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
    case NewFixture::cylinder: {
        const double diameter = bolt_diameter * std::min(size.x(), size.y());
        return {make.cylinder("Bolt", diameter, size.z(),
                              {stock.hi.x() + 0.5 * make.round(diameter), middle.y(), stock.lo.z()})};
    }
    }
    return {};
}

} // namespace facetmill
