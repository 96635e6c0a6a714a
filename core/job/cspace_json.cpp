#include "core/job/cspace_json.h"

#include "core/base/strict_json.h"

#include <cmath>

namespace facetmill {

namespace {

Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json triple(const Vec3& v, double per) {
    return Json::array({v.x() / per, v.y() / per, v.z() / per});
}

Json degrees_of(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double v : values)
        list.push_back(degrees(v));
    return list;
}

} // namespace

std::string cspace_json(const FiveAxisStudy& study, const FiveAxisStudy::Point& point, LengthUnit unit) {
    const double per = mm_per(unit);
    const PostureGrid& grid = point.grid;
    const ContactFrame& frame = point.place.frame;
    Json json;
    json["units"] = std::string(unit_name(unit));
    json["point"] = point.index;
    json["points"] = study.record().points.size();
    json["pass"] = study.record().line_of(point.index).drive;
    json["contact"] = Json{{"position", triple(point.place.surface, per)},
                           {"normal", triple(frame.normal, 1)},
                           {"feed", triple(frame.feed, 1)},
                           {"left", triple(frame.left, 1)}};
    json["strip"] = Json{{"low", (point.place.v_lo - point.place.v) / per},
                         {"high", (point.place.v_hi - point.place.v) / per}};
    json["lambda_deg"] = degrees_of(grid.lead);
    json["omega_deg"] = degrees_of(grid.yaw);
    Json bottom = Json::array(), top = Json::array(), blocked = Json::array();
    for (std::size_t l = 0; l < grid.lead.size(); ++l) {
        Json bottom_row = Json::array(), top_row = Json::array(), blocked_row = Json::array();
        for (std::size_t o = 0; o < grid.yaw.size(); ++o) {
            const std::size_t n = grid.node(l, o);
            bottom_row.push_back(finite(point.space.bottom[n] / per));
            top_row.push_back(finite(point.space.top[n] / per));
            blocked_row.push_back(posture_block_name(point.space.block[n]));
        }
        bottom.push_back(std::move(bottom_row));
        top.push_back(std::move(top_row));
        blocked.push_back(std::move(blocked_row));
    }
    json["delta_bottom"] = std::move(bottom);
    json["delta_top"] = std::move(top);
    json["blocked"] = std::move(blocked);
    json["cm2_lead_deg"] = degrees(point.cm2_lead);
    const auto posture = [&](const ChosenPosture& chosen) {
        if (!chosen.free) return Json{{"free", false}};
        const ToolPose pose = posture_pose(study.field().cutter(), frame, chosen.posture);
        return Json{{"free", true},
                    {"lambda_deg", degrees(chosen.posture.lead)},
                    {"omega_deg", degrees(chosen.posture.yaw)},
                    {"delta", chosen.posture.delta / per},
                    {"tip", triple(pose.tip, per)},
                    {"axis", triple(pose.axis, 1)}};
    };
    json["chosen"] = Json{{"cm2", posture(point.chosen[0])},
                          {"local", posture(point.chosen[1])},
                          {"global", posture(point.chosen[2])},
                          {"planned", posture(point.planned)}};
    return pretty_json(json);
}

std::string cspace_csv(const FiveAxisStudy::Point& point, LengthUnit unit) {
    const double per = mm_per(unit);
    const std::string name(unit_name(unit));
    const PostureGrid& grid = point.grid;
    const auto number = [](double value) {
        return std::isfinite(value) ? format_number(value, 9) : std::string();
    };
    std::string csv = "lambda_deg,omega_deg,delta_bottom_" + name + ",delta_top_" + name + ",blocked\n";
    for (std::size_t l = 0; l < grid.lead.size(); ++l)
        for (std::size_t o = 0; o < grid.yaw.size(); ++o) {
            const std::size_t n = grid.node(l, o);
            csv += number(degrees(grid.lead[l])) + ',' + number(degrees(grid.yaw[o])) + ','
                   + number(point.space.bottom[n] / per) + ',' + number(point.space.top[n] / per) + ','
                   + posture_block_name(point.space.block[n]) + '\n';
        }
    return csv;
}

} // namespace facetmill
