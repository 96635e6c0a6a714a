#include "tests/property/random_jobs.h"

#include "core/mesh/mesh_io.h"
#include "core/strategy/plan/operation.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"

#include <algorithm>

namespace facetmill::test {

namespace {

bool chance(Random& rng, double share) {
    return uniform(rng, 0, 1) < share;
}

template <class List>
auto any_of(Random& rng, const List& list) {
    return list[std::size_t(whole(rng, 0, int(std::size(list)) - 1))];
}

/// A rod about X with lobes, open or closed at its ends.
Mesh rod(Random& rng) {
    Mesh mesh;
    const int rings = whole(rng, 3, 10), around = whole(rng, 5, 24), lobes = whole(rng, 0, 5);
    const double radius = uniform(rng, 3, 8), depth = uniform(rng, 0, 0.3) * radius,
                 length = uniform(rng, 8, 25);
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around, r = radius + depth * std::cos(lobes * angle + 0.3 * i);
            mesh.vertices.emplace_back(length * i / rings, r * std::cos(angle), r * std::sin(angle));
        }
    const auto at = [&](int i, int k) { return Index(i * around + k % around); };
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < around; ++k) {
            mesh.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    for (int k = 1; chance(rng, 0.7) && k + 1 < around; ++k) {
        mesh.facets.push_back({at(0, 0), at(0, k), at(0, k + 1)});
        mesh.facets.push_back({at(rings, 0), at(rings, k + 1), at(rings, k)});
    }
    return mesh;
}

Mesh clean_mesh(Random& rng, int form) {
    const double a = uniform(rng, 0.1, 0.6), b = uniform(rng, 0.1, 0.6), height = uniform(rng, 0.2, 3);
    const Vec2 half(uniform(rng, 4, 12), uniform(rng, 4, 12));
    switch (form) {
    case 0:
        return height_field([&](double x, double y) { return height * std::sin(a * x) * std::cos(b * y); },
                            -half, half, whole(rng, 2, 14), whole(rng, 2, 14));
    case 1:
        return height_field([&](double x, double) { return -height * std::exp(-a * x * x); }, -half, half,
                            whole(rng, 4, 24), whole(rng, 1, 6));
    case 2:
        return box(Vec3(-half.x(), -half.y(), -height - 0.1), Vec3(half.x(), half.y(), 0));
    case 3:
        return dome(uniform(rng, 4, 12), whole(rng, 3, 8));
    case 4:
        return only(step(-height, 0), [&](const Vec3& p) { return std::abs(p.x()) < half.x(); });
    case 5:
        return *soup(whole(rng, 1, 60), uniform(rng, 5, 20), std::uint64_t(whole(rng, 0, 1 << 30)));
    default:
        return rod(rng);
    }
}

/// Facets turned round, doubled, folded back, drawn out to needles, loosened, left out.
Mesh dirtied(const Mesh& clean, double share, Random& rng) {
    Mesh dirty;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto at = Index(dirty.vertices.size());
        for (const Vec3& v : {a, b, c})
            dirty.vertices.push_back(v);
        dirty.facets.push_back({at, at + 1, at + 2});
    };
    for (std::size_t f = 0; f < clean.facet_count(); ++f) {
        const Vec3 &a = clean.corner(f, 0), &b = clean.corner(f, 1), &c = clean.corner(f, 2);
        const int fault = chance(rng, share) ? whole(rng, 0, 6) : -1;
        if (fault == 0) continue;
        fault == 1 ? add(a, c, b) : add(a, b, c);
        if (fault == 2) add(a, b, c);
        if (fault == 3) add(a, c, b);
        if (fault == 4) add(a, b, a + 0.5 * (b - a));
        if (fault == 5) add(a, b, c + Vec3(1e-5, 0, -1e-5));
        if (fault == 6) add(a, b, 0.5 * (b + c) + Vec3(0, 0, uniform(rng, -2, 2)));
    }
    return dirty;
}

double number(Random& rng, const ParameterInfo& info, double usual) {
    const double lo = std::max(info.minimum, -1e6), hi = std::min(info.maximum, 1e6);
    double value = usual * std::exp(uniform(rng, -1.5, 1.5));
    if (usual == 0)
        value = info.quantity == Quantity::angle ? uniform(rng, lo, hi)
                                                 : uniform(rng, std::max(lo, -1.0), std::min(hi, 2.0));
    return std::clamp(value, lo, hi);
}

