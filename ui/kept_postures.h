// Postures that the user keeps by hand for contact points of a 5-axis operation. They are parameters of the
// operation in the document; planning again uses them.
#pragma once

#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/manual_posture.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace facetmill::ui {

class Document;

/// The one of the contact points from `begin` to `end` that is nearest to a place.
std::size_t nearest_point(const FiveAxisRecord& record, const Vec3& place, std::size_t begin,
                          std::size_t end);

class KeptPostures {
public:
    explicit KeptPostures(Document& document) : document_(document) {}

    /// Looks at the operation with this id, planned with these contact points. Null: at none.
    void look_at(int operation, std::shared_ptr<const FiveAxisRecord> record);

    /// Those that the operation has as it stands, planned with them or not.
    std::vector<ManualPosture> all() const;
    /// The contact point that one is for.
    std::size_t point_of(const ManualPosture& kept) const;
    std::optional<ManualPosture> at(std::size_t point) const;
    /// In the place of the one that the point had, as a step of the history.
    void keep(std::size_t point, const ManualPosture& posture);
    /// False where none is kept.
    bool remove(std::size_t point);

private:
    std::optional<std::size_t> number_at(std::size_t point) const;
    void change(const QString& what, const std::vector<ManualPosture>& postures);

    Document& document_;
    int operation_ = -1;
    std::shared_ptr<const FiveAxisRecord> record_;
};

} // namespace facetmill::ui
