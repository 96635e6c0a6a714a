// How the part lies: its size, the faces it can lie on, and the buttons that turn and move it.
#pragma once

#include "core/base/units.h"
#include "core/base/vec.h"
#include "core/setup/lying.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;
class QTreeWidget;
class QVBoxLayout;

namespace facetmill::ui {

class PlaceValueRow;

/// What is picked in the view.
enum class PlacePick { none, face, points, edge, zero, hole };

/// What the buttons of the work zero show.
struct ShownZero {
    bool on_origin = true, on_part = false; ///< else on the stock
    std::array<double, 3> place{0, 0, 0};   ///< see ProgramSpec::zero_place
    QString text;
};

class PlacePanel : public QWidget {
    Q_OBJECT
public:
    enum Column { contact_column, down_column, height_column, tilt_column };

    explicit PlacePanel(QWidget* parent = nullptr);

    QTreeWidget* list() { return list_; }
    QSize sizeHint() const override { return {300, 480}; }
    QSize minimumSizeHint() const override { return {170, 120}; }
    LyingOrder order() const;
    /// The face that is chosen in the list.
    std::optional<std::size_t> chosen() const;
    /// Size and where it begins and ends; an empty box: there is no part. `scale`: of the file's numbers.
    void show_box(const Box3& box, LengthUnit unit, double scale = 1);
    PlaceValueRow* value_row() { return value_row_; }
    /// In the order of the list. `note` stands below it.
    void fill(const std::vector<LyingFace>& faces, LengthUnit unit, const QString& note);
    void show_zero(const ShownZero& zero);
    /// Which button is down.
    void show_picking(PlacePick picking);

signals:
    void order_changed();
    void face_chosen();
    void lay_wanted();
    /// A button that picks in the view went down or up.
    void pick_wanted(facetmill::ui::PlacePick what);
    /// Quarter turns about X, Y, Z (0, 1, 2).
    void turn_wanted(int axis, int quarters);
    void mirror_wanted(int axis);
    void square_wanted();
    void principal_wanted();
    void drop_wanted();
    void centre_wanted();
    /// The zero on a box: from -1, its low side, to 1, its high side.
    void zero_wanted(bool on_part, const std::array<double, 3>& place);
    void zero_origin_wanted();

private:
    void build_list(QVBoxLayout* column);
    void build_picks(QVBoxLayout* column);
    void build_turns(QVBoxLayout* column);
    void build_moves(QVBoxLayout* column);
    void build_zero(QVBoxLayout* column);
    void want_zero();

    QLabel *size_ = nullptr, *extents_ = nullptr, *note_ = nullptr;
    QComboBox* order_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QPushButton* lay_ = nullptr;
    PlaceValueRow* value_row_ = nullptr;
    std::vector<QToolButton*> picks_; ///< face, points, edge, zero, hole
    QComboBox *zero_of_ = nullptr, *zero_level_ = nullptr;
    std::array<QToolButton*, 9> zero_spots_{}; ///< from low X to high X, the row of low Y first
    QLabel* zero_text_ = nullptr;
    std::vector<QWidget*> of_part_; ///< disabled without a part
};

} // namespace facetmill::ui
