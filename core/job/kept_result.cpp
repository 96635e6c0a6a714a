#include "core/job/kept_result.h"

#include "core/base/byte_coder.h"
#include "core/job/axis_view.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/global_local/rework_plan.h"

namespace facetmill {

// Plain records. A member more does not compile; of structs with a base their size says so.

template <class Coder, CodedAs<NumberOrWord> T>
void code_fields(Coder& coder, T& v) {
    auto& [number, word] = v;
    coder(number, word);
}
template <class Coder, CodedAs<Box3> T>
void code_fields(Coder& coder, T& v) {
    auto& [lo, hi] = v;
    coder(lo, hi);
}
template <class Coder, CodedAs<Mesh> T>
void code_fields(Coder& coder, T& v) {
    auto& [vertices, facets] = v;
    coder(vertices, facets);
}
template <class Coder, CodedAs<MeshGeometry> T>
void code_fields(Coder& coder, T& v) {
    auto& [vertex_normals, facet_normals] = v;
    coder(vertex_normals, facet_normals);
}
template <class Coder, CodedAs<VertexCurvature> T>
void code_fields(Coder& coder, T& v) {
    auto& [k1, k2, direction1, direction2, mean, gauss, mixed_area] = v;
    coder(k1, k2, direction1, direction2, mean, gauss, mixed_area);
}
template <class Coder, CodedAs<HolderSection> T>
void code_fields(Coder& coder, T& v) {
    auto& [diameter, length] = v;
    coder(diameter, length);
}
template <class Coder, CodedAs<CuttingData> T>
void code_fields(Coder& coder, T& v) {
    auto& [name, material, spindle, feed, plunge_feed, chip_load, stepover, depth] = v;
    coder(name, material, spindle, feed, plunge_feed, chip_load, stepover, depth);
}
template <class Coder, CodedAs<Tool> T>
void code_fields(Coder& coder, T& v) {
    auto& [number, name, diameter, corner_radius, bottom_angle, taper_angle, flute_length, shank_diameter,
           shank_length, holder, flutes, cutting] = v;
    coder(number, name, diameter, corner_radius, bottom_angle, taper_angle, flute_length, shank_diameter,
          shank_length, holder, flutes, cutting);
}
template <class Coder, CodedAs<AptCutter> T>
void code_fields(Coder& coder, T& v) {
    auto& [d, r, e, f, alpha, beta, h] = v;
    coder(d, r, e, f, alpha, beta, h);
}
template <class Coder, CodedAs<Joints> T>
void code_fields(Coder& coder, T& v) {
    auto& [linear, rotary] = v;
    coder(linear, rotary);
}
template <class Coder, CodedAs<TurningAxis> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, direction] = v;
    coder(point, direction);
}

// Paths.

template <class Coder, CodedAs<CutterContact> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, normal] = v;
    coder(point, normal);
}
template <class Coder, CodedAs<CutterLocation> T>
void code_fields(Coder& coder, T& v) {
    auto& [tip, axis] = v;
    coder(tip, axis);
}
template <class Coder, CodedAs<Pass> T>
void code_fields(Coder& coder, T& v) {
    auto& [drive, offset, cc, cl, layer, entry, from_above] = v;
    coder(drive, offset, cc, cl, layer, entry, from_above);
}
template <class Coder, CodedAs<Strip> T>
void code_fields(Coder& coder, T& v) {
    auto& [kind, name, reason, tool, enabled, band, boundaries, centers, area, length, width] = v;
    coder(kind, name, reason, tool, enabled, band, boundaries, centers, area, length, width);
}
template <class Coder, CodedAs<UnreachedRegion> T>
void code_fields(Coder& coder, T& v) {
    auto& [why, area, angle_from, angle_to, from, to, distance] = v;
    coder(why, area, angle_from, angle_to, from, to, distance);
}
template <class Coder, CodedAs<RoughPath> T>
void code_fields(Coder& coder, T& v) {
    auto& [layers, stock_cell, depth_max] = v;
    coder(layers, stock_cell, depth_max);
}
template <class Coder, CodedAs<TiltedPath> T>
void code_fields(Coder& coder, T& v) {
    static_assert(sizeof(TiltedPath) == 8 * sizeof(double));
    coder(v.lead_min, v.lead_max, v.stage_seconds, v.record);
}
template <class Coder, CodedAs<GlobalLocalPath> T>
void code_fields(Coder& coder, T& v) {
    static_assert(sizeof(GlobalLocalPath) == 10 * sizeof(double));
    coder(v.lead_min, v.lead_max, v.stage_seconds, v.record, v.rework);
}
template <class Coder, CodedAs<CleanupPath> T>
void code_fields(Coder& coder, T& v) {
    static_assert(sizeof(CleanupPath) == 4 * sizeof(double));
    coder(v.lead_min, v.lead_max, v.record);
}
template <class Coder, CodedAs<TurnedPath> T>
void code_fields(Coder& coder, T& v) {
    auto& [axis, zero, part_radius, stock_radius, from, to, side_feed_max, at_core, surface_area, unreached,
           layers] = v;
    coder(axis, zero, part_radius, stock_radius, from, to, side_feed_max, at_core, surface_area, unreached,
          layers);
}
template <class Coder, CodedAs<StrategyResult> T>
void code_fields(Coder& coder, T& v) {
    auto& [passes, drive_planes, stepover_min, stepover_max, direction, direction_reason, cusp_max,
           chord_tolerance, cleanup_points, cleanup, strips, warnings, detail] = v;
    coder(passes, drive_planes, stepover_min, stepover_max, direction, direction_reason, cusp_max,
          chord_tolerance, cleanup_points, cleanup, strips, warnings, detail);
}

