#include "core/strategy/five_axis_study.h"

namespace facetmill {

FiveAxisStudy::FiveAxisStudy(std::shared_ptr<const FiveAxisRecord> record, const Progress& progress)
    : record_(std::move(record)), field_(record_->context, record_->settings, progress, true) {}

FiveAxisStudy::Point FiveAxisStudy::point(std::size_t index, const Progress& progress) const {
    if (index >= record_->points.size())
        throw Error(ErrorCode::out_of_range, "point",
                    "there is no contact point " + std::to_string(index) + ": the operation has "
                        + std::to_string(record_->points.size()),
                    "give a number from 0 to " + std::to_string(record_->points.size() - 1));
    const FiveAxisRecord::Line& line = record_->line_of(index);
    std::vector<ContactPlace> places;
    for (std::size_t i = line.begin; i < line.end; ++i)
        places.push_back(record_->points[i].place);
    const PostureStudy study = study_postures(field_, places, progress.part(0, 0.6));
    std::optional<ToolPose> before;
    if (line.begin > 0)
        if (const auto& last = record_->points[line.begin - 1]; last.choice.free)
            before = posture_pose(field_.cutter(), last.place.frame, last.choice.posture);
    const std::size_t at = index - line.begin;
    Point point;
    point.index = index;
    point.place = places[at];
    point.curves = study.curves[at];
    point.space = study.spaces[at];
    point.cm2_lambda = study.points[at].cm2_lambda;
    point.planned = record_->points[index].choice;
    for (std::size_t m = 0; m < point.chosen.size(); ++m)
        point.chosen[m] = choose_postures(field_, study, Finish5Settings::PostureChoice(m), before,
                                          progress.part(0.6 + 0.13 * double(m), 0.73 + 0.13 * double(m)))[at];
    return point;
}

} // namespace facetmill
