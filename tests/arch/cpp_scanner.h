// A reader of C++ that knows just enough to measure: which functions and classes a file has and where they
// begin and end. It matches braces; what a brace opens it sees from the words before it. Macros are not
// expanded, and of alternatives by #if all are read, so each must close what it opens.
#pragma once

#include <string>
#include <vector>

namespace facetmill::test {

/// A function with a body or a class with its members.
struct Extent {
    enum class Kind { Function, Class };
    Kind kind = Kind::Function;
    std::string
        name; // with its classes and namespaces: "facetmill::Stock::patch"; those without a name are left out
    std::string scope;   // the same without the last part
    bool hidden = false; // inside a namespace without a name: known in this file alone
    int first = 0;       // line of the name, from 1
    int last = 0;        // line of the closing brace

    int lines() const { return last - first + 1; }
};

/// The text without comments, literals and preprocessor lines: each of their characters becomes a blank, ends
/// of line stay.
std::string bare_code(const std::string& text);

struct Scan {
    std::vector<Extent> extents;
    bool closed = true; // every brace found its partner
};

/// Functions and classes of a file, in the order in which they end. What stands inside a function is part of
/// it and not listed.
Scan scan_cpp(const std::string& text);

/// A class with all that belongs to it, wherever it stands.
struct ClassSize {
    std::string name;
    std::string file; // of the declaration
    int lines = 0;    // the declaration and the members defined outside it
};

/// Sizes of the classes of a tree: `scans` has the path of each file and what was found in it.
std::vector<ClassSize> class_sizes(const std::vector<std::pair<std::string, Scan>>& scans);

} // namespace facetmill::test
