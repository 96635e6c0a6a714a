#include "core/strategy/global_local/assumed_path.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// A tool that has to be lifted by no more than this share of the tolerance touches. The coarser its facets,
/// the more a mesh stands above the tangent planes of the surface that it was made from, and with a flat end
/// that asks for lead where the surface does not. Half of what may stay is given to that, the other half to
/// the strip.
constexpr double lifted_share = 0.5;
/// Leads are looked for in steps of the first size, which are then halved down to the second.
constexpr double lead_step = pi / 180, lead_accuracy = lead_step / 16;
/// A part that asks for more contacts is most likely in another unit.
constexpr double max_assumed_contacts = 5e6;

/// The smallest lead at which the tool touches, from a guess on; +inf where there is none. The guess becomes
/// the lead found, or the limit.
double min_lead(const FiveAxisField& field, const ContactPlace& place, double& guess, ToolLift::Hint& hint) {
    const double most = field.settings().lead_limits[1], enough = lifted_share * field.cusp();
    const auto touches = [&](double lead) {
        return field.builder().bottom(place.frame, lead, 0, hint) <= enough;
    };
    double high = std::clamp(guess, 0.0, most), low = -1;
    if (touches(high)) {
        while (high > 0) {
            const double lower = std::max(0.0, high - lead_step);
            if (!touches(lower)) {
                low = lower;
                break;
            }
            high = lower;
        }
    } else {
        while (true) {
            low = high;
            if (high >= most) {
                guess = most;
                return infinity;
            }
            high = std::min(high + lead_step, most);
            if (touches(high)) break;
        }
    }
    if (low >= 0)
        while (high - low > lead_accuracy) {
            const double middle = 0.5 * (low + high);
            (touches(middle) ? high : low) = middle;
        }
    return guess = high;
}

int travel_of(int trajectory) {
    return trajectory % 2 == 0 ? 1 : -1;
}

AssumedContact contact_at(const FiveAxisField& field, const ContactPlace& place, double lead) {
    AssumedContact c;
    c.point = place.surface;
    c.normal = place.frame.normal;
    c.axis = posture_axis(place.frame, std::min(lead, field.settings().lead_limits[1]), 0);
    c.lead = lead;
    c.hollowness = field.hollowness(place);
    return c;
}

} // namespace

AssumedPath assume_path(const FiveAxisField& field, double spacing, const Progress& progress) {
    const SurfaceLines& lines = field.lines();
    AssumedPath path;
    path.spacing = spacing;
    path.direction = field.drive().angle;
    path.travel = Vec3(field.drive().along.x(), field.drive().along.y(), 0);
    const double width = lines.hi() - lines.lo();
    const Vec3 size = field.context().part_box.size();
    if (size.x() * size.y() > max_assumed_contacts * spacing * spacing)
        throw Error(ErrorCode::limit_exceeded, "part",
                    "a part of " + length_text(size.x(), field.context().unit) + " by "
                        + length_text(size.y(), field.context().unit) + " asks for more than "
                        + format_number(max_assumed_contacts) + " contact points of these tools",
                    "check the part's units, or take larger tools");
    const auto planes = std::size_t(std::max(1.0, std::ceil(width / spacing)));
    struct Trajectory {
        std::vector<AssumedContact> contacts;
    };
    std::vector<std::vector<Trajectory>> found(planes);
    parallel_for(planes, 1, progress, [&](std::size_t i) {
        const double v = lines.lo() + width * (double(i) + 0.5) / double(planes);
        const int travel = travel_of(int(i));
        for (const SurfaceLine& line : lines.lines(v)) {
            progress.check();
            Trajectory t;
            double guess = 0;
            ToolLift::Hint hint;
            const auto pieces = std::size_t(std::max(1.0, std::ceil(line.length() / spacing)));
            for (std::size_t k = 0; k <= pieces; ++k) {
                const double travelled = line.length() * double(k) / double(pieces);
                const ContactPlace place =
                    field.place(line, travel > 0 ? travelled : line.length() - travelled, v, travel);
                t.contacts.push_back(contact_at(field, place, min_lead(field, place, guess, hint)));
                t.contacts.back().s = travelled;
            }
            found[i].push_back(std::move(t));
        }
        if (travel < 0) std::reverse(found[i].begin(), found[i].end());
    });
    int trajectory = 0;
    for (const auto& plane : found)
        for (const Trajectory& t : plane) {
            const std::size_t start = path.contacts.size(), end = start + t.contacts.size() - 1;
            for (AssumedContact c : t.contacts) {
                c.trajectory = trajectory;
                c.start = start;
                c.end = end;
                path.contacts.push_back(c);
            }
            ++trajectory;
        }
    return path;
}

