#include "core/gouge/revolved_body.h"
#include "core/base/plane_geometry.h"

#include "core/base/error.h"

#include <cmath>

namespace facetmill {

namespace {

/// Positive when b lies beyond a, on the way of the normals from below over outward to above.
double beyond(double ar, double az, double br, double bz) {
    return ar * bz - az * br;
}

} // namespace

RevolvedBody::RevolvedBody(const CutterProfile& profile, double height) {
    const auto add_line = [&](const Vec2& from, const Vec2& to) {
        Piece p;
        p.rho0 = from.x();
        p.z0 = from.y() + height;
        p.rho1 = to.x();
        p.z1 = to.y() + height;
        const double length = (to - from).norm();
        p.nr0 = p.nr1 = (to.y() - from.y()) / length;
        p.nz0 = p.nz1 = -(to.x() - from.x()) / length;
        p.g0 = p.g1 = (to.y() - from.y()) / (to.x() - from.x());
        pieces_.push_back(p);
    };
    for (const ProfilePiece& source : profile.pieces()) {
        if (source.kind == ProfilePiece::Kind::line) {
            add_line(source.from, source.to);
            continue;
        }
        Piece p;
        p.arc = true;
        p.rho0 = source.from.x();
        p.z0 = source.from.y() + height;
        p.rho1 = source.to.x();
        p.z1 = source.to.y() + height;
        p.e = source.center.x();
        p.f = source.center.y() + height;
        p.r = source.radius;
        const Vec2 start = (source.from - source.center).normalized(),
                   end = (source.to - source.center).normalized();
        p.nr0 = std::max(0.0, start.x());
        p.nz0 = start.y();
        p.nr1 = std::max(0.0, end.x());
        p.nz1 = end.y();
        pieces_.push_back(p);
    }
    const Vec2 last = profile.pieces().back().to;
    if (last.x() > 0) {
        add_line(last, Vec2(0, last.y()));
        pieces_.back().nr0 = pieces_.back().nr1 = 0;
        pieces_.back().nz0 = pieces_.back().nz1 = 1;
    }
    if (pieces_.size() > max_pieces)
        throw Error(ErrorCode::internal, "RevolvedBody", "the profile has too many pieces", "report this");
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        circles_.push_back({pieces_[i].rho0, pieces_[i].z0, unsigned(i == 0 ? 0 : i - 1)});
    circles_.push_back({pieces_.back().rho1, pieces_.back().z1, unsigned(pieces_.size() - 1)});
    max_radius_ = profile.max_radius();
    bottom_ = circles_.front().z;
    top_ = circles_.back().z;
}

RevolvedBody::Support RevolvedBody::support(double mr, double mz) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& p = pieces_[i];
        // Straight up is as far from straight down as from itself.
        const double turn = beyond(mr, mz, p.nr0, p.nz0);
        if (turn > 0 || (turn == 0 && mr * p.nr0 + mz * p.nz0 > 0)) return {p.rho0, p.z0, unsigned(i)};
        if (p.arc && beyond(mr, mz, p.nr1, p.nz1) > 0) {
            const double scale = p.r / std::sqrt(mr * mr + mz * mz);
            return {std::max(0.0, p.e + scale * mr), p.f + scale * mz, unsigned(i)};
        }
    }
    return {pieces_.back().rho1, pieces_.back().z1, unsigned(pieces_.size() - 1)};
}

double RevolvedBody::extent(const Vec3& m) const {
    const double mr = std::sqrt(m.x() * m.x() + m.y() * m.y());
    const Support s = support(mr, m.z());
    return mr * s.rho + m.z() * s.z;
}

Vec3 RevolvedBody::normal(unsigned piece, const Vec3& at) const {
    const Piece& p = pieces_[piece];
    const double rho = std::sqrt(at.x() * at.x() + at.y() * at.y());
    const Vec3 out = rho > 0 ? Vec3(at.x() / rho, at.y() / rho, 0) : Vec3::UnitX();
    if (!p.arc) return p.nr0 * out + Vec3(0, 0, p.nz0);
    return ((rho - p.e) * out + Vec3(0, 0, at.z() - p.f)).normalized();
}

RevolvedBody::Section RevolvedBody::section(double z) const {
    Section best;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& p = pieces_[i];
        if (z < p.z0 || z > p.z1) continue;
        double rho;
        if (p.arc)
            rho = p.e + leg_length(p.r, z - p.f);
        else if (p.z1 > p.z0)
            rho = p.rho0 + (z - p.z0) / (p.z1 - p.z0) * (p.rho1 - p.rho0);
        else
            rho = std::max(p.rho0, p.rho1);
        if (rho >= best.rho) best = {rho, unsigned(i)};
    }
    best.rho = std::min(best.rho, max_radius_);
    return best;
}

double RevolvedBody::on_piece(const Piece& p, double rho, bool lower) const {
    if (p.arc) return p.f + (lower ? -1 : 1) * leg_length(p.r, rho - p.e);
    return std::clamp(p.z0 + p.g0 * (rho - p.rho0), p.z0, p.z1);
}

RevolvedBody::Support RevolvedBody::lowest(double rho) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& p = pieces_[i];
        if (rho <= p.rho0) return {rho, p.z0, unsigned(i)};
        if (rho <= p.rho1) return {rho, on_piece(p, rho, true), unsigned(i)};
    }
    return {rho, top_, unsigned(pieces_.size() - 1)};
}

RevolvedBody::Support RevolvedBody::highest(double rho) const {
    for (std::size_t i = pieces_.size(); i-- > 0;) {
        const Piece& p = pieces_[i];
        if (rho <= p.rho1) return {rho, p.z1, unsigned(i)};
        if (rho <= p.rho0) return {rho, on_piece(p, rho, false), unsigned(i)};
    }
    return {rho, bottom_, 0};
}

} // namespace facetmill
