// Check boxes for what the view shows. Wraps where the window is narrow.
#pragma once

#include <QWidget>

#include <vector>

class QCheckBox;

namespace facetmill {
class Scene;
}

namespace facetmill::ui {

/// What a user tells apart: the scene's layers, with the motions of a path split by kind.
enum class ViewLayer { part, edges, stock, deviation, cc, cuts, links, rapids, tool };

class LayerBar : public QWidget {
    Q_OBJECT
public:
    explicit LayerBar(QWidget* parent = nullptr);

    bool shown(ViewLayer layer) const;
    void set_shown(ViewLayer layer, bool on);
    QCheckBox* box(ViewLayer layer) const;
    /// The shown layers by name, for settings; names that are not known are passed over.
    QStringList shown_names() const;
    void set_shown_names(const QStringList& names);
    /// Hands all check marks to the scene.
    void apply(Scene& scene) const;

signals:
    void toggled();

private:
    std::vector<QCheckBox*> boxes_;
};

} // namespace facetmill::ui
