// Where the cube of a view stands: in the lower right corner, above what lies along the lower edge, and not
// at all where there is no room or something lies in the way.
#pragma once

#include <QObject>

namespace facetmill::ui {

class ViewCube;
class Viewport;

class CubePlace : public QObject {
    Q_OBJECT
public:
    CubePlace(Viewport& viewport, ViewCube& cube);
    void update();

protected:
    /// What lies over the view comes and goes.
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    Viewport& viewport_;
    ViewCube& cube_;
};

} // namespace facetmill::ui