ParameterValue value_of(Random& rng, const ParameterInfo& info, const ParameterValue& usual) {
    const auto* plain = std::get_if<double>(&usual);
    switch (info.kind) {
    case ParameterKind::number:
        return number(rng, info, plain ? *plain : 0);
    case ParameterKind::number_or_word:
        if (chance(rng, 0.5)) return any_of(rng, info.words);
        return number(rng, info, plain && *plain > 0 ? *plain : 1);
    case ParameterKind::integer:
        return long(
            std::clamp(double(whole(rng, 0, 12)), info.minimum, std::max(info.minimum, info.maximum)));
    case ParameterKind::boolean:
        return chance(rng, 0.5);
    case ParameterKind::choice:
        return any_of(rng, info.words);
    case ParameterKind::pair: {
        const double lo = std::max(info.minimum, -10.0), hi = std::min(info.maximum, 10.0);
        std::array<double, 2> two{uniform(rng, lo, hi), uniform(rng, lo, hi)};
        if (two[0] > two[1]) std::swap(two[0], two[1]);
        return two;
    }
    default:
        return usual;
    }
}

/// Parameters that came after seeds had been kept for what they had found: each would make another job of
/// every seed. (What boundaries and tool axes do is tried by tests of their own.)
bool came_later(const Parameterized& settings, const ParameterInfo& info) {
    const std::string_view later[] = {"boundary",  "contain", "avoid", "avoid_distance",
                                      "tool_axis", "off",     "passes"};
    if (info.key == "tilt_limit") return !settings.has("previous_tool"); // clean-up had it before the others
    return std::find(std::begin(later), std::end(later), info.key) != std::end(later);
}

void vary(Random& rng, Parameterized& settings, double share) {
    for (const ParameterInfo* info : settings.parameters()) {
        if (came_later(settings, *info) || !chance(rng, share)) continue;
        try {
            settings.set(info->key, value_of(rng, *info, settings.get(info->key)));
        } catch (const Error&) {
            continue; // out of an open range
        }
    }
}

Tool any_tool(Random& rng, long number) {
    const double diameter = uniform(rng, 1, 8);
    Tool tool = any_of(rng, std::vector<Tool>{ball_tool(diameter), flat_tool(diameter),
                                              bull_tool(diameter, 0.2 * diameter)});
    if (chance(rng, 0.2)) tool.taper_angle = uniform(rng, -0.2, 0.6);
    if (chance(rng, 0.1)) tool.bottom_angle = uniform(rng, 0, 1);
    tool.number = number;
    tool.name = "Tool " + std::to_string(number);
    tool.flute_length = uniform(rng, 2, 30);
    tool.shank_diameter = uniform(rng, 0.5, 1.5) * diameter;
    tool.shank_length = uniform(rng, 0, 30);
    if (chance(rng, 0.5)) tool.holder = {{uniform(rng, 1, 4) * diameter, uniform(rng, 1, 40)}};
    return tool;
}

/// Seeds below stand for jobs of one setup.
constexpr std::uint64_t first_with_setups = 403;
/// Seeds below stand for jobs without boundaries.
constexpr std::uint64_t first_with_boundaries = 2000;

/// Seeds below stand for jobs of the kinds that there were first.
constexpr std::uint64_t first_with_later_kinds = 3000;

/// Kinds that came after seeds had been kept for what they had found: each would make another job of every
/// seed.
const std::vector<OperationKind>& kinds_for(std::uint64_t seed) {
    static const auto first = [] {
        std::vector<OperationKind> kinds = operation_kinds();
        std::erase_if(kinds, [](const OperationKind& k) {
            return k.kind == "waterline" || k.kind == "steep_shallow" || k.kind == "pencil"
                   || k.kind == "along_curve" || k.kind == "radial" || k.kind == "spiral" || k.kind == "morph"
                   || k.kind == "scallop";
        });
        return kinds;
    }();
    return seed < first_with_later_kinds ? first : operation_kinds();
}

/// A region of any kind, which some operations keep within, or keep off.
void add_boundaries(Random& rng, Project& project, const Mesh& part) {
    Boundary b;
    b.kind = Boundary::Kind(whole(rng, 0, 3));
    const auto first = Index(whole(rng, 0, int(part.facet_count()) - 1));
    const auto last = Index(whole(rng, int(first), int(part.facet_count()) - 1));
    b.facets = std::to_string(first) + "-" + std::to_string(last);
    b.slope = {uniform(rng, 0, 0.5), uniform(rng, 0.6, pi)};
    const Vec3 middle = part.box().center();
    const double size = 0.5 * part.box().diagonal();
    for (int corner = whole(rng, 3, 8); corner > 0; --corner)
        b.curve.push_back(
            {{middle.x() + uniform(rng, -size, size), middle.y() + uniform(rng, -size, size), 0}});
    b.offset = uniform(rng, -0.1, 0.1) * size;
    b.invert = chance(rng, 0.3);
    project.boundaries.push_back(b);
    for (const auto& operation : project.operations) {
        if (operation->turning()) continue;
        OperationCommon& common = operation->common();
        if (chance(rng, 0.6)) common.boundary = b.name;
        common.contain = Containment(whole(rng, 0, 2));
        if (chance(rng, 0.3)) common.avoid = b.name;
        common.avoid_distance = uniform(rng, 0.1, 3);
    }
}

