// XML as a stream of elements, read by expat piece by piece. Refused are document types, with which entities
// come, and elements nested deeper than any file of ours. Internal to the room.
#pragma once

#include "core/base/error.h"

#include <exception>
#include <map>
#include <memory>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace facetmill::detail {

/// Names of elements and of attributes that have a prefix have the URI of their namespace and a blank before
/// them: "http://schemas.microsoft.com/3dmanufacturing/core/2015/02 object".
class XmlHandler {
public:
    virtual ~XmlHandler() = default;
    /// `attributes`: name, value, name, value, ..., null. Exceptions pass.
    virtual void start(std::string_view name, const char** attributes) = 0;
    virtual void end(std::string_view name) = 0;
    /// A prefix stands for a namespace from the next element on.
    virtual void prefix(std::string_view /*prefix*/, std::string_view /*uri*/) {}
};

class XmlStream {
public:
    /// `name`: of the document in errors.
    XmlStream(std::string name, XmlHandler& handler);
    ~XmlStream();
    XmlStream(const XmlStream&) = delete;
    XmlStream& operator=(const XmlStream&) = delete;

    /// Throws Error(syntax, limit_exceeded) with the line, and what the handler throws.
    void read(std::string_view bytes) { parse(bytes, false); }
    /// Throws Error(syntax) where the document is not whole.
    void finish() { parse({}, true); }
    /// "part.3mf: 3D/3dmodel.model, line 12"
    std::string place() const;

private:
    struct Callbacks;
    void parse(std::string_view bytes, bool last);
    /// Ends the reading with an exception, which does not pass through expat.
    template <class Work>
    void guarded(const Work& work);

    std::string name_;
    XmlHandler& handler_;
    XML_ParserStruct* parser_;
    std::exception_ptr thrown_;
    int depth_ = 0;
};

/// The value of an attribute, or null.
const char* attribute(const char** attributes, std::string_view name);

} // namespace facetmill::detail