MotionDirection motion_direction(const Vec3& view, const Vec3& machining, const Vec3& motion) {
    return view.cross(machining).dot(view.cross(motion)) > 0 ? MotionDirection::forward
                                                             : MotionDirection::backward;
}

Vec3 offset_along(std::span<const Vec3> polyline, double offset) {
    double left = offset;
    for (std::size_t k = 1; k < polyline.size(); ++k) {
        const double piece = (polyline[k] - polyline[k - 1]).norm();
        if (left <= piece)
            return piece > 0 ? Vec3(polyline[k - 1] + (left / piece) * (polyline[k] - polyline[k - 1]))
                             : polyline[k];
        left -= piece;
    }
    return polyline.back();
}

ScreenedPath screen(const AssumedPath& path, double lead_limit, double offset, const Vec3& view,
                    const Vec3& machining, const Progress& progress) {
    ScreenedPath result;
    const auto& all = path.contacts;
    const auto within = [&](const AssumedContact& c) { return c.lead <= lead_limit; };
    // Between a contact within the limit and one beyond it, the lead taken as linear.
    const auto crossing = [&](const AssumedContact& in, const AssumedContact& beyond) -> Vec3 {
        if (!std::isfinite(beyond.lead)) return in.point;
        const double t = (lead_limit - in.lead) / (beyond.lead - in.lead);
        return in.point + t * (beyond.point - in.point);
    };
    std::vector<Vec3> polyline;
    for (std::size_t start = 0; start < all.size(); start = all[start].end + 1) {
        progress.check();
        const std::size_t end = all[start].end;
        const MotionDirection whole = motion_direction(view, machining, all[end].point - all[start].point);
        for (std::size_t i = start; i <= end; ++i) {
            if (within(all[i])) continue;
            std::size_t last = i;
            while (last < end && !within(all[last + 1]))
                ++last;
            BoundaryPair pair;
            pair.trajectory = all[i].trajectory;
            pair.in_at_side = i == start;
            pair.out_at_side = last == end;
            pair.in = pair.in_at_side ? all[i].point : crossing(all[i - 1], all[i]);
            pair.out = pair.out_at_side ? all[last].point : crossing(all[last + 1], all[last]);
            polyline.assign(1, pair.in);
            for (std::size_t k = i; k > start; --k)
                polyline.push_back(all[k - 1].point);
            pair.in_offset = offset_along(polyline, offset);
            polyline.assign(1, pair.out);
            for (std::size_t k = last; k < end; ++k)
                polyline.push_back(all[k + 1].point);
            pair.out_offset = offset_along(polyline, offset);
            pair.motion = motion_direction(view, machining, pair.out - pair.in);
            // A single contact at the side has no direction of its own.
            pair.regular = pair.motion == whole || pair.out == pair.in;
            result.pairs.push_back(pair);
            result.uncut.push_back({pair.in, all[i].normal, all[i].lead});
            for (std::size_t k = i; k <= last; ++k)
                result.uncut.push_back({all[k].point, all[k].normal, all[k].lead});
            result.uncut.push_back({pair.out, all[last].normal, all[last].lead});
            i = last;
        }
    }
    return result;
}

void assign_pairs(const ReworkRegions& regions, std::vector<BoundaryPair>& pairs, const Progress& progress) {
    std::vector<const std::array<Vec3, 3>*> facets;
    std::vector<std::size_t> region_of;
    std::vector<Box3> boxes;
    for (std::size_t r = 0; r < regions.regions.size(); ++r)
        for (const auto& facet : regions.regions[r].strip.band) {
            facets.push_back(&facet);
            region_of.push_back(r);
            boxes.emplace_back();
            for (const Vec3& c : facet)
                boxes.back().add(c);
        }
    if (facets.empty()) return;
    const BoxTree tree(boxes, progress);
    std::map<std::pair<std::size_t, int>, std::pair<std::size_t, std::size_t>> outermost;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (i % 256 == 0) progress.check();
        BoundaryPair& pair = pairs[i];
        double least = infinity;
        tree.nearest(pair.in, least, [&](std::size_t k) {
            const auto& [a, b, c] = *facets[k];
            if (const double square = squared_distance(pair.in, a, b, c); square < least) {
                least = square;
                pair.region = region_of[k];
            }
        });
        if (!pair.regular) continue;
        const auto [at, is_new] = outermost.try_emplace({pair.region, pair.trajectory}, i, i);
        if (!is_new) at->second.second = i;
    }
    for (const auto& [key, ends] : outermost)
        pairs[ends.first].effective = pairs[ends.second].effective = true;
}

} // namespace facetmill
