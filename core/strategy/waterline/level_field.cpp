#include "core/strategy/waterline/level_field.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Normals of cutter and facet that differ by less are those of one surface.
const double surface_angle = radians(12), same_surface = std::cos(surface_angle);
/// Places that are asked at a time.
constexpr std::size_t band_places = 1 << 18;

} // namespace

/// Whether a cutter that stands on a plane, or on one that leans hardly another way, touches it with its
/// corner at `rel`: only then it cuts the plane with that.
bool TouchTeller::corner_lies_on(const Vec3& normal, const Vec3& rel) const {
    const Vec3 outward = Vec3(rel.x(), rel.y(), 0).normalized(), axis = outward.cross(Vec3::UnitZ());
    if (std::abs(normal.dot(axis)) > std::sin(surface_angle)) return false;
    const Vec3 here = (normal - normal.dot(axis) * axis).normalized();
    return std::ranges::any_of(std::array{0.0, surface_angle, -surface_angle}, [&](double angle) {
        const Vec3 n = Eigen::AngleAxisd(angle, axis) * here;
        return n.z() > 0 && n.dot(rel + cover_.tip_offset(n)) <= tolerance::contact_distance;
    });
}

TipTouch TouchTeller::operator()(const Vec2& p, const AxialContact& contact) const {
    TipTouch touch;
    touch.tip_z = contact.tip_z;
    if (contact.facet == no_index || std::size_t(contact.facet) >= facets_) return touch;
    touch.any = true;
    touch.point = contact.point;
    Vec3 facet = index_->mesh().facet_normal(contact.facet);
    if (facet.z() < 0) facet = -facet;
    const auto open = cover_.contact_normal(contact.point - Vec3(p.x(), p.y(), contact.tip_z));
    touch.normal = open ? *open : facet;
    if (touch.normal.z() < 0) touch.normal = -touch.normal;
    touch.surface = open ? touch.normal.dot(facet) >= same_surface
                         : corner_lies_on(facet, contact.point - Vec3(p.x(), p.y(), contact.tip_z));
    return touch;
}

LevelField::LevelField(const AxialLift& lift, const TouchTeller& tell, const Box3& box, double beyond,
                       double spacing, const UseRows& use, const Progress& progress)
    : lo_(box.lo.head<2>() - Vec2::Constant(beyond)), spacing_(spacing) {
    const Vec2 size = box.hi.head<2>() + Vec2::Constant(beyond) - lo_;
    columns_ = int(std::ceil(size.x() / spacing)) + 1;
    rows_ = int(std::ceil(size.y() / spacing)) + 1;
    heights_.resize(std::size_t(columns_) * std::size_t(rows_));
    const int band = std::max(2, int(band_places / std::size_t(columns_)));
    std::vector<TipTouch> touches;
    const auto columns = std::size_t(columns_);
    for (int first = 0; first < rows_;) {
        // The last row of the band before is known.
        const int known = touches.empty() ? 0 : 1, end = std::min(rows_, first + known + band);
        const int begin = first + known;
        std::vector<Vec2> places;
        places.reserve(std::size_t(end - begin) * columns);
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < columns_; ++column)
                places.push_back(place(column, row));
        std::vector<AxialContact> contacts(places.size());
        const Progress here = progress.part(double(begin) / rows_, double(end) / rows_);
        lift.contact(places, contacts, here.part(0, 0.8));
        if (known) {
            std::copy(touches.end() - columns_, touches.end(), touches.begin());
            touches.resize(columns);
        }
        touches.resize(std::size_t(end - first) * columns);
        parallel_blocks(places.size(), 4096, here.part(0.8, 1), [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                touches[std::size_t(known) * columns + i] = tell(places[i], contacts[i]);
                heights_[std::size_t(begin) * columns + i] = contacts[i].tip_z;
            }
        });
        use(first, touches);
        if (end == rows_) break;
        first = end - 1;
    }
    find_ranges(progress.part(1, 1));
}

void LevelField::find_ranges(const Progress& progress) {
    blocks_ = (columns_ - 1 + block - 1) / block;
    ranges_.assign(std::size_t(std::max(rows_ - 1, 0)) * std::size_t(blocks_), {infinity, -infinity});
    for (int row = 0; row + 1 < rows_; ++row) {
        progress.check();
        for (int b = 0; b < blocks_; ++b) {
            auto& [low, high] = ranges_[std::size_t(row) * std::size_t(blocks_) + std::size_t(b)];
            for (int column = b * block; column <= std::min((b + 1) * block, columns_ - 1); ++column)
                for (const double z : {height(column, row), height(column, row + 1)}) {
                    low = std::min(low, z);
                    high = std::max(high, z);
                }
        }
    }
}

} // namespace facetmill
