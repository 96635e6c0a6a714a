// The charts of a planned path in numbers: what is drawn, where the tool stands in it, what a click means,
// and the same as a table. No widgets.
#pragma once

#include "core/base/units.h"
#include "ui/plot_content.h"
#include "viz/path_tint.h"

#include <QString>

#include <optional>
#include <vector>

namespace facetmill::ui {

enum class Chart { rotary_over_length, rotary_over_time, stepover };

/// Where the tool is: `share` of the way through a motion.
struct ChartPlace {
    std::size_t motion = 0;
    double share = 1;
};

class PathChart {
public:
    PathChart() = default;
    /// `figures`: of the program on its machine; null while they are not there. The step-over needs none.
    PathChart(Chart chart, std::shared_ptr<const OperationResult> program, PathFiguresPtr figures,
              LengthUnit unit);

    /// Why there is nothing to draw; empty: there is.
    const QString& missing() const { return missing_; }
    const PlotContent& content() const { return content_; }
    LengthUnit unit() const { return unit_; }

    /// The place along the chart's axis; not a number where the motion is not in it.
    double x_of(const ChartPlace& place) const;
    /// What stands at a place, in words; the same in fewer and fewer after it.
    QStringList readout(const ChartPlace& place) const;
    /// The motion that is nearest along the axis.
    std::optional<std::size_t> motion_at(double x) const;
    /// The step-over chart goes from pass to pass: the motion `by` passes on.
    std::optional<std::size_t> pass_from(const ChartPlace& place, int by) const;
    /// The values as lines of a CSV file.
    std::string table() const;

private:
    /// A drive plane of the step-over chart with the first motion that cuts in it.
    struct Drive {
        double offset = 0; ///< mm
        std::size_t motion = 0;
        int drive = 0;
    };
    void build_stepover();
    void build_rotary();
    QStringList stepover_readout(const ChartPlace& place) const;
    std::string stepover_table() const;

    Chart chart_ = Chart::rotary_over_length;
    std::shared_ptr<const OperationResult> program_;
    PathFiguresPtr figures_;
    LengthUnit unit_ = LengthUnit::mm;
    QString missing_;
    PlotContent content_;
    std::vector<Drive> drives_; ///< in the order of their places
};

} // namespace facetmill::ui
