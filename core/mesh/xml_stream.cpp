#include "core/mesh/xml_stream.h"

#include <new>

#include <expat.h>

namespace facetmill::detail {

namespace {

constexpr int max_depth = 64;

} // namespace

template <class Work>
void XmlStream::guarded(const Work& work) {
    if (thrown_) return;
    try {
        work();
    } catch (...) {
        thrown_ = std::current_exception();
        XML_StopParser(parser_, XML_FALSE);
    }
}

struct XmlStream::Callbacks {
    static XmlStream& of(void* user) { return *static_cast<XmlStream*>(user); }
    static void start(void* user, const XML_Char* name, const XML_Char** attributes) {
        XmlStream& s = of(user);
        s.guarded([&] {
            if (++s.depth_ > max_depth)
                throw Error(ErrorCode::limit_exceeded, s.place(), "elements are nested too deeply",
                            "export the part again");
            s.handler_.start(name, attributes);
        });
    }
    static void end(void* user, const XML_Char* name) {
        XmlStream& s = of(user);
        s.guarded([&] {
            --s.depth_;
            s.handler_.end(name);
        });
    }
    static void prefix(void* user, const XML_Char* prefix, const XML_Char* uri) {
        XmlStream& s = of(user);
        s.guarded([&] { s.handler_.prefix(prefix ? prefix : "", uri ? uri : ""); });
    }
    static void document_type(void* user, const XML_Char* /*name*/, const XML_Char* /*system*/,
                              const XML_Char* /*public_id*/, int /*has_subset*/) {
        XmlStream& s = of(user);
        s.guarded([&] {
            throw Error(ErrorCode::syntax, s.place(), "the XML declares a document type or entities",
                        "export the part again, without");
        });
    }
};

XmlStream::XmlStream(std::string name, XmlHandler& handler)
    : name_(std::move(name)), handler_(handler), parser_(XML_ParserCreateNS(nullptr, ' ')) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(parser_, Callbacks::start, Callbacks::end);
    XML_SetStartNamespaceDeclHandler(parser_, Callbacks::prefix);
    XML_SetStartDoctypeDeclHandler(parser_, Callbacks::document_type);
}

XmlStream::~XmlStream() {
    XML_ParserFree(parser_);
}

std::string XmlStream::place() const {
    return name_ + ", line " + std::to_string(XML_GetCurrentLineNumber(parser_));
}

void XmlStream::parse(std::string_view bytes, bool last) {
    const XML_Status status =
        XML_Parse(parser_, bytes.data(), int(bytes.size()), last ? XML_TRUE : XML_FALSE);
    if (thrown_) std::rethrow_exception(thrown_);
    if (status == XML_STATUS_OK) return;
    const XML_Error error = XML_GetErrorCode(parser_);
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    throw Error(ErrorCode::syntax, place(), "is no sound XML: " + printable(XML_ErrorString(error)),
                "the file is damaged: export it again");
}

const char* attribute(const char** attributes, std::string_view name) {
    for (; *attributes; attributes += 2)
        if (name == attributes[0]) return attributes[1];
    return nullptr;
}

} // namespace facetmill::detail