// What finishing with five axes remembers.

template <class Coder, CodedAs<ManualPosture> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, lead, yaw] = v;
    coder(point, lead, yaw);
}
template <class Coder, CodedAs<OperationCommon> T>
void code_fields(Coder& coder, T& v) {
    auto& [name, off, tool, tolerance, allowance, feed, ramp_feed, link_feed, spindle, clearance,
           below_bottom, tool_axis, direction, boundary, contain, avoid, avoid_distance] = v;
    coder(name, off, tool, tolerance, allowance, feed, ramp_feed, link_feed, spindle, clearance, below_bottom,
          tool_axis, direction, boundary, contain, avoid, avoid_distance);
}
template <class Coder, CodedAs<Finish5Settings> T>
void code_fields(Coder& coder, T& v) {
    using Common = std::conditional_t<Coder::reads, OperationCommon, const OperationCommon>;
    static_assert(sizeof(Finish5Settings) == sizeof(OperationCommon) + 248);
    coder(static_cast<Common&>(v), v.posture, v.grid_step, v.lead_limits, v.yaw_limits, v.stepover, v.pattern,
          v.sides, v.passes, v.reach_lead, v.chord_tolerance, v.normal_limit, v.turn_limit,
          v.holder_clearance, v.accelerations, v.manual_postures, v.motion_share, v.room_chords, v.own_reach,
          v.strip_look_share, v.max_tilt);
}
template <class Coder, CodedAs<ContactFrame> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, feed, left, normal] = v;
    coder(point, feed, left, normal);
}
template <class Coder, CodedAs<PostureValue> T>
void code_fields(Coder& coder, T& v) {
    auto& [lead, yaw, delta] = v;
    coder(lead, yaw, delta);
}
template <class Coder, CodedAs<ChosenPosture> T>
void code_fields(Coder& coder, T& v) {
    auto& [free, posture] = v;
    coder(free, posture);
}
template <class Coder, CodedAs<ContactPlace> T>
void code_fields(Coder& coder, T& p) {
    auto& [frame, surface, facet, u, v, s, v_lo, v_hi, kept, estimated] = p;
    coder(frame, surface, facet, u, v, s, v_lo, v_hi, kept, estimated);
}
template <class Coder, CodedAs<FiveAxisRecord::Point> T>
void code_fields(Coder& coder, T& v) {
    auto& [place, cm2_lead, choice] = v;
    coder(place, cm2_lead, choice);
}
template <class Coder, CodedAs<FiveAxisRecord::Line> T>
void code_fields(Coder& coder, T& v) {
    auto& [begin, end, drive, piece] = v;
    coder(begin, end, drive, piece);
}
/// What configuration spaces are made from. Machine and stock are left to whoever reads.
template <class Coder, CodedAs<PlanContext> T>
void code_fields(Coder& coder, T& v) {
    coder(v.part, v.is_piece, v.geometry, v.curvatures, v.part_box, v.stock_box, v.fixtures_box, v.tool,
          v.tessellation_tolerance, v.unit, v.to_setup, v.further_tools);
}
template <class Coder, CodedAs<FiveAxisRecord::Piece> T>
void code_fields(Coder& coder, T& v) {
    auto& [context, view, lead_limits, passes] = v;
    coder(context, view, lead_limits, passes);
}
template <class Coder, CodedAs<FiveAxisRecord> T>
void code_fields(Coder& coder, T& v) {
    auto& [context, settings, pieces, points, lines, has_strips, kept_off] = v;
    if constexpr (Coder::reads) {
        coder(kept_off);
    } else {
        for (const FiveAxisRecord::Piece& piece : pieces)
            if (piece.context.contact != context.contact)
                throw Error(ErrorCode::internal, "record", "its pieces are planned beside different things",
                            "plan it again");
        coder(context.contact ? context.contact->mesh_ptr() : kept_off);
    }
    coder(context, settings, pieces, points, lines, has_strips);
}

