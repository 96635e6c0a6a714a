#include "core/strategy/five_axis/five_axis_study.h"

namespace facetmill {

namespace {

PlanContext with_contact(const PlanContext& context, const ContactIndexPtr& contact) {
    PlanContext complete = context;
    if (!complete.contact) complete.contact = contact;
    return complete;
}

ContactIndexPtr contact_of(const FiveAxisRecord& record, const Progress& progress) {
    return record.context.contact ? record.context.contact
                                  : std::make_shared<const ContactIndex>(record.kept_off, progress);
}

} // namespace

FiveAxisStudy::FiveAxisStudy(std::shared_ptr<const FiveAxisRecord> record, const Progress& progress)
    : record_(std::move(record)),
      field_(with_contact(record_->context, contact_of(*record_, progress.part(0, 0.3))),
             record_->settings_of(0), progress.part(0.3, 1), true, record_->pieces.front().view),
      further_(record_->pieces.size()) {}

const FiveAxisField& FiveAxisStudy::field_of(const FiveAxisRecord::Line& line,
                                             const Progress& progress) const {
    if (line.piece == 0) return field_;
    const std::lock_guard lock(mutex_);
    auto& own = further_[line.piece];
    const FiveAxisRecord::Piece& piece = record_->pieces[line.piece];
    if (!own)
        own = std::make_unique<FiveAxisField>(with_contact(piece.context, field_.context().contact),
                                              record_->settings_of(line.piece), progress, true, piece.view);
    return *own;
}

/// Points of passes without strips: the tool is to hold the contact point to within the chord tolerance, and
/// what was planned is all that was chosen.
std::vector<FiveAxisStudy::Point> FiveAxisStudy::line_without_strips(const FiveAxisRecord::Line& line,
                                                                     const Progress& progress) const {
    std::vector<Point> points(line.end - line.begin);
    std::vector<ContactFrame> frames;
    std::vector<std::vector<RaisedCurve>> curves;
    for (std::size_t i = line.begin; i < line.end; ++i) {
        const ContactFrame& frame = record_->points[i].place.frame;
        frames.push_back(frame);
        curves.push_back({{frame.point + field_.chord() * frame.normal}});
    }
    std::vector<CSpace> spaces = field_.builder().build(frames, curves, progress);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Point& point = points[i];
        point.index = line.begin + i;
        point.place = record_->points[point.index].place;
        point.grid = field_.grid();
        point.curves = std::move(curves[i]);
        point.space = std::move(spaces[i]);
        point.planned = record_->points[point.index].choice;
        point.chosen.fill(point.planned);
    }
    return points;
}

FiveAxisStudy::Point FiveAxisStudy::point(std::size_t index, const Progress& progress) const {
    std::vector<Point> points = line(index, progress);
    return std::move(points[index - points.front().index]);
}

std::vector<FiveAxisStudy::Point> FiveAxisStudy::line(std::size_t index, const Progress& progress) const {
    if (index >= record_->points.size())
        throw Error(ErrorCode::out_of_range, "point",
                    "there is no contact point " + std::to_string(index) + ": the operation has "
                        + std::to_string(record_->points.size()),
                    "give a number from 0 to " + std::to_string(record_->points.size() - 1));
    const FiveAxisRecord::Line& line = record_->line_of(index);
    if (!record_->has_strips) return line_without_strips(line, progress);
    std::vector<ContactPlace> places;
    for (std::size_t i = line.begin; i < line.end; ++i)
        places.push_back(record_->points[i].place);
    const FiveAxisField& field = field_of(line, progress.part(0, 0));
    PostureStudy study = study_postures(field, places, progress.part(0, 0.55));
    std::vector<ContactPlace> coming;
    if (&line != &record_->lines.back() && (&line + 1)->piece == line.piece) {
        const FiveAxisRecord::Line& next = *(&line + 1);
        for (std::size_t i = next.begin; i < std::min(next.end, next.begin + choose_horizon); ++i)
            coming.push_back(record_->points[i].place);
    }
    const PostureStudy next = study_postures(field, coming, progress.part(0.55, 0.6));
    std::optional<ToolPose> before;
    for (std::size_t i = line.begin; i > 0 && !before; --i)
        if (record_->line_of(i - 1).piece != line.piece)
            break;
        else if (const auto& last = record_->points[i - 1]; last.choice.free)
            before = posture_pose(field_.cutter(), last.place.frame, last.choice.posture);
    std::array<std::vector<ChosenPosture>, 3> chosen;
    for (std::size_t m = 0; m < chosen.size(); ++m)
        chosen[m] = choose_postures(field, study, Finish5Settings::PostureChoice(m), before, next.points,
                                    progress.part(0.6 + 0.13 * double(m), 0.73 + 0.13 * double(m)));
    std::vector<Point> points(places.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        Point& point = points[i];
        point.index = line.begin + i;
        point.place = places[i];
        point.grid = field.grid();
        point.curves = std::move(study.curves[i]);
        point.space = std::move(study.spaces[i]);
        point.cm2_lead = study.points[i].cm2_lead;
        point.planned = record_->points[point.index].choice;
        for (std::size_t m = 0; m < chosen.size(); ++m)
            point.chosen[m] = chosen[m][i];
    }
    return points;
}

} // namespace facetmill