/// The part turned over or on its side, and the same done once more: to what the first setup left, or to a
/// stock of its own.
void add_setup(Random& rng, Project& project, const std::vector<std::string>& machine_names) {
    Setup next = project;
    next.name = "Setup 2";
    const double x = any_of(rng, std::vector<double>{pi, pi / 2, 0});
    next.place.rotate = {x, any_of(rng, std::vector<double>{0, pi}), 0};
    next.place.translate = {0, uniform(rng, -20, 20), uniform(rng, -20, 20)};
    if (chance(rng, 0.7)) next.stock.kind = StockSpec::Kind::rest;
    if (chance(rng, 0.2)) next.machine = any_of(rng, machine_names);
    for (std::size_t i = 0; i < next.operations.size(); ++i)
        next.operations[i]->common().name = "Then " + std::to_string(i + 1);
    project.after.push_back(std::move(next));
}

} // namespace

Project random_job(std::uint64_t seed, const std::filesystem::path& folder, std::uint64_t* stamp) {
    Random rng(seed);
    Project project;
    project.path = folder / "p.facetmill";
    project.part.file = "part.stl";
    const int form = whole(rng, 0, 6);
    const Mesh clean = clean_mesh(rng, form);
    const Mesh dirty = dirtied(clean, any_of(rng, std::vector<double>{0, 0.02, 0.3}), rng);
    save_stl(dirty.facets.empty() ? clean : dirty, folder / "part.stl", LengthUnit::mm, {});
    if (chance(rng, 0.2))
        project.part.rotate = {any_of(rng, std::vector<double>{0, pi / 2, -pi / 2, pi, 0.3}), 0,
                               uniform(rng, 0, pi)};
    if (chance(rng, 0.1)) project.part.mirror = Mirror::x;
    if (chance(rng, 0.1)) project.part.flip = true;
    if (chance(rng, 0.1)) project.unit = LengthUnit::inch;
    const bool turns = form == 6 && chance(rng, 0.8);
    std::vector<std::string> names;
    for (const Machine& m : machines())
        names.push_back(m.name);
    project.machine = turns ? "lathe-mill" : any_of(rng, names);
    if (turns || chance(rng, 0.1)) project.stock.kind = StockSpec::Kind::cylinder;
    if (turns) project.stock.axis = StockSpec::Axis::x;
    for (double& m : project.stock.margin)
        m = chance(rng, 0.3) ? 0 : uniform(rng, 0, 4);
    const int tools = whole(rng, 1, 3);
    for (long n = 1; n <= tools; ++n)
        project.tools.push_back(any_tool(rng, n));
    const int operations = whole(rng, 1, 2);
    for (int i = 0; i < operations; ++i) {
        const auto& kinds = kinds_for(seed);
        const OperationKind& kind = kinds[std::size_t(whole(rng, 0, int(kinds.size()) - 1))];
        auto op = kind.make();
        vary(rng, *op, 0.15);
        op->common().tool = whole(rng, 1, tools);
        for (const ParameterInfo* info : op->parameters())
            if (info->key.ends_with("_tool")) op->set(info->key, long(whole(rng, 1, tools)));
        op->common().name = "Op " + std::to_string(i + 1);
        op->common().tolerance = uniform(rng, 0.1, 0.5);
        if (op->common().allowance > 0) op->common().allowance = uniform(rng, 0, 0.5);
        project.operations.push_back(std::move(op));
    }
    if (seed >= first_with_boundaries && chance(rng, 0.8)) add_boundaries(rng, project, clean);
    if (seed >= first_with_setups && chance(rng, 0.25)) add_setup(rng, project, names);
    if (stamp) {
        *stamp = rng();
        for (const auto& op : project.operations)
            for (const char c : op->kind())
                *stamp = *stamp * 31 + std::uint64_t(c);
    }
    return project;
}

} // namespace facetmill::test
