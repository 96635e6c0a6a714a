#include "core/strategy/five_axis/contact_widths.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// An estimated posture at yaw 0 may be lifted by this share of the tolerance: a mesh lifts by as much as its
/// facets are coarse, and what a posture is lifted by its strip loses.
constexpr double lifted_share = 0.1;
/// One with a yaw by this share: a flat end that stands on both flanks of a hollow clears a wide strip.
constexpr double yawed_share = 0.5;
/// A strip that is as wide to either side as this share of the gap needs no other posture: half would be
/// enough if the neighbour's were as wide.
constexpr double wanted_share = 0.75;
/// Step of the yaw while an estimated posture is sought: a few tries to either side.
const double yaw_step = radians(15);
/// Largest step of the lead while the least inclined posture is sought.
const double max_lead_step = radians(3);
/// Contacts that a thread takes at a time.
constexpr std::size_t contacts_per_block = 16;

/// Nodes of the grid, from yaw 0 outward.
std::vector<double> outward_from_zero(const std::vector<double>& nodes) {
    std::vector<double> yaws;
    const std::size_t step =
        nodes.size() > 1 ? std::size_t(std::ceil(yaw_step / (nodes[1] - nodes[0]) - 0.5)) : 1;
    const auto middle =
        std::size_t(std::min_element(nodes.begin(), nodes.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); })
                    - nodes.begin());
    for (std::size_t away = 0; away < nodes.size(); away += std::max<std::size_t>(step, 1)) {
        if (middle + away < nodes.size()) yaws.push_back(nodes[middle + away]);
        if (away > 0 && away <= middle) yaws.push_back(nodes[middle - away]);
    }
    return yaws;
}

} // namespace

ContactWidths::ContactWidths(const FiveAxisField& field, double leave)
    : field_(field), leave_(leave),
      is_ball_(field.cutter().cutter().r > 0 && field.cutter().cutter().e <= tolerance::contact_distance) {
    if (field.settings().posture != Finish5Settings::PostureChoice::cm2)
        yaws_ = outward_from_zero(field.grid().yaw);
}

void ContactWidths::find(std::vector<EstimatedContact>& contacts, double gap,
                         const Progress& progress) const {
    parallel_blocks(contacts.size(), contacts_per_block, progress, [&](std::size_t begin, std::size_t end) {
        if (!contacts[begin].known)
            find_block(std::span(contacts).subspan(begin, end - begin), gap, progress);
    });
}

std::size_t ContactWidths::blocks(std::size_t contacts) {
    return (contacts + contacts_per_block - 1) / contacts_per_block;
}

std::span<EstimatedContact> ContactWidths::block(std::vector<EstimatedContact>& contacts,
                                                 std::size_t number) {
    const std::size_t begin = number * contacts_per_block;
    return std::span(contacts).subspan(begin, std::min(contacts_per_block, contacts.size() - begin));
}

void ContactWidths::find_block(std::span<EstimatedContact> block, double gap,
                               const Progress& progress) const {
    // Blocks have their own hints, so that threads make no difference.
    double lead = field_.settings().lead_limits[0];
    ToolLift::Hint hint;
    for (EstimatedContact& c : block) {
        progress.check();
        find(c, gap, lead, hint);
        c.known = true;
        if (!c.usable) continue;
        const double slope = std::abs(field_.across(c.place));
        c.left = c.width_lo + c.width_hi < leave_ * slope;
    }
}

void ContactWidths::find(EstimatedContact& contact, double gap, double& lead, ToolLift::Hint& hint) const {
    find_posture(contact, lead, hint);
    if (contact.usable) find_widths(contact, gap, hint);
}

void ContactWidths::find_posture(EstimatedContact& contact, double& lead, ToolLift::Hint& hint) const {
    const auto& limits = field_.settings().lead_limits;
    const double step = std::min(field_.settings().grid_step, max_lead_step);
    // Exact up to `most`, above it where it is more.
    const auto lift = [&](double at, double most) {
        return field_.builder().bottom(contact.place.frame, at, 0, hint, most);
    };
    const double enough = lifted_share * field_.cusp();
    // From the neighbour's inclination: down as far as it serves, else up until it does.
    double at = std::clamp(lead, limits[0], limits[1]), delta = lift(at, infinity);
    double best = at, best_delta = delta;
    if (delta <= enough) {
        while (at > limits[0]) {
            const double lower = std::max(at - step, limits[0]), d = lift(lower, enough);
            if (!(d <= enough)) break;
            best = at = lower;
            best_delta = d;
        }
    } else {
        while (at < limits[1] && !(best_delta <= enough)) {
            at = std::min(at + step, limits[1]);
            delta = lift(at, best_delta);
            if (delta < best_delta) {
                best = at;
                best_delta = delta;
            }
        }
        if (!(best_delta <= enough))
            for (at = std::clamp(lead, limits[0], limits[1]); at > limits[0];) {
                at = std::max(at - step, limits[0]);
                delta = lift(at, best_delta);
                if (delta < best_delta) {
                    best = at;
                    best_delta = delta;
                }
            }
    }
    lead = best;
    contact.posture = {best, 0, best_delta};
    contact.usable = best_delta <= field_.cusp();
}

