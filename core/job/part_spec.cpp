// What a project says of its part.
#include "core/job/project.h"
#include "core/mesh/mesh_format.h"
#include "core/strategy/plan/shared_parameters.h"

namespace facetmill {

namespace {

ParameterInfo relief_length(const char* key, const char* label, std::string help) {
    return {.key = key,
            .label = label,
            .help = std::move(help),
            .kind = ParameterKind::number_or_word,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1e5,
            .open_minimum = true,
            .words = {"auto"},
            .stage = Stage::mesh,
            .default_unwritten = true};
}

/// What is said of a picture, which is read as a relief.
void add_relief(ParameterTable<PartSpec>& t) {
    using K = ParameterKind;
    t.add(&PartSpec::picture_width,
          relief_length("picture_width", "Picture width",
                        "How wide a picture (PNG, TIFF) is as a part, along X from its first column to its "
                        "last. `auto`: 100 mm, with a warning."));
    t.add(&PartSpec::picture_length,
          relief_length("picture_length", "Picture length",
                        "How long a picture is along Y, from its lowest row to its highest. `auto`: as its "
                        "pixels are, square."));
    t.add(&PartSpec::relief_height,
          relief_length("relief_height", "Relief height",
                        "How far white lies above black, which is Z 0; of floating point numbers the highest "
                        "above the lowest. `auto`: 5 mm, with a warning."));
    t.add(&PartSpec::smoothing,
          {.key = "smoothing",
           .label = "Smoothing",
           .help = "Evens out a picture's relief, across six pixels or so; no height moves by more than "
                   "this. A 500th of the relief height takes the steps of 256 greys away. 0: none.",
           .kind = K::number,
           .quantity = Quantity::length,
           .minimum = 0,
           .maximum = 1000,
           .stage = Stage::mesh,
           .default_unwritten = true});
    t.add(&PartSpec::invert, {.key = "invert",
                              .label = "Invert",
                              .help = "Black is the top of a picture's relief and white its ground. What is "
                                      "transparent lies on the ground all the same.",
                              .kind = K::boolean,
                              .stage = Stage::mesh,
                              .default_unwritten = true});
}

void add_surfaces(ParameterTable<PartSpec>& t) {
    ParameterInfo chord = length_or_word_parameter(
        {.key = "chord_tolerance",
         .label = "Chord tolerance",
         .help = "How far facets may lie from the surfaces of a STEP or IGES file. auto is a tenth of the "
                 "finest tolerance of the operations; painted facets stay what they are where a length "
                 "is given.",
         .words = {"auto"},
         .advanced = true,
         .default_unwritten = true});
    chord.stage = Stage::mesh;
    t.add(&PartSpec::chord_tolerance, chord);
    t.add(&PartSpec::angle_tolerance, {.key = "angle_tolerance",
                                       .label = "Angle tolerance",
                                       .help = "How much the normals of facets side by side may differ on a "
                                               "surface of a STEP or IGES file.",
                                       .kind = ParameterKind::number,
                                       .quantity = Quantity::angle,
                                       .minimum = radians(1),
                                       .maximum = radians(60),
                                       .stage = Stage::mesh,
                                       .advanced = true,
                                       .default_unwritten = true});
}

} // namespace

const ParameterTable<PartSpec>& part_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<PartSpec> t;
        t.add(&PartSpec::file, {.key = "file",
                                .label = "File",
                                .help = "The part's mesh (" + mesh_format_names()
                                        + "); a relative path starts at the project file.",
                                .kind = K::text,
                                .stage = Stage::mesh,
                                .required = "name the part's file"});
        t.add_choice(&PartSpec::unit, mesh_unit_parameter());
        t.add(&PartSpec::scale, scale_parameter("part"));
        t.add_choice(&PartSpec::mirror, mirror_parameter("part"));
        t.add(&PartSpec::flip,
              {.key = "flip",
               .label = "Flip",
               .help = "Takes the other side of open surfaces as their outside. By itself that is the upper "
                       "side of a sheet, and the side that is seen of what nearly closes; of closed bodies "
                       "it is always the outside.",
               .kind = K::boolean,
               .stage = Stage::mesh});
        t.add(&PartSpec::rotate, rotate_parameter("Turns the part about X, then Y, then Z (fixed axes)."));
        t.add(&PartSpec::translate, translate_parameter("Moves the part after it was turned."));
        t.add(&PartSpec::tessellation_tolerance, {.key = "tessellation_tolerance",
                                                  .label = "Tessellation tolerance",
                                                  .help = "How far the true surface may lie outside and "
                                                          "inside the mesh. 0 takes the mesh as the part; of "
                                                          "STEP and IGES files what was measured counts, "
                                                          "where that is more.",
                                                  .kind = K::pair,
                                                  .quantity = Quantity::length,
                                                  .minimum = 0,
                                                  .maximum = 1000,
                                                  .stage = Stage::contact});
        t.add(
            &PartSpec::objects,
            {.key = "objects",
             .label = "Objects",
             .help =
                 "Which objects of a 3MF or glTF file are the part, by name or number, separated by commas; "
                 "`info` lists them. Empty: all on the file's build plate, or in its scene.",
             .kind = K::text,
             .stage = Stage::mesh,
             .default_unwritten = true});
        add_relief(t);
        add_surfaces(t);
        t.add_records(&PartSpec::repair, repair_list,
                      {.label = "Repair",
                       .help = "Steps that make the file's mesh worth machining, in their order, carried out "
                               "again whenever the file has changed.",
                       .stage = Stage::mesh,
                       .nouns = {"step", "steps"}});
        return t;
    }();
    return table;
}

const std::vector<std::string>& relief_keys() {
    static const std::vector<std::string> keys{"picture_width", "picture_length", "relief_height",
                                               "smoothing", "invert"};
    return keys;
}

MeshReading PartSpec::reading() const {
    const auto stated = [](const NumberOrWord& v) {
        return v.is_number() ? std::optional(v.number) : std::nullopt;
    };
    MeshReading reading = unit;
    reading.objects = objects;
    if (chord_tolerance.is_number()) reading.chord = chord_tolerance.number;
    reading.chord_angle = angle_tolerance;
    reading.relief = {stated(picture_width), stated(picture_length), stated(relief_height), smoothing,
                      invert};
    return reading;
}

} // namespace facetmill
