// The words for views and layers.
#include "viz/scene.h"

namespace facetmill {

const std::vector<StandardView>& standard_views() {
    using V = StandardView;
    static const std::vector<V> all{V::iso, V::front, V::top, V::right, V::rear, V::bottom, V::left};
    return all;
}

std::string_view view_name(StandardView view) {
    switch (view) {
    case StandardView::iso:
        return "iso";
    case StandardView::front:
        return "front";
    case StandardView::top:
        return "top";
    case StandardView::right:
        return "right";
    case StandardView::rear:
        return "rear";
    case StandardView::bottom:
        return "bottom";
    case StandardView::left:
        return "left";
    }
    return "";
}

std::string_view view_label(StandardView view) {
    switch (view) {
    case StandardView::iso:
        return "Isometric";
    case StandardView::front:
        return "Front";
    case StandardView::top:
        return "Top";
    case StandardView::right:
        return "Right";
    case StandardView::rear:
        return "Rear";
    case StandardView::bottom:
        return "Bottom";
    case StandardView::left:
        return "Left";
    }
    return "";
}

StandardView parse_view(std::string_view text, const std::string& where) {
    std::string words;
    for (const StandardView v : standard_views()) {
        if (view_name(v) == text) return v;
        words += (words.empty() ? "" : ", ") + std::string(view_name(v));
    }
    throw Error(ErrorCode::out_of_range, where, "unknown view '" + printable(text) + "'",
                "use one of " + words);
}

const std::vector<Layer>& all_layers() {
    static const std::vector<Layer> all{Layer::part,     Layer::edges,  Layer::stock, Layer::deviation,
                                        Layer::findings, Layer::strips, Layer::cc,    Layer::cl,
                                        Layer::tool,     Layer::marker, Layer::axes,  Layer::scale,
                                        Layer::legend,   Layer::title};
    return all;
}

std::string_view layer_name(Layer layer) {
    switch (layer) {
    case Layer::part:
        return "part";
    case Layer::edges:
        return "edges";
    case Layer::stock:
        return "stock";
    case Layer::deviation:
        return "deviation";
    case Layer::findings:
        return "findings";
    case Layer::strips:
        return "strips";
    case Layer::cc:
        return "cc";
    case Layer::cl:
        return "cl";
    case Layer::tool:
        return "tool";
    case Layer::marker:
        return "marker";
    case Layer::axes:
        return "axes";
    case Layer::scale:
        return "scale";
    case Layer::legend:
        return "legend";
    case Layer::title:
        return "title";
    }
    return "";
}

std::string_view layer_label(Layer layer) {
    switch (layer) {
    case Layer::part:
        return "Part";
    case Layer::edges:
        return "Facet edges";
    case Layer::stock:
        return "Stock";
    case Layer::deviation:
        return "Deviation";
    case Layer::findings:
        return "Findings";
    case Layer::strips:
        return "Rework and clean-up regions";
    case Layer::cc:
        return "Contact points (CC)";
    case Layer::cl:
        return "Tool path (CL)";
    case Layer::tool:
        return "Tool";
    case Layer::marker:
        return "Picked point";
    case Layer::axes:
        return "Axes";
    case Layer::scale:
        return "Scale";
    case Layer::legend:
        return "Legend";
    case Layer::title:
        return "Title";
    }
    return "";
}

} // namespace facetmill
