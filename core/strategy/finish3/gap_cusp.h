// The largest cusp in the gap between two neighbouring lines of a plan. Places in three rows between them are
// asked what both lines leave there (cusp_field.h); the cusp's ridge between the rows is where both leave the
// same. Where the contact jumps from one flank to another, or the lift as at a wall, it is looked at more
// closely.
#pragma once

#include "core/strategy/finish3/cusp_field.h"

#include <array>

namespace facetmill {

struct CuspAt {
    double u = 0, cusp = 0;
};

class GapCusp {
public:
    /// Between `a` and `b`; without one of them, between the border v = edge and the other. Only over
    /// `within` (u), where that is given.
    GapCusp(const CuspField& field, const DriveLine* a, const DriveLine* b, double edge,
            const Interval* within = nullptr);

    /// The largest cusp at places along the gap, `CuspField::spacing()` apart where there is something to
    /// cut; u never falls.
    std::vector<CuspAt> along(const Progress& progress) const;
    /// Whether any of them is above the allowed cusp.
    bool is_any_above(const Progress& progress) const;

private:
    using Sample = CuspField::Sample;
    static constexpr int rows = 3;

    /// A place along the lines.
    struct Column {
        double u = 0;
        bool joins_next = false; ///< the next column belongs to the same piece of the domain
    };
    /// What is found at a column: contacts, and roots of what the lines leave there.
    struct Found {
        double u = 0, worst = 0;
        CuspField::Near a, b; ///< the lines here
        bool is_cut = false;  ///< false: a place is not cut at all
        std::array<Sample, rows> s;
        std::array<double, rows> x{}, y{};
        /// The contact stands still while the cutter rolls over a convex edge.
        bool still = false;
    };
    /// The rows of some columns one after another, and of one more where the last joins it.
    struct Block {
        std::size_t first = 0;
        std::vector<std::array<Sample, rows>> samples;
        std::array<LiftHint, rows> hints;
        const std::array<Sample, rows>& at(std::size_t column) const { return samples[column - first]; }
    };

    void place_columns(std::vector<Interval> all, const Interval* within);
    Block sampled(std::size_t begin, std::size_t end, const Progress& progress) const;
    /// Two tips at a column between which contacts may be far apart.
    struct Pair {
        std::size_t found = 0; ///< of the columns of a block
        double v0 = 0, v1 = 0;
        Sample s0, s1;
        double gap = 0; ///< contacts farther apart are looked between
        int depth = 0;  ///< halvings that are left
    };

    std::vector<Found> look(std::size_t begin, std::size_t end, const Progress& progress) const;
    /// With what the rows tell.
    Found at_rows(std::size_t column, const Block& block) const;
    /// Pairs of neighbouring places, where it is worth to look between them.
    std::vector<Pair> pairs(const std::vector<Found>& columns, const Progress& progress) const;
    void look_between(std::vector<Pair> pairs, std::vector<Found>& columns, const Progress& progress) const;
    void look_at_ridges(Found& found) const;
    void look_at_walls(Found& found, Block& block) const;
    void look_at_wall_ahead(Found& found, std::size_t column, Block& block) const;

    /// What stays where the contact jumps from one to the other of two tips that are close together.
    double at_jump(const Pair& pair, const Found& found) const;
    /// What stays on both flanks of a hollow, at a column and v, beside the contacts of the cutter that
    /// touches both: no tip touches there, but it would leave less.
    double hollow(const Sample& s0, const Sample& s1, const Found& found, double v) const;
    /// What stays on a flank of a hollow, the contact on which is `s`; `inward` points to the other contact.
    double hollow_flank(const Sample& s, Vec3 inward, const Vec3& seat, const Found& found, double v,
                        double beside) const;
    double wall(Vec2 from, Vec2 to, double z_from, double z_to, LiftHint& hint) const;

    double left_at(double u, const Sample& s) const {
        return field_.left_at(field_.near(a_, u), field_.near(b_, u), s);
    }

    const CuspField& field_;
    const StepOverInput& in_;
    const DriveLine *a_, *b_;
    double v0_, v1_;
    std::array<double, rows> v_{};
    std::array<std::vector<Interval>, rows> domain_;
    std::vector<Interval> domain_a_, domain_b_; ///< where the lines themselves have something to cut
    std::vector<Column> columns_;
};

} // namespace facetmill