template <class Coder, CodedAs<CleanupRecord::Touch> T>
void code_fields(Coder& coder, T& v) {
    auto& [strip, center, tip, touch, gap] = v;
    coder(strip, center, tip, touch, gap);
}
template <class Coder, CodedAs<CleanupRecord> T>
void code_fields(Coder& coder, T& v) {
    auto& [previous, touches] = v;
    coder(previous, touches);
}

template <class Coder, CodedAs<BoundaryPair> T>
void code_fields(Coder& coder, T& v) {
    auto& [trajectory, in, out, in_offset, out_offset, in_at_side, out_at_side, motion, regular, effective,
           region] = v;
    coder(trajectory, in, out, in_offset, out_offset, in_at_side, out_at_side, motion, regular, effective,
          region);
}
template <class Coder, CodedAs<UncutPlace> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, normal, lead] = v;
    coder(point, normal, lead);
}
template <class Coder, CodedAs<ReworkRegion> T>
void code_fields(Coder& coder, T& v) {
    auto& [strip, lead_largest, grow, place, edits, places, uncut] = v;
    coder(strip, lead_largest, grow, place, edits, places, uncut);
}
/// Without the pieces of the part that planning works with.
template <class Coder, CodedAs<ReworkRegions> T>
void code_fields(Coder& coder, T& v) {
    auto& [regions, within, outside, area, uncut_area, part_area] = v;
    coder(regions, area, uncut_area, part_area);
}
template <class Coder, CodedAs<ReworkPlan> T>
void code_fields(Coder& coder, T& v) {
    auto& [source, pairs, regions, left_by_main, tool, three_axis, path, part_area, remaining_area] = v;
    coder(pairs, regions, left_by_main, tool, three_axis, path, part_area, remaining_area);
}

// Programs.

template <class Coder, CodedAs<Motion> T>
void code_fields(Coder& coder, T& v) {
    auto& [kind, to, pass, point] = v;
    coder(kind, to, pass, point);
}
template <class Coder, CodedAs<ToolMotions> T>
void code_fields(Coder& coder, T& v) {
    auto& [motions, clearance_z, air_length, turning] = v;
    coder(motions, clearance_z, air_length, turning);
}
template <class Coder, CodedAs<ClRange> T>
void code_fields(Coder& coder, T& v) {
    auto& [pass, first, last] = v;
    coder(pass, first, last);
}
template <class Coder, CodedAs<ClTurning> T>
void code_fields(Coder& coder, T& v) {
    auto& [zero, winding, ranges] = v;
    coder(zero, winding, ranges);
}
template <class Coder, CodedAs<ClSection> T>
void code_fields(Coder& coder, T& v) {
    auto& [operation_name, tool_number, tool_name, cutter, gauge_length, feed_mm_per_min, spindle_rpm,
           coolant, multi_axis, part_box, motions, motion_feeds, turning] = v;
    coder(operation_name, tool_number, tool_name, cutter, gauge_length, feed_mm_per_min, spindle_rpm, coolant,
          multi_axis, part_box, motions, motion_feeds, turning);
}
template <class Coder, CodedAs<MotionTotals> T>
void code_fields(Coder& coder, T& v) {
    auto& [cut_length, rapid_length, time_seconds, turn_max] = v;
    coder(cut_length, rapid_length, time_seconds, turn_max);
}
template <class Coder, CodedAs<MachineRun> T>
void code_fields(Coder& coder, T& v) {
    auto& [joints, reversals, largest_angular_rate, motions, findings, warnings] = v;
    coder(joints, reversals, largest_angular_rate, motions, findings, warnings);
}
template <class Coder, CodedAs<PlanKeys> T>
void code_fields(Coder& coder, T& v) {
    auto& [path, motions, program, in_view] = v;
    coder(path, motions, program, in_view);
}
template <class Coder, CodedAs<OperationResult> T>
void code_fields(Coder& coder, T& v) {
    auto& [name, kind, path, program, totals, machine_run, joints, motion_warnings, out_of_reach,
           nothing_to_do, within, view, seconds_strategy, seconds_link, seconds_planning, cc_points,
           cl_points, further, keys] = v;
    coder(name, kind, path, program, totals, machine_run, joints, motion_warnings, out_of_reach,
          nothing_to_do, view, seconds_strategy, seconds_link, seconds_planning, cc_points, cl_points,
          further, keys);
}

