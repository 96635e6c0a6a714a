#include "core/job/program_spec.h"

namespace facetmill {

const ParameterTable<ProgramSpec>& program_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<ProgramSpec> t;
        t.add(&ProgramSpec::post,
              {.key = "post",
               .label = "Control",
               .help =
                   "The control that programs are written for, see below, or a file of your own "
                   "(`resources/posts/README.md`); its name ends with `.json`, a relative one starts at the "
                   "project file. Without it programs are APT alone.",
               .kind = K::text,
               .stage = Stage::output});
        t.add(&ProgramSpec::wcs,
              {.key = "wcs",
               .label = "Work coordinates",
               .help = "The control's work coordinate system that programs are told in: `G54`, or the "
                       "number of a preset. Default: the control's first, or what is active in it.",
               .kind = K::text,
               .stage = Stage::output});
        t.add_choice(&ProgramSpec::zero_from,
                     {.key = "zero_from",
                      .label = "Zero from",
                      .help = "What the zero of the work coordinates is on: the part's origin, or the box of "
                              "the stock or of the part. Posted programs and the setup sheet count from "
                              "there; APT files are in part coordinates.",
                      .words = {"origin", "stock", "part"},
                      .stage = Stage::output});
        t.add(&ProgramSpec::zero_place,
              {.key = "zero_place",
               .label = "Zero on box",
               .help = "Where on the box of stock or part the zero is, in X, Y and Z: -1 its low side, 0 its "
                       "middle, 1 its high side. `0, 0, 1`: the middle of its top.",
               .kind = K::triple,
               .minimum = -1,
               .maximum = 1,
               .stage = Stage::output});
        t.add(&ProgramSpec::zero, {.key = "zero",
                                   .label = "Zero",
                                   .help = "Of the work coordinates, from the place that `zero_from` says; "
                                           "from the part's origin a point of the part.",
                                   .kind = K::triple,
                                   .quantity = Quantity::length,
                                   .minimum = -1e6,
                                   .maximum = 1e6,
                                   .stage = Stage::output});
        t.add(&ProgramSpec::number, {.key = "program_number",
                                     .label = "Program number",
                                     .help = "Number of the first program, for controls that want one; those "
                                             "after it count on.",
                                     .kind = K::integer,
                                     .minimum = 1,
                                     .maximum = 99999999,
                                     .stage = Stage::output});
        t.add_choice(&ProgramSpec::files,
                     {.key = "programs",
                      .label = "Programs",
                      .help = "A program for each operation, or one for all with tool changes between.",
                      .words = {"each", "one"},
                      .stage = Stage::output});
        t.add(&ProgramSpec::arcs,
              {.key = "arcs",
               .label = "Arcs",
               .help =
                   "Programs of three axes hold arcs (`G2`, `G3`) where the control has them and one stands "
                   "for "
                   "three motions or more: every end of a motion within a quarter of the chord tolerance of "
                   "the arc, and the arc within half of it of the motions. Where the tool leans, in tilted "
                   "planes alone.",
               .kind = K::boolean,
               .stage = Stage::output});
        return t;
    }();
    return table;
}

} // namespace facetmill
