// Fields and choices that are narrower than their text: it is shortened with "…", so that no number looks
// like another one, and the tool tip has the whole of it. Also, lists of choices are as wide as these.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

namespace facetmill::ui {

/// The whole text of a QLineEdit or QComboBox that cannot show it; empty for all others.
QString shortened_text(const QWidget& widget);

/// A tool tip that begins with the whole text.
QString with_whole_text(const QWidget& widget, const QString& tip);

/// Watches fields and choices; the style gives them one as they are polished.
class WholeText : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    bool eventFilter(QObject* object, QEvent* event) override;
};

} // namespace facetmill::ui