// Verdicts.

template <class Coder, CodedAs<MotionPlace> T>
void code_fields(Coder& coder, T& v) {
    auto& [program, motion, course] = v;
    coder(program, motion, course);
}
template <class Coder, CodedAs<DeviationSurface> T>
void code_fields(Coder& coder, T& v) {
    auto& [points, normals, deviation, flags, triangles] = v;
    coder(points, normals, deviation, flags, triangles);
}
template <class Coder, CodedAs<DeviationFigures> T>
void code_fields(Coder& coder, T& v) {
    auto& [samples, area, gouge_max, p50, p95, p99, p999, excess_max, over_fraction, uncut_fraction] = v;
    coder(samples, area, gouge_max, p50, p95, p99, p999, excess_max, over_fraction, uncut_fraction);
}
template <class Coder, CodedAs<SlopeBand> T>
void code_fields(Coder& coder, T& v) {
    auto& [from, to, figures] = v;
    coder(from, to, figures);
}
template <class Coder, CodedAs<CuttingLoad> T>
void code_fields(Coder& coder, T& v) {
    auto& [volume, peak_rate, peak_motion] = v;
    coder(volume, peak_rate, peak_motion);
}
template <class Coder, CodedAs<DeviationExtreme> T>
void code_fields(Coder& coder, T& v) {
    auto& [point, normal, deviation, by] = v;
    coder(point, normal, deviation, by);
}
template <class Coder, CodedAs<Collision> T>
void code_fields(Coder& coder, T& v) {
    auto& [kind, with_part, at, place, depth, fixture] = v;
    coder(kind, with_part, at, place, depth, fixture);
}
template <class Coder, CodedAs<UncutReason> T>
void code_fields(Coder& coder, T& v) {
    auto& [why, program, area, excess_max, place] = v;
    coder(why, program, area, excess_max, place);
}
template <class Coder, CodedAs<StockPiece> T>
void code_fields(Coder& coder, T& v) {
    auto& [volume, box] = v;
    coder(volume, box);
}
template <class Coder, CodedAs<LoosePieces> T>
void code_fields(Coder& coder, T& v) {
    auto& [part_is_free, count, largest, at] = v;
    coder(part_is_free, count, largest, at);
}
template <class Coder, CodedAs<VerifySettings> T>
void code_fields(Coder& coder, T& v) {
    auto& [resolution, sample_spacing, motion_bound, tolerance, gouge_limit, uncut_limit, open_side,
           cut_before, look_for_pieces, allowance, usual_rays, usual_rays_asked, max_samples, before_work,
           cannot_verify, max_stock_bytes, unit] = v;
    coder(resolution, sample_spacing, motion_bound, tolerance, gouge_limit, uncut_limit, open_side,
          cut_before, look_for_pieces, allowance, usual_rays, usual_rays_asked, max_samples, max_stock_bytes,
          unit);
}
template <class Coder, CodedAs<Verification> T>
void code_fields(Coder& coder, T& v) {
    auto& [stock, surface, figures, border, bands, program_gouges, program_air, program_loads, gouges, excess,
           collisions, uncut, uncut_share, not_judged_share, not_judged, loose, remarks, used,
           seconds_cutting, seconds_probing] = v;
    coder(surface, figures, border, bands, program_gouges, program_air, program_loads, gouges, excess,
          collisions, uncut, uncut_share, not_judged_share, not_judged, loose, remarks, used, seconds_cutting,
          seconds_probing);
}
template <class Coder, CodedAs<CarriedStock> T>
void code_fields(Coder& coder, T& v) {
    auto& [mesh, edge_loss, key, source] = v;
    coder(mesh, edge_loss, key);
}

