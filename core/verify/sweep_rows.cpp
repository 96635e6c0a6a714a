// Many lines in one row at once: the same arithmetic as for single lines, step by step over the whole row, in
// loops that compilers turn into vector instructions. What they cannot (tori, leaning lines) is asked line by
// line.
#include "core/base/tolerances.h"
#include "core/verify/sweep.h"

#include <algorithm>

/// Compiled for vectors of four and of eight doubles as well; which of them is run is chosen when the program
/// is loaded. The same operations in the same order, so the same numbers. Sanitizers look at the one for
/// every processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)        \
    && !defined(__SANITIZE_THREAD__)
#define FACETMILL_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FACETMILL_WIDE
#endif
/// So that what a function above calls is compiled with it.
#define FACETMILL_WITHIN __attribute__((always_inline))

namespace facetmill {

namespace {

using RowValues = SweepRow::Values;

/// Radii of a body of these sides at heights; below 0 where it has none.
FACETMILL_WITHIN inline void radii_at(const std::vector<ProfilePiece>& sides, const RowValues& z, int count,
                                      RowValues& radius) {
    for (int i = 0; i < count; ++i)
        radius[i] = -1;
    for (const ProfilePiece& s : sides) {
        const double from = s.from.y(), to = s.to.y(), wide = std::max(s.from.x(), s.to.x());
        if (s.kind == ProfilePiece::Kind::arc) {
            const double middle = s.center.y(), off = s.center.x(), r = s.radius;
            for (int i = 0; i < count; ++i) {
                const double up = z[i] - middle, square = (r - up) * (r + up);
                const double here = off + std::sqrt(square > 0 ? square : 0);
                const double more = here > radius[i] ? here : radius[i];
                radius[i] = (z[i] < from) | (z[i] > to) ? radius[i] : more;
            }
        } else {
            const bool rises = to > from;
            const double start = rises ? s.from.x() : wide,
                         slope = rises ? (s.to.x() - s.from.x()) / (to - from) : 0;
            for (int i = 0; i < count; ++i) {
                const double here = start + slope * (z[i] - from);
                const double more = here > radius[i] ? here : radius[i];
                radius[i] = (z[i] < from) | (z[i] > to) ? radius[i] : more;
            }
        }
    }
}

/// Where s, a piece of a profile that is not upright, has these radii: heights[i] for which `takes` is true.
template <class Takes>
FACETMILL_WITHIN inline void set_heights(const ProfilePiece& s, const RowValues& rho, int count,
                                         const Takes& takes, RowValues& heights) {
    if (s.kind == ProfilePiece::Kind::line) {
        const double slope = (s.to.y() - s.from.y()) / (s.to.x() - s.from.x());
        for (int i = 0; i < count; ++i) {
            const double height = s.from.y() + slope * (rho[i] - s.from.x());
            heights[i] = takes(rho[i]) ? height : heights[i];
        }
        return;
    }
    const double sign = s.from.x() < s.to.x() ? -1 : 1, middle = s.center.y(), off = s.center.x(),
                 r = s.radius;
    for (int i = 0; i < count; ++i) {
        const double out = rho[i] - off, square = (r - out) * (r + out);
        const double height = middle + sign * std::sqrt(square > 0 ? square : 0);
        heights[i] = takes(rho[i]) ? height : heights[i];
    }
}

} // namespace

FACETMILL_WIDE void SweepRow::set_along(const TurnedBody& body, const Vec3& p, const Vec3& step, int count,
                                        const Vec3& u, const Flags& wanted) {
    if (u.x() == 0 && u.y() == 0) {
        RowValues rho{}, low{}, high{};
        for (int i = 0; i < count; ++i) {
            const double x = p.x() + i * step.x(), y = p.y() + i * step.y();
            rho[i] = std::sqrt(x * x + y * y);
            low[i] = high[i] = body.sides_[body.lower_ - 1].to.y();
        }
        for (std::size_t k = body.lower_; k-- > 0;) // the innermost that reaches so far is told last
            set_heights(
                body.sides_[k], rho, count, [to = body.sides_[k].to.x()](double r) { return r <= to; }, low);
        for (std::size_t k = body.lower_; k < body.sides_.size(); ++k) {
            const ProfilePiece& s = body.sides_[k];
            const double from = s.from.x();
            if (from > s.to.x())
                set_heights(
                    s, rho, count, [from](double r) { return r <= from; }, high);
            else if (from == s.to.x())
                for (int i = 0; i < count; ++i)
                    high[i] = rho[i] <= from ? s.to.y() : high[i];
        }
        const double per_z = 1 / u.z();
        for (int i = 0; i < count; ++i) {
            const double z = p.z() + i * step.z();
            const double a = (low[i] - z) * per_z, b = (high[i] - z) * per_z;
            lo[i] = rho[i] > body.radius_ ? infinity : a < b ? a : b;
            hi[i] = rho[i] > body.radius_ ? -infinity : a < b ? b : a;
        }
    } else if (u.z() == 0) {
        RowValues z{}, radius{};
        for (int i = 0; i < count; ++i)
            z[i] = p.z() + i * step.z();
        radii_at(body.sides_, z, count, radius);
        const double per_length = 1 / std::sqrt(u.x() * u.x() + u.y() * u.y());
        const double along_x = u.x() * per_length, along_y = u.y() * per_length;
        for (int i = 0; i < count; ++i) {
            const double x = p.x() + i * step.x(), y = p.y() + i * step.y();
            const double middle = -(x * along_x + y * along_y) * per_length,
                         beside = x * along_y - y * along_x;
            const double square = (radius[i] - beside) * (radius[i] + beside);
            const double half = std::sqrt(square > 0 ? square : 0) * per_length;
            const bool none = (radius[i] < 0) | (square < 0);
            lo[i] = none ? infinity : middle - half;
            hi[i] = none ? -infinity : middle + half;
        }
    } else {
        for (int i = 0; i < count; ++i) {
            const Stretch s = wanted[i] ? body.along_general(p + i * step, u) : Stretch();
            lo[i] = s.lo;
            hi[i] = s.hi;
        }
    }
}

void SweepRow::set_at_end(const SweepRays& swept, const Vec3& p, const Vec3& step, int count, bool last,
                          const Flags& wanted) {
    set_along(*swept.body_, swept.frame_ * (p - swept.from_) - (last ? swept.length_ : 0.0) * swept.along_,
              swept.frame_ * step, count, swept.u_, wanted);
}

/// Touches of the outline at offsets that grow or shrink evenly.
struct SweepRow::Touches {
    RowValues y, l;
};

FACETMILL_WIDE void SweepRow::touch(const SweepRays& swept, double side, const Values& c, int count,
                                    const Flags& wanted, Touches& found) {
    using Link = SweepRays::Link;
    const std::vector<Link>& chain = side < 0 ? swept.entry_ : swept.exit_;
    const bool grows = c[count - 1] >= c[0];
    const Link* link = grows ? chain.data() : chain.data() + chain.size() - 1;
    const Link* const last = grows ? chain.data() + chain.size() - 1 : chain.data();
    for (int i = 0; i < count;) {
        int end = i;
        if (link == last)
            end = count;
        else if (grows)
            while (end < count && !(c[end] > link->c1))
                ++end;
        else
            while (end < count && c[end] > (link - 1)->c1)
                ++end;
        if (link->kind == Link::Kind::line) {
            for (int k = i; k < end; ++k) {
                const double t = c[k] - link->c0;
                found.y[k] = link->y0 + t * link->slope_y;
                found.l[k] = link->l0 + t * link->slope_l;
            }
        } else if (link->kind == Link::Kind::torus) {
            for (int k = i; k < end; ++k) {
                if (!wanted[k]) continue;
                const SweepRays::Touch at =
                    swept.touch_torus(*link, side, std::clamp(c[k], link->c0, link->c1));
                found.y[k] = at.y;
                found.l[k] = at.l;
            }
        } else {
            for (int k = i; k < end; ++k) {
                double cosine = (c[k] - link->middle_c) * link->scale;
                cosine = cosine < -1 ? -1 : cosine;
                cosine = cosine > 1 ? 1 : cosine;
                const double sine = std::sqrt((1 - cosine) * (1 + cosine));
                found.y[k] = link->middle_y + link->cos_y * cosine + link->sin_y * sine;
                found.l[k] = link->middle_l + link->cos_l * cosine + link->sin_l * sine;
            }
        }
        i = end;
        link += grows ? 1 : -1;
    }
}

FACETMILL_WIDE void SweepRow::ask(const SweepRays& swept, const Vec3& p, const Vec3& step, int count,
                                  double low, double high, Flags wanted, const float* known_lo,
                                  const float* known_hi) {
    if (swept.slow_)
        for (int i = 0; i < count; ++i)
            wanted[i] = wanted[i] && !swept.misses(p + i * step, low, high);
    if (swept.parallel_) {
        set_at_end(swept, p, step, count, false, wanted);
        const double shift = swept.length_ * swept.u_along_;
        for (int i = 0; i < count; ++i) {
            lo[i] += std::min(0.0, shift);
            hi[i] += std::max(0.0, shift);
        }
        return;
    }
    if (swept.exit_.empty()) {
        lo.fill(infinity);
        hi.fill(-infinity);
        return;
    }
    const Vec3 local = p - swept.from_;
    const Vec3 &across = swept.world_across_, &out = swept.world_out_, &along = swept.world_along_;
    const double c0 = local.dot(across), y0 = local.dot(out), l0 = local.dot(along);
    const double dc = step.dot(across), dy = step.dot(out), dl = step.dot(along);
    RowValues c{};
    for (int i = 0; i < count; ++i)
        c[i] = c0 + i * dc;
    Touches entry{}, exit{};
    touch(swept, -1, c, count, wanted, entry);
    touch(swept, 1, c, count, wanted, exit);
    const double least = swept.exit_.front().c0, most = swept.exit_.back().c1;
    const double per_sine = 1 / swept.sine_, per_t = swept.u_along_, length = swept.length_;
    // Which lines need the body at an end, 1 or 0. By pointers: compilers do not see through arrays in
    // structs.
    Values from, to, enters_first, enters_last, leaves_first, leaves_last;
    const double *const cs = c.data(), *const entry_y = entry.y.data(), *const entry_l = entry.l.data(),
                        *const exit_y = exit.y.data(), *const exit_l = exit.l.data();
    double *const from_at = from.data(), *const to_at = to.data(), *const ef = enters_first.data(),
                  *const el = enters_last.data(), *const lf = leaves_first.data(),
                  *const ll = leaves_last.data();
    for (int i = 0; i < count; ++i) {
        const double y = y0 + i * dy, l = l0 + i * dl;
        const double a = (entry_y[i] - y) * per_sine, b = (exit_y[i] - y) * per_sine;
        // The tool that had moved for ever would not reach those outside either.
        const double beside = least - cs[i] > cs[i] - most ? least - cs[i] : cs[i] - most;
        const double beyond = a - high > low - b ? a - high : low - b;
        const double outside = beside > beyond ? beside : beyond;
        const double entry_at = l + a * per_t - entry_l[i], exit_at = l + b * per_t - exit_l[i];
        const double inside = outside > 0 ? 0.0 : 1.0, enter = entry_at * inside, leave = exit_at * inside;
        from_at[i] = outside > 0 ? infinity : a;
        to_at[i] = outside > 0 ? -infinity : b;
        ef[i] = enter < 0 ? 1.0 : 0.0;
        el[i] = enter > length ? 1.0 : 0.0;
        lf[i] = leave < 0 ? 1.0 : 0.0;
        ll[i] = leave > length ? 1.0 : 0.0;
    }
    if (known_lo)
        for (int i = 0; i < count; ++i) {
            const double a = from_at[i] > low ? from_at[i] : low, b = to_at[i] < high ? to_at[i] : high;
            wanted[i] &= -std::int64_t((a < known_lo[i]) | (b > known_hi[i]));
        }
    lo = from;
    hi = to;
    // There the body at the nearer end instead.
    const auto take = [&](bool is_last, const double* enters, const double* leaves) FACETMILL_WITHIN {
        Flags either{};
        std::int64_t any = 0;
        for (int i = 0; i < count; ++i)
            any |= either[i] = wanted[i] && (enters[i] > 0 || leaves[i] > 0);
        if (!any) return;
        SweepRow end;
        end.set_at_end(swept, p, step, count, is_last, either);
        const double *const end_lo = end.lo.data(), *const end_hi = end.hi.data();
        double *const lows = lo.data(), *const highs = hi.data();
        for (int i = 0; i < count; ++i) {
            const double a = end_lo[i], b = end_hi[i], old_a = lows[i], old_b = highs[i];
            lows[i] = enters[i] > 0 ? a : old_a;
            highs[i] = leaves[i] > 0 ? b : old_b;
        }
    };
    take(false, ef, lf);
    take(true, el, ll);
    for (int i = 0; i < count; ++i)
        if (!wanted[i]) {
            lo[i] = infinity;
            hi[i] = -infinity;
        }
}

} // namespace facetmill
