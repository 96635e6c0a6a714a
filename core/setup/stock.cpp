#include "core/setup/stock.h"

#include "core/mesh/mesh_format.h"

namespace facetmill {

const ParameterTable<StockSpec>& stock_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<StockSpec> t;
        t.add_choice(&StockSpec::kind, {.key = "kind",
                                        .label = "Kind",
                                        .help = "Shape of the raw material. `rest`: what the setup before "
                                                "left of its stock, as it was verified; not in the first "
                                                "setup.",
                                        .words = {"box", "cylinder", "mesh", "rest"},
                                        .stage = Stage::contact});
        t.add(&StockSpec::margin,
              {.key = "margin",
               .label = "Margin",
               .help = "What the stock is larger than the part: on both sides in x, on both sides in y, on "
                       "top in z. Round a cylinder whose diameter is `auto` the larger one of those across "
                       "its axis counts.",
               .kind = K::triple,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1e6,
               .stage = Stage::contact});
        t.add_choice(&StockSpec::axis,
                     {.key = "axis",
                      .label = "Axis",
                      .help = "Along which the cylinder lies, through the middle of the part's box.",
                      .words = {"x", "y", "z"},
                      .stage = Stage::contact});
        t.add(&StockSpec::diameter, {.key = "diameter",
                                     .label = "Diameter",
                                     .help = "Of the cylinder; `auto`: what holds the part and the margin.",
                                     .kind = K::number_or_word,
                                     .quantity = Quantity::length,
                                     .minimum = 0,
                                     .maximum = 1e6,
                                     .open_minimum = true,
                                     .words = {"auto"},
                                     .stage = Stage::contact});
        t.add(&StockSpec::file,
              {.key = "file",
               .label = "File",
               .help = "The stock's mesh (" + solid_format_names()
                       + "), closed, such as the stock.stl that `simulate` leaves; a relative path starts at "
                         "the project file.",
               .kind = K::text,
               .stage = Stage::mesh});
        t.add_choice(&StockSpec::unit, mesh_unit_parameter());
        t.add(&StockSpec::scale, scale_parameter("stock's mesh"));
        t.add_choice(&StockSpec::mirror, mirror_parameter("stock's mesh"));
        t.add(&StockSpec::rotate, rotate_parameter("Turns the stock's mesh about X, then Y, then Z (fixed "
                                                   "axes); the part's placement does not move it."));
        t.add(&StockSpec::translate, translate_parameter("Moves the stock's mesh after it was turned."));
        return t;
    }();
    return table;
}

const std::string& stock_kind_name(StockSpec::Kind kind) {
    return stock_parameters().find("kind")->info.words.at(std::size_t(kind));
}

const std::vector<std::string>& stock_keys(StockSpec::Kind kind) {
    static const std::array<std::vector<std::string>, 4> keys{
        {{"kind", "margin"},
         {"kind", "margin", "axis", "diameter"},
         {"kind", "file", "units", "scale", "mirror", "rotate", "translate"},
         {"kind"}}};
    return keys.at(std::size_t(kind));
}

Box3 stock_box(const StockSpec& stock, const Box3& part) {
    if (part.empty()) return part;
    const auto& [x, y, z] = stock.margin;
    Box3 box;
    box.lo = part.lo - Vec3(x, y, 0);
    box.hi = part.hi + Vec3(x, y, z);
    return box;
}

StockCylinder stock_cylinder(const StockSpec& stock, const Box3& part, const std::array<double, 3>& reach) {
    StockCylinder c;
    const auto axis = std::size_t(stock.axis), u = (axis + 1) % 3, v = (axis + 2) % 3;
    c.axis = int(axis);
    c.needed = reach[axis];
    c.radius = stock.diameter.is_number() ? 0.5 * stock.diameter.number
                                          : c.needed + std::max(stock.margin[u], stock.margin[v]);
    c.box = stock_box(stock, part);
    if (part.empty()) return c;
    for (const std::size_t k : {u, v}) {
        c.box.lo[Eigen::Index(k)] = part.center()[Eigen::Index(k)] - c.radius;
        c.box.hi[Eigen::Index(k)] = part.center()[Eigen::Index(k)] + c.radius;
    }
    return c;
}

} // namespace facetmill