namespace {

/// What both sides have.
template <class Coder>
void tell_known(Coder& coder, const PreparedPart& part) {
    coder.knows(part.mesh);
    coder.knows(part.kept_off);
}

/// Normals of the whole part that a path was planned with; null where it has none, or those of pieces.
std::shared_ptr<const MeshGeometry> part_normals(const StrategyResult& path, const PreparedPart& part) {
    if (const auto* tilted = path.as<TiltedPath>(); tilted && tilted->record)
        if (const PlanContext& context = tilted->record->context; context.part == part.mesh)
            return context.geometry;
    if (const auto* global_local = path.as<GlobalLocalPath>(); global_local && global_local->rework)
        return part_normals(global_local->rework->path, part);
    return nullptr;
}

/// Gives what was just read the part of its contexts that is not written; `whole`: of the operation.
void complete(const StrategyResult& path, const PlanContext& whole) {
    if (const auto* tilted = path.as<TiltedPath>(); tilted && tilted->record) {
        auto& record =
            const_cast<FiveAxisRecord&>(*tilted->record); // made by the reader, and nobody else's yet
        record.context.machine = whole.machine;
        for (FiveAxisRecord::Piece& piece : record.pieces)
            piece.context.machine = whole.machine;
    }
    if (const auto* global_local = path.as<GlobalLocalPath>(); global_local && global_local->rework)
        complete(global_local->rework->path, whole);
}

} // namespace

std::string result_bytes(const OperationResult& result, const PreparedPart& part, const Progress& progress) {
    ByteWriter writer(progress);
    tell_known(writer, part);
    // Whoever reads works them out of the part, where it has none yet.
    const auto normals = part_normals(result.path, part);
    const bool has_normals = normals != nullptr;
    writer(has_normals);
    writer.knows(normals);
    writer(result);
    return writer.take();
}

std::shared_ptr<const OperationResult> result_from_bytes(std::string_view bytes, const Project& project,
                                                         std::size_t i, const PreparedPart& part,
                                                         const Progress& progress) {
    ByteReader reader(bytes, progress);
    tell_known(reader, part);
    bool has_normals = false;
    reader(has_normals);
    if (has_normals)
        reader.knows(part.geometry ? part.geometry : compute_geometry(*part.mesh, progress.part(0, 0)));
    auto result = std::make_shared<OperationResult>();
    reader(*result);
    reader.end();
    const PlanContext whole = preview_context(project, i, part, {});
    const Operation& operation = *project.operations.at(i);
    result->within = kept_within_of(project, operation, part, result->view, progress);
    complete(result->path, whole);
    if (result->keys && result->keys->in_view) complete(*result->keys->in_view, whole);
    for (auto& further : result->further) {
        complete(further->path, whole);
        auto own = std::make_shared<OperationResult>(*further);
        own->within = result->within;
        further = std::move(own);
    }
    return result;
}

std::string verdict_bytes(const KeptVerdict& verdict, const Progress& progress) {
    ByteWriter writer(progress);
    writer(verdict.posted_blocks, verdict.verification);
    return writer.take();
}

KeptVerdict verdict_from_bytes(std::string_view bytes, const Progress& progress) {
    ByteReader reader(bytes, progress);
    KeptVerdict verdict;
    reader(verdict.posted_blocks, verdict.verification);
    reader.end();
    if (!verdict.verification || !verdict.verification->surface)
        throw Error(ErrorCode::syntax, "bytes", "there is no verdict in them", "leave them out");
    return verdict;
}

std::string carried_bytes(const CarriedStock& stock, const Progress& progress) {
    ByteWriter writer(progress);
    writer(stock);
    return writer.take();
}

std::shared_ptr<CarriedStock> carried_from_bytes(std::string_view bytes, const Progress& progress) {
    ByteReader reader(bytes, progress);
    auto stock = std::make_shared<CarriedStock>();
    reader(*stock);
    reader.end();
    return stock;
}

} // namespace facetmill
