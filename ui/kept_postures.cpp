#include "ui/kept_postures.h"

#include "ui/document.h"

#include <QObject>

#include <utility>

namespace facetmill::ui {

std::size_t nearest_point(const FiveAxisRecord& record, const Vec3& place, std::size_t begin,
                          std::size_t end) {
    double nearest = infinity;
    std::size_t index = begin;
    for (std::size_t i = begin; i < end; ++i) {
        const double away = (record.points[i].place.surface - place).squaredNorm();
        if (away < nearest) {
            nearest = away;
            index = i;
        }
    }
    return index;
}

void KeptPostures::look_at(int operation, std::shared_ptr<const FiveAxisRecord> record) {
    operation_ = operation;
    record_ = std::move(record);
}

std::vector<ManualPosture> KeptPostures::all() const {
    const auto index = record_ ? document_.index_of(operation_) : std::nullopt;
    if (!index) return {};
    return manual_posture_list.of(document_.operation(*index));
}

std::size_t KeptPostures::point_of(const ManualPosture& kept) const {
    const auto& p = kept.point;
    return nearest_point(*record_, {p[0], p[1], p[2]}, 0, record_->points.size());
}

std::optional<std::size_t> KeptPostures::number_at(std::size_t point) const {
    const std::vector<ManualPosture> kept = all();
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (point_of(kept[i]) == point) return i;
    return std::nullopt;
}

std::optional<ManualPosture> KeptPostures::at(std::size_t point) const {
    const auto number = number_at(point);
    return number ? std::optional(all()[*number]) : std::nullopt;
}

void KeptPostures::change(const QString& what, const std::vector<ManualPosture>& postures) {
    const auto index = document_.index_of(operation_);
    if (!index) return;
    document_.change(what, [&](Project& project) {
        Operation& operation = *project.operations[*index];
        if (manual_posture_list.is_in(operation)) manual_posture_list.set(operation, postures);
    });
}

void KeptPostures::keep(std::size_t point, const ManualPosture& posture) {
    std::vector<ManualPosture> kept = all();
    if (const auto number = number_at(point))
        kept[*number] = posture;
    else
        kept.push_back(posture);
    change(QObject::tr("Keep posture"), kept);
}

bool KeptPostures::remove(std::size_t point) {
    const auto number = number_at(point);
    if (!number) return false;
    std::vector<ManualPosture> kept = all();
    kept.erase(kept.begin() + std::ptrdiff_t(*number));
    change(QObject::tr("Remove kept posture"), kept);
    return true;
}

} // namespace facetmill::ui
