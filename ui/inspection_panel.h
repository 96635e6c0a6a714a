// The panel of the charts: which chart, of which operation, what stands at the cursor, and the chart.
#pragma once

#include <QWidget>

#include <vector>

class QComboBox;
class QToolButton;

namespace facetmill::ui {

class ElidedLabel;
class PlotView;

class InspectionPanel : public QWidget {
    Q_OBJECT
public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    PlotView* plot() { return plot_; }
    QComboBox* chart_box() { return chart_; }
    QComboBox* operation_box() { return operation_; }
    ElidedLabel* readout() { return readout_; }
    void set_ready(bool ready);

signals:
    void picture_requested();
    void table_requested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    PlotView* plot_ = nullptr;
    QComboBox *chart_ = nullptr, *operation_ = nullptr;
    ElidedLabel* readout_ = nullptr;
    std::vector<QToolButton*> buttons_;
};

} // namespace facetmill::ui
