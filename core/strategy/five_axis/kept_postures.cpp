#include "core/strategy/five_axis/kept_postures.h"

#include "core/strategy/plan/plan_text.h"

namespace facetmill {

namespace {

std::string place_text(LengthUnit unit, const Vec3& point) {
    const PlanText text{unit};
    return "the point " + text(point.x()) + ", " + text(point.y()) + ", " + text(point.z());
}

std::string block_text(PostureBlock block) {
    switch (block) {
    case PostureBlock::local:
    case PostureBlock::global:
        return "the cutter would cut into the part";
    case PostureBlock::shank:
        return "the shank would hit the part";
    case PostureBlock::holder:
        return "the holder would hit the part";
    case PostureBlock::lift:
        return "it leaves more than the tolerance";
    case PostureBlock::machine:
        return "the machine's axes do not reach, or the tool would lie down";
    case PostureBlock::free:
        break;
    }
    return {};
}

Vec3 point_of(const ManualPosture& posture) {
    return {posture.point[0], posture.point[1], posture.point[2]};
}

} // namespace

KeptPostures::KeptPostures(const FiveAxisField& field)
    : field_(&field), postures_(field.settings().manual_postures), unit_(field.context().unit),
      met_(postures_.size(), false) {
    for (const ManualPosture& kept : postures_)
        v_.push_back(field.v_of(point_of(kept)));
}

void KeptPostures::hand_over(std::vector<PlacedLine>& pass) {
    for (std::size_t k = 0; k < met_.size(); ++k) {
        const ManualPosture& kept = postures_[k];
        const Vec3 point = point_of(kept);
        const double v = v_[k];
        if (met_[k]) continue;
        ContactPlace* nearest = nullptr;
        double least = field_->radius(); // what is farther away is another place
        for (PlacedLine& line : pass)
            for (ContactPlace& place : line.places) {
                if (v < place.v_lo - field_->chord() || v > place.v_hi + field_->chord()) continue;
                const double away = (place.surface - point).norm();
                if (away >= least) continue;
                least = away;
                nearest = &place;
            }
        if (!nearest) continue;
        met_[k] = true;
        if (nearest->kept)
            warnings_.push_back("the posture kept for " + place_text(unit_, point)
                                + " is not used: another one is kept for the same contact point");
        else
            nearest->kept = {kept.lead, kept.yaw};
    }
}

void KeptPostures::check(const PlacedLine& line, const PostureStudy& study) {
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        const ContactPlace& place = line.places[i];
        if (!place.kept || study.points[i].kept) continue;
        const auto [lead, yaw] = *place.kept;
        const PostureBlock block = field_->builder().reason(place.frame, lead, yaw, study.curves[i]).block;
        warnings_.push_back("the posture kept for " + place_text(unit_, place.surface)
                            + " is not free and not used: " + block_text(block));
    }
}

void KeptPostures::add(const KeptPostures& other) {
    for (std::size_t k = 0; k < met_.size(); ++k)
        met_[k] = met_[k] || other.met_[k];
    warnings_.insert(warnings_.end(), other.warnings_.begin(), other.warnings_.end());
}

std::vector<std::string> KeptPostures::warnings() const {
    std::vector<std::string> all = warnings_;
    for (std::size_t k = 0; k < met_.size(); ++k)
        if (!met_[k])
            all.push_back("the posture kept for " + place_text(unit_, point_of(postures_[k]))
                          + " is not used: no pass comes there");
    return all;
}

} // namespace facetmill