void ContactWidths::find_widths(EstimatedContact& contact, double gap, ToolLift::Hint& hint) const {
    const double wanted = wanted_share * gap;
    const ContactPlace& place = contact.place;
    const CSpaceBuilder& builder = field_.builder();
    StripWidth width(field_, place);
    const auto value = [&](const StripWidth::Width& lo, const StripWidth::Width& hi) {
        return std::min(lo.width, wanted) * std::min(hi.width, wanted);
    };
    const StripWidth::Standing upright = width.standing(contact.posture);
    StripWidth::Width lo = width(upright, -1), hi = width(upright, +1);
    // On a wall it may be one that the machine does not hold. Where none is found that it holds, what that
    // one would clear stands for it.
    const auto is_held = [&](const PostureValue& posture) { return builder.holds(place.frame, posture); };
    // A ball clears what it clears whichever way it leans.
    const auto counts = [&](const PostureValue& posture) { return is_ball_ || is_held(posture); };
    double most = yaws_.empty() || counts(contact.posture) ? value(lo, hi) : 0;
    const double enough = wanted * wanted;
    const double hollow = std::max(field_.hollowness(place, place.frame.feed), 0.0), r = field_.radius();
    // A strip that makes the value larger is wider than this to both sides. First the one that was not.
    int harder = -1;
    const auto may_be_wider = [&](const StripWidth::Standing& at) {
        if (!width.may_exceed(at, harder, most / wanted)) return false;
        if (width.may_exceed(at, -harder, most / wanted)) return true;
        harder = -harder;
        return false;
    };
    const std::vector<double>& leads = field_.grid().lead;
    // Nodes of the grid: what is free there the choice of postures finds.
    for (const double yaw : yaws_) {
        if (most >= enough) break;
        // Leaning to a side a flat end lies over the strip's border there with its whole width, and in a
        // hollow along the travel holds it with heel or toe only: what lies between them stays.
        const double aside = std::abs(std::sin(yaw));
        const double arched = 0.5 * hollow * r * r * aside * (2 - aside);
        const double liftable = yawed_share * field_.cusp();
        const auto bottom = [&](std::size_t l) {
            return builder.bottom(place.frame, leads[l], yaw, hint, liftable);
        };
        // Inclined further than one that is held and need hardly be lifted its strip is narrower.
        const double hardly = lifted_share * field_.cusp();
        bool rises_aside = false; // the largest lead may clear more than smaller ones
        std::size_t asked = 0;    // the leads below have to be lifted more, or are not held
        const auto serves = [&](std::size_t l) {
            const double delta = bottom(l);
            return delta <= hardly && counts({leads[l], yaw, delta});
        };
        for (std::size_t l = 0; l < leads.size() && most < enough; ++l) {
            // Lifted clear of the part it holds less still.
            if (!may_be_wider(width.standing({leads[l], yaw, arched}))) {
                // Inclined further it holds less, but where the part rises towards the side it leans to: the
                // largest lead tells.
                if (!rises_aside && !may_be_wider(width.standing({leads.back(), yaw, arched}))) break;
                rises_aside = true;
                continue;
            }
            while (asked < l && !serves(asked))
                ++asked;
            if (asked < l) break;
            const PostureValue posture{leads[l], yaw, bottom(asked++)};
            const StripWidth::Standing at = width.standing({leads[l], yaw, posture.delta + arched});
            if (posture.delta <= liftable && may_be_wider(at) && is_held(posture)
                && width.clears_own_line(posture)) {
                std::array<StripWidth::Width, 2> to;
                StripWidth::Width &first = to[harder > 0], &second = to[harder < 0];
                first = width(at, harder);
                if (first.width > 0 && width.may_exceed(at, -harder, most / std::min(first.width, wanted))) {
                    second = width(at, -harder);
                    if (value(first, second) > most) {
                        most = value(first, second);
                        contact.posture = posture;
                        lo = to[0];
                        hi = to[1];
                    }
                }
            }
            if (posture.delta <= hardly && counts(posture)) break;
        }
    }
    // Strips end in planes of the lattice.
    const double spacing = field_.lines().spacing();
    const auto whole = [&](double w) { return std::floor(w / spacing + tolerance::level_angle) * spacing; };
    contact.width_lo = whole(lo.width);
    contact.width_hi = whole(hi.width);
    contact.end_lo = lo.end;
    contact.end_hi = hi.end;
}

} // namespace facetmill
