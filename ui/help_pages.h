// The pages of the manual as the program carries them: what stands on them, for the contents and the search,
// and their drawings in the colours of a palette. app/manual makes them of resources/manual. Pages are those
// of the language that is spoken; what there is none of comes in English.
#pragma once

#include <QImage>
#include <QPalette>
#include <QString>
#include <QStringList>

#include <vector>

namespace facetmill::ui {

/// A heading of the manual with what stands below it.
struct HelpSection {
    QString topic; ///< "rough.html#depth": the page and the place on it
    int level = 1; ///< 1 a page, 2 and 3 its headings, 4 a parameter
    QString title, text;
    QString page() const { return topic.section(QChar('#'), 0, 0); }
};

/// In the order of the manual.
const std::vector<HelpSection>& help_sections();
bool has_help(const QString& topic);
/// Sections that have all words, those with the words in their title first.
std::vector<const HelpSection*> find_help(const QString& words);

/// A file of the manual by its name in it: "first_job.html", "pictures/plan.png"; empty where there is none.
QByteArray help_file(const QString& name);
/// How pages look in a window with this palette.
QString help_style(const QPalette& palette);

/// The drawing of a parameter ("step_over"), or an empty text. `scope`: kind of the operation, or the section
/// of the reference that the parameter stands in.
QString parameter_drawing(const QString& scope, const QString& key);
/// Null where there is no such drawing; `width` in points.
QImage help_drawing(const QString& name, const QPalette& palette, int width, qreal pixel_ratio);
/// For rich text: the drawing as a picture within the text.
QString help_drawing_html(const QString& name, const QPalette& palette, int width);

} // namespace facetmill::ui
