#include "ui/controller.h"

namespace facetmill::ui {

void Controller::tell(const QString& message) {
    emit said(MessageBar::Kind::information, message, false);
}

bool Controller::report_written(const QString& path, const QString& wrong) {
    if (wrong.isEmpty())
        emit wrote(path);
    else
        emit failed(wrong);
    return wrong.isEmpty();
}

void Controller::offer() {
    if (!std::exchange(offered_, true)) emit offered();
}

} // namespace facetmill::ui
