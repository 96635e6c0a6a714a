// What any page and dialog is asked by who works with keys, with a screen reader, or sees little: each rule
// names the widgets that break it, and nothing where all is well.
#pragma once

#include <QStringList>
#include <QWidget>

class QColor;

namespace facetmill::test {

/// WCAG 2.1: contrast ratio of two colours, 1 to 21.
double contrast(const QColor& a, const QColor& b);
/// A widget by the classes and names above it.
QString described(const QWidget& w);
/// What Tab stops at: takes the keys, and is there to be seen.
std::vector<QWidget*> controls_of(QWidget& window);

/// Controls without a name or without a role.
QStringList nameless(QWidget& window);
/// The first control of each area that Tab reaches too late or too early. Areas: a dialog, or the docks.
QStringList out_of_order(QWidget& window);
/// Controls that Tab does not stop at, whose commands are in no menu either.
QStringList out_of_reach(QWidget& window);
/// Mnemonics that two things which are seen at once have.
QStringList shared_mnemonics(QWidget& window);
/// Words of labels, buttons, fields, lists and texts with less contrast than 4.5 to 1.
QStringList faint_words(QWidget& window);
/// Controls from which F1 leads nowhere, or to another place than their parameter's.
QStringList without_help(QWidget& window);

} // namespace facetmill::test
