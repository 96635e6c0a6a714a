#include "ui/cspace_studies.h"

namespace facetmill::ui {

void CSpaceStudies::set_record(std::shared_ptr<const FiveAxisRecord> record) {
    job_.cancel();
    known_.clear();
    study_.reset();
    record_ = std::move(record);
}

CSpaceStudies::PointPtr CSpaceStudies::known(std::size_t index) const {
    const auto at = known_.find(index);
    return at == known_.end() ? nullptr : at->second;
}

void CSpaceStudies::cancel() {
    job_.cancel();
    wanted_.reset();
}

void CSpaceStudies::look_at(std::size_t index) {
    const std::size_t first = record_->line_of(index).begin;
    if (wanted_ == first && job_.running() && !job_.cancelling()) return;
    wanted_ = first;
    struct Outcome {
        std::shared_ptr<const FiveAxisStudy> study;
        std::vector<FiveAxisStudy::Point> points;
    };
    auto outcome = std::make_shared<Outcome>();
    outcome->study = study_;
    job_.start(
        tr("Configuration space"),
        [outcome, record = record_, first](const Progress& p) {
            if (!outcome->study)
                outcome->study = std::make_shared<const FiveAxisStudy>(record, p.part(0, 0.2));
            outcome->points = outcome->study->line(first, p.part(0.2, 1));
        },
        [this, outcome, record = record_, first](const JobEnd& end) {
            if (record != record_) return;
            if (wanted_ == first) wanted_.reset();
            if (!end.done()) {
                if (!wanted_) emit given_up();
                return;
            }
            study_ = outcome->study;
            known_.clear();
            for (auto& point : outcome->points) {
                const std::size_t i = point.index;
                known_[i] = std::make_shared<const FiveAxisStudy::Point>(std::move(point));
            }
            emit ready();
        });
}

} // namespace facetmill::ui
