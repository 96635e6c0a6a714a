// Studies of contact points for the configuration space, a line of the path at a time, in the background. The
// points of the line studied last are kept, so that stepping along it shows the next one at once.
#pragma once

#include "core/strategy/five_axis/five_axis_study.h"
#include "ui/background_job.h"

#include <map>
#include <memory>
#include <optional>

namespace facetmill::ui {

class CSpaceStudies : public QObject {
    Q_OBJECT
public:
    using PointPtr = std::shared_ptr<const FiveAxisStudy::Point>;

    explicit CSpaceStudies(QObject* parent) : QObject(parent) {}

    /// The record of another path, or none. What was studied is forgotten.
    void set_record(std::shared_ptr<const FiveAxisRecord> record);
    /// The study of the whole record; null before the first line.
    const std::shared_ptr<const FiveAxisStudy>& study() const { return study_; }
    /// A point of the line studied last; null: it is not of that line.
    PointPtr known(std::size_t index) const;
    /// Studies the line of a contact point.
    void look_at(std::size_t index);
    /// Cancels the job and wants no line any more.
    void cancel();
    void cancel_job() { job_.cancel(); }
    const BackgroundJob& job() const { return job_; }

signals:
    /// The points of the line are known.
    void ready();
    /// The line was not studied: the job was cancelled or failed, and no other is wanted.
    void given_up();

private:
    std::shared_ptr<const FiveAxisRecord> record_;
    std::shared_ptr<const FiveAxisStudy> study_;
    std::map<std::size_t, PointPtr> known_;
    std::optional<std::size_t> wanted_; ///< first point of the line under study
    BackgroundJob job_;                 // last: it ends first
};

} // namespace facetmill::ui
